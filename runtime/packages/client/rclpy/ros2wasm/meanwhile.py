"""
What goes on while a callback waits, and a word of help when it waits in vain.

Natively other threads of an executor go on. Where the browser cannot suspend a program there are none: an executor of
several threads then runs callbacks of other groups within the one that waits.
"""
from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ros2wasm import host

#: After so long somebody who waits is told why that may never end. By the site's time.
HELP_AFTER_NS = 5_000_000_000

#: The executors of several threads that spin in one.
spinning: list[Any] = []
_told: set[str] = set()


@contextmanager
def in_one_thread(executor: Any) -> Iterator[None]:
    """While an executor of several threads spins in one."""
    spinning.append(executor)
    try:
        yield
    finally:
        spinning.remove(executor)


def wait(token: int, timeout_ns: int) -> None:
    """As host.wait, while others run, if somebody can; comes back after what they did. Negative: without end."""
    if any(executor._run_meanwhile(token) for executor in reversed(spinning)):
        return
    for executor in spinning:
        timeout_ns = executor._until_timers(timeout_ns)
    host.wait(token, timeout_ns)


def why_stuck(what: str, executor: Any, entity: Any) -> str | None:
    """Why an entity is not called, which would end the wait; None: there is no such reason."""
    if executor is None or not executor._is_spinning:
        return f'{what} waits for what only an executor takes, and nobody spins the node'
    group = entity.callback_group
    if executor._spins_in == threading.get_ident() and not executor._in_threads and not spinning:
        return f'{what} waits in a callback of the executor that must take what it waits for, and has one thread'
    if group is not None and not group.can_execute(entity):
        return f'{what} waits for what belongs to a callback group of which a callback runs'
    return None


def help_once(reason: str | None) -> None:
    """Say once why somebody waits so long. It waits on."""
    if reason is None or reason in _told:
        return
    _told.add(reason)
    print(f'[ros2wasm] {reason}: it may never go on, as in ROS 2. Spin in another thread, or use a '
          'MultiThreadedExecutor and another callback group, or an asynchronous call.', file=sys.stderr, flush=True)
