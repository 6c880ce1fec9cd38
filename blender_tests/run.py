"""blender --background --factory-startup --python blender_tests/run.py -- [pytest arguments]"""

import os
import sys
from pathlib import Path

import pytest

sys.dont_write_bytecode = True
here = Path(__file__).resolve().parent
arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
if not any(Path(argument.split("::")[0]).exists() for argument in arguments):
    arguments.append(str(here / "headless"))
code = pytest.main(["-p", "no:cacheprovider", f"--rootdir={here}", *arguments])
sys.stdout.flush()
sys.stderr.flush()
os._exit(int(code))  # Blender 3.4 can crash during its own exit
