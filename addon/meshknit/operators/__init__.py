"""One operator a file. Each has a full execute(); a person's clicks run stages in a thread."""

import bpy

from . import (
    add_boundary_constraint,
    add_opening,
    add_shapes,
    add_time_constraint,
    allow_seams,
    build_graph,
    cancel,
    check_mesh,
    remove_constraint,
    remove_opening,
    running_step,
    schedule,
    select_constraint,
    select_opening,
    select_problem,
    solve_time,
    write_knitout,
)

MODULES = (
    check_mesh,
    add_boundary_constraint,
    add_time_constraint,
    remove_constraint,
    select_constraint,
    add_opening,
    remove_opening,
    select_opening,
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
