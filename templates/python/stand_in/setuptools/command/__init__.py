"""Commands that packages derive their own from: `from setuptools.command.install import install`."""
from __future__ import annotations

import sys
from types import ModuleType

from setuptools import Command

COMMANDS = (
    'build', 'build_ext', 'build_py', 'develop', 'egg_info', 'install', 'install_lib',
    'install_scripts', 'sdist', 'test',
)

for _name in COMMANDS:
    _module = ModuleType(f'{__name__}.{_name}')
    setattr(_module, _name, type(_name, (Command,), {}))
    sys.modules[_module.__name__] = _module
    globals()[_name] = _module
