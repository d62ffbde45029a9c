"""What happens to nodes."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from . import lifecycle

__all__ = ['lifecycle', 'matches_node_name']


def matches_node_name(node_name: str) -> Callable[[Any], bool]:
    return lifecycle.matches_node_name(node_name)
