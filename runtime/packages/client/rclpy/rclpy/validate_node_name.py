"""Checks node names."""
from __future__ import annotations

from rclpy.exceptions import InvalidNodeNameException
from ros2wasm import names


def validate_node_name(node_name: str) -> bool:
    """Return True, or raise InvalidNodeNameException."""
    problem = names.check_node_name(node_name)
    if problem is not None:
        raise InvalidNodeNameException(node_name, *problem)
    return True
