"""A buffer of transforms that waits for what is not there yet."""
from __future__ import annotations

import threading
import time as python_time
from collections.abc import Callable
from typing import Any

from rclpy.impl.elsewhere import names_of
import rclpy.logging
from rclpy.clock import Clock, JumpThreshold, TimeJump
from rclpy.duration import Duration
from rclpy.task import Future
from rclpy.time import Time
from tf2_msgs.srv import FrameGraph
from tf2_py import BufferCore

from tf2_ros.buffer_interface import BufferInterface

__getattr__ = names_of(__name__, {
    'geometry_msgs.msg': 'TransformStamped',
    'rclpy.node': 'Node',
    'time': 'sleep',
    'typing': 'List Optional Tuple TypeVar',
})

LOOK_AGAIN_S = 0.02
#: A clock that goes back further than this while one waits starts anew: nothing is waited for.
JUMP_BACK = Duration(seconds=3)


class Buffer(BufferCore, BufferInterface):
    """Keeps what a listener puts in. With a node it tells all frames by the service `tf2_frames`."""

    def __init__(self, cache_time: Duration | None = None, node: Any = None) -> None:
        BufferCore.__init__(self, *([] if cache_time is None else [cache_time]))
        BufferInterface.__init__(self)
        self._new_data_callbacks: list[Callable[[], None]] = []
        self._callbacks_to_remove: list[Callable[[], None]] = []
        self._callbacks_lock = threading.RLock()
        if node is not None:
            self.srv = node.create_service(FrameGraph, 'tf2_frames', self._tell_frames)
            self.clock = node.get_clock()
        else:
            self.clock = Clock()
        threshold = JumpThreshold(min_forward=None, min_backward=Duration(seconds=-1), on_clock_change=True)
        self.jump_handle = self.clock.create_jump_callback(threshold, post_callback=self.time_jump_callback)

    def _tell_frames(self, _request: Any, _response: Any) -> Any:
        return FrameGraph.Response(frame_yaml=self.all_frames_as_yaml())

    def time_jump_callback(self, time_jump: TimeJump) -> None:
        rclpy.logging.get_logger('tf2_buffer').warning('Detected jump back in time. Clearing tf buffer.')
        self.clear()

    # ---- taking in

    def set_transform(self, transform: Any, authority: str) -> None:
        super().set_transform(transform, authority)
        self._call_new_data_callbacks()

    def set_transform_static(self, transform: Any, authority: str) -> None:
        super().set_transform_static(transform, authority)
        self._call_new_data_callbacks()

    def _call_new_data_callbacks(self) -> None:
        with self._callbacks_lock:
            for callback in self._new_data_callbacks:
                callback()
            # Not before: the loop above goes over what is removed here.
            for callback in self._callbacks_to_remove:
                self._new_data_callbacks.remove(callback)
            self._callbacks_to_remove.clear()

    def _remove_callback(self, callback: Callable[[], None]) -> None:
        with self._callbacks_lock:
            self._callbacks_to_remove.append(callback)

    # ---- asking

    def lookup_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration()
    ) -> Any:
        """Where the source stands in the target. Time zero: the latest that is known."""
        self.can_transform(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str,
        timeout: Duration = Duration()
    ) -> Any:
        """Where the source stood at one time, in the target at another, by way of a frame that does not move."""
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def can_transform(
        self, target_frame: str, source_frame: str, time: Time, timeout: Duration = Duration(),
        return_debug_tuple: bool = False
    ) -> Any:
        """Whether it can; with `return_debug_tuple` also why not."""
        answer = self._ask_until(lambda: self.can_transform_core(target_frame, source_frame, time), timeout)
        return answer if return_debug_tuple else answer[0]

    def can_transform_full(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str,
        timeout: Duration = Duration(), return_debug_tuple: bool = False
    ) -> Any:
        answer = self._ask_until(lambda: self.can_transform_full_core(
            target_frame, target_time, source_frame, source_time, fixed_frame), timeout)
        return answer if return_debug_tuple else answer[0]

    def _ask_until(self, ask: Callable[[], tuple[int, str]], timeout: Duration) -> tuple[int, str]:
        """Ask again and again; others put transforms in meanwhile, from another callback group or thread."""
        if timeout != Duration():
            clock = Clock()
            start = clock.now()
            while clock.now() < start + timeout and not ask()[0] and clock.now() + JUMP_BACK >= start:
                python_time.sleep(LOOK_AGAIN_S)
        return ask()

    # ---- asking without waiting

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Any:
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> Any:
        await self.wait_for_transform_full_async(target_frame, target_time, source_frame, source_time, fixed_frame)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Time) -> Future:
        """Done with the transform as soon as it can be had."""
        return self._future_of(
            lambda: self.can_transform_core(target_frame, source_frame, time),
            lambda: self.lookup_transform_core(target_frame, source_frame, time))

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Time, source_frame: str, source_time: Time, fixed_frame: str
    ) -> Future:
        return self._future_of(
            lambda: self.can_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame),
            lambda: self.lookup_transform_full_core(
                target_frame, target_time, source_frame, source_time, fixed_frame))

    def _future_of(self, ask: Callable[[], tuple[int, str]], look_up: Callable[[], Any]) -> Future:
        future = Future()
        if ask()[0]:
            future.set_result(look_up())
            return future

        def on_new_data() -> None:
            if future.done():
                return
            try:
                if ask()[0]:
                    future.set_result(look_up())
            except Exception as error:
                future.set_exception(error)
        self._new_data_callbacks.append(on_new_data)
        future.add_done_callback(lambda _: self._remove_callback(on_new_data))
        return future
