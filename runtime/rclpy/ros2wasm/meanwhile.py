"""
What goes on while a callback waits, and a word of help when it waits in vain.

Natively other threads of an executor go on. Where the browser cannot suspend a program there are none: an executor of
several threads then runs callbacks of other groups within the one that waits.
"""
from __future__ import annotations

import sys
import threading
from collections.abc import Callable
from typing import Any

#: After so long somebody who waits is told why that may never end. By the site's time.
HELP_AFTER_NS = 5_000_000_000

#: Of each executor of several threads that spins in one: does something for the link's token. False: nothing is to do.
spinning: list[Callable[[int], bool]] = []
_told: set[str] = set()


def give_way(token: int) -> bool:
    """Let others run, if somebody can. False: nothing was to do."""
    return any(run(token) for run in reversed(spinning))


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
