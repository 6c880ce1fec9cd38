"""Mesh files are read as they are: order of vertices, polygons, doubled vertices."""

import struct

import numpy as np
import pytest

import meshes
from meshknit.core.errors import UsageError
from meshknit.core.mesh_files import read_mesh_file


def ply_header(form, vertices, polygons, real="float"):
    return (
        f"ply\nformat {form} 1.0\ncomment made by hand\nelement vertex {len(vertices)}\n"
        f"property {real} x\nproperty {real} y\nproperty {real} z\nproperty uchar red\n"
        f"element face {len(polygons)}\nproperty list uchar int vertex_indices\nend_header\n"
    ).encode()


def ply_text(face_property, face):
    """Three vertices and one face."""
    return (
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        f"property float z\nelement face 1\n{face_property}\nend_header\n"
        f"0 0 0\n1 0 0\n0 1 0\n{face}\n"
    ).encode()


def write_ply(path, vertices, polygons, form):
    data = ply_header(form, vertices, polygons)
    if form == "ascii":
        lines = ["%.9g %.9g %.9g 7" % tuple(v) for v in vertices]
        lines += [" ".join(map(str, [len(p), *p])) for p in polygons]
        data += "\n".join(lines).encode() + b"\n"
    else:
        order = "<" if form.endswith("little_endian") else ">"
        data += b"".join(struct.pack(order + "fffB", *v, 7) for v in vertices)
        data += b"".join(struct.pack(f"{order}B{len(p)}i", len(p), *p) for p in polygons)
    path.write_bytes(data)


@pytest.mark.parametrize("form", ["ascii", "binary_little_endian", "binary_big_endian"])
def test_ply_keeps_vertices_and_quads(tmp_path, form):
    vertices, polygons = meshes.tube()
    write_ply(tmp_path / "tube.ply", vertices, polygons, form)
    read_vertices, read_polygons = read_mesh_file(tmp_path / "tube.ply")
    assert read_polygons == polygons
    np.testing.assert_allclose(read_vertices, vertices, atol=1e-4)


def test_obj_reads_all_ways_to_name_a_vertex(tmp_path):
    text = "# two triangles\no x\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0\nvt 0 0\ns off\n"
    text += "f 1/1 2/1/1 3//1\nf -4 -2 -1\n"
    (tmp_path / "x.obj").write_text(text)
    vertices, polygons = read_mesh_file(tmp_path / "x.obj")
    assert polygons == [[0, 1, 2], [0, 2, 3]]
    assert len(vertices) == 4


def test_obj_keeps_doubled_vertices(tmp_path):
    (tmp_path / "x.obj").write_text("v 0 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 4\nf 2 4 3\n")
    vertices, polygons = read_mesh_file(tmp_path / "x.obj")
    assert len(vertices) == 4 and polygons == [[0, 2, 3], [1, 3, 2]]


def triangles_of(polygons):
    return [[p[0], p[i], p[i + 1]] for p in polygons for i in range(1, len(p) - 1)]


@pytest.mark.parametrize("binary", [True, False])
def test_stl_triangles_are_joined_again(tmp_path, binary):
    vertices, polygons = meshes.tube()
    triangles = triangles_of(polygons)
    path = tmp_path / "tube.stl"
    if binary:
        data = b"\0" * 80 + struct.pack("<I", len(triangles))
        for t in triangles:
            data += struct.pack("<12fH", 0, 0, 0, *np.float32(vertices[t]).ravel(), 0)
        path.write_bytes(data)
    else:
        text = "solid tube\n"
        for t in triangles:
            corners = "".join("vertex %.9g %.9g %.9g\n" % tuple(v) for v in vertices[t])
            text += f"facet normal 0 0 0\nouter loop\n{corners}endloop\nendfacet\n"
        path.write_text(text + "endsolid tube\n")
    read_vertices, read_polygons = read_mesh_file(path)
    assert len(read_vertices) == len(vertices)
    assert len(read_polygons) == len(triangles)
    for mine, theirs in zip(triangles, read_polygons):
        np.testing.assert_allclose(vertices[mine], read_vertices[theirs], atol=1e-4)


@pytest.mark.parametrize(
    "name, data",
    [
        ("missing.obj", None),
        ("noise.obj", b"\x89PNG\x00\x01 nonsense\n more nonsense"),
        ("noise.ply", b"plywood"),
        ("noise.stl", b"\x00\x01\x02"),
        ("word.obj", b"v 0 0 zero\nf 1 1 1\n"),
        ("beyond.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"),
        ("short.ply", ply_header("ascii", [0] * 3, [0]) + b"0 0 0 1\n1 0"),
        ("short_binary.ply", ply_header("binary_little_endian", [0] * 3, [0]) + b"\0" * 8),
        ("no_list.ply", ply_text("property int other", "0")),
        ("scalar.ply", ply_text("property int vertex_indices", "0")),
        ("infinite.ply", ply_text("property list uchar float vertex_indices", "3 0 1 inf")),
        ("bare.ply", b"ply\nformat ascii 1.0\nelement vertex 9999999999\nend_header\n"),
        ("other.fbx", b""),
    ],
)
def test_unreadable_files_are_refused_in_one_sentence(tmp_path, name, data):
    if data is not None:
        (tmp_path / name).write_bytes(data)
    with pytest.raises(UsageError, match=name):
        read_mesh_file(tmp_path / name)


def test_a_face_with_a_vertex_too_many_is_named(tmp_path):
    (tmp_path / "x.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n")
    with pytest.raises(UsageError, match="face 1 has a corner at vertex 8.* 3 vertices"):
        read_mesh_file(tmp_path / "x.obj")


def test_a_file_without_faces_is_an_empty_mesh(tmp_path):
    (tmp_path / "empty.obj").write_text("o nothing\n")
    vertices, polygons = read_mesh_file(tmp_path / "empty.obj")
    assert len(vertices) == 0 and polygons == []
