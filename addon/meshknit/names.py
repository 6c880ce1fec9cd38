"""Every identifier that saved files, scripts and other modules rely on."""

# Attributes on the mesh. Zero means "nothing", so that new geometry starts unmarked.
TIME = "knit_time"  # POINT FLOAT, from -1 (first) to 1 (last)
TIME_COLOR = "knit_time_color"  # POINT FLOAT_COLOR, the same for Solid and Vertex shading
CONSTRAINT = "knit_constraint"  # EDGE INT, 0 = none, n = entry n-1 of the constraint list
OPENING = "knit_opening"  # FACE INT, not 0 = left out of the knit surface

# The property groups on bpy.types.Scene and bpy.types.Mesh.
PROPERTIES = "meshknit"

# Stages, in the order in which they run: as in `--until` and in the report's seconds.
STAGES = ("check", "time", "graph", "trace", "schedule", "emit")

# Machine profiles built into the library, first the default.
MACHINES = (
    ("shima_swg091n2", "Shima Seiki SWG091N2", "V-bed, 15 gauge, 540 needles", 0),
    ("kniterate", "Kniterate", "V-bed, 7 gauge, 252 needles", 1),
)

# Where the millimetres come from (numbers are stored in files).
SIZE_MODES = (
    ("SCENE", "Scene units", "The object is as large as the scene says", 0),
    ("SCALE", "Scale", "Choose how many millimetres a Blender unit is", 1),
    ("SIZE", "Longest side", "Choose the length of the finished object's longest side", 2),
)

# Where the time field comes from.
TIME_SOURCES = (
    ("CONSTRAINTS", "Constraints", "Interpolate between the constraints below", 0),
    ("ATTRIBUTE", "Attribute knit_time", "Use the point attribute knit_time as it is", 1),
    (
        "DISTANCE",
        "Distance",
        "The distance along the surface from the boundaries with the earliest time: next to no "
        "short rows",
        2,
    ),
    ("HEIGHT", "Height", "The height along an axis", 3),
    (
        "VALUES",
        "Attribute or group",
        "A point attribute of numbers, also from Geometry Nodes, or a vertex group",
        4,
    ),
)

# The way the rows go, for times by height (numbers are stored in files).
TIME_AXES = tuple(
    (axis, axis, f"Rows go along {axis}", index)
    for index, axis in enumerate(("X", "Y", "Z", "-X", "-Y", "-Z"))
)

# The lists of marks on a mesh; which of them keys act on is stored in files.
MARK_KINDS = (
    ("CONSTRAINT", "Constraint", "The active time constraint", 0),
    ("OPENING", "Opening", "The active opening", 1),
)

# What time a new mark of the tool gets (numbers are stored in files).
NEW_TIMES = (
    (
        "AUTOMATIC",
        "Automatic",
        "A chain gets the time that its place has now; the first boundary or opening is the start, "
        "the second the end",
        0,
    ),
    ("VALUE", "Value", "The time beside this", 1),
)

OP_CHECK = "meshknit.check_mesh"
OP_ADD_CONSTRAINT = "meshknit.add_time_constraint"
OP_ADD_BOUNDARY = "meshknit.add_boundary_constraint"
OP_REMOVE_CONSTRAINT = "meshknit.remove_constraint"
OP_SELECT_CONSTRAINT = "meshknit.select_constraint"
OP_DRAW_CONSTRAINT = "meshknit.draw_constraint"
OP_TAKE_BOUNDARY = "meshknit.take_boundary"
OP_FROM_SEAMS = "meshknit.add_from_seams"
OP_ASSIGN_TIME = "meshknit.assign_time"
OP_DRAG_OPENING = "meshknit.drag_opening"
OP_PICK_MARK = "meshknit.pick_mark"
OP_CHANGE_TIME = "meshknit.change_time"
OP_SET_TIME = "meshknit.set_time"
OP_REMOVE_MARK = "meshknit.remove_mark"
OP_ADD_OPENING = "meshknit.add_opening"
OP_REMOVE_OPENING = "meshknit.remove_opening"
OP_SELECT_OPENING = "meshknit.select_opening"
OP_SOLVE_TIME = "meshknit.solve_time"
OP_BUILD_GRAPH = "meshknit.build_graph"
OP_SCHEDULE = "meshknit.schedule"
OP_ALLOW_SEAMS = "meshknit.allow_seams"
OP_WRITE = "meshknit.write_knitout"
OP_SUGGEST = "meshknit.suggest"
OP_GIVE_TIME = "meshknit.give_time"
OP_MEND_TIME = "meshknit.mend_time"
OP_SELECT_FINDING = "meshknit.select_finding"
OP_CANCEL = "meshknit.cancel"
OP_SELECT_PROBLEM = "meshknit.select_problem"
OP_ADD_TUBE = "meshknit.add_straight_tube"
OP_ADD_CONE = "meshknit.add_cone"
OP_ADD_BENT_TUBE = "meshknit.add_bent_tube"
OP_ADD_SOCK = "meshknit.add_sock"
OP_ADD_TWO_WAY_SPLIT = "meshknit.add_two_way_split"
OP_ADD_THREE_WAY_SPLIT = "meshknit.add_three_way_split"
OP_ADD_TWO_WAY_MERGE = "meshknit.add_two_way_merge"
OP_ADD_THREE_WAY_MERGE = "meshknit.add_three_way_merge"
OP_ADD_TROUSERS = "meshknit.add_trousers"
OP_ADD_MITTEN = "meshknit.add_mitten"
OP_ADD_RING_TORUS = "meshknit.add_ring_torus"
OP_ADD_TEDDY = "meshknit.add_teddy"

# Keys of the main block, from 0 to 9.
DIGITS = ("ZERO", "ONE", "TWO", "THREE", "FOUR", "FIVE", "SIX", "SEVEN", "EIGHT", "NINE")

MADE_BY_MODIFIER = "A modifier made this part: mark the mesh's own surface, or apply the modifier"

TOOL = "meshknit.knit_time"  # the workspace tool

LIST_CONSTRAINTS = "MESHKNIT_UL_constraints"
LIST_OPENINGS = "MESHKNIT_UL_openings"
MENU_SHAPES = "MESHKNIT_MT_shapes"
PANEL = "MESHKNIT_PT_knit"
SIDEBAR = "Knit"
