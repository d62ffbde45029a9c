"""Guard conditions."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.context import Context
from rclpy.exceptions import InvalidHandle
from rclpy.utilities import get_default_context
from ros2wasm import host
from ros2wasm.entities import changes


class GuardCondition:
    """Calls back after somebody has triggered it."""

    def __init__(
        self, callback: Callable[[], Any] | None, callback_group: CallbackGroup | None, context: Context | None = None
    ) -> None:
        self._context = get_default_context() if context is None else context
        if not self._context.ok():
            from rclpy.exceptions import NotInitializedException
            raise NotInitializedException()
        self._triggered = False
        self._destroyed = False
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False

    @property
    def handle(self) -> GuardCondition:
        return self

    def trigger(self) -> None:
        if self._destroyed:
            raise InvalidHandle('cannot use Destroyable because destruction was requested')
        self._triggered = True
        host.wake()

    def _rw_take_call(self) -> Callable[[], Any] | None:
        """Take the call that is due; what remains is to make it."""
        if not self._triggered:
            return None
        self._triggered = False
        return self.callback

    def destroy(self) -> None:
        self._destroyed = True
        changes.add()
