"""The module is imported through the add-on's package, so that it is loaded once."""

import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, os.environ.get("MESHKNIT_ADDONS", str(HERE.parents[2] / "addon")))
