"""`from distutils.command.build_py import build_py`."""
from __future__ import annotations

import sys

from setuptools.command import make_commands

make_commands(sys.modules[__name__])
