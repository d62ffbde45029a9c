"""What belongs together between init and shutdown."""
from __future__ import annotations

import sys
import weakref
from collections.abc import Callable, Sequence
from types import MethodType, TracebackType
from typing import Any

from rclpy._rclpy_pybind11 import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError
from ros2wasm import host, log
from ros2wasm.arguments import ArgumentError, Arguments, parse

#: Contexts that are initialised, in the order in which they were.
g_contexts: list[weakref.ref[Context]] = []
g_logging_configured = False


class Context:
    """From init to shutdown. Its arguments hold for all of its nodes."""

    def __init__(self) -> None:
        self._valid = False
        self._arguments = Arguments()
        self._domain_id: int | None = None
        self._callbacks: list[Callable[[], Any]] = []
        self._logging_initialized = False

    @property
    def handle(self) -> Context:
        return self

    def init(
        self, args: Sequence[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None
    ) -> None:
        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f'Domain id ({domain_id}) should not be lower than zero.')
        if self._valid:
            raise RuntimeError('Context.init() must only be called once')
        try:
            arguments = parse(list(args if args is not None else sys.argv))
        except ArgumentError as error:
            raise RCLInvalidROSArgsError(f'failed to initialize rcl: {error}') from None
        if arguments.unknown:
            raise UnknownROSArgsError(arguments.unknown)
        self._arguments = arguments
        self._domain_id = 0 if domain_id is None else domain_id
        if initialize_logging:
            self._configure_logging()
        self._valid = True
        g_contexts.append(weakref.ref(self))

    def _configure_logging(self) -> None:
        for name, level in self._arguments.log_levels:
            log.logging.set_level(name, level)
        log.logging.console = self._arguments.log_stdout
        self._logging_initialized = True

    def ok(self) -> bool:
        """Between init and shutdown?"""
        return self._valid

    def shutdown(self) -> None:
        """End. RCLError: it has ended already."""
        if not self._valid:
            raise RCLError('failed to shutdown: rcl_shutdown already called on the given context')
        self._end()

    def try_shutdown(self) -> None:
        """End, if it has not."""
        if self._valid:
            self._end()

    def _end(self) -> None:
        self._valid = False
        g_contexts[:] = [one for one in g_contexts if one() not in (None, self)]
        callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            if isinstance(callback, weakref.WeakMethod):
                method = callback()
                if method is not None:
                    method()
            else:
                callback()
        host.wake()

    def destroy(self) -> None:
        """Nothing lies behind it that would have to be freed."""

    def on_shutdown(self, callback: Callable[[], None]) -> None:
        """Have something called at the end. Methods are held weakly."""
        if not callable(callback):
            raise TypeError('callback should be a callable, got {}', type(callback))
        if not self._valid:
            callback()
        elif isinstance(callback, MethodType):
            self._callbacks.append(weakref.WeakMethod(callback, self._forget))
        else:
            self._callbacks.append(callback)

    def _forget(self, callback: Any) -> None:
        """Its object is gone."""
        if callback in self._callbacks:
            self._callbacks.remove(callback)

    def get_domain_id(self) -> int:
        """The number that was given; all of a site are in one domain."""
        if self._domain_id is None:
            from rclpy.exceptions import NotInitializedException
            raise NotInitializedException('Context')
        return self._domain_id

    def __enter__(self) -> Context:
        # The context is initialised by whoever enters it.
        if not self._valid:
            self.init()
        return self

    def __exit__(
        self, exc_type: type[BaseException] | None, exc_val: BaseException | None, exc_tb: TracebackType | None
    ) -> None:
        self.try_shutdown()


def shut_down_all() -> None:
    """What a signal does."""
    for reference in list(g_contexts):
        context = reference()
        if context is not None:
            context.try_shutdown()
