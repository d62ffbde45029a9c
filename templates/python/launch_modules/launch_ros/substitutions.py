"""launch_ros's substitutions."""
from __future__ import annotations

from typing import Any

from ament_index_python.packages import get_package_prefix, get_package_share_directory
from launch.substitutions import Called, PathJoinSubstitution
from launch.utilities import normalize_to_list_of_substitutions


class FindPackage(Called):
    """What packages are found by."""

    def __init__(self, name: str, package: Any) -> None:
        super().__init__(name, package)
        self.package = normalize_to_list_of_substitutions(package)

    def find(self, package_name: str) -> str:
        """At once, of any package."""
        raise NotImplementedError(f'{type(self).__name__} finds nothing')

    def __truediv__(self, other: Any) -> PathJoinSubstitution:
        return PathJoinSubstitution([self, other])


class FindPackagePrefix(FindPackage):
    def __init__(self, package: Any) -> None:
        super().__init__('find-pkg-prefix', package)

    def find(self, package_name: str) -> str:
        return get_package_prefix(package_name)


class FindPackageShare(FindPackage):
    def __init__(self, package: Any) -> None:
        super().__init__('find-pkg-share', package)

    def find(self, package_name: str) -> str:
        return get_package_share_directory(package_name)


class ExecutableInPackage(Called):
    def __init__(self, executable: Any, package: Any) -> None:
        super().__init__('exec-in-pkg', executable, package)


class Parameter(Called):
    def __init__(self, name: Any, *, default: Any = None) -> None:
        super().__init__('param', name, str(default) if isinstance(default, (bool, int, float)) else default)
