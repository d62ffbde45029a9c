"""Clocks. System and steady time are the site's; ROS time is what /clock says while use_sim_time is set."""
from __future__ import annotations

import time
from collections.abc import Callable
from enum import IntEnum
from types import TracebackType
from typing import Any

from rclpy.clock_type import ClockType
from rclpy.context import Context
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.impl.elsewhere import names_of
from rclpy.time import Time
from rclpy.utilities import get_default_context
from ros2wasm import host, meanwhile

__all__ = ['Clock', 'ClockChange', 'ClockType', 'JumpHandle', 'JumpThreshold', 'ROSClock', 'TimeJump']

__getattr__ = names_of(__name__, {'typing': 'Optional Type'})


class ClockChange(IntEnum):
    """What happened to the time of a clock."""

    ROS_TIME_NO_CHANGE = 1
    ROS_TIME_ACTIVATED = 2
    ROS_TIME_DEACTIVATED = 3
    SYSTEM_TIME_NO_CHANGE = 4


class JumpThreshold:
    """How far time must jump for a callback to be called."""

    def __init__(
        self, *, min_forward: Duration | None, min_backward: Duration | None, on_clock_change: bool = True
    ) -> None:
        if min_forward is not None and min_forward.nanoseconds <= 0:
            raise ValueError('min_forward must be a positive non-zero duration')
        if min_backward is not None and min_backward.nanoseconds >= 0:
            raise ValueError('min_backward must be a negative non-zero duration')
        if min_forward is None and min_backward is None and not on_clock_change:
            raise ValueError('At least one jump threshold must be enabled')
        self.min_forward = min_forward
        self.min_backward = min_backward
        self.on_clock_change = on_clock_change


class TimeJump:
    """A jump that has happened."""

    def __init__(self, clock_change: ClockChange, delta: Duration) -> None:
        if not isinstance(clock_change, ClockChange):
            raise TypeError('clock_change must be an instance of rclpy.clock.ClockChange')
        self._clock_change = clock_change
        self._delta = delta

    @property
    def clock_change(self) -> ClockChange:
        return self._clock_change

    @property
    def delta(self) -> Duration:
        return self._delta


class JumpHandle:
    """Keeps jump callbacks registered until it is unregistered."""

    def __init__(
        self, *, clock: Clock, threshold: JumpThreshold, pre_callback: Callable[[], None] | None,
        post_callback: Callable[[TimeJump], None] | None
    ) -> None:
        if pre_callback is None and post_callback is None:
            raise ValueError('One of pre_callback or post_callback must be callable')
        if pre_callback is not None and not callable(pre_callback):
            raise ValueError('pre_callback must be callable if given')
        if post_callback is not None and not callable(post_callback):
            raise ValueError('post_callback must be callable if given')
        self._clock: Clock | None = clock
        self._threshold = threshold
        self._pre_callback = pre_callback
        self._post_callback = post_callback
        clock._jump_handles.append(self)

    def unregister(self) -> None:
        if self._clock is not None and self in self._clock._jump_handles:
            self._clock._jump_handles.remove(self)
        self._clock = None

    def __enter__(self) -> JumpHandle:
        return self

    def __exit__(
        self, t: type[BaseException] | None, v: BaseException | None, tb: TracebackType | None
    ) -> None:
        self.unregister()

    def concerns(self, change: ClockChange, delta_ns: int) -> bool:
        if change in (ClockChange.ROS_TIME_ACTIVATED, ClockChange.ROS_TIME_DEACTIVATED):
            return self._threshold.on_clock_change
        forward, backward = self._threshold.min_forward, self._threshold.min_backward
        return (forward is not None and delta_ns >= forward.nanoseconds) or \
            (backward is not None and delta_ns <= backward.nanoseconds)


class Clock:
    """Tells the time. Of type ROS_TIME it is a ROSClock."""

    _clock_type: ClockType
    _jump_handles: list[JumpHandle]

    def __new__(cls, *, clock_type: ClockType = ClockType.SYSTEM_TIME) -> Clock:
        if not isinstance(clock_type, ClockType):
            raise TypeError('Clock type must be a ClockType enum')
        kind: Any = ROSClock if clock_type is ClockType.ROS_TIME else cls
        self: Clock = super().__new__(kind)
        self._clock_type = clock_type
        self._jump_handles = []
        return self

    @property
    def clock_type(self) -> ClockType:
        return self._clock_type

    @property
    def handle(self) -> Clock:
        return self

    def __repr__(self) -> str:
        return f'Clock(clock_type={self.clock_type.name})'

    def _now_ns(self) -> int:
        return time.monotonic_ns() if self._clock_type == ClockType.STEADY_TIME else time.time_ns()

    def now(self) -> Time:
        return Time(nanoseconds=self._now_ns(), clock_type=self._clock_type)

    def create_jump_callback(
        self, threshold: JumpThreshold, *, pre_callback: Callable[[], None] | None = None,
        post_callback: Callable[[TimeJump], None] | None = None
    ) -> JumpHandle:
        return JumpHandle(clock=self, threshold=threshold, pre_callback=pre_callback, post_callback=post_callback)

    def sleep_until(self, until: Time, context: Context | None = None) -> bool:
        """Sleep to a point in time. False: the context was shut down, or the time source changed, meanwhile."""
        if context is None:
            context = get_default_context()
        if not context.ok():
            raise NotInitializedException()
        if until.clock_type != self._clock_type:
            raise ValueError("until's clock type does not match this clock's type")
        changes: list[TimeJump] = []
        # Each new time ends a wait; only a change of the source is noted.
        handle = self.create_jump_callback(
            JumpThreshold(min_forward=None, min_backward=None, on_clock_change=True), post_callback=changes.append)
        try:
            while True:
                token = host.wake_token()
                if not context.ok():
                    return False
                if changes:
                    return False
                left = until.nanoseconds - self._now_ns()
                if left <= 0:
                    return True
                meanwhile.wait(token, -1 if self._is_told() else left)
        finally:
            handle.unregister()

    def sleep_for(self, rel_time: Duration, context: Context | None = None) -> bool:
        return self.sleep_until(self.now() + rel_time, context)

    def _is_told(self) -> bool:
        """Whether time goes on only when somebody says so."""
        return False


class ROSClock(Clock):
    """The time that the nodes of a graph agree on."""

    _active: bool
    _told_ns: int

    def __new__(cls) -> ROSClock:
        made = super().__new__(cls, clock_type=ClockType.ROS_TIME)
        assert isinstance(made, ROSClock)
        made._active = False
        made._told_ns = 0
        return made

    def __init__(self, **_: Any) -> None:
        self._active = getattr(self, '_active', False)
        self._told_ns = getattr(self, '_told_ns', 0)

    def _now_ns(self) -> int:
        return self._told_ns if self._active else time.time_ns()

    def _is_told(self) -> bool:
        return self._active

    @property
    def ros_time_is_active(self) -> bool:
        return self._active

    def _set_ros_time_is_active(self, enabled: bool) -> None:
        if enabled == self._active:
            return
        change = ClockChange.ROS_TIME_ACTIVATED if enabled else ClockChange.ROS_TIME_DEACTIVATED
        before = self._now_ns()
        handles = [one for one in self._jump_handles if one.concerns(change, 0)]
        for handle in handles:
            if handle._pre_callback is not None:
                handle._pre_callback()
        self._active = enabled
        self._jumped(handles, change, self._now_ns() - before)

    def _jumped(self, handles: list[JumpHandle], change: ClockChange, delta_ns: int) -> None:
        for handle in handles:
            if handle._post_callback is not None:
                handle._post_callback(TimeJump(change, Duration(nanoseconds=delta_ns)))
        host.wake()

    def set_ros_time_override(self, time: Time) -> None:
        if not isinstance(time, Time):
            raise TypeError('Time must be specified as rclpy.time.Time. Received type: ' + type(time).__name__)
        delta = time.nanoseconds - self._told_ns
        change = ClockChange.ROS_TIME_NO_CHANGE
        handles = [one for one in self._jump_handles if self._active and one.concerns(change, delta)]
        for handle in handles:
            if handle._pre_callback is not None:
                handle._pre_callback()
        self._told_ns = time.nanoseconds
        self._jumped(handles, change, delta)
