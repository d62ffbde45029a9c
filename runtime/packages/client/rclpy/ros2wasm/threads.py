"""
Threads of a Python program: stacks of which one runs at a time.

What blocks (locks, sleeps, waits on the link) gives the way to the next stack; who computes for long is interrupted
between two bytecodes, as by the interpreter's lock natively. Needs JavaScript Promise Integration.
"""
from __future__ import annotations

import _thread
import queue
import signal
import sys
import threading
import time
import traceback
from _threading_local import local
from asyncio import events
from collections import deque
from collections.abc import Callable
from functools import partial
from types import FrameType
from typing import Any

from ros2wasm import host

NS = 1_000_000_000
#: Told by the host when a stack has run for its slice of time.
SLICE_SIGNAL = signal.SIGVTALRM
#: Nobody is interrupted in our own code: what it keeps is of one piece.
ROOT = __file__.rpartition('/ros2wasm/')[0]
OWN = (f'{ROOT}/ros2wasm/', f'{ROOT}/rclpy/', '<ros2wasm')
LIBRARY = (threading.__file__.rpartition('/')[0], '<frozen')
REFUSED = (
    "error[R2W0714]: can't start new thread: this browser cannot suspend a program. Give the work to a timer, to a "
    'callback group of a MultiThreadedExecutor, or to a node of its own')


class Stack:
    """One thread."""

    __slots__ = ('ident', 'begin', 'reason', 'blocked', 'deadline', 'token', 'sentinel')

    def __init__(self, ident: int) -> None:
        self.ident = ident
        #: Of one that has not begun.
        self.begin: Callable[[], None] | None = None
        #: Why it goes on, as WaitResult; what wakes it says.
        self.reason = host.WOKEN
        self.blocked = False
        self.deadline: int | None = None
        #: It goes on when the link's token is another; None: that means nothing to it.
        self.token: int | None = None
        self.sentinel: Lock | None = None


class Threads:
    """All stacks, and which of them runs."""

    def __init__(self) -> None:
        self.main = Stack(threading.get_ident())
        self.current = self.main
        self.ready: deque[Stack] = deque()
        #: Those that time or the link may wake, in the order in which they came.
        self.sleeping: list[Stack] = []
        self.count = 1
        self._last_ident = self.main.ident

    # ---- starting and ending

    def start(self, function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any] | None = None) -> int:
        """In place of _thread.start_new_thread."""
        if not host.can_switch():
            raise RuntimeError(REFUSED)
        if self.count == 1:
            signal.signal(SLICE_SIGNAL, self._on_slice)
        self._last_ident += 1
        stack = Stack(self._last_ident)
        stack.begin = partial(self._run, stack, function, args, kwargs or {})
        self.count += 1
        self.ready.append(stack)
        host.set_threads(self.count)
        return stack.ident

    def _run(self, stack: Stack, function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        self._now_runs(stack)
        events._set_running_loop(None)
        try:
            function(*args, **kwargs)
        except SystemExit:
            pass
        except BaseException as error:
            print(f'Exception ignored in thread started by: {function!r}', file=sys.stderr)
            traceback.print_exception(error)
        if stack.sentinel is not None:
            stack.sentinel.release()
        self.count -= 1
        host.set_threads(self.count)
        while not self.ready:
            self._idle()
        self._resume(self.ready.popleft())

    # ---- switching

    def _now_runs(self, stack: Stack) -> None:
        self.current = stack
        host.thread_runs(stack.ident, stack is self.main)

    def _resume(self, stack: Stack) -> None:
        """Have a stack go on as soon as the present one rests."""
        begin, stack.begin = stack.begin, None
        if begin is not None:
            host.begin_thread(begin)
        else:
            host.unpark(stack.ident)

    def _switch(self, me: Stack) -> None:
        """Rest until somebody says that it is this stack's turn."""
        self._collect()
        while not self.ready:
            self._idle()
        after = self.ready.popleft()
        if after is me:
            return
        self._resume(after)
        host.park(me.ident)
        self._now_runs(me)

    def block(self, deadline: int | None = None, token: int | None = None) -> int:
        """Rest until woken, until a time, or while the link's token is this. A stop wakes the main stack only."""
        me = self.current
        me.blocked, me.deadline, me.token = True, deadline, token
        if deadline is not None or token is not None:
            self.sleeping.append(me)
        self._switch(me)
        return me.reason

    def wake(self, stack: Stack, reason: int = host.WOKEN) -> None:
        """End a stack's rest."""
        if not stack.blocked:
            return
        stack.blocked = False
        stack.reason = reason
        if stack in self.sleeping:
            self.sleeping.remove(stack)
        self.ready.append(stack)

    def give_way(self) -> None:
        """Let what came on the link be seen, and the others go on first."""
        me = self.current
        me.reason = host.WOKEN
        # On the port link nothing comes while a program computes.
        if host.wait_on_link(host.wake_token(), 0) == host.STOP:
            self._told_of_stop()
        self._collect()
        if self.ready:
            self.ready.append(me)
            self._switch(me)
        else:
            # Another slice.
            self._now_runs(me)
        if me.reason == host.STOP:
            host.interrupt()

    def look_up(self) -> None:
        """Let the others go on, when the present stack has had its slice of time."""
        if self.count > 1 and host.slice_is_over():
            self.give_way()

    # ---- what wakes from outside

    def stopped(self) -> None:
        """A stop was asked for: the main stack is interrupted, now or when it runs."""
        if self.current is self.main:
            if host.take_stop():
                host.interrupt()
        elif self.main.blocked and host.take_stop():
            self.wake(self.main, host.STOP)

    def _told_of_stop(self) -> None:
        """The link told of a stop, and will not again: the main stack hears of it as soon as it goes on."""
        self.wake(self.main, host.STOP)
        self.main.reason = host.STOP

    def _collect(self) -> None:
        """Wake whom time or the link wakes."""
        if self.current is not self.main and host.stop_requested():
            self.stopped()
        if not self.sleeping:
            return
        now, token = time.monotonic_ns(), host.wake_token()
        for stack in list(self.sleeping):
            if stack.token is not None and stack.token != token:
                self.wake(stack, host.WOKEN)
            elif stack.deadline is not None and stack.deadline <= now:
                self.wake(stack, host.TIMEOUT)

    def _idle(self) -> None:
        """All rest: wait on the link."""
        token = host.wake_token()
        self._collect()
        if self.ready:
            return
        ends = [stack.deadline for stack in self.sleeping if stack.deadline is not None]
        wait = max(0, min(ends) - time.monotonic_ns()) if ends else -1
        if host.wait_on_link(token, wait) == host.STOP:
            self._told_of_stop()
        self._collect()

    def _on_slice(self, _number: int, frame: FrameType | None) -> None:
        """The present stack has run for long: the others are next, unless our own code runs."""
        if self.count == 1 or not host.can_switch():
            return
        while frame is not None:
            name = frame.f_code.co_filename
            if name.startswith(OWN):
                return
            if not name.startswith(LIBRARY):
                break
            frame = frame.f_back
        self.give_way()

    # ---- waits of a stack among others

    def wait(self, token: int, timeout_ns: int) -> int:
        """As host.wait."""
        if host.wake_token() != token:
            self.look_up()
            return host.WOKEN
        return self.block(None if timeout_ns < 0 else time.monotonic_ns() + timeout_ns, token)

    def sleep(self, duration_ns: int) -> int:
        """As host.sleep."""
        result = self.block(time.monotonic_ns() + duration_ns)
        return host.STOP if result == host.STOP else host.WOKEN


threads = Threads()


class Lock:
    """In place of _thread.lock. Given to those who wait in the order in which they came."""

    __slots__ = ('_locked', '_waiting', '__weakref__')

    def __init__(self) -> None:
        self._locked = False
        self._waiting: deque[Stack] = deque()

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        if not blocking and timeout != -1:
            raise ValueError("can't specify a timeout for a non-blocking call")
        if timeout < 0 and timeout != -1:
            raise ValueError('timeout value must be a non-negative number')
        if not self._locked:
            self._locked = True
            return True
        if not blocking:
            threads.look_up()
            if self._locked:
                return False
            self._locked = True
            return True
        deadline = None if timeout == -1 else time.monotonic_ns() + int(timeout * NS)
        while True:
            me = threads.current
            self._waiting.append(me)
            reason = threads.block(deadline)
            if me not in self._waiting:
                # The stack that released the lock handed it over to this one.
                if reason == host.STOP:
                    self._interrupt()
                return True
            self._waiting.remove(me)
            if reason == host.TIMEOUT:
                return False
            host.interrupt()

    def _interrupt(self) -> None:
        """A stop came with the lock: who does not get into the block must not keep it."""
        try:
            host.interrupt()
        except BaseException:
            self.release()
            raise

    def release(self) -> None:
        if not self._locked:
            raise RuntimeError('release unlocked lock')
        if self._waiting:
            stack = self._waiting.popleft()
            threads.wake(stack)
        else:
            self._locked = False

    def locked(self) -> bool:
        return self._locked

    acquire_lock, release_lock, locked_lock = acquire, release, locked

    def __enter__(self) -> bool:
        return self.acquire()

    def __exit__(self, *_: object) -> None:
        self.release()

    def _at_fork_reinit(self) -> None:
        self.__init__()  # type: ignore[misc]

    def __repr__(self) -> str:
        return f"<{'locked' if self._locked else 'unlocked'} _thread.lock object at {hex(id(self))}>"


def set_sentinel() -> Lock:
    """In place of _thread._set_sentinel: a lock that is released when the present thread ends."""
    lock = Lock()
    threads.current.sentinel = lock
    return lock


def get_ident() -> int:
    return threads.current.ident


def install() -> None:
    """Put these in place of the interpreter's, which would block or fail."""
    plain_lock: Any = Lock
    reentrant: Any = getattr(threading, '_PyRLock')
    for module, names in (
        (_thread, {'start_new_thread': threads.start, 'start_new': threads.start, 'allocate_lock': plain_lock,
                   'allocate': plain_lock, 'LockType': plain_lock, 'RLock': reentrant, '_set_sentinel': set_sentinel,
                   'get_ident': get_ident, 'get_native_id': get_ident, '_local': local}),
        (threading, {'_start_new_thread': threads.start, '_allocate_lock': plain_lock, 'Lock': plain_lock,
                     '_CRLock': None, '_set_sentinel': set_sentinel, 'get_ident': get_ident,
                     'get_native_id': get_ident, 'local': local}),
        (queue, {'SimpleQueue': getattr(queue, '_PySimpleQueue')}),
    ):
        for name, value in names.items():
            setattr(module, name, value)
    host.threads = threads
