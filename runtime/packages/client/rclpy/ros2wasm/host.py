"""The functions of the host (SPEC.md section 3), for Python. The one file that knows the JavaScript module of the site.

Places in memory are those of arrays that live as long as the program.
"""
from __future__ import annotations

import signal
import struct
import sys
import time
from array import array
from asyncio import events
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple, NoReturn

import ros2wasm_host
from pyodide.ffi import can_run_sync, run_sync

from ros2wasm.codec import PAYLOAD_AT, CdrError
from ros2wasm.constants import (
    ENDPOINT_DESC_FORMAT, ENDPOINT_STATUS_FORMAT, SAMPLE_INFO_FORMAT, EndpointKind, ErrorCode, StatusKind, TerminalMode,
    WaitResult,
)
from ros2wasm.graph_snapshot import GraphEndpoint, GraphNode, Qos, read_graph

WOKEN, TIMEOUT, STOP = int(WaitResult.WOKEN), int(WaitResult.TIMEOUT), int(WaitResult.STOP)
#: The host's result is a promise, which it keeps for suspend.
PENDING = -1 << 31
#: A message was sent, and the slice of time is over (threads.py).
SLICE_OVER = 1
#: What js.input_is_there says.
INPUT, INPUT_STOP = 1, 2
NOTHING = int(ErrorCode.NOTHING)
CDR_HEADER = b'\x00\x01\x00\x00'
INFO_SIZE = struct.calcsize(SAMPLE_INFO_FORMAT)
NO_INFO = bytes(INFO_SIZE)
LITTLE_ENDIAN = 1
FIRST_CAPACITY = 1 << 16
MOST_READY = 1024
#: Words of a look before the readers.
LOOK_WORDS = 6
LOW = 0xFFFFFFFF

#: As it is before signals.py has others.
_handler_of = signal.getsignal
#: Pyodide's event loop, on which its suspensions run.
own_loop: Any = None
#: The program's threads, once they are installed (threads.py).
threads: Any = None
#: Called before a wait with its timeout in ns (negative: none); returns the timeout to use.
before_wait: Callable[[int], int] | None = None

#: What an executor sees: the wake token, the version of the statuses, the own readers that have something.
Seen = tuple[int, int, list[int]]


class Functions:
    """
    The site's functions, looked up once each: Pyodide makes a new object whenever one is asked for.

    Such objects cannot be in an image of the memory: `forget` before it is made.
    """

    def __getattr__(self, name: str) -> Any:
        found = getattr(ros2wasm_host, name)
        vars(self)[name] = found
        return found

    def forget(self) -> None:
        vars(self).clear()


js = Functions()


class BusError(RuntimeError):
    """A function of the host refused."""

    def __init__(self, what: str, code: int) -> None:
        super().__init__(f'{what}: {ErrorCode(code).name.lower()}')
        self.code = ErrorCode(code)


class Buffer:
    """Bytes whose place in memory the host knows; it only grows."""

    def __init__(self, capacity: int) -> None:
        self.reserve(capacity)

    def reserve(self, capacity: int) -> None:
        self.capacity = capacity
        self.bytes = array('B', bytes(capacity))
        self.view = memoryview(self.bytes)
        self.address: int = js.address(self.bytes)


_out = Buffer(FIRST_CAPACITY)
_in = Buffer(FIRST_CAPACITY)
_info = Buffer(INFO_SIZE)
#: Wake token, version of the statuses, where a message is taken to (address, capacity, address of its info), where one
#: is that is published, readers.
_looked = Buffer(4 * (LOOK_WORDS + MOST_READY))
_looked_words = _looked.view.cast('i')
_info_struct = struct.Struct(SAMPLE_INFO_FORMAT)
_out.view[:PAYLOAD_AT] = CDR_HEADER


class SampleInfo(NamedTuple):
    length: int
    flags: int
    sequence: int
    source_timestamp_ns: int
    related_sequence: int
    related_gid: bytes
    writer_gid: bytes


class Status(NamedTuple):
    total_count: int
    total_change: int
    current_count: int
    current_change: int
    last_policy: int


def interrupt() -> None:
    """What Ctrl-C does: the handler of SIGINT runs here."""
    handler = _handler_of(signal.SIGINT)
    if callable(handler):
        handler(signal.SIGINT, sys._getframe(1))


def _told(result: int) -> int:
    if result == STOP:
        interrupt()
    return result


def _stopped() -> None:
    """A stop is delivered once, whoever hears of it first."""
    if take_stop():
        interrupt()


def wake_token() -> int:
    token: int = js.wake_token()
    return token


def _settled(result: Any) -> int:
    """What the link says at once, or after a suspension."""
    settled: int = suspend() if result == PENDING else result
    return settled


def suspend() -> Any:
    """Wait for the promise that the host has for us; nobody is interrupted meanwhile."""
    running = events._get_running_loop()
    events._set_running_loop(own_loop)
    try:
        return run_sync(js.pending())
    finally:
        events._set_running_loop(running)
        js.resumed()


def wait_on_link(token: int, timeout_ns: int) -> int:
    """As wait, for the whole program; a stop is only told of."""
    if timeout_ns < 0:
        # Small numbers reach the host sooner.
        return _settled(js.wait(token, -1, -1))
    return _settled(js.wait(token, timeout_ns & LOW, timeout_ns >> 32))


def wait(token: int, timeout_ns: int) -> int:
    """Wait for an event after the token, a stop, or so long. Negative: without end."""
    if before_wait is not None:
        timeout_ns = before_wait(timeout_ns)
    if threads is not None and threads.count > 1:
        return _told(threads.wait(token, timeout_ns))
    return _told(wait_on_link(token, timeout_ns))


def sleep(duration_ns: int) -> int:
    if threads is not None and threads.count > 1:
        return _told(threads.sleep(duration_ns))
    return _told(_settled(js.sleep(duration_ns & LOW, duration_ns >> 32)))


def look_around() -> None:
    """For what does not wait: when it has run for long, what came on the link is seen, and other threads go on."""
    if threads is not None and slice_is_over():
        threads.give_way()


def can_switch() -> bool:
    """Whether the present stack can rest while others run."""
    return bool(can_run_sync())


def set_threads(count: int) -> None:
    js.set_threads(count)


def thread_runs(ident: int, is_main: bool) -> None:
    js.thread_runs(ident, is_main)


def begin_thread(begin: Any) -> None:
    """Call it on a stack of its own as soon as the present one rests."""
    js.begin_thread(begin)


def park(ident: int) -> None:
    """Rest until unpark says so."""
    js.park(ident)
    suspend()


def unpark(ident: int) -> None:
    js.unpark(ident)


def slice_is_over() -> bool:
    return bool(js.slice_is_over())


def take_stop() -> bool:
    """Whether a stop is news; it is none from then on."""
    return bool(js.take_stop())


def forget_stop() -> None:
    """The program goes on after a stop, and will hear of the next one."""
    js.forget_stop()


def tell(event: str) -> int:
    """Have the page know of something. Returns how much of it the page has not dealt with yet."""
    ahead: int = js.tell(event)
    return ahead


def give_file(path: str, data: bytes) -> None:
    """Hand a file that was written to whoever runs the site, who may keep it."""
    js.file_give(path, data)


def terminal_mode(mode: TerminalMode) -> None:
    """What the program makes of its standard input from now on."""
    js.terminal_mode(int(mode))


def wake() -> None:
    js.wake()


def stop_requested() -> bool:
    return bool(js.stop_requested())


def read_input(capacity: int) -> bytes | None:
    """Wait for standard input. Empty: there will be no more; None: a stop."""
    # A prompt does not end in a newline, so it is shown now.
    js.show_output()
    while threads is not None and threads.count > 1:
        token = wake_token()
        arrived = _settled(js.input_is_there())
        if arrived == INPUT:
            break
        if arrived == INPUT_STOP:
            threads.stopped()
        elif wait(token, -1) == STOP:
            return None
    result = js.read_input(capacity)
    if result == PENDING:
        result = suspend()
    if result is None:
        _stopped()
        return None
    return bytes(result.to_bytes())


def input_arrives(timeout_ns: int) -> bool:
    """Whether standard input has something, or is over, now or within that time. Negative: without end."""
    end = time.monotonic_ns() + timeout_ns
    while True:
        token = wake_token()
        arrived = _settled(js.input_is_there())
        if arrived == INPUT:
            return True
        if arrived == INPUT_STOP:
            _stopped()
        left = -1 if timeout_ns < 0 else end - time.monotonic_ns()
        if timeout_ns >= 0 and left <= 0:
            look_around()
            return False
        wait(token, left)


def ready() -> list[int]:
    """The own readers that have something."""
    count = js.ready(_looked.address + 4 * LOOK_WORDS, MOST_READY)
    return _looked_words[LOOK_WORDS:LOOK_WORDS + min(count, MOST_READY)].tolist()


def look() -> Seen:
    """What there is to do for an executor."""
    return _seen(js.look(_looked.address, MOST_READY, -1, 0))


def _seen(count: int) -> Seen:
    return _looked_words[0], _looked_words[1], _looked_words[LOOK_WORDS:LOOK_WORDS + count].tolist()


def _tell_places() -> None:
    """
    Tell the host where a message goes that is taken with a look, and where one is that is published.

    Beside them lies what is known about it.
    """
    struct.pack_into('<IIII', _looked.view, 8, _in.address, _in.capacity, _info.address, _out.address)


_tell_places()


def _words(*texts: str) -> list[int]:
    """Lay texts down for the host: address and length of each."""
    places, at = [], 0
    for text in texts:
        data = text.encode()
        _in.view[at:at + len(data)] = data
        places += [_in.address + at, len(data)]
        at += len(data)
    return places


def _checked(what: str, result: int) -> int:
    if result < 0:
        raise BusError(what, result)
    return result


def node_create(name: str, namespace: str) -> int:
    return _checked('the node cannot be made', js.node_create(*_words(name, namespace)))


def node_destroy(node: int) -> None:
    js.node_destroy(node)


def status_version() -> int:
    version: int = js.status_version()
    return version


def graph_version() -> int:
    version: int = js.graph_version()
    return version


class Endpoint:
    """A publisher, subscription, client or server on the bus."""

    def __init__(
        self, kind: EndpointKind, node: int, name: str, type_name: str, type_hash: str, qos: Qos, flags: int = 0
    ) -> None:
        texts = _words(name, type_name, type_hash)
        desc = struct.pack(
            ENDPOINT_DESC_FORMAT, kind, node, *texts, qos.reliability, qos.durability, qos.history, qos.depth,
            qos.liveliness, flags, 0, 0, qos.deadline_ns, qos.lifespan_ns, qos.lease_ns, 0, 0, 0)
        at = (sum(texts[1::2]) + 7) & -8
        _in.view[at:at + len(desc)] = desc
        self.handle = _checked(f'{name} cannot be made', js.endpoint_create(_in.address + at))
        js.endpoint_gid(self.handle, _info.address)
        self.gid = bytes(_info.view[:16])

    @cached_property
    def _publish(self) -> Callable[[int], int]:
        """Send so many bytes of the buffer that goes out. One argument: each more costs as much as a copy."""
        publish: Callable[[int], int] = js.publisher(self.handle, _looked.address)
        return publish

    @cached_property
    def _hear(self) -> Callable[[int], int]:
        """As js.look, for this reader and a version of the statuses."""
        hear: Callable[[int], int] = js.hearer(self.handle, _looked.address, MOST_READY)
        return hear

    def destroy(self) -> None:
        js.endpoint_destroy(self.handle)
        self.handle = -1
        # The next endpoint may have the same handle.
        for name in ('_publish', '_hear'):
            vars(self).pop(name, None)

    def matched(self) -> int:
        count: int = js.matched(self.handle)
        return max(0, count)

    def assert_liveliness(self) -> None:
        js.assert_liveliness(self.handle)

    def status(self, kind: StatusKind) -> Status | None:
        """None: the endpoint has no such status."""
        if js.endpoint_status(self.handle, int(kind), _info.address) < 0:
            return None
        return Status(*struct.unpack_from(ENDPOINT_STATUS_FORMAT, _info.view)[:5])

    def write(self, codec: Any, message: Any, related_sequence: int = 0, related_gid: bytes = bytes(16)) -> SampleInfo:
        """Serialise and send a message."""
        end = encode(codec, message)
        _info_struct.pack_into(_info.view, 0, 0, 0, 0, 0, related_sequence, related_gid, bytes(16))
        return self._send(end)

    def publish(self, codec: Any, message: Any) -> None:
        """As write, for messages that are not part of an exchange."""
        try:
            end = codec.write(message, _out.view, PAYLOAD_AT)
        except Exception:
            end = encode(codec, message)
        result = self._publish(end)
        if result:
            self._published(result)

    def _published(self, result: int) -> None:
        """What else may come of it."""
        if result == PENDING:
            result = suspend()
        if result < 0:
            self._refused(result)
        if result == SLICE_OVER:
            look_around()

    def write_bytes(self, data: bytes) -> SampleInfo:
        """Send what is serialised already."""
        if len(data) > _out.capacity:
            _grow(_out, len(data))
        _out.view[:len(data)] = data
        _info.view[:] = NO_INFO
        try:
            return self._send(len(data))
        finally:
            _out.view[:PAYLOAD_AT] = CDR_HEADER

    def _send(self, length: int) -> SampleInfo:
        result = _settled(js.write(self.handle, _out.address, length, _info.address))
        if result < 0:
            self._refused(result)
        return SampleInfo(*_info_struct.unpack_from(_info.view))

    def _refused(self, code: int) -> None:
        if code == ErrorCode.STOPPED:
            _stopped()
        raise BusError('the message cannot be sent', code)

    def take(self, codec: Any) -> tuple[Any, SampleInfo] | None:
        """The next message; None: there is none."""
        message = self.take_message(codec)
        return None if message is None else (message, SampleInfo(*_info_struct.unpack_from(_info.view)))

    def take_message(self, codec: Any) -> Any:
        """As take, without what is known about the message."""
        length = js.take(self.handle, _in.address, _in.capacity, _info.address)
        if length > _in.capacity:
            length = self._take()
        return None if length < 0 else _taken(codec, length)

    def look_and_take(self, codec: Any, version: int) -> tuple[Any, Seen | None]:
        """
        Look, and take the next message if no other own reader has something and the statuses are of that version.

        The message, or what was seen in place of it.
        """
        result = self._hear(version)
        if result >= 0:
            return None, _seen(result)
        data = _in.bytes
        if data[1] != LITTLE_ENDIAN:
            _refuse_encoding()
        message, end = codec.read(data, PAYLOAD_AT)
        if end > ~result:
            _refuse_length()
        return message, None

    def take_bytes(self) -> tuple[bytes, SampleInfo] | None:
        length = self._take()
        if length < 0:
            return None
        return bytes(_in.view[:length]), SampleInfo(*_info_struct.unpack_from(_info.view))

    def _take(self) -> int:
        while True:
            length: int = js.take(self.handle, _in.address, _in.capacity, _info.address)
            if length <= _in.capacity:
                return length
            _grow(_in, length)


def _taken(codec: Any, length: int) -> Any:
    """The message that was taken."""
    data = _in.bytes
    if data[1] != LITTLE_ENDIAN:
        _refuse_encoding()
    message, end = codec.read(data, PAYLOAD_AT)
    if end > length:
        _refuse_length()
    return message


def _refuse_encoding() -> NoReturn:
    raise BusError('only little-endian CDR is read', int(ErrorCode.UNSUPPORTED))


def _refuse_length() -> NoReturn:
    raise CdrError('the message is shorter than its type')


def _grow(buffer: Buffer, least: int) -> None:
    buffer.reserve(max(2 * buffer.capacity, least))
    if buffer is _out:
        _out.view[:PAYLOAD_AT] = CDR_HEADER
    _tell_places()


MOST_CAPACITY = 1 << 30


def encode(codec: Any, message: Any) -> int:
    """
    Serialise into the buffer that goes out; returns the end. What does not fit is tried in a larger one.

    AssertionError: the value of a field is none of its type.
    """
    while True:
        try:
            return int(codec.write(message, _out.view, PAYLOAD_AT))
        except Exception:
            # Too small a buffer, or a value that is wrong: the latter fails in a larger buffer too.
            if _out.capacity >= _largest(codec, message) or _out.capacity >= MOST_CAPACITY:
                from ros2wasm.wrong_field import about
                wrong = about(codec, message)
                if wrong is None:
                    raise
                raise AssertionError(wrong) from None
            _grow(_out, 0)


def _largest(codec: Any, message: Any) -> int:
    """Bytes in which the message fits for sure, if its values are right."""
    size = 64
    for field in codec.structure.fields:
        value = getattr(message, f'_{field.name}', None)
        items: Any = value if field.type.container else (value,)
        if not hasattr(items, '__len__'):
            continue
        if field.type.is_message:
            inner = codec.find(field.type.base)
            size += 8 + sum(_largest(inner, one) for one in items)
        elif isinstance(value, (str, bytes)) or (len(items) and isinstance(items[0], str)):
            size += 8 + sum(16 + 4 * len(one) for one in items if hasattr(one, '__len__'))
        else:
            size += 16 + 8 * len(items)
    return size


def serialize(codec: Any, message: Any) -> bytes:
    # The buffer may be another one when it had to grow.
    end = encode(codec, message)
    return bytes(_out.view[:end])


def decode(codec: Any, data: bytes) -> Any:
    """A message out of its bytes, which begin with the CDR header."""
    if data[:2] != CDR_HEADER[:2]:
        _refuse_encoding()
    message, end = codec.read(array('B', data), PAYLOAD_AT)
    if end > len(data):
        _refuse_length()
    return message


def graph() -> tuple[list[GraphNode], list[GraphEndpoint]]:
    """All nodes and endpoints that can be seen."""
    size = js.graph_snapshot(_in.address, _in.capacity)
    while size > _in.capacity:
        _grow(_in, size)
        size = js.graph_snapshot(_in.address, _in.capacity)
    return read_graph(_in.view)


def system_ns() -> int:
    """Time of day of the site."""
    return time.time_ns()


def steady_ns() -> int:
    return time.monotonic_ns()
