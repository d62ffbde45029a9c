"""
Executors: they wait for work and call back.

One turn: read the wake token, look what is ready (tasks, timers, subscriptions, services, clients, waitables), else
wait until the token changes or a timer is due. No turn polls.

A turn is called by a function that is not Python's (call_afresh), so that it begins a frame of the interpreter's own.
An engine compiles the interpreter better while that runs, and uses the better code for frames that begin from then on:
one that goes round for ever would stay in what it began with.
"""
from __future__ import annotations

import inspect
import time
import warnings
from collections import deque
from collections.abc import Callable, Coroutine
from functools import partial
from operator import call as call_afresh
from threading import get_ident
from types import TracebackType
from typing import Any, NamedTuple

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.context import Context
from rclpy.event_handler import EventHandler
from rclpy.guard_condition import GuardCondition
from rclpy.impl.elsewhere import names_of
from rclpy.subscription import Subscription
from rclpy.task import Future, Task
from rclpy.timer import Timer
from rclpy.utilities import get_default_context, timeout_sec_to_nsec
from ros2wasm import host, meanwhile
from ros2wasm.entities import changes

__getattr__ = names_of(__name__, {
    'concurrent.futures': 'ThreadPoolExecutor',
    'rclpy.client': 'Client',
    'rclpy.clock': 'Clock',
    'rclpy.clock_type': 'ClockType',
    'rclpy.exceptions': 'InvalidHandle',
    'rclpy.service': 'Service',
    'rclpy.waitable': 'NumberOfEntities Waitable',
    'threading': 'Condition Lock RLock',
    'typing': 'ContextManager Generator List Optional Set Tuple Type TypeVar Union',
})


class TimeoutException(Exception):
    """The time is over."""


class ShutdownException(Exception):
    """The executor has ended."""


class ExternalShutdownException(Exception):
    """The context ended while somebody spun."""

    def __init__(self) -> None:
        super().__init__()


class ConditionReachedException(Exception):
    """What was waited for holds."""


class TimeoutObject:
    """A timeout that its owner may change."""

    def __init__(self, timeout: float) -> None:
        self._timeout = timeout

    @property
    def timeout(self) -> float:
        return self._timeout

    @timeout.setter
    def timeout(self, timeout: float) -> None:
        self._timeout = timeout


async def await_or_execute(callback: Any, *args: Any) -> Any:
    """Call, and await what is a coroutine function."""
    if inspect.iscoroutinefunction(callback):
        return await callback(*args)
    return callback(*args)


#: What is done for an entity that is ready; None: somebody else was quicker. May give a coroutine.
Call = Callable[[], Any]


class Work(NamedTuple):
    """One call of a callback, with what it belongs to."""

    call: Call
    entity: Any
    node: Any


class Executor:
    """The base class of executors."""

    def __init__(self, *, context: Context | None = None) -> None:
        self._context = get_default_context() if context is None else context
        self._nodes: list[Any] = []
        #: Tasks that are not done, with entity and node.
        self._tasks: list[tuple[Task, Any, Any]] = []
        self._is_shutdown = False
        self._is_spinning = False
        #: The thread of the last spin.
        self._spins_in = 0
        self._queue: deque[tuple[Any, Any]] = deque()
        self._seen = -1
        self._readers: dict[int, tuple[Any, Any]] = {}
        self._timers: list[tuple[Timer, Any]] = []
        self._guards: list[tuple[GuardCondition, Any]] = []
        self._waitables: list[tuple[Any, Any]] = []
        self._events: list[tuple[EventHandler, Any]] = []
        #: While the statuses are of this version, no event is ready.
        self._quiet_version = -1
        #: The subscription that was called last: where nothing else is due, its next message comes with the look.
        self._heard: tuple[Any, Any] | None = None
        #: Only subscriptions, services and clients: nothing else can be due.
        self._only_readers = False
        #: Calls are made in other threads than the one that spins.
        self._in_threads = False
        #: An executor of the user's own takes calls out and makes them wherever it likes.
        self._hands_out_calls = False
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Context:
        return self._context

    # ---- nodes

    def add_node(self, node: Any) -> bool:
        """Call back for this node too. False: it was there already."""
        if node in self._nodes:
            return False
        self._nodes.append(node)
        node.executor = self
        changes.add()
        host.wake()
        return True

    def remove_node(self, node: Any) -> None:
        """Call back for it no more."""
        if node in self._nodes:
            self._nodes.remove(node)
            changes.add()
            host.wake()

    def get_nodes(self) -> list[Any]:
        return list(self._nodes)

    def wake(self) -> None:
        """End its wait."""
        host.wake()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """End: nothing is called any more."""
        self._is_shutdown = True
        self._nodes = []
        self._tasks = []
        self._queue.clear()
        changes.add()
        host.wake()
        return True

    def __enter__(self) -> Executor:
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.shutdown()

    # ---- tasks

    def create_future(self) -> Future:
        return Future(executor=self)

    def create_task(
        self, callback: Callable[..., Any] | Coroutine[Any, Any, Any], *args: Any, **kwargs: Any
    ) -> Task:
        """Call it, or step it, while spinning; a Future of its result."""
        task = Task(callback, args, kwargs, executor=self)
        self._add_task(task, None, None)
        return task

    def _add_task(self, task: Task, entity: Any, node: Any) -> None:
        self._tasks.append((task, entity, node))
        host.wake()

    # ---- what is ready

    def _refresh(self) -> None:
        """Learn what the nodes have, when that changed."""
        if self._seen == changes.count:
            return
        self._seen = changes.count
        self._heard = None
        self._readers = {}
        self._timers, self._guards, self._waitables, self._events = [], [], [], []
        self._quiet_version = -1
        for node in self._nodes:
            for timer in node._timers:
                self._timers.append((timer, node))
            for reader in (*node._subscriptions, *node._services, *node._clients):
                self._readers[reader._endpoint.handle] = (reader, node)
            for guard in node._guards:
                self._guards.append((guard, node))
            for waitable in node._rw_waitables:
                (self._events if isinstance(waitable, EventHandler) else self._waitables).append((waitable, node))
                for handle in waitable._rw_handles():
                    self._readers[handle] = (waitable, node)
        self._only_readers = not (self._timers or self._guards or self._waitables)

    def can_execute(self, entity: Any) -> bool:
        """Whether its group allows a call now."""
        group = entity.callback_group
        return group is None or bool(group.can_execute(entity))

    def _is_alone(self) -> bool:
        """Whether nothing that goes before messages, or is ready without one, can be due."""
        if self._tasks or self._guards or self._waitables:
            return False
        for timer, _ in self._timers:
            if not timer._destroyed and timer.is_ready():
                return False
        return True

    def _hear(self, reader: Any) -> tuple[Any, host.Seen | None]:
        """The subscription's next message, for which its group is held, if nothing else is ready; or what there is."""
        if reader._with_info or reader.raw:
            return None, host.look()
        group = reader.callback_group
        found: tuple[Any, host.Seen | None]
        if group.__class__ is MutuallyExclusiveCallbackGroup:
            # A shortcut for most subscriptions. No other stack runs between the look and the hold.
            if group._active_entity is not None:
                return None, host.look()
            found = reader._endpoint.look_and_take(reader._codec, self._quiet_version)
            if found[1] is None:
                group._active_entity = reader
            return found
        if group is not None and not group.beginning_execution(reader):
            return None, host.look()
        held = False
        try:
            found = reader._endpoint.look_and_take(reader._codec, self._quiet_version)
            held = found[1] is None
            return found
        finally:
            if not held and group is not None:
                group.ending_execution(reader)

    def _collect(self, seen: host.Seen) -> int:
        """Queue all that can be executed now. Returns the wake token of before."""
        token, version, handles = seen
        for entry in self._tasks:
            if entry[0]._is_due():
                self._queue.append((entry, None))
        for timer, node in self._timers:
            if not timer._destroyed and timer.is_ready() and self.can_execute(timer):
                self._queue.append((timer, node))
        for guard, node in self._guards:
            if guard._triggered and self.can_execute(guard):
                self._queue.append((guard, node))
        for handle in handles:
            found = self._readers.get(handle)
            if found is not None:
                if self.can_execute(found[0]):
                    self._queue.append(found)
        if self._events:
            self._collect_events(version)
        else:
            self._quiet_version = version
        for waitable, node in self._waitables:
            if (waitable, node) not in self._queue and self.can_execute(waitable) and waitable._rw_ready():
                self._queue.append((waitable, node))
        return token

    def _collect_events(self, version: int) -> None:
        """Queue those of the endpoints whose statuses changed; looked at only when something did."""
        if version == self._quiet_version:
            return
        self._quiet_version = version
        for handler, node in self._events:
            if not self.can_execute(handler):
                self._quiet_version = -1
            elif handler._rw_ready():
                self._quiet_version = -1
                self._queue.append((handler, node))

    def _pop(self) -> Work | None:
        """The next call of the queue that is still due."""
        while self._queue:
            entity, node = self._queue.popleft()
            if isinstance(entity, tuple):
                task, owner, of = entity
                if task.done():
                    self._forget((task, owner, of))
                    continue
                task._claimed = True
                return Work(partial(self._step, entity), owner, of)
            group = entity.callback_group
            if entity._destroyed or (group is not None and not group.beginning_execution(entity)):
                continue
            try:
                call: Call | None = entity._rw_take_call()
            except BaseException:
                if group is not None:
                    group.ending_execution(entity)
                raise
            if call is None:
                if group is not None:
                    group.ending_execution(entity)
                continue
            if isinstance(entity, Subscription):
                self._heard = entity, node
            return Work(partial(self._execute, entity, node, call), entity, node)
        return None

    def _step(self, entry: tuple[Task, Any, Any]) -> None:
        task = entry[0]
        task._claimed = False
        task()
        if task.done():
            self._forget(entry)
            task.result()

    def _forget(self, entry: tuple[Task, Any, Any]) -> None:
        """Be done with a task. It may be gone already: a shutdown forgets all."""
        if entry not in self._tasks:
            return
        self._tasks.remove(entry)
        entity = entry[1]
        if entity is not None and entity.callback_group is not None:
            entity.callback_group.ending_execution(entity)

    def _end_giving_way(self) -> bool:
        """Let tasks go on that gave way without waiting for anything. False: there are none."""
        gave_way = [task for task, _, _ in self._tasks if task._gave_way]
        for task in gave_way:
            task._gave_way = False
        return bool(gave_way)

    def _execute(self, entity: Any, node: Any, call: Callable[..., Any], *args: Any) -> None:
        group = entity.callback_group
        held = group is not None
        try:
            result = call(*args)
            if result is not None and inspect.iscoroutine(result):
                # The group stays taken until the coroutine ends.
                task = Task(result, executor=self)
                entry: tuple[Task, Any, Any] = (task, entity, node)
                self._tasks.append(entry)
                held = False
                self._step(entry)
        finally:
            if held:
                group.ending_execution(entity)
            if self._tasks:
                self._end_giving_way()
            if self._in_threads or self._hands_out_calls:
                # Others of the group may be called now, by whoever spins.
                host.wake()

    def _next_work(
        self, timeout_ns: int, condition: Callable[[], bool], seen: host.Seen | None = None
    ) -> Work:
        """
        Wait for work. Raises TimeoutException, ShutdownException or ConditionReachedException.

        `seen`: what there is, from a moment ago.
        """
        end = None if timeout_ns < 0 else time.monotonic_ns() + timeout_ns
        while True:
            if self._is_shutdown:
                raise ShutdownException()
            if not self._context.ok():
                raise ExternalShutdownException()
            if self._seen != changes.count:
                self._refresh()
            work = self._pop() if self._queue else None
            if work is not None:
                return work
            heard = self._heard
            if seen is None and heard is not None and self._is_alone():
                reader, node = heard
                message, seen = self._hear(reader)
                if seen is None:
                    return Work(partial(self._execute, reader, node, reader._callback, message), reader, node)
            token = self._collect(host.look() if seen is None else seen)
            seen = None
            work = self._pop() if self._queue else None
            if work is not None:
                return work
            if condition():
                raise ConditionReachedException()
            if self._end_giving_way():
                host.wait(token, 0)
                continue
            if self._is_shutdown or not self._context.ok() or self._seen != changes.count:
                # Another thread did that before the token was read.
                continue
            wait = -1
            if end is not None:
                wait = end - time.monotonic_ns()
                if wait <= 0 and timeout_ns != 0:
                    raise TimeoutException()
                wait = max(wait, 0)
            result = host.wait(token, self._until_timers(wait))
            if timeout_ns == 0 and result == host.TIMEOUT:
                raise TimeoutException()

    def _until_timers(self, wait_ns: int) -> int:
        """How long to wait for a timer that can be called, and no longer than so long. Negative: without end."""
        for timer, _ in self._timers:
            until = None if timer._destroyed or not self.can_execute(timer) else timer._wait_ns()
            if until is not None and (wait_ns < 0 or until < wait_ns):
                wait_ns = until
        return wait_ns

    # ---- spinning

    def _wake_for(self, _: Future) -> None:
        self.wake()

    def _enter_spin(self) -> None:
        """One stack spins at a time; a callback that spins the executor that called it would wait for itself."""
        if self._is_spinning:
            raise RuntimeError('Executor is already spinning')
        self._is_spinning = True
        self._spins_in = get_ident()

    def _exit_spin(self) -> None:
        self._is_spinning = False

    def spin(self) -> None:
        """Call back until the end."""
        if type(self).spin_once is not Executor.spin_once:
            # An executor of the user's own, with turns of its own.
            while self._context.ok() and not self._is_shutdown:
                self.spin_once()
            return
        self._enter_spin()
        try:
            while self._context.ok() and not self._is_shutdown:
                call_afresh(self._spin_once_impl)
        finally:
            self._exit_spin()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Call back until the future is done or the time is over."""
        if self._wake_for not in future._callbacks:
            future.add_done_callback(self._wake_for)
        end = None if timeout_sec is None or timeout_sec < 0 else time.monotonic() + timeout_sec
        own = type(self).spin_once_until_future_complete is not Executor.spin_once_until_future_complete
        if not own:
            self._enter_spin()
        try:
            while self._context.ok() and not future.done() and not self._is_shutdown:
                left = None if end is None else end - time.monotonic()
                if left is not None and left < 0:
                    return
                if own:
                    self.spin_once_until_future_complete(future, left)
                else:
                    call_afresh(self._spin_once_impl, left, future.done)
        finally:
            if not own:
                self._exit_spin()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Call back once."""
        self._enter_spin()
        try:
            call_afresh(self._spin_once_impl, timeout_sec)
        finally:
            self._exit_spin()

    def spin_once_until_future_complete(
        self, future: Future, timeout_sec: float | TimeoutObject | None = None
    ) -> None:
        """Call back once, unless the future is done before."""
        seconds = timeout_sec.timeout if isinstance(timeout_sec, TimeoutObject) else timeout_sec
        self._enter_spin()
        try:
            call_afresh(self._spin_once_impl, seconds, future.done)
        finally:
            self._exit_spin()

    def _spin_once_impl(
        self, timeout_sec: float | None = None, condition: Callable[[], bool] = lambda: False
    ) -> None:
        seen: host.Seen | None = None
        heard = self._heard
        if heard is not None and not self._queue and self._seen == changes.count and self._context._valid \
                and not self._is_shutdown and (self._only_readers and not self._tasks or self._is_alone()):
            # The way of most messages, in as few steps as can be.
            reader, node = heard
            message, seen = self._hear(reader)
            if seen is None:
                self._execute(reader, node, reader._callback, message)
                return
        try:
            work = self._next_work(timeout_sec_to_nsec(timeout_sec), condition, seen)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        work.call()

    def wait_for_ready_callbacks(
        self, timeout_sec: float | None = None, nodes: Any = None, condition: Callable[[], bool] = lambda: False
    ) -> tuple[Callable[[], None], Any, Any]:
        """Wait for a call: the call, what it is of, and the node."""
        self._hands_out_calls = True
        work = self._next_work(timeout_sec_to_nsec(timeout_sec), condition)
        return work.call, work.entity, work.node


class SingleThreadedExecutor(Executor):
    """One callback after the other."""


#: As many as on a machine of the usual size: there is no other number here.
DEFAULT_THREADS = 4


class MultiThreadedExecutor(Executor):
    """
    Runs callbacks of different groups side by side, in threads of its own.

    Where the browser cannot suspend a program there is one thread: a callback that waits for a service lets those of
    other groups run meanwhile, one that sleeps does not.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        self._num_threads = DEFAULT_THREADS if num_threads is None else num_threads
        if self._num_threads == 1:
            warnings.warn('MultiThreadedExecutor is used with a single thread.\n'
                          'Use the SingleThreadedExecutor instead.', stacklevel=2)
        self._in_threads = host.can_switch()
        self._futures: list[Any] = []
        self._executor: Any = None
        if self._in_threads:
            from concurrent.futures import ThreadPoolExecutor
            self._executor = ThreadPoolExecutor(self._num_threads)
        #: Callbacks that wait for a service, one within the other.
        self._depth = 0

    def _spin_once_impl(
        self, timeout_sec: float | None = None, condition: Callable[[], bool] = lambda: False
    ) -> None:
        if not self._in_threads:
            with meanwhile.in_one_thread(self):
                super()._spin_once_impl(timeout_sec, condition)
            return
        try:
            work = self._next_work(timeout_sec_to_nsec(timeout_sec), condition)
        except (ExternalShutdownException, ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._futures.append(self._executor.submit(work.call))
        for future in [one for one in self._futures if one.done()]:
            self._futures.remove(future)
            # Raises the exception of the callback, if it raised one.
            future.result()

    def shutdown(self, timeout_sec: float | None = None, *, wait_for_threads: bool = True) -> bool:
        done = super().shutdown(timeout_sec)
        if self._executor is not None:
            self._executor.shutdown(wait=wait_for_threads)
        return done

    def _run_meanwhile(self, token: int) -> bool:
        """For a callback that waits, in the only thread: execute one of another group. False: nothing is to do."""
        if self._depth >= self._num_threads:
            return False
        self._refresh()
        work = self._pop()
        if work is None:
            self._collect(host.look())
            work = self._pop()
        if work is not None:
            self._depth += 1
            try:
                work.call()
            finally:
                self._depth -= 1
            return True
        if self._end_giving_way():
            host.wait(token, 0)
            return True
        return False
