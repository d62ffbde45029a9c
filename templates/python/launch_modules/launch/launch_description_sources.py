"""Where an included launch file is."""
from __future__ import annotations

from typing import Any

from ros2wasm_launch.texts import text_of


class InvalidLaunchFileError(Exception):
    """A launch file that cannot be read."""


class InvalidPythonLaunchFileError(InvalidLaunchFileError):
    """One in Python."""


class InvalidFrontendLaunchFileError(InvalidLaunchFileError):
    """One in XML or YAML."""


class LaunchDescriptionSource:
    """A path, or a description that is there already."""

    def __init__(self, launch_description: Any = None, location: Any = '', method: str = '') -> None:
        self.launch_description = launch_description
        self._location = location
        self.method = method

    @property
    def location(self) -> str:
        return self._location if isinstance(self._location, str) else text_of(self._location)


class _File(LaunchDescriptionSource):
    def __init__(self, launch_file_path: Any) -> None:
        super().__init__(None, launch_file_path, type(self).__name__)


class PythonLaunchDescriptionSource(_File):
    pass


class AnyLaunchDescriptionSource(_File):
    pass


class FrontendLaunchDescriptionSource(_File):
    def __init__(self, launch_file_path: Any, *, parser: Any = None) -> None:
        super().__init__(launch_file_path)
