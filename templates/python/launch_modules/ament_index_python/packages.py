"""Packages of the workspace and of its channels."""
from __future__ import annotations

import os
import pathlib

from ros2wasm_launch import host
from ros2wasm_launch.texts import call


class PackageNotFoundError(KeyError):
    """No such package."""


def get_package_prefix(package_name: str) -> str:
    try:
        return host.evaluate(call('find-pkg-prefix', package_name), {})
    except host.HostError as error:
        raise PackageNotFoundError(f'there is no package `{package_name}`') from error


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    return f'{get_package_prefix(package_name)}/share/{package_name}'


def get_package_share_path(package_name: str, print_warning: bool = True) -> pathlib.Path:
    return pathlib.Path(get_package_share_directory(package_name))


def get_packages_with_prefixes() -> dict[str, str]:
    found: dict[str, str] = {}
    for prefix in os.environ.get('AMENT_PREFIX_PATH', '').split(':'):
        share = f'{prefix}/share'
        for name in sorted(os.listdir(share)) if os.path.isdir(share) else ():
            if os.path.isdir(f'{share}/{name}'):
                found.setdefault(name, prefix)
    return found
