"""Makes full names."""
from __future__ import annotations

from rclpy.exceptions import InvalidTopicNameException
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name
from ros2wasm import names


def expand_topic_name(topic_name: str, node_name: str, node_namespace: str) -> str:
    """The full name of a topic that a node names. Exceptions say which of the three names is wrong."""
    validate_topic_name(topic_name)
    validate_node_name(node_name)
    validate_namespace(node_namespace or '/')
    try:
        return names.expand(topic_name, node_name, node_namespace or '/')
    except ValueError as error:
        raise InvalidTopicNameException(topic_name, str(error), topic_name.find('{')) from None
