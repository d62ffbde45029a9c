"""For setup.py files: makes a module of parameters while the package is installed."""
from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from generate_parameter_library_py.generate_python_module import run


def build_folder(arguments: Sequence[str]) -> str:
    """The argument of `--build-base`, which colcon gives; empty: the package is not being installed."""
    for option, value in zip(arguments, arguments[1:]):
        if option in ('--build-base', '--build-directory'):
            return value
    return ''


def generate_parameter_module(
    module_name: str, yaml_file: str, validation_module: str = '', install_base: str | None = None,
    merge_install: bool = False
) -> None:
    """
    Make PACKAGE.module_name where the package is built, and where it is installed.

    `validation_module` has the user's functions. `install_base`: the install folder of the workspace, which is beside
    its build folder when nothing else is given.
    """
    build = os.path.dirname(build_folder(sys.argv))  # WORKSPACE/build/PACKAGE
    if not build:
        return
    package = os.path.basename(build)
    workspace = os.path.dirname(os.path.dirname(build))
    prefix = install_base or os.path.join(workspace, 'install')
    if not merge_install:
        prefix = os.path.join(prefix, package)
    version = f'python{sys.version_info.major}.{sys.version_info.minor}'
    for folder in (os.path.join(build, package), os.path.join(prefix, 'lib', version, 'site-packages', package)):
        run(os.path.join(folder, f'{module_name}.py'), yaml_file, validation_module)
