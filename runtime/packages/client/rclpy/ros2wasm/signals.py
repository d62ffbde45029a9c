"""The standard library's `signal`, where the interpreter of a page has none of the kernel's part.

A stop is SIGINT. A handler that stands in for another one is never shown to the program.
"""
from __future__ import annotations

import os
import signal
from collections.abc import Callable
from types import FrameType
from typing import Any

from ros2wasm import host

INTERRUPT = signal.SIGINT
_install, _installed = signal.signal, signal.getsignal
HOUR_NS = 3600 * 1_000_000_000
NO_ALARM = ("signals that come after a time cannot be had here, as the program is none of an operating system's: use a "
            'timer of rclpy, or threading.Timer')
#: Our own handlers, and what the program is told in their place.
stand_ins: list[tuple[Any, Callable[[], Any]]] = []


def _end(number: int, _frame: FrameType | None) -> None:
    """What the system does by default: it ends the program at once."""
    os._exit(-number)


def shown(handler: Any) -> Any:
    """What a program is told of a handler."""
    for own, instead in stand_ins:
        if handler is own:
            return shown(instead())
    return handler


def installed() -> Any:
    """Who hears of SIGINT, be it one of ours."""
    return _installed(INTERRUPT)


def getsignal(number: int) -> Any:
    """In place of signal.getsignal."""
    return shown(_installed(number))


def install_handler(number: int, handler: Any) -> Any:
    """In place of signal.signal."""
    if host.threads is not None and host.threads.current is not host.threads.main:
        raise ValueError('signal only works in main thread of the main interpreter')
    return replace(number, handler)


def replace(number: int, handler: Any) -> Any:
    """From any thread. Gives back what was there before."""
    before = getsignal(number)
    # The interpreter itself never hears of a stop that nobody handles.
    _install(number, _end if number == INTERRUPT and handler == signal.SIG_DFL else handler)
    return before


def alarm(seconds: int, /) -> int:
    """In place of signal.alarm."""
    if seconds:
        raise NotImplementedError(f'signal.alarm: {NO_ALARM}')
    return 0


def setitimer(which: int, seconds: float, interval: float = 0.0, /) -> tuple[float, float]:
    """In place of signal.setitimer."""
    if seconds:
        raise NotImplementedError(f'signal.setitimer: {NO_ALARM}')
    return 0.0, 0.0


def pause() -> None:
    """In place of signal.pause."""
    while host.sleep(HOUR_NS) != host.STOP:
        pass


def install() -> None:
    stand_ins.append((_end, lambda: signal.SIG_DFL))
    setattr(signal, 'signal', install_handler)
    for function in (getsignal, alarm, setitimer, pause):
        setattr(signal, function.__name__, function)
