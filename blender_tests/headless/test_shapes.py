"""Add > Mesh > Knit: every example comes with what it takes to knit it."""

from collections import Counter

import bpy
import pytest

from meshknit import native
from meshknit.core import edge_chains
from meshknit.operators import add_shapes
from meshknit.scene import constraints
from meshknit.scene.attributes import edge_vertices, polygon_edges
from objects import session, times

KNIT = bpy.ops.meshknit
EXAMPLES = native.load().example_shape_names()

# Starts and ends of the shapes that branch.
RIMS = {
    "two_way_split": (1, 2),
    "three_way_split": (1, 3),
    "two_way_merge": (2, 1),
    "three_way_merge": (3, 1),
    "trousers": (1, 2),
    "mitten": (1, 1),
    "ring_torus": (1, 1),
}


def test_every_example_of_the_library_can_be_added():
    added = {operator.bl_idname.rpartition("add_")[2] for operator in add_shapes.CLASSES}
    assert added == set(EXAMPLES)


def test_a_shape_is_added_though_the_collection_in_use_is_linked(tmp_path):
    path, scene = str(tmp_path / "other.blend"), bpy.context.scene
    linked = bpy.data.collections.new("Linked")
    scene.collection.children.link(linked)
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(path, link=True) as (_, wanted):
        wanted.collections = ["Linked"]
    scene, layer = bpy.context.scene, bpy.context.view_layer
    scene.collection.children.link(wanted.collections[0])
    layer.active_layer_collection = layer.layer_collection.children["Linked"]
    assert KNIT.add_sock() == {"FINISHED"}
    assert "Sock" in scene.collection.objects and bpy.context.object.name == "Sock"


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_added_shape_has_a_time_on_every_rim(name):
    assert getattr(KNIT, f"add_{name}")() == {"FINISHED"}
    mesh = bpy.context.object.data
    edges = edge_vertices(mesh)
    rims = edge_chains.connected_groups(
        edges, edge_chains.boundary_edges(edges, polygon_edges(mesh))
    )
    assert len(rims) == len(times(bpy.context.object))
    assert all(opening.has_time for opening in mesh.meshknit.openings)
    assert not constraints.loops_without_constraint(mesh)
    assert KNIT.solve_time() == {"FINISHED"}
    field = session().report["time_field"]
    assert field["extrema"] == 0 and field["saddles"] == field["expected_saddles"]


@pytest.mark.parametrize("name", RIMS)
def test_a_branching_shape_starts_and_ends_where_its_name_says(name):
    getattr(KNIT, f"add_{name}")()
    found = times(bpy.context.object)
    assert (found.count(-1.0), found.count(1.0)) == RIMS[name]


def test_the_rims_of_an_example_have_names_that_tell_them_apart():
    KNIT.add_trousers()
    entries = bpy.context.object.data.meshknit.constraints
    assert [entry.name for entry in entries] == ["Start", "End 1", "End 2"]


def test_the_teddy_is_closed_and_opens_at_feet_hands_and_ears():
    KNIT.add_teddy()
    mesh = bpy.context.object.data
    edges = edge_vertices(mesh)
    assert not len(edge_chains.boundary_edges(edges, polygon_edges(mesh)))
    assert Counter(round(o.time, 4) for o in mesh.meshknit.openings) == {-1.0: 2, 0.7: 2, 1.0: 2}
    KNIT.solve_time()
    report = session().report
    # Every rim holds at least six stitches of 3.66 mm.
    assert all(opening["rim_length"] > 6 * 3.66 for opening in report["openings"])
    # 2 g - 2 + b of a sphere with six openings.
    assert report["time_field"]["saddles"] == 4
