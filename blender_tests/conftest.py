"""The add-on comes from this checkout, or from the folder that MESHKNIT_ADDONS names."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, os.environ.get("MESHKNIT_ADDONS", str(HERE.parent / "addon")))
sys.path.insert(0, str(HERE))
