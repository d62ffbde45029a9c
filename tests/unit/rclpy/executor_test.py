"""Executors, tasks and timers on a host that only counts wakes: a wait that nothing would end fails the test."""
from __future__ import annotations

import importlib
import types
import unittest
from collections.abc import Generator
from typing import Any
from unittest import mock

from tests.unit.rclpy.installation import WOKEN, install, install_host


class GiveWay:
    def __await__(self) -> Generator[None, None, None]:
        yield


class ExecutorTest(unittest.TestCase):
    rclpy: Any

    @classmethod
    def setUpClass(cls) -> None:
        install(cls)
        install_host(cls)
        cls.rclpy = importlib.import_module('rclpy')

    def setUp(self) -> None:
        context = importlib.import_module('rclpy.context').Context()
        context.init([])
        self.addCleanup(context.try_shutdown)
        self.executor = self.rclpy.executors.SingleThreadedExecutor(context=context)

    def spin(self, future: Any) -> Any:
        self.executor.spin_until_future_complete(future, 5)
        self.assertTrue(future.done())
        return future.result()

    def test_an_exception_of_a_task_comes_out_of_spin(self) -> None:
        async def fail() -> None:
            raise ZeroDivisionError('of the task')
        self.executor.create_task(fail)
        with self.assertRaisesRegex(ZeroDivisionError, 'of the task'):
            self.executor.spin()

    def test_a_task_goes_on_when_what_it_awaits_is_done(self) -> None:
        future = self.rclpy.task.Future()

        async def ask() -> int:
            return 1 + int(await future)
        waiting = self.executor.create_task(ask)
        self.executor.spin_once(timeout_sec=0)
        self.executor.create_task(future.set_result, 4)
        self.assertEqual(self.spin(waiting), 5)

    def test_the_end_of_a_future_ends_a_wait(self) -> None:
        host = importlib.import_module('ros2wasm.host')
        token = host.wake_token()
        self.rclpy.task.Future().set_result(None)
        self.assertEqual(host.wait(token, -1), host.WOKEN)

    def test_a_task_that_gives_way_goes_on_by_itself(self) -> None:
        said: list[str] = []

        async def count(name: str) -> str:
            for i in range(3):
                said.append(f'{name}{i}')
                await GiveWay()
            return name
        first, second = (self.executor.create_task(count, name) for name in 'ab')
        future = self.rclpy.task.Future(executor=self.executor)
        second.add_done_callback(lambda _: future.set_result(first.done()))
        self.assertTrue(self.spin(future))
        self.assertEqual(said, ['a0', 'b0', 'a1', 'b1', 'a2', 'b2'])

    def test_a_thread_is_refused_where_nothing_can_be_suspended(self) -> None:
        threads = importlib.import_module('ros2wasm.threads').threads
        with self.assertRaisesRegex(RuntimeError, 'R2W0714.*start new thread'):
            threads.start(print, ())

    def test_a_lock_is_taken_and_given_back(self) -> None:
        lock = importlib.import_module('ros2wasm.threads').Lock()
        self.assertTrue(lock.acquire())
        self.assertFalse(lock.acquire(blocking=False))
        self.assertFalse(lock.acquire(timeout=0))
        lock.release()
        self.assertFalse(lock.locked())
        with self.assertRaisesRegex(RuntimeError, 'release unlocked lock'):
            lock.release()
        with self.assertRaises(ValueError):
            lock.acquire(False, 1)

    def test_callbacks_that_wait_nest_as_deep_as_there_are_threads(self) -> None:
        executor = self.rclpy.executors.MultiThreadedExecutor(2, context=self.executor.context)
        depths: list[int] = []

        def wait() -> None:
            depths.append(executor._depth)
            executor._run_meanwhile(0)
        for _ in range(4):
            executor.create_task(wait)
        executor.spin_once(timeout_sec=0)
        self.assertEqual(depths, [0, 1, 2])

    def test_who_spins_an_executor_that_spins_is_told(self) -> None:
        # Compatibility, works: `RuntimeError: Executor is already spinning`, as since rclpy 7.1.9
        said: list[str] = []
        future = self.rclpy.task.Future(executor=self.executor)

        def nested() -> None:
            for spin in (self.executor.spin, self.executor.spin_once, lambda: self.spin(future)):
                with self.assertRaisesRegex(RuntimeError, '^Executor is already spinning$'):
                    spin()
            other = self.rclpy.executors.SingleThreadedExecutor(context=self.executor.context)
            other.create_task(said.append, 'in another')
            other.spin_once(timeout_sec=0)
            raise ValueError('nested')
        self.executor.create_task(nested)
        with self.assertRaisesRegex(ValueError, 'nested'):
            self.executor.spin_once(timeout_sec=0)
        self.assertEqual(said, ['in another'])
        # Whatever came of it, it can be spun again.
        self.executor.create_task(future.set_result, 1)
        self.assertTrue(self.spin(future))

    def test_an_executor_of_the_users_own_has_its_own_turns(self) -> None:
        turns: list[str] = []

        class Own(self.rclpy.executors.Executor):  # type: ignore[name-defined, misc]
            def spin_once(self, timeout_sec: float | None = None) -> None:
                turns.append('turn')
                super().spin_once(0)
                if len(turns) == 3:
                    self.shutdown()
        Own(context=self.executor.context).spin()
        self.assertEqual(turns, ['turn'] * 3)

    def test_a_future_that_is_waited_for_again_and_again_knows_it_once(self) -> None:
        future = self.rclpy.task.Future(executor=self.executor)
        for _ in range(3):
            self.executor.spin_until_future_complete(future, 0)
        self.assertEqual(len(future._callbacks), 1)

    def test_the_executor_of_events_calls_back(self) -> None:
        from_package = importlib.import_module('rclpy.experimental').EventsExecutor
        module = importlib.import_module('rclpy.experimental.events_executor')
        executor = module.EventsExecutor(context=self.executor.context)
        self.assertIsInstance(executor, from_package)
        said: list[int] = []
        executor.create_task(said.append, 1)
        executor.spin_once(timeout_sec=0)
        self.assertEqual(said, [1])

    def test_a_sleep_lasts_to_its_end_whatever_wakes_it(self) -> None:
        start = importlib.import_module('ros2wasm.start')
        now, slept = [0], list[int]()

        def sleep(duration_ns: int) -> int:
            slept.append(duration_ns)
            now[0] += min(duration_ns, 400_000_000)
            return WOKEN
        with mock.patch.object(start.host, 'sleep', sleep), \
                mock.patch.object(start, 'time', types.SimpleNamespace(monotonic_ns=lambda: now[0])):
            start.sleep(1)
        self.assertEqual(slept, [1_000_000_000, 600_000_000, 200_000_000])

    def test_a_context_forgets_whose_methods_it_was_to_call(self) -> None:
        context = self.executor.context
        before = len(context._callbacks)
        executor = self.rclpy.executors.SingleThreadedExecutor(context=context)
        self.assertEqual(len(context._callbacks), before + 1)
        del executor
        self.assertEqual(len(context._callbacks), before)

    def test_a_sleep_by_a_clock_that_is_told_notes_no_jumps(self) -> None:
        clock = importlib.import_module('rclpy.clock').ROSClock()
        time = importlib.import_module('rclpy.time').Time
        clock._set_ros_time_is_active(True)
        host = importlib.import_module('ros2wasm.host')

        def tell(_token: int, _timeout_ns: int) -> int:
            self.assertEqual(len(clock._jump_handles), 1)
            clock.set_ros_time_override(time(nanoseconds=clock._now_ns() + 1, clock_type=clock.clock_type))
            return WOKEN
        with mock.patch.object(host, 'wait', tell):
            until = time(nanoseconds=1000, clock_type=clock.clock_type)
            self.assertTrue(clock.sleep_until(until, self.executor.context))
        with mock.patch.object(host, 'wait', lambda *_: clock._set_ros_time_is_active(False)):
            until = time(nanoseconds=2000, clock_type=clock.clock_type)
            self.assertFalse(clock.sleep_until(until, self.executor.context))

    def test_open_policies_are_chosen_by_those_who_are_there(self) -> None:
        best = importlib.import_module('rclpy.impl.best_available')
        qos = importlib.import_module('rclpy.qos')
        bus = importlib.import_module('ros2wasm.host').Qos
        open_ = qos.qos_profile_best_available
        self.assertTrue(best.is_open(open_))
        weak = bus(2, 2, 1, 5, 1, 30, 0, 0)
        strong = bus(1, 1, 1, 5, 3, 20, 0, 7)

        def chosen(others: list[Any], for_subscription: bool) -> tuple[Any, ...]:
            found = best.choose(open_, others, for_subscription)
            self.assertFalse(best.is_open(found))
            return tuple(map(int, qos.to_bus(found)[:2])) + tuple(qos.to_bus(found)[4:6]) + (qos.to_bus(found)[7],)
        self.assertEqual(chosen([weak, strong], True), (2, 2, 1, 30, 7))
        self.assertEqual(chosen([strong], True), (1, 1, 3, 20, 7))
        self.assertEqual(chosen([weak, strong], False), (1, 1, 3, 20, 7))
        self.assertEqual(chosen([], False), (1, 1, 1, 0, 0))

    def test_who_takes_calls_out_hears_when_one_has_ended(self) -> None:
        host = importlib.import_module('ros2wasm.host')
        ended: list[Any] = []
        entity = types.SimpleNamespace(callback_group=types.SimpleNamespace(ending_execution=ended.append))
        token = host.wake_token()
        self.executor._execute(entity, None, lambda: None)
        self.assertEqual(host.wake_token(), token)
        task = self.executor.create_task(print)
        call, of, node = self.executor.wait_for_ready_callbacks(0)
        call()
        self.assertTrue(task.done())
        token = host.wake_token()
        self.executor._execute(entity, None, lambda: None)
        self.assertNotEqual(host.wake_token(), token)
        self.assertEqual((of, node, ended), (None, None, [entity, entity]))

    def test_a_task_may_end_its_executor(self) -> None:
        self.executor.create_task(self.executor.shutdown)
        self.executor.spin()
        self.assertEqual(self.executor._tasks, [])

    def test_a_cancelled_task_is_forgotten(self) -> None:
        self.executor.create_task(print).cancel()
        self.executor.spin_once(timeout_sec=0)
        self.assertEqual(self.executor._tasks, [])

    def test_a_timer_starts_anew_when_time_jumps_back_or_comes_from_elsewhere(self) -> None:
        clock = importlib.import_module('rclpy.clock').ROSClock()
        time = importlib.import_module('rclpy.time').Time
        timer = self.rclpy.timer.Timer(None, None, 10, clock, context=self.executor.context)

        def tell(now: int) -> None:
            clock.set_ros_time_override(time(nanoseconds=now, clock_type=clock.clock_type))
        tell(1000)
        clock._set_ros_time_is_active(True)
        self.assertEqual(timer.time_until_next_call(), 10)
        tell(1009)
        self.assertEqual(timer.time_until_next_call(), 1)
        tell(100)
        self.assertEqual((timer.time_until_next_call(), timer.time_since_last_call()), (10, 0))
        timer.destroy()
        self.assertEqual(clock._jump_handles, [])


if __name__ == '__main__':
    unittest.main()
