"""What a node sees of the graph."""
from __future__ import annotations

import time
from collections.abc import Callable, Iterable
from typing import Any

from rclpy._rclpy_pybind11 import NodeNameNonExistentError
from rclpy.impl.node_base import NodeBase
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum
from ros2wasm import host, meanwhile, names
from ros2wasm.constants import EndpointKind
from ros2wasm.graph_snapshot import GraphEndpoint

NS = 1_000_000_000
NamesAndTypes = list[tuple[str, list[str]]]


def gather(endpoints: Iterable[GraphEndpoint]) -> NamesAndTypes:
    """Names with their types, both in order."""
    found: dict[str, set[str]] = {}
    for one in endpoints:
        found.setdefault(one.name, set()).add(one.type)
    return [(name, sorted(types)) for name, types in sorted(found.items())]


class NodeGraph(NodeBase):
    def _rw_endpoints(self, *kinds: EndpointKind) -> list[GraphEndpoint]:
        return [one for one in host.graph()[1] if one.kind in kinds]

    def _rw_of_node(self, node_name: str, node_namespace: str, kind: EndpointKind) -> NamesAndTypes:
        space = node_namespace or '/'
        if not any(one.name == node_name and one.namespace == space for one in host.graph()[0]):
            raise NodeNameNonExistentError(
                f"Cannot get names and types for nonexistent node: name '{node_name}' namespace '{space}'")
        return gather(one for one in self._rw_endpoints(kind)
                      if one.node.name == node_name and one.node.namespace == space)

    def get_publisher_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        return self._rw_of_node(node_name, node_namespace, EndpointKind.PUBLISHER)

    def get_subscriber_names_and_types_by_node(
        self, node_name: str, node_namespace: str, no_demangle: bool = False
    ) -> NamesAndTypes:
        return self._rw_of_node(node_name, node_namespace, EndpointKind.SUBSCRIPTION)

    def get_service_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        return self._rw_of_node(node_name, node_namespace, EndpointKind.SERVER)

    def get_client_names_and_types_by_node(self, node_name: str, node_namespace: str) -> NamesAndTypes:
        return self._rw_of_node(node_name, node_namespace, EndpointKind.CLIENT)

    def get_topic_names_and_types(self, no_demangle: bool = False) -> NamesAndTypes:
        return gather(self._rw_endpoints(EndpointKind.PUBLISHER, EndpointKind.SUBSCRIPTION))

    def get_service_names_and_types(self) -> NamesAndTypes:
        return gather(self._rw_endpoints(EndpointKind.SERVER, EndpointKind.CLIENT))

    def get_node_names(self) -> list[str]:
        return [one.name for one in host.graph()[0]]

    def get_fully_qualified_node_names(self) -> list[str]:
        return [names.join(one.namespace, one.name) for one in host.graph()[0]]

    def get_node_names_and_namespaces(self) -> list[tuple[str, str]]:
        return [(one.name, one.namespace) for one in host.graph()[0]]

    def get_node_names_and_namespaces_with_enclaves(self) -> list[tuple[str, str, str]]:
        return [(one.name, one.namespace, '/') for one in host.graph()[0]]

    def _rw_count(self, name: str, kind: EndpointKind, is_service: bool) -> int:
        full = self._rw_resolve(name, is_service)
        return sum(one.name == full for one in self._rw_endpoints(kind))

    def count_publishers(self, topic_name: str) -> int:
        return self._rw_count(topic_name, EndpointKind.PUBLISHER, False)

    def count_subscribers(self, topic_name: str) -> int:
        return self._rw_count(topic_name, EndpointKind.SUBSCRIPTION, False)

    def count_clients(self, service_name: str) -> int:
        return self._rw_count(service_name, EndpointKind.CLIENT, True)

    def count_services(self, service_name: str) -> int:
        return self._rw_count(service_name, EndpointKind.SERVER, True)

    def _rw_infos(self, topic_name: str, no_mangle: bool, kind: EndpointKind) -> list[TopicEndpointInfo]:
        full = topic_name if no_mangle else self._rw_resolve(topic_name, False)
        return [TopicEndpointInfo._from_graph(one, TopicEndpointTypeEnum(int(kind)))
                for one in self._rw_endpoints(kind) if one.name == full]

    def get_publishers_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        return self._rw_infos(topic_name, no_mangle, EndpointKind.PUBLISHER)

    def get_subscriptions_info_by_topic(self, topic_name: str, no_mangle: bool = False) -> list[TopicEndpointInfo]:
        return self._rw_infos(topic_name, no_mangle, EndpointKind.SUBSCRIPTION)

    def wait_for_node(self, fully_qualified_node_name: str, timeout: float) -> bool:
        wanted = fully_qualified_node_name
        wanted = wanted if wanted.startswith('/') else f'/{wanted}'
        return self._rw_wait_for_graph(lambda: wanted in self.get_fully_qualified_node_names(), timeout)

    def _rw_wait_for_graph(self, holds: Callable[[], Any], timeout: float) -> bool:
        end = time.monotonic_ns() + int(timeout * NS)
        while self._context.ok():
            token = host.wake_token()
            # From the first look at the version on, each change of the graph ends a wait.
            host.graph_version()
            if holds():
                return True
            left = end - time.monotonic_ns()
            if left <= 0:
                return False
            meanwhile.wait(token, left)
        return False
