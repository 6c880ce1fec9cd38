"""One operator a file, or one kind. Each has a full execute(); a person's clicks run stages in a thread."""

import bpy

from . import (
    add_boundary_constraint,
    add_from_seams,
    add_opening,
    add_shapes,
    add_time_constraint,
    allow_seams,
    assign_time,
    build_graph,
    cancel,
    check_mesh,
    drag_opening,
    draw_constraint,
    edit_mark,
    give_time,
    mend_time,
    remove_mark,
    running_step,
    schedule,
    select_mark,
    select_problem,
    set_time,
    solve_time,
    suggest,
    take_boundary,
    write_knitout,
)

MODULES = (
    check_mesh,
    add_boundary_constraint,
    add_time_constraint,
    add_from_seams,
    assign_time,
    add_opening,
    remove_mark,
    select_mark,
    draw_constraint,
    drag_opening,
    take_boundary,
    edit_mark,
    set_time,
    give_time,
    mend_time,
    suggest,
    solve_time,
    build_graph,
    schedule,
    allow_seams,
    write_knitout,
    cancel,
    select_problem,
    add_shapes,
)


def register():
    for module in MODULES:
        for cls in module.CLASSES:
            bpy.utils.register_class(cls)


def unregister():
    running_step.stop(bpy.context)
    for module in reversed(MODULES):
        for cls in reversed(module.CLASSES):
            bpy.utils.unregister_class(cls)
