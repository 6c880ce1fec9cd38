"""Rules of the code base that no single test would notice."""

import ast
import json
import os
import shutil
import subprocess
from pathlib import Path

import bpy
import pytest

import meshes
import meshknit
from meshknit import names, native

PACKAGE = Path(meshknit.__file__).resolve().parent
SOURCES = sorted(p for p in PACKAGE.rglob("*.py"))
# A module never imports one of a higher rank.
RANKS = {
    "names": 0, "compat": 0, "native": 1, "core": 2, "scene": 3, "properties": 3, "overlay": 4,
    "operators": 5, "tool": 6, "ui": 6, "registration": 7, "headless": 8, "batch": 9, "demo": 9,
    "demo_picture": 9, "__init__": 9,
}  # fmt: skip


def imports(path):
    """(relative level, dotted name) of every import."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from ((0, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = node.module or ""
            yield from ((node.level, f"{base}.{a.name}".strip(".")) for a in node.names)


def part_of(path):
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imported_parts(path):
    """Which parts of the package a module imports."""
    depth = len(path.relative_to(PACKAGE).parts)
    for level, name in imports(path):
        if level == depth:
            yield name.split(".")[0]
        elif level:
            yield part_of(path)


@pytest.mark.parametrize("path", SOURCES, ids=lambda p: str(p.relative_to(PACKAGE)))
def test_a_module_imports_only_lower_ranks(path):
    for part in imported_parts(path):
        assert RANKS[part] <= RANKS[part_of(path)], f"imports {part}"


def test_core_and_overlay_data_run_without_blender():
    for path in [*PACKAGE.glob("core/*.py"), PACKAGE / "overlay" / "overlay_data.py"]:
        used = {name.split(".")[0] for level, name in imports(path) if level == 0}
        assert not used & {"bpy", "gpu", "bmesh", "mathutils", "blf"}, path


def test_only_native_names_the_compiled_module():
    for path in SOURCES:
        if path.name != "native.py":
            assert "_native" not in path.read_text(), path


def test_the_package_never_imports_itself_by_name():
    for path in SOURCES:
        assert not any(level == 0 and n.split(".")[0] == "meshknit" for level, n in imports(path))


def test_no_file_is_long():
    for path in SOURCES:
        assert len(path.read_text().splitlines()) <= 300, path


def left_in_blender():
    """What add-ons hang into Blender: handlers, menu entries, tools' keys, classes, properties."""
    handlers = bpy.app.handlers
    lists = {name: getattr(handlers, name) for name in dir(handlers)}
    found = {name: len(held) for name, held in lists.items() if isinstance(held, list)}
    for name in dir(bpy.types):
        draw = getattr(getattr(bpy.types, name), "draw", None)
        found[name] = len(getattr(draw, "_draw_funcs", ()))
    configs = bpy.context.window_manager.keyconfigs
    found["keymaps"] = {keymap.name for keymap in configs.default.keymaps}
    found["properties"] = [hasattr(t, names.PROPERTIES) for t in (bpy.types.Mesh, bpy.types.Scene)]
    return found


def test_registering_again_and_again_leaves_nothing_behind(tube):
    meshknit.unregister()
    without = left_in_blender()
    try:
        assert not any(without["properties"])
        for _ in range(10):
            meshknit.register()
            assert left_in_blender() != without
            meshknit.unregister()
            assert left_in_blender() == without
    finally:
        meshknit.register()
    assert [c.time for c in bpy.context.object.data.meshknit.constraints] == [-1.0, 1.0]
    assert bpy.ops.meshknit.check_mesh() == {"FINISHED"}


def test_property_defaults_are_those_of_the_library():
    library = native.load()
    scene = bpy.context.scene.meshknit
    bpy.ops.meshknit.add_straight_tube()
    bpy.ops.meshknit.build_graph()
    shape = library.example_shape("straight_tube")
    surface = library.Surface(shape["vertices"], shape["faces"])
    graph = library.build_knit_graph(surface, shape["vertices"][:, 2] / 60.0 - 1.0)
    assert round(scene.stitch_width, 6) == graph.stitch_width
    assert round(scene.stitch_height, 6) == graph.stitch_height
    # What the panel shows of relaxing is what the library does by itself.
    again = library.build_knit_graph(
        surface, shape["vertices"][:, 2] / 60.0 - 1.0, relax=scene.relax
    )
    assert (again.nodes == graph.nodes).all()


def test_without_the_compiled_module_the_addon_registers_and_says_how_to_build(tmp_path):
    script = tmp_path / "try.py"
    script.write_text(
        f"import sys; sys.path.insert(0, {str(PACKAGE.parent)!r}); sys.dont_write_bytecode = True\n"
        "sys.modules['meshknit._native'] = None\n"  # importing it now fails
        "import bpy, os, meshknit; meshknit.register()\n"
        "assert 'make build' in meshknit.native.why_missing()\n"
        "try:\n    bpy.ops.meshknit.check_mesh()\n"
        "except RuntimeError as error:\n    print('SAID', error)\n"
        "sys.stdout.flush(); os._exit(0)\n"
    )
    command = [bpy.app.binary_path, "--background", "--factory-startup", "--python", str(script)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert "SAID" in done.stdout and "make build" in done.stdout, done.stdout + done.stderr


def test_an_installed_copy_runs_batch_under_its_own_name(tmp_path):
    installed = tmp_path / "addons" / "meshknit"
    shutil.copytree(PACKAGE, installed, ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "tube.obj").write_text(meshes.obj_text(*meshes.tube()))
    (tmp_path / "marks.json").write_text(
        json.dumps(meshes.marks((-1.0, (0, 0, 0)), (1.0, (0, 0, 60))))
    )
    switch_on = "import addon_utils, bpy; addon_utils.enable('meshknit', default_set=True); "
    switch_on += "bpy.ops.wm.save_userpref()"
    command = [bpy.app.binary_path, "--background", "--python"]
    command += [str(installed / "batch.py"), "--", "--scale", "1"]
    command += ["--input", str(tmp_path / "tube.obj"), "--marks", str(tmp_path / "marks.json")]
    command += ["--output", str(tmp_path / "tube.k")]
    home = {"BLENDER_USER_SCRIPTS": str(tmp_path), "BLENDER_USER_CONFIG": str(tmp_path)}
    for arguments in (
        [bpy.app.binary_path, "--background", "--factory-startup", "--python-expr", switch_on],
        command,  # where it is on from the start
        [command[0], "--factory-startup", "--addons", "meshknit", *command[1:]],
    ):
        done = subprocess.run(arguments, capture_output=True, text=True, env={**os.environ, **home})
        assert done.returncode == 0, done.stdout + done.stderr
        assert "Traceback" not in done.stdout + done.stderr
        assert (tmp_path / "tube.k").exists() == (arguments[-1] != switch_on)
        (tmp_path / "tube.k").unlink(missing_ok=True)


def test_the_manifest_and_bl_info_tell_the_same_version():
    manifest = (PACKAGE / "blender_manifest.toml").read_text()
    version = ".".join(map(str, meshknit.bl_info["version"]))
    assert f'version = "{version}"' in manifest.splitlines()
