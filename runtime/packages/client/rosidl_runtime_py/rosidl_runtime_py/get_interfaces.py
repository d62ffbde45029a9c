"""Which interfaces there are, read off the share folders of the site."""
from __future__ import annotations

import os
from collections.abc import Iterable

from ros2wasm import types


def get_interface_packages() -> dict[str, str]:
    """Package -> the prefix that it is installed in."""
    found: dict[str, str] = {}
    for prefix in types.prefixes():
        share = os.path.join(prefix, 'share')
        for name in sorted(os.listdir(share)) if os.path.isdir(share) else []:
            if name not in found and any(os.path.isdir(os.path.join(share, name, kind)) for kind in types.KINDS):
                found[name] = prefix
    return found


def _known(package: str) -> bool:
    return any(os.path.isdir(os.path.join(prefix, 'share', package)) for prefix in types.prefixes())


def _interfaces(package_names: Iterable[str], kinds: Iterable[str]) -> dict[str, list[str]]:
    """Package -> names such as `msg/String`, of packages that have any."""
    kinds = list(kinds)
    found: dict[str, list[str]] = {}
    for package in list(package_names) or get_interface_packages():
        if not _known(package):
            raise LookupError(f"Unknown package '{package}'")
        names = [f'{kind}/{name}' for kind in kinds for name in types.names_in(package, kind)]
        if names:
            found[package] = names
    return found


def get_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    """Of these packages, or of all. LookupError: there is no such package."""
    return _interfaces(package_names, types.KINDS)


def get_message_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    return _interfaces(package_names, ['msg'])


def get_service_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    return _interfaces(package_names, ['srv'])


def get_action_interfaces(package_names: Iterable[str] = ()) -> dict[str, list[str]]:
    return _interfaces(package_names, ['action'])


def get_interface_path(interface_name: str) -> str:
    """The file of `std_msgs/msg/String` or `std_msgs/msg/String.msg`."""
    parts = interface_name.split('/')
    if len(parts) < 2:
        raise ValueError(f"Invalid name '{interface_name}'. Expected at least two parts separated by '/'")
    if not all(parts):
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain empty parts")
    if '..' in parts:
        raise ValueError(f"Invalid name '{interface_name}'. Must not contain '..'")
    if not _known(parts[0]):
        raise LookupError(f"Unknown package '{parts[0]}'")
    endings = [''] if '.' in parts[-1] else [f'.{parts[-2]}', '.idl']
    tried = [os.path.join(prefix, 'share', interface_name + ending)
             for ending in endings for prefix in types.prefixes()]
    for path in tried:
        if os.path.exists(path):
            return path
    raise LookupError(f"Could not find the interface '{tried[-1]}'")
