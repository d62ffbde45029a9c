"""Commands that packages derive their own from: `from setuptools.command.install import install`."""
from __future__ import annotations

import sys
from types import ModuleType

from setuptools import Command

COMMANDS = (
    'build', 'build_clib', 'build_ext', 'build_py', 'build_scripts', 'clean', 'develop', 'easy_install', 'egg_info',
    'install', 'install_data', 'install_lib', 'install_scripts', 'sdist', 'test',
)


def make_commands(package: ModuleType) -> None:
    """A module of each command below `package`, with a class of its name."""
    for name in COMMANDS:
        module = ModuleType(f'{package.__name__}.{name}')
        setattr(module, name, type(name, (Command,), {}))
        sys.modules[module.__name__] = module
        setattr(package, name, module)


make_commands(sys.modules[__name__])
