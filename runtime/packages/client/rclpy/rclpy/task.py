"""Futures, and tasks that executors run."""
from __future__ import annotations

import inspect
import sys
import threading
import warnings
import weakref
from asyncio import events
from collections.abc import Callable, Coroutine, Generator
from enum import Enum
from typing import Any

from ros2wasm import host


class FutureState(Enum):
    PENDING = 'PENDING'
    CANCELLED = 'CANCELLED'
    FINISHED = 'FINISHED'


class Future:
    """A result that is there later."""

    def __init__(self, *, executor: Any = None) -> None:
        self._state = FutureState.PENDING
        self._result: Any = None
        self._exception: BaseException | None = None
        self._exception_fetched = False
        self._callbacks: list[Callable[[Future], Any]] = []
        #: What wakes the loops of asyncio whose tasks wait for it.
        self._sleepers: list[Callable[[], None]] = []
        self._executor: weakref.ref[Any] | None = None
        self._set_executor(executor)

    def __del__(self) -> None:
        if self._exception is not None and not self._exception_fetched:
            print(f'The following exception was never retrieved: {self._exception}', file=sys.stderr)

    def __await__(self) -> Generator[Any, None, Any]:
        while self._state is FutureState.PENDING:
            loop = events._get_running_loop()
            if loop is None or _steps.depth:
                # Tells the task what it waits for.
                yield self
            else:
                yield from self._sleep(loop)
        return self.result()

    def _sleep(self, loop: events.AbstractEventLoop) -> Generator[Any, None, None]:
        """What a task of asyncio waits for: its loop is told when this is done."""
        told = loop.create_future()

        def tell() -> None:
            if not told.done():
                told.set_result(None)

        def wake() -> None:
            if not loop.is_closed():
                loop.call_soon_threadsafe(tell)
        self._sleepers.append(wake)
        return told.__await__()

    def cancel(self) -> None:
        """Give up, if it is not done."""
        if self._state is FutureState.PENDING:
            self._state = FutureState.CANCELLED
            self._schedule_or_invoke_done_callbacks()

    def cancelled(self) -> bool:
        return self._state is FutureState.CANCELLED

    def done(self) -> bool:
        """Is there a result, or was it given up?"""
        return self._state is not FutureState.PENDING

    def result(self) -> Any:
        """The result; raises the exception that is in its place."""
        if self._exception is not None:
            self._exception_fetched = True
            raise self._exception
        return self._result

    def exception(self) -> BaseException | None:
        """The exception in place of a result."""
        self._exception_fetched = True
        return self._exception

    def set_result(self, result: Any) -> None:
        """Be done."""
        self._result = result
        self._state = FutureState.FINISHED
        self._schedule_or_invoke_done_callbacks()

    def set_exception(self, exception: BaseException) -> None:
        """Be done, with an exception."""
        self._exception = exception
        self._exception_fetched = False
        self._state = FutureState.FINISHED
        self._schedule_or_invoke_done_callbacks()

    def _schedule_or_invoke_done_callbacks(self) -> None:
        executor = self._executor() if self._executor is not None else None
        callbacks, self._callbacks = self._callbacks, []
        # Continue every wait for this future.
        host.wake()
        for wake in self._sleepers:
            wake()
        self._sleepers.clear()
        if executor is None:
            for callback in callbacks:
                self._invoke(callback)
            return
        for callback in callbacks:
            executor.create_task(callback, self)

    def _invoke(self, callback: Callable[[Future], Any]) -> None:
        try:
            callback(self)
        except Exception as error:
            # Nobody waits for what a callback says.
            warnings.warn(f'Unhandled exception in done callback: {error}', stacklevel=2)

    def _set_executor(self, executor: Any) -> None:
        """The executor that steps what waits for it."""
        self._executor = None if executor is None else weakref.ref(executor)

    def add_done_callback(self, callback: Callable[[Future], Any]) -> None:
        """Have something called when it is done."""
        if not self.done():
            self._callbacks.append(callback)
            return
        executor = self._executor() if self._executor is not None else None
        if executor is not None:
            executor.create_task(callback, self)
        else:
            self._invoke(callback)


class _Steps(threading.local):
    """Tasks in the middle of a step in this thread, one within the other."""

    depth = 0


_steps = _Steps()


class Task(Future):
    """A function to call, or a coroutine to step."""

    def __init__(
        self, handler: Callable[..., Any] | Coroutine[Any, Any, Any], args: Any = None, kwargs: Any = None,
        executor: Any = None
    ) -> None:
        super().__init__(executor=executor)
        if inspect.iscoroutine(handler):
            self._handler: Any = handler
            self._args: Any = None
            self._kwargs: Any = None
        elif inspect.iscoroutinefunction(handler):
            self._handler = handler(*(args or []), **(kwargs or {}))
            self._args = self._kwargs = None
        else:
            self._handler = handler
            self._args = args or []
            self._kwargs = kwargs or {}
        self._executing = False
        #: A thread is about to step it.
        self._claimed = False
        #: What its last step yielded: a future, or anything else to give way once.
        self._yielded: Any = None
        self._gave_way = False

    def __call__(self) -> None:
        """Call it, or step it."""
        if self._state is not FutureState.PENDING or self._executing:
            return
        self._executing = True
        try:
            if inspect.iscoroutine(self._handler):
                _steps.depth += 1
                try:
                    self._yielded = self._handler.send(None)
                    self._gave_way = not isinstance(self._yielded, Future)
                except StopIteration as end:
                    self.set_result(end.value)
                    self._complete_task()
                finally:
                    _steps.depth -= 1
            else:
                self.set_result(self._handler(*self._args, **self._kwargs))
                self._complete_task()
        except Exception as error:
            self.set_exception(error)
            self._complete_task()
        finally:
            self._executing = False

    def _complete_task(self) -> None:
        self._handler = None
        self._args = None
        self._kwargs = None

    def _is_due(self) -> bool:
        """Can it be stepped, or forgotten, now?"""
        if self._executing or self._claimed:
            return False
        if self.done():
            return True
        if self._gave_way:
            return False
        return not isinstance(self._yielded, Future) or self._yielded.done()

    def executing(self) -> bool:
        """Is it in the middle of a step?"""
        return self._executing
