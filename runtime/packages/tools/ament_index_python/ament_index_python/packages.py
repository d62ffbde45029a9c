"""Packages and their folders."""
from __future__ import annotations

import os
import pathlib
import re

from .resources import get_resources, has_resource

PACKAGE_NAME = re.compile(r'[A-Za-z][A-Za-z0-9_-]*')


class PackageNotFoundError(KeyError):
    """No prefix has the package."""

    def __str__(self) -> str:
        return f"package '{self.args[0]}' not found" if self.args else 'package not found'


def get_packages_with_prefixes() -> dict[str, str]:
    """Return name -> prefix of all packages."""
    return get_resources('packages')


def get_package_prefix(package_name: str) -> str:
    """Return the prefix that has the package. PackageNotFoundError, or ValueError for what is not a name."""
    if not PACKAGE_NAME.fullmatch(package_name):
        raise ValueError(f"'{package_name}' is not a valid package name")
    prefix = has_resource('packages', package_name)
    if not isinstance(prefix, str):
        raise PackageNotFoundError(package_name)
    return prefix


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    """Return the package's share folder, which may be missing."""
    path = os.path.join(get_package_prefix(package_name), 'share', package_name)
    if print_warning and not os.path.exists(path):
        print(f'WARNING: Share directory for package {package_name} ({path}) does not exist.')
    return path


def get_package_share_path(package_name: str, print_warning: bool = True) -> pathlib.Path:
    """Return the package's share folder as a Path."""
    return pathlib.Path(get_package_share_directory(package_name, print_warning))
