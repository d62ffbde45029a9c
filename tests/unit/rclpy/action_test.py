"""Actions between two nodes of one process: goals, feedback, results, cancelling."""
from __future__ import annotations

import importlib
import unittest
from typing import Any
from unittest import mock

from tests.unit.rclpy.fake_bus import BusTest


class ActionTest(BusTest):
    def setUp(self) -> None:
        super().setUp()
        self.action = importlib.import_module('rclpy.action')
        self.type = importlib.import_module('example_interfaces.action').Fibonacci
        self.status = importlib.import_module('action_msgs.msg').GoalStatus
        self.cancel = importlib.import_module('action_msgs.srv').CancelGoal
        self.serving, self.asking = self.node('serving'), self.node('asking')
        self.goals: list[Any] = []
        self.feedback: list[list[int]] = []

    def serve(self, execute: Any = None, **options: Any) -> Any:
        def run(goal: Any) -> Any:
            for end in range(1, goal.request.order + 1):
                goal.publish_feedback(self.type.Feedback(sequence=list(range(end))))
            goal.succeed()
            return self.type.Result(sequence=list(range(goal.request.order)))
        return self.action.ActionServer(self.serving, self.type, 'count', execute or run, **options)

    def keep(self, **options: Any) -> Any:
        """A server that does not execute its goals."""
        return self.serve(handle_accepted_callback=self.goals.append, **options)

    def ask(self) -> Any:
        return self.action.ActionClient(self.asking, self.type, 'count')

    def sent(self, client: Any, order: int) -> Any:
        return self.result(client.send_goal_async(
            self.type.Goal(order=order), lambda told: self.feedback.append(list(told.feedback.sequence))))

    def cancelled(self, client: Any, **info: Any) -> tuple[int, int]:
        """Of the answer: the code, and how many goals it names."""
        request = self.cancel.Request()
        for name, value in info.items():
            setattr(request.goal_info, name, value)
        answer = self.result(client._cancel_client.call_async(request))
        return answer.return_code, len(answer.goals_canceling)

    def test_a_goal_tells_how_far_it_is_and_succeeds(self) -> None:
        server, client = self.serve(), self.ask()
        self.assertTrue(client.wait_for_server(0))
        goal = self.sent(client, 3)
        self.assertTrue(goal.accepted)
        result = self.result(goal.get_result_async())
        self.assertEqual((result.status, list(result.result.sequence)), (self.status.STATUS_SUCCEEDED, [0, 1, 2]))
        self.spin_until(lambda: bool(goal.status == self.status.STATUS_SUCCEEDED))
        self.assertEqual(self.feedback, [[0], [0, 1], [0, 1, 2]])
        server.destroy()
        self.assertFalse(client.wait_for_server(0.01))
        self.assertNotIn(server, self.serving.waitables)

    def test_an_action_leaves_nothing_on_the_bus(self) -> None:
        before = set(self.bus.endpoints)
        with self.serve(), self.ask() as client:
            self.assertEqual(len(self.bus.endpoints), len(before) + 10)
        self.assertEqual(set(self.bus.endpoints), before)
        client.destroy()

    def test_a_goal_may_be_waited_for_to_its_end(self) -> None:
        def run(goal: Any) -> Any:
            goal.succeed()
            return self.type.Result(sequence=[goal.request.order])
        self.serve(run, goal_callback=lambda goal: self.action.GoalResponse(2 if goal.order else 1))
        client = self.ask()
        # As the other threads do that natively spin meanwhile.
        meanwhile = mock.patch.object(
            importlib.import_module('ros2wasm.meanwhile'), 'spinning',
            [mock.Mock(_run_meanwhile=lambda _: self.executor._spin_once_impl(0) or True)])
        with meanwhile:
            done = client.send_goal(self.type.Goal(order=7))
            self.assertEqual((done.status, list(done.result.sequence)), (self.status.STATUS_SUCCEEDED, [7]))
            rejected = client.send_goal(self.type.Goal())
        self.assertEqual((rejected.status, list(rejected.result.sequence)), (self.status.STATUS_UNKNOWN, []))

    def test_feedback_is_told_also_when_the_result_is_heard_first(self) -> None:
        self.serve()
        client = self.ask()
        goal = self.sent(client, 3)
        future = goal.get_result_async()
        self.spin_until(lambda: bool(self.bus.endpoints[client._result_client._endpoint.handle].queue))
        told = len(self.feedback)
        self.assertLess(told, 3)
        # As a thread does that waits for the result.
        self.assertTrue(client._result_client._receive())
        self.assertTrue(future.done())
        self.spin_until(lambda: len(self.feedback) == 3)

    def test_a_goal_that_ended_or_was_given_up_keeps_no_callback(self) -> None:
        self.serve()
        client = self.ask()
        self.sent(client, 2)
        # Nobody asks for its result.
        self.spin_until(lambda: not client._goal_handles)
        self.spin_until(lambda: len(self.feedback) == 2)
        self.assertEqual(client._feedback_callbacks, {})
        future = client.send_goal_async(self.type.Goal(order=3), self.feedback.append)
        future.cancel()
        self.spin_until(lambda: not client._feedback_callbacks)
        self.spin_until(lambda: not client._goal_client._pending_requests)
        self.assertTrue(future.cancelled())
        self.assertEqual(client._goal_handles, {})
        self.assertEqual(len(self.feedback), 2)

    def test_a_server_written_for_older_releases_runs(self) -> None:
        def run(goal: Any) -> Any:
            if goal.is_cancel_requested or goal.request.order < 0:
                goal.set_aborted()
            else:
                goal.set_succeeded()
            return self.type.Result(sequence=[goal.request.order])

        def accept(goal_request: Any) -> Any:
            return self.action.GoalResponse.ACCEPT if goal_request.order < 9 else self.action.GoalResponse.REJECT
        self.serve(run, goal_callback=accept)
        client = self.ask()
        ends = [self.result(self.sent(client, order).get_result_async()).status for order in (3, -1, 9)]
        self.assertEqual(
            ends, [self.status.STATUS_SUCCEEDED, self.status.STATUS_ABORTED, self.status.STATUS_UNKNOWN])

    def test_goals_are_rejected_and_unknown_ones_have_no_result(self) -> None:
        self.serve(goal_callback=lambda goal: self.action.GoalResponse.REJECT)
        goal = self.sent(self.ask(), 3)
        self.assertFalse(goal.accepted)
        self.assertEqual(self.result(goal.get_result_async()).status, self.status.STATUS_UNKNOWN)

    def test_a_goal_is_cancelled_by_its_id(self) -> None:
        self.keep(cancel_callback=lambda goal: self.action.CancelResponse.ACCEPT)
        client = self.ask()
        goal = self.sent(client, 3)
        answer = self.result(goal.cancel_goal_async())
        self.assertEqual((answer.return_code, len(answer.goals_canceling)), (self.cancel.Response.ERROR_NONE, 1))
        self.assertTrue(self.goals[0].is_cancel_requested)
        self.goals[0].canceled()
        self.assertEqual(
            self.cancelled(client, goal_id=goal.goal_id), (self.cancel.Response.ERROR_GOAL_TERMINATED, 0))
        unknown = type(goal.goal_id)(uuid=list(range(16)))
        self.assertEqual(self.cancelled(client, goal_id=unknown), (self.cancel.Response.ERROR_UNKNOWN_GOAL_ID, 0))

    def test_a_goal_that_is_being_cancelled_is_not_asked_again(self) -> None:
        asked: list[Any] = []

        def say(goal: Any) -> Any:
            asked.append(goal)
            return self.action.CancelResponse.ACCEPT
        self.keep(cancel_callback=say)
        client = self.ask()
        goal = self.sent(client, 3)
        self.assertEqual(self.cancelled(client, goal_id=goal.goal_id), (self.cancel.Response.ERROR_NONE, 1))
        self.assertEqual(
            self.cancelled(client, goal_id=goal.goal_id), (self.cancel.Response.ERROR_GOAL_TERMINATED, 0))
        self.assertEqual(len(asked), 1)

    def test_to_cancel_all_of_none_is_no_error(self) -> None:
        self.keep(cancel_callback=lambda goal: self.action.CancelResponse.ACCEPT)
        client = self.ask()
        self.assertEqual(self.cancelled(client), (self.cancel.Response.ERROR_NONE, 0))
        self.sent(client, 3)
        self.sent(client, 3)
        self.assertEqual(self.cancelled(client), (self.cancel.Response.ERROR_NONE, 2))

    def test_a_goal_that_is_accepted_is_told_of_before_it_runs(self) -> None:
        told: list[int] = []
        message = self.type.Impl.GoalStatusMessage
        self.asking.create_subscription(
            message, 'count/_action/status', lambda said: told.extend(one.status for one in said.status_list), 10)
        self.keep()
        self.sent(self.ask(), 3)
        self.spin_until(lambda: bool(told))
        self.assertEqual(told, [self.status.STATUS_ACCEPTED])

    def test_a_result_is_kept_for_a_quarter_of_an_hour(self) -> None:
        self.assertEqual(self.serve()._result_timeout_ns, 900_000_000_000)

    def test_a_server_without_a_callback_leads_its_goals_itself(self) -> None:
        self.action.ActionServer(self.serving, self.type, 'count', handle_accepted_callback=self.goals.append)
        client = self.ask()
        goals = [self.sent(client, 3) for _ in range(2)]
        for own in self.goals:
            own.execute()
        self.goals[0].succeed(self.type.Result(sequence=[5]))
        self.goals[1].abort()
        results = [self.result(goal.get_result_async()) for goal in goals]
        self.assertEqual(
            [(one.status, list(one.result.sequence)) for one in results],
            [(self.status.STATUS_SUCCEEDED, [5]), (self.status.STATUS_ABORTED, [])])

    def test_the_first_result_of_a_goal_counts(self) -> None:
        def run(goal: Any) -> Any:
            if goal.request.order:
                goal.succeed(self.type.Result(sequence=[1]))
            else:
                goal.succeed()
            return self.type.Result(sequence=[2])
        self.serve(run)
        client = self.ask()
        found = [list(self.result(self.sent(client, order).get_result_async()).result.sequence) for order in (1, 0)]
        self.assertEqual(found, [[1], [2]])

    def test_a_server_may_refuse_to_cancel(self) -> None:
        self.keep()
        client = self.ask()
        goal = self.sent(client, 3)
        self.assertEqual(self.cancelled(client, goal_id=goal.goal_id), (self.cancel.Response.ERROR_REJECTED, 0))
        self.assertFalse(self.goals[0].is_cancel_requested)


if __name__ == '__main__':
    unittest.main()
