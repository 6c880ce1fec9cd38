"""The headless run:

    blender --background [scene.blend] --python addon/meshknit/batch.py -- OPTIONS

`-- --help` lists the options. Exit status: 0 done, 1 this model cannot be knit as asked, 2 wrong
usage or unreadable file, 3 a promise of ours broke."""

import importlib
import os
import sys
from pathlib import Path


def load_package():
    """The name of this file's package: as Blender loaded it, else imported from here."""
    folder = Path(__file__).resolve().parent
    for name, module in list(sys.modules.items()):
        file = getattr(module, "__file__", None)
        if file and hasattr(module, "bl_info") and Path(file).resolve().parent == folder:
            return name
    sys.path.insert(0, str(folder.parent))
    return folder.name


if __name__ == "__main__":
    headless = importlib.import_module(load_package() + ".headless")
    status = headless.main(sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else [])
    sys.stdout.flush()
    sys.stderr.flush()
    # Some Blenders crash while they exit, which would spoil the status.
    os._exit(status)
