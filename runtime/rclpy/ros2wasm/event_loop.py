"""asyncio on the link: its loops sleep as everything else does, by the site's time, until something is to do."""
from __future__ import annotations

import asyncio
import threading
import time
from asyncio import base_events, events
from typing import Any

from ros2wasm import background, host

NS = 1_000_000_000


class LinkSelector:
    """In place of a selector of sockets: the link."""

    def __init__(self) -> None:
        # Of the last look, so that nothing is missed that came while the loop worked.
        self._token = host.wake_token()

    def select(self, timeout: float | None) -> list[Any]:
        """Wait for an event of the link, or so long."""
        token, wait = self._token, -1 if timeout is None else max(0, int(timeout * NS))
        if wait != 0:
            background.run()
            host.wait(token, wait)
        else:
            host.look_around()
        self._token = host.wake_token()
        return []

    def close(self) -> None:
        """Nothing is held."""


class LinkEventLoop(base_events.BaseEventLoop):
    """Has no sockets, pipes and child processes."""

    def __init__(self) -> None:
        super().__init__()
        self._selector = LinkSelector()

    def time(self) -> float:
        return time.monotonic()

    def _process_events(self, event_list: list[Any]) -> None:
        """There are none."""

    def _write_to_self(self) -> None:
        host.wake()


class LinkEventLoopPolicy(events.BaseDefaultEventLoopPolicy):
    _loop_factory = LinkEventLoop


def install() -> None:
    """Of Pyodide's own loop only what it needs for itself is left (host.suspend)."""
    host.own_loop = events._get_running_loop()
    events._set_running_loop(None)
    policy: Any = LinkEventLoopPolicy
    # What keeps a loop for each thread must know our threads.
    policy._Local = type('_Local', (threading.local,), {'_loop': None, '_set_called': False})
    asyncio.set_event_loop_policy(policy())
