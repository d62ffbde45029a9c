"""Resources: small files of packages, filed by what they are."""
from __future__ import annotations

import os

from .constants import RESOURCE_INDEX_SUBFOLDER
from .search_paths import get_search_paths

FORBIDDEN = ('/', '\\')


class InvalidResourceTypeNameError(ValueError):
    """The name of a kind of resources has a separator in it."""


class InvalidResourceNameError(ValueError):
    """The name of a resource has a separator in it."""


def name_is_invalid(resource_name: str) -> bool:
    """Tell whether a name would lead out of its folder."""
    return any(one in resource_name for one in FORBIDDEN)


def _check(resource_type: str, resource_name: str | None = None) -> None:
    if not resource_type:
        raise AssertionError('The resource type must not be empty')
    if name_is_invalid(resource_type):
        raise InvalidResourceTypeNameError(f"Resource type '{resource_type}' is invalid")
    if resource_name is None:
        return
    if not resource_name:
        raise AssertionError('The resource name must not be empty')
    if name_is_invalid(resource_name):
        raise InvalidResourceNameError(f"Resource name '{resource_name}' is invalid")


def _index(prefix: str, *parts: str) -> str:
    return os.path.join(prefix, RESOURCE_INDEX_SUBFOLDER, *parts)


def has_resource(resource_type: str, resource_name: str) -> str | bool:
    """Return the prefix that has the resource, else False."""
    _check(resource_type, resource_name)
    for prefix in get_search_paths():
        if os.path.isfile(_index(prefix, resource_type, resource_name)):
            return prefix
    return False


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """Return the resource's text and its prefix. LookupError when there is none."""
    prefix = has_resource(resource_type, resource_name)
    if not isinstance(prefix, str):
        raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")
    path = _index(prefix, resource_type, resource_name)
    try:
        with open(path, encoding='utf-8') as stream:
            return stream.read(), prefix
    except OSError as error:
        raise OSError(f"Could not open the resource '{resource_name}' of type '{resource_type}':\n{error}") from error


def _listed(folder: str) -> list[str]:
    return sorted(os.listdir(folder)) if os.path.isdir(folder) else []


def get_resources(resource_type: str) -> dict[str, str]:
    """Return name -> prefix of all resources of a kind; the first prefix wins."""
    _check(resource_type)
    found: dict[str, str] = {}
    for prefix in get_search_paths():
        folder = _index(prefix, resource_type)
        for name in _listed(folder):
            if not name.startswith('.') and os.path.isfile(os.path.join(folder, name)):
                found.setdefault(name, prefix)
    return found


def get_resource_types() -> set[str]:
    """Return all kinds of resources."""
    return {name for prefix in get_search_paths() for name in _listed(_index(prefix)) if not name.startswith('.')}
