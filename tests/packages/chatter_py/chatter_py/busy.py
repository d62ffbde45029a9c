"""Hears messages, in spin and beside asyncio, while a thread computes without end. Ends by hand."""
import asyncio
import threading

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String


class Busy(Node):
    def __init__(self):
        super().__init__('busy')
        self.turns = 0
        self.heard = 0
        self.third = Future()
        self.create_subscription(String, 'chatter', self.hear, 10)
        threading.Thread(target=self.turn, daemon=True).start()

    def turn(self):
        while True:
            self.turns += 1

    def hear(self, _):
        self.heard += 1
        if self.heard >= 3 and not self.third.done():
            self.third.set_result(self.heard)


async def rush(until):
    while not until.done():
        await asyncio.sleep(0)


async def wait(node):
    node.heard, node.third = 0, Future()
    _, heard = await asyncio.gather(rush(node.third), node.third)
    return heard


def main():
    with rclpy.init():
        node = Busy()
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        executor.spin_until_future_complete(node.third)
        print('heard', node.third.result() >= 3, 'while a thread computes', node.turns > 0)
        spinner = threading.Thread(target=executor.spin)
        spinner.start()
        print('awaited', asyncio.run(wait(node)) >= 3, 'in a loop that never rests')
        executor.shutdown()
        spinner.join()
        try:
            rclpy.spin(node)
        except (KeyboardInterrupt, ExternalShutdownException):
            print('busy is stopped by hand')
