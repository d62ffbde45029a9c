"""Threads of a program: one runs at a time, and none makes the program deaf."""
from __future__ import annotations

import contextlib
import importlib
import io
import signal
import threading
import unittest
from collections.abc import Callable, Coroutine
from typing import Any

from tests.unit.rclpy.fake_bus import BusTest

# Compatibility, differs: threads of a Python node -> one runs at a time: who waits lets the next go on, who computes
# is interrupted after 5 ms, between two bytecodes; they gain no time. A publish that waits for a slow reader keeps all
# waiting

#: Looks of a thread that computes, after which somebody should have ended it.
MANY = 1000


class ThreadsCase(BusTest):
    suspends = True

    def setUp(self) -> None:
        super().setUp()
        self.host: Any = importlib.import_module('ros2wasm.host')
        self.module: Any = importlib.import_module('ros2wasm.threads')
        self.threads = self.module.Threads()
        self.module.threads = self.host.threads = self.threads
        before = signal.getsignal(self.module.SLICE_SIGNAL)
        self.addCleanup(signal.signal, self.module.SLICE_SIGNAL, before)
        self.addCleanup(setattr, self.host, 'threads', None)
        self.addCleanup(setattr, self.bus, 'on_turn', lambda: None)
        self.bus.stops = self.bus.stops_told = self.bus.turns = 0

    def compute(self, done: Callable[[], bool]) -> int:
        """As a thread that never waits: after each slice of time it is interrupted."""
        for count in range(MANY):
            if done():
                return count
            self.bus.slice_over = True
            self.threads.look_up()
        return MANY


class ThreadsTest(ThreadsCase):
    """Stacks that wait, and stacks that compute."""

    def test_locks_are_handed_over_from_stack_to_stack(self) -> None:
        lock, said = self.module.Lock(), list[str]()

        def speak(name: str) -> None:
            with lock:
                said.append(f'{name} begins')
                self.host.sleep(1_000_000)
                said.append(f'{name} ends')
        lock.acquire()
        for name in 'ab':
            self.threads.start(speak, (name,))
        self.host.sleep(1_000_000)
        self.assertEqual(said, [])
        lock.release()
        while self.threads.count > 1:
            self.host.sleep(1_000_000)
        self.assertEqual(said, ['a begins', 'a ends', 'b begins', 'b ends'])

    def test_a_lock_is_waited_for_no_longer_than_said(self) -> None:
        lock, ends = self.module.Lock(), self.module.Lock()
        ends.acquire()
        self.threads.start(ends.acquire, ())
        lock.acquire()
        self.assertFalse(lock.acquire(timeout=0.01))
        ends.release()
        self.host.sleep(1_000_000)
        self.assertEqual(self.threads.count, 1)

    def test_messages_come_while_a_thread_computes(self) -> None:
        """As on the port link: what comes is seen only where the program waits or sleeps."""
        heard, looks = list[int](), list[int]()
        self.bus.on_turn = lambda: self.bus.wake() if self.bus.turns > 10 else None
        self.threads.start(lambda: looks.append(self.compute(lambda: bool(heard))), ())
        token = self.host.wake_token()
        self.host.wait(token, -1)
        heard.append(self.host.wake_token())
        while self.threads.count > 1:
            self.host.sleep(1_000_000)
        self.assertLess(looks[0], MANY)

    def test_a_stop_comes_while_a_thread_computes_and_the_main_one_waits(self) -> None:
        def turn() -> None:
            self.bus.stops = int(self.bus.turns > 10)
        over = list[int]()
        self.bus.on_turn = turn
        self.threads.start(self.compute, (lambda: bool(over),))
        with self.assertRaises(KeyboardInterrupt):
            self.host.wait(self.host.wake_token(), -1)
        over.append(1)
        while self.threads.count > 1:
            self.host.sleep(1_000_000)

    def test_a_stop_that_another_thread_hears_of_is_kept_for_the_main_one(self) -> None:
        main = threading.get_ident()
        heard_in, over = list[int](), list[int]()

        def turn() -> None:
            if self.bus.turns > 10 and threading.get_ident() != main and not self.bus.stops:
                self.bus.stops = 1
                heard_in.append(threading.get_ident())
        self.bus.on_turn = turn
        self.threads.start(self.compute, (lambda: bool(over),))
        with self.assertRaises(KeyboardInterrupt):
            # Neither of them rests.
            self.compute(lambda: False)
        self.assertEqual(len(heard_in), 1)
        over.append(1)
        while self.threads.count > 1:
            self.host.sleep(1_000_000)

    def test_a_stop_comes_with_a_thread_that_computes_alone(self) -> None:
        def turn() -> None:
            self.bus.stops = 1
        self.bus.on_turn = turn
        self.bus.slice_over = True
        with self.assertRaises(KeyboardInterrupt):
            self.host.look_around()

    def test_a_function_that_fails_is_told_of_and_the_others_go_on(self) -> None:
        def fail() -> None:
            raise LookupError('nothing here')
        with contextlib.redirect_stderr(io.StringIO()) as told:
            self.threads.start(fail, ())
            self.host.sleep(1_000_000)
        self.assertEqual(self.threads.count, 1)
        self.assertRegex(told.getvalue(), r'(?s)^Exception ignored in thread started by: .*fail.*LookupError: nothing')

    def test_a_stop_comes_with_a_program_that_only_publishes(self) -> None:
        string = importlib.import_module('std_msgs.msg').String
        publisher = self.node('shouting').create_publisher(string, 'chatter', 1)
        publisher.publish(string(data='in its slice'))

        def turn() -> None:
            self.bus.stops = 1
        self.bus.on_turn = turn
        self.bus.slice_over = True
        with self.assertRaises(KeyboardInterrupt):
            publisher.publish(string(data='after it'))

    def test_who_computes_among_sleepers_has_its_whole_slice(self) -> None:
        over = list[int]()
        self.threads.start(self.compute, (lambda: bool(over),))
        self.bus.on_turn = lambda: over.append(1) if self.bus.turns > 10 else None
        self.host.sleep(50_000_000)
        self.assertEqual(self.threads.count, 1)
        self.assertFalse(self.bus.slice_over)


class AsyncioTest(ThreadsCase):
    """Loops of asyncio, whose tasks await what other threads bring."""

    def run_loop(self, main: Coroutine[Any, Any, Any]) -> Any:
        loop = importlib.import_module('ros2wasm.event_loop').LinkEventLoop()
        try:
            return loop.run_until_complete(main)
        finally:
            loop.close()

    def test_a_loop_that_never_rests_hears_what_comes(self) -> None:
        asyncio = importlib.import_module('asyncio')
        self.bus.on_turn = lambda: self.bus.wake()
        token = self.host.wake_token()

        async def wait() -> int:
            for count in range(MANY):
                if self.host.wake_token() != token:
                    return count
                self.bus.slice_over = True
                await asyncio.sleep(0)
            return MANY
        self.assertLess(self.run_loop(wait()), MANY)

    def test_a_task_of_asyncio_sleeps_until_another_thread_brings_the_result(self) -> None:
        future = self.rclpy.task.Future()

        def bring() -> None:
            self.host.sleep(10_000_000)
            future.set_result('brought')
        self.threads.start(bring, ())

        async def ask() -> Any:
            return await future
        self.bus.turns = 0
        self.assertEqual(self.run_loop(ask()), 'brought')
        self.assertLess(self.bus.turns, 20)
        while self.threads.count > 1:
            self.host.sleep(1_000_000)

    def test_a_task_of_asyncio_may_await_while_another_thread_is_in_a_step(self) -> None:
        future, stepping = self.rclpy.task.Future(), list[int]()

        async def step() -> None:
            stepping.append(1)
            self.host.sleep(10_000_000)
            future.set_result('brought')
        task = self.rclpy.task.Task(step)
        self.threads.start(task, ())
        self.host.sleep(1_000_000)
        self.assertEqual((len(stepping), task.executing()), (1, True))

        async def ask() -> Any:
            return await future
        self.assertEqual(self.run_loop(ask()), 'brought')

    def test_a_task_of_asyncio_that_is_cancelled_is_not_told(self) -> None:
        asyncio = importlib.import_module('asyncio')
        future = self.rclpy.task.Future()

        async def ask() -> str:
            try:
                await asyncio.wait_for(wait_for(future), 0.01)
            except asyncio.TimeoutError:
                future.set_result(None)
                await asyncio.sleep(0)
                return 'gave up'
            return 'went on'

        async def wait_for(what: Any) -> Any:
            return await what
        self.assertEqual(self.run_loop(ask()), 'gave up')


if __name__ == '__main__':
    unittest.main()
