"""The event loop of figures: runs timers, takes events of panels, sends pictures."""
from __future__ import annotations

import threading
import time
from collections.abc import Callable
from typing import Any

from matplotlib._pylab_helpers import Gcf
from ros2wasm import host
from ros2wasm_figures.surface import LOOK, desk

NS = 1_000_000_000
#: Depth of nested loops.
_depth = 0
#: The thread that draws the pictures that were not due when its loop ended.
_owner = 0


def _canvases() -> list[Any]:
    return [manager.canvas for manager in Gcf.get_all_fig_managers() if hasattr(manager.canvas, 'take_events')]


def _timers() -> list[Any]:
    from ros2wasm_figures.backend import Timer
    return list(Timer.running)


def _next_picture() -> float | None:
    return min((due for canvas in _canvases() if (due := canvas.due()) is not None), default=None)


def _work() -> None:
    for timer in _timers():
        timer.run()
    for canvas in _canvases():
        canvas.take_events()
    for canvas in _canvases():
        canvas.refresh()


def turn(seconds: float | None) -> None:
    """Do everything that is due, then wait for at most that time (None: LOOK) for more."""
    global _depth
    _depth += 1
    try:
        _work()
        now = time.monotonic()
        times = [timer.due - now for timer in _timers() if timer.due is not None]
        picture = _next_picture()
        if picture is not None:
            times.append(picture - now)
        desk.wait(max(0, min([LOOK if seconds is None else min(seconds, LOOK), *times])))
        if seconds == 0:
            _work()
    finally:
        _depth -= 1
        finish_later()


def run(goes_on: Callable[[], bool], seconds: float | None) -> None:
    """Run the loop while `goes_on()`, for at most that time."""
    end = None if seconds is None else time.monotonic() + seconds
    while goes_on():
        left = None if end is None else end - time.monotonic()
        if left is not None and left <= 0:
            break
        turn(left)


def finish_later() -> None:
    """Draw pictures that are not due yet when the program waits the next time, for example in spin()."""
    global _owner
    if _depth == 0 and _next_picture() is not None:
        _owner = threading.get_ident()
        host.before_wait = _before_wait


def _before_wait(timeout_ns: int) -> int:
    """Draw the pictures that are due, and limit the wait to the time of the next one (host.before_wait)."""
    global _depth
    if _depth > 0 or threading.get_ident() != _owner:
        return timeout_ns
    host.before_wait = None
    _depth += 1
    try:
        for canvas in _canvases():
            canvas.refresh()
        picture = _next_picture()
    finally:
        _depth -= 1
    if picture is None:
        return timeout_ns
    host.before_wait = _before_wait
    left = max(0, int((picture - time.monotonic()) * NS))
    return left if timeout_ns < 0 else min(timeout_ns, left)
