"""An action server whose goals sleep, and a client in another thread: one goal runs to its end, one is cancelled."""
import threading
import time

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class Errands(Node):
    def __init__(self):
        super().__init__('errands')
        self.waiting = []
        self.server = ActionServer(
            self, Fibonacci, 'errand', self.run, callback_group=ReentrantCallbackGroup(),
            goal_callback=lambda goal: GoalResponse.REJECT if goal.order < 0 else GoalResponse.ACCEPT,
            handle_accepted_callback=self.defer, cancel_callback=lambda goal: CancelResponse.ACCEPT)
        self.client = ActionClient(self, Fibonacci, 'errand', callback_group=ReentrantCallbackGroup())

    def defer(self, goal):
        self.waiting.append(goal)
        self.create_timer(0.05, self.begin)

    def begin(self):
        while self.waiting:
            self.waiting.pop().execute()

    def run(self, goal):
        numbers = [0, 1]
        for _ in range(goal.request.order):
            if goal.is_cancel_requested:
                goal.canceled()
                return Fibonacci.Result(sequence=numbers)
            numbers.append(numbers[-1] + numbers[-2])
            goal.publish_feedback(Fibonacci.Feedback(sequence=numbers))
            time.sleep(0.05)
        goal.succeed()
        return Fibonacci.Result(sequence=numbers)

    def sent(self, goal, **options):
        told = threading.Event()
        future = self.client.send_goal_async(goal, **options)
        future.add_done_callback(lambda _: told.set())
        told.wait()
        return future.result()

    def send(self):
        self.client.wait_for_server()
        print('rejected', not self.sent(Fibonacci.Goal(order=-1)).accepted)
        feedback = []
        done = self.client.send_goal(
            Fibonacci.Goal(order=3), feedback_callback=lambda told: feedback.append(len(told.feedback.sequence)))
        print('done', done.status, list(done.result.sequence), feedback)
        begun = threading.Event()
        goal = self.sent(Fibonacci.Goal(order=100_000), feedback_callback=lambda _: begun.set())
        begun.wait()
        answer = goal.cancel_goal()
        print('cancelled', len(answer.goals_canceling), goal.get_result().status)


def main():
    with rclpy.init():
        node = Errands()
        executor = MultiThreadedExecutor(num_threads=3)
        executor.add_node(node)
        spinner = threading.Thread(target=executor.spin, name='spinner')
        spinner.start()
        node.send()
        executor.shutdown()
        spinner.join()
        node.destroy_node()
    print('errands are done')
