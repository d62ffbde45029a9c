"""Checks namespaces."""
from __future__ import annotations

from rclpy.exceptions import InvalidNamespaceException
from ros2wasm import names


def validate_namespace(namespace: str) -> bool:
    """Return True, or raise InvalidNamespaceException."""
    problem = names.check_namespace(namespace)
    if problem is not None:
        raise InvalidNamespaceException(namespace, *problem)
    return True
