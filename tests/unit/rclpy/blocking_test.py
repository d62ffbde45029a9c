"""What blocks natively blocks here: who waits for what only an executor takes, while no executor can take it."""
from __future__ import annotations

import contextlib
import importlib
import io
import unittest
from collections.abc import Callable
from typing import Any
from unittest import mock

from tests.unit.rclpy.fake_bus import BusTest

#: What the bus says to a wait without end when nothing more is going to happen.
FOR_EVER = 'nothing would end this wait'


class BlockingTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        self.trigger = importlib.import_module('std_srvs.srv').Trigger
        self.groups = importlib.import_module('rclpy.callback_groups')
        self.executors = importlib.import_module('rclpy.executors')
        self.meanwhile = importlib.import_module('ros2wasm.meanwhile')
        self.meanwhile._told.clear()
        # So that help comes with the first wait.
        self.enterContext(mock.patch.object(self.meanwhile, 'HELP_AFTER_NS', 0))

    def blocks(self, wait: Callable[[], Any]) -> str:
        """Make sure that it waits for ever; the help that is given."""
        said = io.StringIO()
        with contextlib.redirect_stderr(said), self.assertRaisesRegex(AssertionError, FOR_EVER):
            wait()
        return said.getvalue()

    def asking(self, name: str, group: Any = None) -> tuple[Any, Any, list[Any]]:
        """A node whose timer calls a service of the node itself: the node, its client, what was answered."""
        node = self.node(name)
        answers: list[Any] = []
        others = self.groups.ReentrantCallbackGroup()
        node.create_service(self.trigger, 'service', lambda _, answer: answer, callback_group=others)
        client = node.create_client(self.trigger, 'service', callback_group=group)

        def ask() -> None:
            timer.cancel()
            answers.append(client.call(self.trigger.Request()))
        timer = node.create_timer(0.0, ask)
        return node, client, answers

    def test_a_call_in_a_callback_of_a_single_thread(self) -> None:
        for group in (None, self.groups.MutuallyExclusiveCallbackGroup()):
            with self.subTest(group=group):
                node, _, answers = self.asking('single', group)
                executor = self.executors.SingleThreadedExecutor(context=node.context)
                executor.add_node(node)
                self.meanwhile._told.clear()
                said = self.blocks(executor.spin)
                self.assertTrue(said.startswith(
                    '[ros2wasm] Client.call waits in a callback of the executor that must take what it waits for, and '
                    'has one thread: it may never go on, as in ROS 2. '), said)
                self.assertEqual(said.count('\n'), 1)
                self.assertEqual(answers, [])

    def test_a_call_in_a_callback_of_the_group_of_the_client(self) -> None:
        node, _, answers = self.asking('exclusive')
        executor = self.executors.MultiThreadedExecutor(2, context=node.context)
        executor.add_node(node)
        said = self.blocks(executor.spin)
        self.assertIn('Client.call waits for what belongs to a callback group of which a callback runs', said)
        self.assertEqual(answers, [])

    def test_a_call_that_another_group_lets_through(self) -> None:
        node, _, answers = self.asking('free', self.groups.MutuallyExclusiveCallbackGroup())
        executor = self.executors.MultiThreadedExecutor(2, context=node.context)
        executor.add_node(node)
        self.spin_these(executor, lambda: bool(answers))

    def spin_these(self, executor: Any, done: Callable[[], bool]) -> None:
        for _ in range(100):
            if done():
                return
            executor.spin_once(timeout_sec=0)
        self.fail('it does not come')

    def test_a_call_while_nobody_spins(self) -> None:
        node, client, _ = self.asking('unspun')
        said = self.blocks(lambda: client.call(self.trigger.Request()))
        self.assertIn('Client.call waits for what only an executor takes, and nobody spins the node', said)
        # Nor is it taken when the answer has come.
        pending = client.call_async(self.trigger.Request())
        self.assertIsNone(client.call(self.trigger.Request(), timeout_sec=0.01))
        self.assertFalse(pending.done())
        node.destroy_node()

    def test_a_rate_is_a_timer_that_somebody_spins(self) -> None:
        node = self.node('rated')
        rate = node.create_rate(1e6)
        self.assertIn(rate._timer, list(node.timers))
        said = self.blocks(rate.sleep)
        self.assertIn('Rate.sleep waits for what only an executor takes, and nobody spins the node', said)
        executor = self.executors.MultiThreadedExecutor(2, context=node.context)
        executor.add_node(node)
        turns: list[int] = []

        def turn() -> None:
            timer.cancel()
            for number in range(3):
                rate.sleep()
                turns.append(number)
        timer = node.create_timer(0.0, turn)
        self.spin_these(executor, lambda: len(turns) == 3)
        executor.remove_node(node)
        self.assertTrue(node.destroy_rate(rate))
        self.assertNotIn(rate._timer, list(node.timers))
        with self.assertRaisesRegex(RuntimeError, 'Rate cannot sleep because it has been destroyed'):
            rate.sleep()

    def test_who_waits_is_back_for_the_timers_of_others(self) -> None:
        node = self.node('timed')
        executor = self.executors.MultiThreadedExecutor(2, context=node.context)
        executor.add_node(node)
        rate = node.create_rate(20.0)
        waits: list[int] = []
        host = importlib.import_module('ros2wasm.host')
        wait = host.wait
        ends: list[int] = []

        def noted(token: int, timeout_ns: int) -> Any:
            waits.append(timeout_ns)
            return wait(token, timeout_ns)

        def tick() -> None:
            timer.cancel()
            self.enterContext(mock.patch.object(host, 'wait', noted))
            rate.sleep()
            ends.append(1)
        timer = node.create_timer(0.0, tick)
        self.enterContext(mock.patch.object(self.meanwhile, 'HELP_AFTER_NS', 5_000_000_000))
        self.spin_these(executor, lambda: bool(ends))
        self.assertTrue(waits)
        self.assertLessEqual(max(waits), 50_000_000)

    def test_a_rate_in_a_callback_of_a_single_thread(self) -> None:
        node = self.node('in_timer')
        rate = node.create_rate(1e6)
        ends: list[int] = []

        def tick() -> None:
            rate.sleep()
            ends.append(1)
        node.create_timer(0.0, tick)
        executor = self.executors.SingleThreadedExecutor(context=node.context)
        executor.add_node(node)

        def spin() -> None:
            while True:
                executor.spin_once()
        self.assertIn('Rate.sleep waits in a callback of the executor', self.blocks(spin))
        self.assertEqual(ends, [])

    def test_told_time_goes_on_for_who_spins(self) -> None:
        clock_message = importlib.import_module('rosgraph_msgs.msg').Clock
        parameter = importlib.import_module('rclpy.parameter').Parameter
        duration = importlib.import_module('rclpy.duration').Duration
        node = self.node('told', parameter_overrides=[parameter('use_sim_time', value=True)])
        teller = self.node('teller').create_publisher(clock_message, '/clock', 1)
        self.assertEqual([one.topic_name for one in node.subscriptions], ['/clock'])
        message = clock_message()
        message.clock.sec = 5
        teller.publish(message)
        self.blocks(lambda: node.get_clock().sleep_for(duration(seconds=1), self.context))
        self.assertEqual(node.get_clock().now().nanoseconds, 0)
        self.spin_until(lambda: bool(node.get_clock().now().nanoseconds == 5_000_000_000))


if __name__ == '__main__':
    unittest.main()
