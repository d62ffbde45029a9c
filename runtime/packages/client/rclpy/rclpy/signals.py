"""What SIGINT and SIGTERM do: a stop in the page is SIGINT."""
from __future__ import annotations

import signal
from enum import IntEnum
from types import FrameType
from typing import Any

from rclpy.context import shut_down_all
from ros2wasm import signals


class SignalHandlerOptions(IntEnum):
    """Which signals shut rclpy down."""

    ALL = 3
    SIGINT = 1
    SIGTERM = 2
    NO = 0


_options = SignalHandlerOptions.NO
_before: Any = None


def _on_interrupt(number: int, frame: FrameType | None) -> None:
    shut_down_all()
    if callable(_before):
        _before(number, frame)


# As natively, where it is none of Python's: `signal` does not know of it, and who installs another one replaces it.
signals.stand_ins.append((_on_interrupt, lambda: _before))


def install_signal_handlers(options: SignalHandlerOptions = SignalHandlerOptions.ALL) -> None:
    """Have SIGINT end all contexts before Python hears of it."""
    global _options, _before
    handles = bool(options & SignalHandlerOptions.SIGINT)
    handled = bool(_options & SignalHandlerOptions.SIGINT)
    if handles and not handled:
        _before = signals.replace(signal.SIGINT, _on_interrupt)
    _options = SignalHandlerOptions(options)


def get_current_signal_handlers_options() -> SignalHandlerOptions:
    return _options


def uninstall_signal_handlers() -> None:
    """Leave signals to Python."""
    global _options
    if _options & SignalHandlerOptions.SIGINT and signals.installed() is _on_interrupt:
        signals.replace(signal.SIGINT, _before)
    _options = SignalHandlerOptions.NO
