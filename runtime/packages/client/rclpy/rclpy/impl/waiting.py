"""The loop of calls that wait: for a service, an action, an answer, a message, a rate."""
from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from rclpy.context import Context
from rclpy.task import Future
from ros2wasm import host, meanwhile

NS = 1_000_000_000


def wait_until(
    ready: Callable[[], bool], context: Context, timeout_sec: float | None,
    why_stuck: Callable[[], str | None] | None = None
) -> bool:
    """
    Wait until something is so. False: the time was over, or the context shut down, before. None: without end.

    `why_stuck` gives the reason when nobody will make it so.
    """
    end = None if timeout_sec is None else time.monotonic_ns() + int(timeout_sec * NS)
    help_at = None if why_stuck is None else time.monotonic_ns() + meanwhile.HELP_AFTER_NS
    while True:
        token = host.wake_token()
        if ready():
            return True
        if not context.ok():
            return False
        now = time.monotonic_ns()
        if end is not None and now >= end:
            return False
        if help_at is not None and now >= help_at:
            help_at = None
            assert why_stuck is not None
            meanwhile.help_once(why_stuck())
        moments = [moment for moment in (end, help_at) if moment is not None]
        meanwhile.wait(token, min(moments) - now if moments else -1)


def wait_for_answer(
    future: Future, context: Context, executor: Any, client: Any, what: str, timeout_sec: float | None = None
) -> bool:
    """
    Wait for the future of an answer. False: the time was over, or the context shut down, before.

    Only an executor takes the answer, when the client's callback group allows it: a call in a callback of that group,
    or of an executor of one thread, waits for ever, as in ROS 2.
    """
    return wait_until(future.done, context, timeout_sec, lambda: meanwhile.why_stuck(what, executor, client))
