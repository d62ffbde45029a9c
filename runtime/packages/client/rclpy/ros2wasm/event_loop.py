"""asyncio on the link: its loops sleep as everything else does, by the site's time, until something is to do."""
from __future__ import annotations

import asyncio
import errno
import os
import signal
import threading
import time
from asyncio import base_events, coroutines, events, transports
from collections.abc import Callable
from typing import Any

from ros2wasm import host, terminal

NS = 1_000_000_000
STDIN = 0
#: Bytes of one read.
MOST = 1 << 16


class LinkSelector:
    """In place of a selector of sockets: the link, and standard input."""

    def __init__(self) -> None:
        # The wake token of the last look, so that an event that came while the loop worked is not missed.
        self._token = host.wake_token()
        #: Called whenever standard input has something.
        self.reader: Any = None

    def select(self, timeout: float | None) -> list[Any]:
        """Wait for an event of the link, or so long."""
        token, wait = self._token, -1 if timeout is None else max(0, int(timeout * NS))
        if self._input_is_there():
            self._token = host.wake_token()
            host.look_around()
            return [self.reader]
        if wait != 0:
            host.wait(token, wait)
        else:
            host.look_around()
        self._token = host.wake_token()
        return [self.reader] if self._input_is_there() else []

    def _input_is_there(self) -> bool:
        return self.reader is not None and terminal.terminal.waits(0)

    def close(self) -> None:
        self.reader = None


class InputTransport(transports.ReadTransport):
    """Standard input as a pipe: what connect_read_pipe gives."""

    def __init__(self, loop: Any, pipe: Any, protocol: Any, waiter: Any) -> None:
        super().__init__({'pipe': pipe})
        self._loop, self._protocol, self._closing, self._reads = loop, protocol, False, False
        loop.call_soon(protocol.connection_made, self)
        loop.call_soon(self.resume_reading)
        if waiter is not None:
            loop.call_soon(waiter.set_result, None)

    def _read(self) -> None:
        data = os.read(STDIN, MOST)
        if data:
            self._protocol.data_received(data)
            return
        self.pause_reading()
        self._loop.call_soon(self._protocol.eof_received)
        self._loop.call_soon(self._lose)

    def _lose(self) -> None:
        if not self._closing:
            self._closing = True
            self._protocol.connection_lost(None)

    def is_reading(self) -> bool:
        return self._reads

    def pause_reading(self) -> None:
        if self._reads:
            self._reads = False
            self._loop.remove_reader(STDIN)

    def resume_reading(self) -> None:
        if not self._closing and not self._reads:
            self._reads = True
            self._loop.add_reader(STDIN, self._read)

    def set_protocol(self, protocol: Any) -> None:
        self._protocol = protocol

    def get_protocol(self) -> Any:
        return self._protocol

    def is_closing(self) -> bool:
        return self._closing

    def close(self) -> None:
        self.pause_reading()
        self._loop.call_soon(self._lose)


class LinkEventLoop(base_events.BaseEventLoop):
    """Has no sockets and child processes; of pipes, standard input."""

    def __init__(self) -> None:
        super().__init__()
        self._selector = LinkSelector()
        self._signal_handlers: dict[int, Any] = {}

    def time(self) -> float:
        return time.monotonic()

    def _process_events(self, event_list: list[Any]) -> None:
        for handle in event_list:
            if handle is not None and not handle.cancelled():
                getattr(self, '_ready').append(handle)

    def _write_to_self(self) -> None:
        host.wake()

    def close(self) -> None:
        for number in list(self._signal_handlers):
            self.remove_signal_handler(number)
        super().close()
        self._selector.close()

    # ---- standard input

    def add_reader(self, fd: Any, callback: Callable[..., object], *args: Any) -> None:
        self._only(fd, STDIN, 'add_reader')
        self._selector.reader = events.Handle(callback, args, self, None)

    def remove_reader(self, fd: Any) -> bool:
        had = terminal.file_number(fd) == STDIN and self._selector.reader is not None
        if had:
            self._selector.reader.cancel()
            self._selector.reader = None
        return had

    def add_writer(self, fd: Any, callback: Callable[..., object], *args: Any) -> None:
        raise OSError(errno.ENOTSUP, 'add_writer: a program of a page writes to nothing that would keep it waiting')

    def remove_writer(self, fd: Any) -> bool:
        return False

    def _only(self, fd: Any, wanted: int, what: str) -> None:
        number = terminal.file_number(fd)
        if number != wanted:
            raise OSError(
                errno.ENOTSUP, f'{what}: a program of a page waits for standard input only, not for file {number}')

    def _make_read_pipe_transport(self, pipe: Any, protocol: Any, waiter: Any, extra: Any = None) -> InputTransport:
        self._only(pipe, STDIN, 'connect_read_pipe')
        return InputTransport(self, pipe, protocol, waiter)

    async def _make_subprocess_transport(self, *_: Any, **__: Any) -> Any:
        raise OSError(errno.ENOTSUP, 'a program of a page cannot start another one')

    # ---- signals

    def add_signal_handler(self, sig: int, callback: Callable[..., object], *args: Any) -> None:
        if coroutines.iscoroutine(callback) or coroutines.iscoroutinefunction(callback):
            raise TypeError('coroutines cannot be used with add_signal_handler()')
        self._check_closed()  # type: ignore[attr-defined]
        self._checked_signal(sig)
        handle = events.Handle(callback, args, self, None)
        try:
            signal.signal(sig, lambda _number, _frame: self._signalled(handle))
        except ValueError as error:
            raise RuntimeError(str(error)) from error
        self._signal_handlers[sig] = handle

    def _signalled(self, handle: Any) -> None:
        if not handle.cancelled():
            getattr(self, '_ready').append(handle)
            self._write_to_self()

    def remove_signal_handler(self, sig: int) -> bool:
        self._checked_signal(sig)
        handle = self._signal_handlers.pop(sig, None)
        if handle is None:
            return False
        handle.cancel()
        signal.signal(sig, signal.default_int_handler if sig == signal.SIGINT else signal.SIG_DFL)
        return True

    @staticmethod
    def _checked_signal(sig: Any) -> None:
        if not isinstance(sig, int):
            raise TypeError(f'sig must be an int, not {sig!r}')
        if sig not in signal.valid_signals():
            raise ValueError(f'invalid signal number {sig}')
        if sig in (signal.SIGKILL, signal.SIGSTOP):
            raise RuntimeError(f'sig {sig} cannot be caught')


class LinkEventLoopPolicy(events.BaseDefaultEventLoopPolicy):
    _loop_factory = LinkEventLoop


def install() -> None:
    """Of Pyodide's own loop only what it needs for itself is left (host.suspend)."""
    host.own_loop = events._get_running_loop()
    events._set_running_loop(None)
    policy: Any = LinkEventLoopPolicy
    # The policy stores one loop for each thread, so it must know the threads of ros2wasm.
    policy._Local = type('_Local', (threading.local,), {'_loop': None, '_set_called': False})
    asyncio.set_event_loop_policy(policy())
