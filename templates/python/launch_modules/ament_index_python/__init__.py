"""Where packages are, as launch files ask for it."""
from __future__ import annotations

from .packages import (PackageNotFoundError, get_package_prefix, get_package_share_directory, get_package_share_path,
                       get_packages_with_prefixes)
from .resources import get_resource, has_resource

__all__ = ['PackageNotFoundError', 'get_package_prefix', 'get_package_share_directory', 'get_package_share_path',
           'get_packages_with_prefixes', 'get_resource', 'has_resource']
