"""Lets the tests import the channel's scripts."""
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[4]
_scripts = str(ROOT / "runtime" / "channel")
if _scripts not in sys.path:
    sys.path.append(_scripts)
