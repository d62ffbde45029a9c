"""Actions in the graph: what publishes feedback serves an action, what subscribes to it is a client."""
from __future__ import annotations

from typing import Any

from rclpy.impl.node_graph import NamesAndTypes

FEEDBACK = '/_action/feedback'
MESSAGE = '_FeedbackMessage'


def _actions(topics: NamesAndTypes) -> NamesAndTypes:
    return [(name[:-len(FEEDBACK)], [one.removesuffix(MESSAGE) for one in types])
            for name, types in topics if name.endswith(FEEDBACK)]


def get_action_client_names_and_types_by_node(
    node: Any, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """The actions that a node asks for."""
    return _actions(node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_server_names_and_types_by_node(
    node: Any, remote_node_name: str, remote_node_namespace: str
) -> NamesAndTypes:
    """The actions that a node serves."""
    return _actions(node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_names_and_types(node: Any) -> NamesAndTypes:
    """All actions that have a server or a client."""
    return _actions(node.get_topic_names_and_types())
