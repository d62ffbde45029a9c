"""launch_ros's substitutions."""
from __future__ import annotations

from typing import Any

from launch.substitutions import Called, PathJoinSubstitution


class FindPackage(Called):
    """What packages are found by."""

    def __truediv__(self, other: Any) -> PathJoinSubstitution:
        return PathJoinSubstitution([self, other])


class FindPackagePrefix(FindPackage):
    def __init__(self, package: Any) -> None:
        super().__init__('find-pkg-prefix', package)


class FindPackageShare(FindPackage):
    def __init__(self, package: Any) -> None:
        super().__init__('find-pkg-share', package)


class ExecutableInPackage(Called):
    def __init__(self, executable: Any, package: Any) -> None:
        super().__init__('exec-in-pkg', executable, package)


class Parameter(Called):
    def __init__(self, name: Any, *, default: Any = None) -> None:
        super().__init__('param', name, str(default) if isinstance(default, (bool, int, float)) else default)
