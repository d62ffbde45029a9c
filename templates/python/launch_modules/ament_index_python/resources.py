"""The index of resources: of packages only, which are all that a site's index has."""
from __future__ import annotations

from .packages import PackageNotFoundError, get_package_prefix

_PACKAGES = 'packages'


def has_resource(resource_type: str, resource_name: str) -> str | bool:
    """The prefix where it is, or False."""
    if resource_type != _PACKAGES:
        return False
    try:
        return get_package_prefix(resource_name)
    except PackageNotFoundError:
        return False


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    """What the index says of it, and the prefix."""
    prefix = has_resource(resource_type, resource_name)
    if not isinstance(prefix, str):
        raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")
    return '', prefix
