"""Timers and rates."""
from __future__ import annotations

from collections.abc import Callable
from threading import get_ident
from types import TracebackType
from typing import Any

from rclpy.callback_groups import CallbackGroup
from rclpy.clock import Clock, JumpThreshold, TimeJump
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import InvalidHandle, ROSInterruptException
from rclpy.impl.elsewhere import names_of
from rclpy.impl.waiting import wait_until
from rclpy.utilities import get_default_context
from ros2wasm import host, meanwhile
from ros2wasm.entities import changes

__getattr__ = names_of(__name__, {'typing': 'Optional'})


class Timer:
    """Calls back at a period, by a clock."""

    def __init__(
        self, callback: Callable[[], Any] | None, callback_group: CallbackGroup | None, timer_period_ns: int,
        clock: Clock, *, context: Context | None = None, autostart: bool = True
    ) -> None:
        if timer_period_ns < 0:
            raise ValueError('timer period must be non-negative')
        self._context = get_default_context() if context is None else context
        self._clock = clock
        self._period_ns = int(timer_period_ns)
        self._start()
        self._jumps = clock.create_jump_callback(
            JumpThreshold(min_forward=None, min_backward=Duration(nanoseconds=-1)), post_callback=self._start)
        self._canceled = not autostart
        self._destroyed = False
        self.callback = callback
        self.callback_group = callback_group
        self._executor_event = False

    @property
    def handle(self) -> Timer:
        return self

    def _start(self, _: TimeJump | None = None) -> None:
        """Count the period from now: at first, and when what was counted means nothing any more."""
        self._last_ns = self._clock._now_ns()
        self._next_ns = self._last_ns + self._period_ns

    def destroy(self) -> None:
        if self._destroyed:
            return
        self._destroyed = True
        self._jumps.unregister()
        changes.add()

    @property
    def clock(self) -> Clock:
        return self._clock

    @property
    def timer_period_ns(self) -> int:
        return self._period_ns

    @timer_period_ns.setter
    def timer_period_ns(self, value: int) -> None:
        self._check()
        self._period_ns = int(value)
        host.wake()

    def _check(self) -> None:
        if self._destroyed:
            raise InvalidHandle('cannot use Destroyable because destruction was requested')

    def is_ready(self) -> bool:
        self._check()
        return not self._canceled and self._clock._now_ns() >= self._next_ns

    def is_canceled(self) -> bool:
        self._check()
        return self._canceled

    def cancel(self) -> None:
        self._check()
        self._canceled = True

    def reset(self) -> None:
        self._check()
        self._canceled = False
        self._next_ns = self._clock._now_ns() + self._period_ns
        host.wake()

    def time_since_last_call(self) -> int:
        self._check()
        return self._clock._now_ns() - self._last_ns

    def time_until_next_call(self) -> int | None:
        """Nanoseconds; None when the timer is canceled."""
        self._check()
        return None if self._canceled else self._next_ns - self._clock._now_ns()

    def call(self) -> None:
        """Take note that the callback is called now."""
        now = self._clock._now_ns()
        self._last_ns = now
        self._next_ns += self._period_ns
        if self._next_ns < now:
            # Periods that were missed are skipped; the phase stays.
            if self._period_ns == 0:
                self._next_ns = now
            else:
                self._next_ns += ((now - self._next_ns) // self._period_ns + 1) * self._period_ns

    def _rw_take_call(self) -> Callable[[], Any] | None:
        """Take the call that is due; what remains is to make it."""
        if not self.is_ready():
            return None
        self.call()
        return self.callback

    def _wait_ns(self) -> int | None:
        """How long to wait for it at most; None: until somebody tells."""
        if self._canceled or self._clock._is_told():
            return None
        return max(0, self._next_ns - self._clock._now_ns())

    def __enter__(self) -> Timer:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.destroy()


class Rate:
    """Sleeps to the next beat: to the next call of its timer, which an executor of the node makes."""

    def __init__(
        self, timer: Timer, *, context: Context, find_executor: Callable[[], Any] = lambda: None
    ) -> None:
        self._clock = timer.clock
        self._timer = timer
        self._context = context
        self._find_executor = find_executor
        self._is_destroyed = False
        #: Beats that nobody has slept to are one.
        self._beat = False
        #: The thread that made the last one.
        self._beaten_by = 0
        self._num_sleepers = 0
        timer.callback = self._on_beat

    def _on_beat(self) -> None:
        self._beat, self._beaten_by = True, get_ident()
        host.wake()

    def destroy(self) -> None:
        self._is_destroyed = True
        self._timer.destroy()
        host.wake()

    def _presleep(self) -> None:
        if self._is_destroyed:
            raise RuntimeError('Rate cannot sleep because it has been destroyed')
        if not self._context.ok():
            raise ROSInterruptException()

    def sleep(self) -> None:
        """Sleep to the next beat. ROSInterruptException: the end came before."""
        self._presleep()
        if self._beaten_by == get_ident() and not meanwhile.spinning:
            # A callback of an executor of one thread: no other beat can come, and this one would only hide that.
            self._beat = False
        self._num_sleepers += 1
        try:
            wait_until(lambda: self._beat or self._is_destroyed, self._context, None, lambda: meanwhile.why_stuck(
                'Rate.sleep', self._find_executor(), self._timer))
        finally:
            self._num_sleepers -= 1
            if self._num_sleepers == 0:
                self._beat = False
        if not self._context.ok():
            raise ROSInterruptException()
