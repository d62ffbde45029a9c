"""For setup.py files: makes a module of parameters while the package is installed."""
from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from generate_parameter_library_py.generate_python_module import run


def option(arguments: Sequence[str], *names: str) -> str:
    """The value behind one of these options; empty when none is there."""
    return next((value for name, value in zip(arguments, arguments[1:]) if name in names), '')


def generate_parameter_module(
    module_name: str, yaml_file: str, validation_module: str = '', install_base: str | None = None,
    merge_install: bool = False
) -> None:
    """
    Make PACKAGE.module_name where the package is built, and where it is installed.

    `validation_module` has the user's functions. `install_base` and `merge_install` say how other tools lay out a
    workspace; here `--prefix` says where the package is installed.
    """
    build = os.path.dirname(option(sys.argv, '--build-base', '--build-directory'))  # WORKSPACE/build/PACKAGE
    prefix = option(sys.argv, '--prefix')
    if not build or not prefix:  # the package is not being installed
        return
    package = os.path.basename(build)
    version = f'python{sys.version_info.major}.{sys.version_info.minor}'
    for folder in (os.path.join(build, package), os.path.join(prefix, 'lib', version, 'site-packages', package)):
        run(os.path.join(folder, f'{module_name}.py'), yaml_file, validation_module)
