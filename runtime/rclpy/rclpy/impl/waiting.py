"""The loop of calls that wait: for a service, an action, an answer, a message."""
from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from rclpy.context import Context
from rclpy.task import Future
from ros2wasm import background, host

NS = 1_000_000_000


def wait_until(
    ready: Callable[[], bool], context: Context, timeout_sec: float | None,
    meanwhile: Callable[[int], bool] | None = None
) -> bool:
    """
    Wait until something is so. False: the time was over, or the context shut down, before. None: without end.

    `meanwhile` gets the link's token, and says whether it did something, after which it is worth to look again.
    """
    end = None if timeout_sec is None else time.monotonic_ns() + int(timeout_sec * NS)
    while True:
        token = host.wake_token()
        if ready():
            return True
        if not context.ok():
            return False
        left = -1 if end is None else end - time.monotonic_ns()
        if end is not None and left <= 0:
            return False
        if meanwhile is None or not meanwhile(token):
            background.run()
            host.wait(token, left)


def wait_for_answer(
    future: Future, receive: Callable[[], bool], context: Context, find_executor: Callable[[], Any],
    timeout_sec: float | None = None
) -> bool:
    """
    Wait for a future that `receive` may complete. False: the time was over, or the context shut down, before.

    The executor may run callbacks of other groups meanwhile.
    """
    def done() -> bool:
        while not future.done() and receive():
            pass
        return future.done()

    def meanwhile(token: int) -> bool:
        executor = find_executor()
        return executor is not None and bool(executor._run_meanwhile(token))
    return wait_until(done, context, timeout_sec, meanwhile)
