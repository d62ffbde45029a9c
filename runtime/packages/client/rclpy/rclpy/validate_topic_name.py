"""Checks names of topics and services before they are expanded."""
from __future__ import annotations

from rclpy.exceptions import InvalidServiceNameException, InvalidTopicNameException
from ros2wasm import names

TOPIC_SEPARATOR_STRING = '/'


def validate_topic_name(name: str, *, is_service: bool = False) -> bool:
    """Return True, or raise InvalidTopicNameException or InvalidServiceNameException."""
    problem = names.check_topic_name(name)
    if problem is not None:
        raise (InvalidServiceNameException if is_service else InvalidTopicNameException)(name, *problem)
    return True
