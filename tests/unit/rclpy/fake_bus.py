"""A bus within one process, for tests of the Python half: all that is written is there at once. Its waits that nothing
would end fail the test. Threads are those of the operating system, of which one runs at a time.
"""
from __future__ import annotations

import importlib
import struct
import sys
import threading
import time
import types
import unittest
from array import array
from bisect import bisect_right
from collections import deque
from collections.abc import Callable
from typing import Any
from unittest import mock

from tests.unit.rclpy.installation import install

WOKEN, TIMEOUT, STOP = 0, 1, 2
NOTHING, BAD_HANDLE = -1, -1
PUBLISHER, SUBSCRIPTION, CLIENT, SERVER = 1, 2, 3, 4
READERS = {PUBLISHER: SUBSCRIPTION, CLIENT: SERVER, SERVER: CLIENT}
PEERS = {**READERS, SUBSCRIPTION: PUBLISHER}
PENDING = -1 << 31


class Reader:
    """An endpoint; its queue holds payloads with their SampleInfo."""

    def __init__(self, handle: int, kind: int, name: str) -> None:
        self.handle, self.kind, self.name = handle, kind, name
        self.gid = handle.to_bytes(16, 'little')
        self.sequence = 0
        self.queue: deque[tuple[bytes, bytes]] = deque()


class FakeBus(types.ModuleType):
    """The module `ros2wasm_host`."""

    def __init__(self) -> None:
        super().__init__('ros2wasm_host')
        self.wakes = 0
        self.endpoints: dict[int, Reader] = {}
        self.handles = 0
        self._bases: list[int] = []
        self._blocks: list[array[int]] = []
        self._parked: dict[int, threading.Semaphore] = {}
        self._next: list[Callable[[], None]] = []
        self._pending: Any = None
        #: Called at each wait of no time, as a turn of the event loop is.
        self.on_turn: Callable[[], None] = lambda: None
        self.turns = 0
        self.stops = 0
        self.stops_told = 0
        #: Whether a stack has had its slice of time.
        self.slice_over = False
        self.log: list[tuple[Any, ...]] = []
        #: What was typed, message by message.
        self.typed: deque[bytes] = deque()
        self.rest = b''
        #: Whether there is a visitor.
        self.page = True
        #: As the program has set it, the newest last.
        self.terminal_modes: list[int] = []

    # ---- memory

    def address(self, block: 'array[int]') -> int:
        base = self._bases[-1] + len(self._blocks[-1]) + 4096 & -16 if self._bases else 4096
        self._bases.append(base)
        self._blocks.append(block)
        return base

    def _memory(self, address: int, length: int) -> memoryview:
        at = bisect_right(self._bases, address) - 1
        start = address - self._bases[at]
        return memoryview(self._blocks[at])[start:start + length]

    # ---- nodes and endpoints

    def node_create(self, *_: int) -> int:
        return 1

    def node_destroy(self, _: int) -> None:
        pass

    def endpoint_create(self, desc: int) -> int:
        kind, _, name, length = struct.unpack('<IIII', self._memory(desc, 16))
        self.handles += 1
        self.endpoints[self.handles] = Reader(self.handles, kind, bytes(self._memory(name, length)).decode())
        self.wake()
        return self.handles

    def endpoint_gid(self, handle: int, out: int) -> int:
        self._memory(out, 16)[:] = self.endpoints[handle].gid
        return 0

    def endpoint_destroy(self, handle: int) -> None:
        del self.endpoints[handle]
        self.wake()

    def endpoint_status(self, *_: int) -> int:
        return BAD_HANDLE

    def matched(self, handle: int) -> int:
        own = self.endpoints[handle]
        return len([one for one in self.endpoints.values() if one.name == own.name and one.kind == PEERS[own.kind]])

    def status_version(self) -> int:
        return 0

    def graph_version(self) -> int:
        return self.handles

    def graph_snapshot(self, out: int, _capacity: int) -> int:
        self._memory(out, 8)[:] = bytes(8)
        return 8

    # ---- messages

    def write(self, handle: int, data: int, length: int, info: int) -> int:
        writer = self.endpoints[handle]
        payload = bytes(self._memory(data, length))
        related_sequence, = struct.unpack('<q', self._memory(info + 24, 8))
        related_gid = bytes(self._memory(info + 32, 16))
        writer.sequence += 1
        if writer.kind == CLIENT:
            related_sequence, related_gid = writer.sequence, writer.gid
        about = struct.pack(
            '<IIqqq16s16s', length, 0, writer.sequence, 0, related_sequence, related_gid, writer.gid)
        self._memory(info, len(about))[:] = about
        for reader in self.endpoints.values():
            if reader.name != writer.name or reader.kind != READERS.get(writer.kind):
                continue
            if writer.kind != SERVER or reader.gid == related_gid:
                reader.queue.append((payload, about))
        self.wake()
        return 0

    def take(self, handle: int, out: int, capacity: int, info: int) -> int:
        return self._take(handle, out, capacity, info)

    def _take(self, handle: int, out: int, capacity: int, info: int) -> int:
        queue = self.endpoints[handle].queue
        if not queue:
            return NOTHING
        payload, about = queue[0]
        if len(payload) <= capacity:
            queue.popleft()
            self._memory(out, len(payload))[:] = payload
            self._memory(info, len(about))[:] = about
        return len(payload)

    def ready(self, out: int, _capacity: int) -> int:
        found = [one.handle for one in self.endpoints.values() if one.queue]
        self._memory(out, 4 * len(found))[:] = struct.pack(f'<{len(found)}I', *found)
        return len(found)

    def publisher(self, handle: int, places: int) -> Callable[[int], int]:
        def publish(length: int) -> int:
            info, data = struct.unpack('<II', self._memory(places + 16, 8))
            self._memory(info, 64)[:] = bytes(64)
            return self.write(handle, data, length, info) or int(self.slice_over)
        return publish

    def hearer(self, handle: int, out: int, capacity: int) -> Callable[[int], int]:
        return lambda statuses: self.look(out, capacity, handle, statuses)

    def look(self, out: int, capacity: int, expected: int, statuses: int) -> int:
        count = self.ready(out + 24, capacity)
        self._memory(out, 8)[:] = struct.pack('<ii', self.wake_token(), self.status_version())
        place, room, info = struct.unpack('<III', self._memory(out + 8, 12))
        first, = struct.unpack('<i', self._memory(out + 24, 4))
        if (count, first, self.status_version()) == (1, expected, statuses):
            length = self._take(expected, place, room, info)
            if 0 <= length <= room:
                return ~length
        return count

    # ---- waiting

    def wake(self) -> None:
        self.wakes += 1

    def wake_token(self) -> int:
        return self.wakes

    def wait(self, token: int, low: int, high: int) -> int:
        if low == high == 0:
            self.turns += 1
            self.on_turn()
        if self.stops_told < self.stops:
            self.stops_told = self.stops
            return STOP
        if token != self.wakes:
            return WOKEN
        if high < 0:
            raise AssertionError('nothing would end this wait')
        time.sleep(min(0.001, (low + (high << 32)) / 1e9))
        return TIMEOUT

    def sleep(self, low: int, high: int) -> int:
        time.sleep((low + (high << 32)) / 1e9)
        return WOKEN

    def stop_requested(self) -> bool:
        return self.stops > 0

    def take_stop(self) -> bool:
        news = self.stops_told < self.stops
        self.stops_told = self.stops
        return news

    # ---- standard input

    def input_is_there(self) -> int:
        if self.stops_told < self.stops:
            return 2
        return int(bool(self.rest or self.typed))

    def show_output(self) -> None:
        pass

    def has_page(self) -> bool:
        return self.page

    def terminal_mode(self, mode: int) -> None:
        self.terminal_modes.append(mode)

    def read_input(self, capacity: int) -> Any:
        """As the loader's: a part of one message."""
        if not self.rest and not self.typed:
            raise AssertionError('nothing would end this read')
        if not self.rest:
            self.rest = self.typed.popleft()
        part, self.rest = self.rest[:capacity], self.rest[capacity:]
        return types.SimpleNamespace(to_bytes=lambda: part)

    # ---- stacks

    def set_threads(self, _count: int) -> None:
        pass

    def thread_runs(self, ident: int, is_main: bool) -> None:
        self.slice_over = False
        self.log.append((ident, is_main))

    def slice_is_over(self) -> bool:
        return self.slice_over

    def begin_thread(self, begin: Callable[[], None]) -> None:
        def run() -> None:
            begin()
            self._rest()
        self._next.append(threading.Thread(target=run, daemon=True).start)

    def park(self, ident: int) -> None:
        self._pending = self._parked[ident] = threading.Semaphore(0)

    def unpark(self, ident: int) -> None:
        self._next.append(self._parked.pop(ident).release)

    def _rest(self) -> None:
        going_on, self._next = self._next, []
        for go_on in going_on:
            go_on()

    def pending(self) -> Any:
        return self._pending

    def resumed(self) -> None:
        pass

    def run_sync(self, parked: threading.Semaphore) -> None:
        """As Pyodide's: the others go on while this stack is suspended."""
        self._rest()
        if not parked.acquire(timeout=20):
            raise AssertionError('nobody lets this stack go on')


class BusTest(unittest.TestCase):
    """A test with rclpy on a bus of its own class."""

    bus: FakeBus
    rclpy: Any
    #: Whether stacks can be suspended.
    suspends = False

    @classmethod
    def setUpClass(cls) -> None:
        install(cls)
        cls.bus = FakeBus()
        ffi = types.ModuleType('pyodide.ffi')
        setattr(ffi, 'run_sync', cls.bus.run_sync)
        setattr(ffi, 'can_run_sync', lambda: cls.suspends)
        cls.enterClassContext(mock.patch.dict(sys.modules, {
            'ros2wasm_host': cls.bus, 'pyodide': types.ModuleType('pyodide'), 'pyodide.ffi': ffi}))
        cls.rclpy = importlib.import_module('rclpy')

    def setUp(self) -> None:
        self.context = importlib.import_module('rclpy.context').Context()
        self.context.init([])
        self.addCleanup(self.context.try_shutdown)
        self.executor = self.rclpy.executors.SingleThreadedExecutor(context=self.context)

    def replace(self, name: str, function: Callable[..., Any]) -> None:
        """Another function of the host, to the end of the test."""
        forget: Callable[[], None] = importlib.import_module('ros2wasm.host').js.forget
        self.addCleanup(forget)
        self.enterContext(mock.patch.object(self.bus, name, function, create=True))
        forget()

    def node(self, name: str, **options: Any) -> Any:
        """A node of the executor."""
        made = importlib.import_module('rclpy.node').Node(name, context=self.context, **options)
        self.addCleanup(made.destroy_node)
        self.executor.add_node(made)
        return made

    def spin_until(self, done: Callable[[], bool]) -> None:
        end = time.monotonic() + 10
        while not done():
            self.assertLess(time.monotonic(), end, 'it does not come to this')
            self.executor.spin_once(timeout_sec=0)

    def result(self, future: Any) -> Any:
        """What a future brings while the executor spins."""
        self.spin_until(future.done)
        return future.result()
