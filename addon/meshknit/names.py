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
)

OP_CHECK = "meshknit.check_mesh"
OP_ADD_CONSTRAINT = "meshknit.add_time_constraint"
OP_ADD_BOUNDARY = "meshknit.add_boundary_constraint"
OP_REMOVE_CONSTRAINT = "meshknit.remove_constraint"
OP_SELECT_CONSTRAINT = "meshknit.select_constraint"
OP_ADD_OPENING = "meshknit.add_opening"
OP_REMOVE_OPENING = "meshknit.remove_opening"
OP_SELECT_OPENING = "meshknit.select_opening"
OP_SOLVE_TIME = "meshknit.solve_time"
OP_BUILD_GRAPH = "meshknit.build_graph"
OP_SCHEDULE = "meshknit.schedule"
OP_ALLOW_SEAMS = "meshknit.allow_seams"
OP_WRITE = "meshknit.write_knitout"
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

LIST_CONSTRAINTS = "MESHKNIT_UL_constraints"
LIST_OPENINGS = "MESHKNIT_UL_openings"
MENU_SHAPES = "MESHKNIT_MT_shapes"
PANEL = "MESHKNIT_PT_knit"
SIDEBAR = "Knit"
