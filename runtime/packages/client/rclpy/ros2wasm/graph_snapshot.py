"""Nodes and endpoints of the graph as the host lays them down (runtime/site/bus/graph_snapshot.ts)."""
from __future__ import annotations

import struct
from typing import Any, NamedTuple


class Qos(NamedTuple):
    """As EndpointDesc has it; times in ns, 0: none."""

    reliability: int
    durability: int
    history: int
    depth: int
    liveliness: int
    deadline_ns: int
    lifespan_ns: int
    lease_ns: int


class GraphNode(NamedTuple):
    participant: int
    namespace: str
    name: str


class GraphEndpoint(NamedTuple):
    kind: int
    node: GraphNode
    name: str
    type: str
    hash: str
    qos: Qos
    gid: bytes


class _Cursor:
    def __init__(self, view: memoryview) -> None:
        self.view, self.at = view, 0

    def numbers(self, format_: str) -> tuple[Any, ...]:
        found = struct.unpack_from('<' + format_, self.view, self.at)
        self.at += struct.calcsize('<' + format_)
        return found

    def text(self) -> str:
        length, = self.numbers('I')
        self.at += length
        return str(self.view[self.at - length:self.at], 'utf-8')


def read_graph(view: memoryview) -> tuple[list[GraphNode], list[GraphEndpoint]]:
    cursor = _Cursor(view)
    nodes = []
    for _ in range(cursor.numbers('I')[0]):
        participant, = cursor.numbers('I')
        namespace = cursor.text()
        nodes.append(GraphNode(participant, namespace, cursor.text()))
    endpoints = []
    for _ in range(cursor.numbers('I')[0]):
        kind, node = cursor.numbers('II')
        name, type_, hash_ = cursor.text(), cursor.text(), cursor.text()
        qos = Qos(*cursor.numbers('IIIIIqqq'))
        endpoints.append(GraphEndpoint(kind, nodes[node], name, type_, hash_, qos, cursor.numbers('16s')[0]))
    return nodes, endpoints
