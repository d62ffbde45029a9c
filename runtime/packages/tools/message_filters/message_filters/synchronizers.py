"""Put messages of several filters together by their times."""
from __future__ import annotations

import itertools
import threading
from collections.abc import Sequence
from typing import Any

from rclpy.clock import ROSClock
from rclpy.duration import Duration

from message_filters.simple_filter import SimpleFilter
from message_filters.stamps import stamp_of, time_of

#: Time in nanoseconds -> the message of that time.
Queue = dict[int, Any]


class TimeSynchronizer(SimpleFilter):
    """Messages of the very same time, one of each filter. Calls back with all of them, in the order of the filters."""

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = threading.Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        self.queues: list[Queue] = [{} for _ in fs]
        self.input_connections = [
            f.registerCallback(self.add, queue, i) for i, (f, queue) in enumerate(zip(fs, self.queues))]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        with self.lock:
            self._keep(my_queue, time_of(msg.header.stamp).nanoseconds, msg)
            for time in sorted(set.intersection(*(set(queue) for queue in self.queues))):
                self.signalMessage(*(queue[time] for queue in self.queues))
                # Older messages are dropped: a set of them would come out of order.
                for queue in self.queues:
                    for old in [one for one in queue if one <= time]:
                        del queue[old]

    def _keep(self, queue: Queue, time: int, msg: Any) -> None:
        queue[time] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Messages whose times lie less than `slop` seconds apart. `sync_arrival_time`: the times at which they come."""

    def __init__(
        self, fs: Sequence[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False,
        sync_arrival_time: bool = False
    ) -> None:
        super().__init__(fs, queue_size)
        self.slop = Duration(seconds=slop)
        self.allow_headerless = allow_headerless
        self.sync_arrival_time = sync_arrival_time

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        stamp = ROSClock().now() if self.sync_arrival_time else \
            stamp_of(msg, self.allow_headerless, 'message_filters_approx')
        if stamp is None:
            return
        with self.lock:
            self._keep(my_queue, stamp.nanoseconds, msg)
            times = self._times_around(stamp.nanoseconds, my_queue_index)
            if times is None:
                return
            self.signalMessage(*(queue[time] for queue, time in zip(self.queues, times)))
            for queue, time in zip(self.queues, times):
                del queue[time]

    def _times_around(self, stamp: int, index: int | None) -> tuple[int, ...] | None:
        """One time of each queue, those close to `stamp` first; of the queue at `index` it is `stamp`."""
        slop = self.slop.nanoseconds
        choices = []
        for i, queue in enumerate(self.queues):
            near = [stamp] if i == index else sorted(
                (time for time in queue if abs(time - stamp) <= slop), key=lambda time: abs(time - stamp))
            choices.append([time for time in near if time in queue])
        return next((times for times in itertools.product(*choices) if max(times) - min(times) < slop), None)
