"""What the graph says of one endpoint."""
from __future__ import annotations

from enum import IntEnum
from typing import Any

from rclpy.qos import QoSProfile, from_bus
from rclpy.type_hash import TypeHash
from ros2wasm.graph_snapshot import GraphEndpoint


class TopicEndpointTypeEnum(IntEnum):
    """Whether an endpoint publishes or subscribes."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """What the graph knows of one endpoint."""

    def __init__(
        self, node_name: str = '', node_namespace: str = '', topic_type: str = '',
        topic_type_hash: TypeHash | None = None,
        endpoint_type: TopicEndpointTypeEnum = TopicEndpointTypeEnum.INVALID, endpoint_gid: list[int] | None = None,
        qos_profile: QoSProfile | None = None
    ) -> None:
        self.node_name = node_name
        self.node_namespace = node_namespace
        self.topic_type = topic_type
        self.topic_type_hash = TypeHash() if topic_type_hash is None else topic_type_hash
        self.endpoint_type = endpoint_type
        self.endpoint_gid = [] if endpoint_gid is None else endpoint_gid
        self.qos_profile: Any = qos_profile

    @classmethod
    def _from_graph(cls, of: GraphEndpoint, kind: TopicEndpointTypeEnum) -> TopicEndpointInfo:
        return cls(of.node.name, of.node.namespace, of.type, TypeHash._from_text(of.hash), kind, list(of.gid),
                   from_bus(of.qos))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TopicEndpointInfo) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        gid = '.'.join(format(x, '02x') for x in self.endpoint_gid)
        if self.qos_profile is None:
            return f'Node name: {self.node_name}'
        history = f'{self.qos_profile.history.name} ({self.qos_profile.depth})' \
            if self.qos_profile.history.name == 'KEEP_LAST' else self.qos_profile.history.name

        def time(duration: Any) -> str:
            return str(duration) if str(duration) == 'Infinite' else f'{duration.nanoseconds} nanoseconds'
        return '\n'.join([
            f'Node name: {self.node_name}',
            f'Node namespace: {self.node_namespace}',
            f'Topic type: {self.topic_type}',
            f'Topic type hash: {self.topic_type_hash}',
            f'Endpoint type: {self.endpoint_type.name}',
            f'GID: {gid}',
            'QoS profile:',
            f'  Reliability: {self.qos_profile.reliability.name}',
            f'  History (Depth): {history}',
            f'  Durability: {self.qos_profile.durability.name}',
            f'  Lifespan: {time(self.qos_profile.lifespan)}',
            f'  Deadline: {time(self.qos_profile.deadline)}',
            f'  Liveliness: {self.qos_profile.liveliness.name}',
            f'  Liveliness lease duration: {time(self.qos_profile.liveliness_lease_duration)}',
        ])
