"""What runs a launch file natively."""
from __future__ import annotations

from typing import Any


class LaunchService:
    """A launch file that starts its own service is a program; a site has one launch, which the page runs."""

    def __init__(self, **_options: Any) -> None:
        raise NotImplementedError('a launch file gives back its description; a LaunchService is a program')


class LaunchIntrospector:
    """Describes descriptions, of files that are run as programs."""

    def format_launch_description(self, launch_description: Any) -> str:
        return '\n'.join(type(one).__name__ for one in launch_description.entities)
