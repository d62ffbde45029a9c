"""Peer (peer.ts) as a Python program on ros2wasm.host: carries out one command of a scene after another."""
from __future__ import annotations

import signal
import struct
from typing import Any

import js
from pyodide.ffi import to_js

from ros2wasm import graph_snapshot, host
from ros2wasm.codec import PAYLOAD_AT
from ros2wasm.constants import Durability, EndpointKind, History, Liveliness, Reliability, StatusKind

MS = 1_000_000
DEFAULT_QOS = graph_snapshot.Qos(
    reliability=Reliability.RELIABLE, durability=Durability.VOLATILE, history=History.KEEP_LAST, depth=10,
    liveliness=Liveliness.AUTOMATIC, deadline_ns=0, lifespan_ns=0, lease_ns=0)
IN_NS = {'deadline': 'deadline_ns', 'lifespan': 'lifespan_ns', 'lease': 'lease_ns'}


class RawCodec:
    """Writes bytes as they are, in place of a message with its CDR header."""

    @staticmethod
    def write(message: bytes, view: memoryview, _at: int) -> int:
        view[:len(message)] = message
        return len(message)


def plain_sample(data: bytes, info: host.SampleInfo) -> dict[str, Any]:
    return {
        'bytes': data, 'sequence': info.sequence, 'relatedSequence': info.related_sequence,
        'relatedGid': info.related_gid, 'writerGid': info.writer_gid, 'sourceTimestamp': info.source_timestamp_ns,
    }


def plain_status(status: host.Status | None) -> dict[str, int] | None:
    if status is None:
        return None
    return {
        'totalCount': status.total_count, 'totalChange': status.total_change, 'currentCount': status.current_count,
        'currentChange': status.current_change, 'lastPolicy': status.last_policy,
    }


def plain_endpoint(one: graph_snapshot.GraphEndpoint, nodes: list[graph_snapshot.GraphNode]) -> dict[str, Any]:
    qos = {
        'reliability': one.qos.reliability, 'durability': one.qos.durability, 'history': one.qos.history,
        'depth': one.qos.depth, 'liveliness': one.qos.liveliness, 'deadline': one.qos.deadline_ns,
        'lifespan': one.qos.lifespan_ns, 'lease': one.qos.lease_ns,
    }
    return {
        'kind': one.kind, 'node': nodes.index(one.node), 'name': one.name, 'type': one.type, 'hash': one.hash,
        'qos': qos, 'gid': one.gid,
    }


class Peer:
    """The methods are those of peer.ts, and so are their names."""

    def __init__(self) -> None:
        self.endpoints: dict[int, host.Endpoint] = {}
        self.interrupted = False

    def node(self, name: str, namespace: str = '/') -> int:
        return host.node_create(name, namespace)

    def destroyNode(self, node: int) -> None:
        host.node_destroy(node)

    def endpoint(self, kind: EndpointKind, options: dict[str, Any]) -> int:
        asked = {IN_NS.get(name, name): value for name, value in options.get('qos', {}).items()}
        made = host.Endpoint(
            kind, options['node'], options['name'], options.get('type', 'test_msgs/msg/Any'), options.get('hash', ''),
            DEFAULT_QOS._replace(**asked), options.get('flags', 0))
        self.endpoints[made.handle] = made
        return made.handle

    def publisher(self, options: dict[str, Any]) -> int:
        return self.endpoint(EndpointKind.PUBLISHER, options)

    def subscription(self, options: dict[str, Any]) -> int:
        return self.endpoint(EndpointKind.SUBSCRIPTION, options)

    def client(self, options: dict[str, Any]) -> int:
        return self.endpoint(EndpointKind.CLIENT, options)

    def server(self, options: dict[str, Any]) -> int:
        return self.endpoint(EndpointKind.SERVER, options)

    def of(self, handle: int) -> host.Endpoint:
        """Also one that nobody made: the link must refuse it."""
        found = self.endpoints.get(handle)
        if found is None:
            found = object.__new__(host.Endpoint)
            found.handle = handle
        return found

    def destroy(self, handle: int) -> None:
        self.endpoints.pop(handle).destroy()

    def gid(self, handle: int) -> bytes:
        return self.endpoints[handle].gid

    def write(self, handle: int, data: bytes, options: dict[str, Any] | None = None) -> int:
        """With success the sequence number."""
        about = options or {}
        if not about:
            return self.of(handle).write_bytes(bytes(data)).sequence
        try:
            info = self.of(handle).write(
                RawCodec, bytes(data), about.get('relatedSequence', 0), bytes(about.get('relatedGid', bytes(16))))
        finally:
            host._out.view[:PAYLOAD_AT] = host.CDR_HEADER
        return info.sequence

    def writeMany(self, handle: int, first: int, count: int, size: int = 4) -> int:
        endpoint, data = self.of(handle), bytearray(size)
        for number in range(first, first + count):
            struct.pack_into('<i', data, 0, number)
            endpoint.write_bytes(bytes(data))
        return count

    def take(self, handle: int) -> dict[str, Any] | None:
        taken = self.of(handle).take_bytes()
        return None if taken is None else plain_sample(*taken)

    def takeNext(self, handle: int) -> dict[str, Any]:
        while True:
            token = host.wake_token()
            if handle in host.ready():
                sample = self.take(handle)
                if sample is not None:
                    return sample
            host.wait(token, -1)

    def flood(self, handle: int, largest: int) -> None:
        """Without end: only a kill ends it."""
        endpoint, i = self.of(handle), 0
        while True:
            i += 1
            endpoint.write_bytes(bytes((i & 255,)) * (1 + (i * 7919) % largest))

    def makeForEver(self, name: str) -> None:
        while True:
            node = self.node('maker')
            made = self.publisher({'node': node, 'name': name})
            self.write(made, bytes((255,)) * 3000)
            self.destroy(made)
            self.destroyNode(node)

    def verify(self, handle: int, count: int) -> int:
        newest: dict[bytes, int] = {}
        for _ in range(count):
            sample = self.takeNext(handle)
            sequence, writer = sample['sequence'], sample['writerGid']
            if sequence <= newest.get(writer, 0):
                raise ValueError(f'{sequence} after {newest[writer]}')
            newest[writer] = sequence
            if sample['bytes'].count(sequence & 255) != len(sample['bytes']):
                raise ValueError(f'sample {sequence} is torn')
        return len(newest)

    @staticmethod
    def number(sample: dict[str, Any]) -> int:
        return int(struct.unpack_from('<i', sample['bytes'])[0])

    def takeUntil(self, handle: int, last: int) -> list[int]:
        numbers: list[int] = []
        while not numbers or numbers[-1] != last:
            numbers.append(self.number(self.takeNext(handle)))
        return numbers

    def takeNumbers(self, handle: int) -> list[int]:
        numbers = []
        while (sample := self.take(handle)) is not None:
            numbers.append(self.number(sample))
        return numbers

    def ready(self) -> list[int]:
        return host.ready()

    def answer(self, handle: int, request: dict[str, Any]) -> int:
        about = {name: request[name] for name in ('relatedSequence', 'relatedGid')}
        return self.write(handle, bytes((byte + 1) & 255 for byte in request['bytes']), about)

    def serve(self, handle: int) -> int:
        served = 0
        while True:
            request = self.takeNext(handle)
            self.answer(handle, request)
            if request['bytes'][0] == 255:
                return served
            served += 1

    def serveReversed(self, handle: int, count: int) -> list[int]:
        requests = [self.takeNext(handle) for _ in range(count)]
        return [self.answer(handle, request) for request in reversed(requests)]

    def matched(self, handle: int) -> int:
        return int(host.js.matched(handle))

    def waitMatched(self, handle: int, count: int) -> int:
        while True:
            token = host.wake_token()
            if self.of(handle).matched() == count:
                return count
            host.wait(token, -1)

    def status(self, handle: int, kind: int) -> dict[str, int] | None:
        return plain_status(self.of(handle).status(StatusKind(kind)))

    def waitStatus(self, handle: int, kind: int, count: int) -> dict[str, int]:
        change = 0
        while True:
            token = host.wake_token()
            status = self.status(handle, kind)
            if status is not None:
                change += status['totalChange']
                if status['totalCount'] >= count:
                    return {**status, 'totalChange': change}
            host.wait(token, -1)

    def waitAlive(self, handle: int, count: int) -> dict[str, int]:
        alive = dead = 0
        while True:
            token = host.wake_token()
            status = self.status(handle, StatusKind.LIVELINESS_CHANGED)
            if status is not None:
                alive, dead = alive + status['currentChange'], dead + status['totalChange']
                if status['currentCount'] == count:
                    return {**status, 'currentChange': alive, 'totalChange': dead}
            host.wait(token, -1)

    def waitStatusVersion(self, version: int) -> int:
        while True:
            token = host.wake_token()
            now = host.status_version()
            if now != version:
                return now
            host.wait(token, -1)

    def statusVersion(self) -> int:
        return host.status_version()

    def assertLiveliness(self, handle: int) -> int:
        self.of(handle).assert_liveliness()
        return 0

    def graph(self) -> dict[str, Any]:
        nodes, endpoints = host.graph()
        return {
            'nodes': [{'participant': one.participant, 'namespace': one.namespace, 'name': one.name} for one in nodes],
            'endpoints': [plain_endpoint(one, nodes) for one in endpoints],
        }

    def waitGraph(self, endpoints: int, nodes: int = -1) -> dict[str, Any]:
        while True:
            token = host.wake_token()
            host.graph_version()
            graph = self.graph()
            if len(graph['endpoints']) == endpoints and (nodes < 0 or len(graph['nodes']) == nodes):
                return graph
            host.wait(token, -1)

    def wait(self, timeout_ms: float) -> int:
        return self.told(host.wait(host.wake_token(), -1 if timeout_ms < 0 else int(timeout_ms * MS)))

    def sleep(self, duration_ms: float) -> int:
        return self.told(host.sleep(int(duration_ms * MS)))

    def waitOut(self, timeout_ms: float) -> int:
        end = host.steady_ns() + int(timeout_ms * MS)
        while True:
            result = self.told(host.wait(host.wake_token(), max(0, end - host.steady_ns())))
            if result != host.WOKEN:
                return result

    def steadyMs(self) -> float:
        return host.steady_ns() / MS

    def heldMs(self) -> float:
        while not js.scene.isHeld():
            host.wait(host.wake_token(), 0)
        return self.steadyMs()

    def untilNs(self, steady_ns: float) -> None:
        # Python's clock is made of milliseconds.
        while host.steady_ns() + MS // 1000 < steady_ns:
            host.wait(host.wake_token(), 0)

    def told(self, result: int) -> int:
        """Python is told once of a stop, by the result of a wait or, a moment before the wait begins, as of Ctrl-C."""
        return host.STOP if self.interrupted else result

    def interrupt(self, *_: object) -> None:
        self.interrupted = True

    def stopRequested(self) -> bool:
        return host.stop_requested()


def main() -> None:
    # A stop ends waits here; it raises nothing.
    peer = Peer()
    signal.signal(signal.SIGINT, peer.interrupt)
    while True:
        # The input only means that there is a command.
        host.read_input(1)
        command = js.scene.take().to_py()
        if command['call'] == 'open':
            # Another scene, on another link.
            host.forget_stop()
            peer = Peer()
            signal.signal(signal.SIGINT, peer.interrupt)
            js.scene.answer('open')
            continue
        try:
            value = getattr(peer, command['call'])(*command['args'])
        except host.BusError as error:
            value = int(error.code)
        except Exception as error:
            js.scene.fail(f'{type(error).__name__}: {error}')
            continue
        js.scene.answer(to_js(value, dict_converter=js.Object.fromEntries))


main()
