import sys
import threading

from example_interfaces.srv import AddTwoInts
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


class MinimalClient(Node):

    def __init__(self):
        super().__init__('minimal_client')
        self.cli = self.create_client(AddTwoInts, 'add_two_ints', callback_group=MutuallyExclusiveCallbackGroup())
        while not self.cli.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('service not available, waiting again...')

    def send_request(self, a, b):
        future = self.cli.call_async(AddTwoInts.Request(a=a, b=b))
        rclpy.spin_until_future_complete(self, future)
        return future.result()

    def ask_in_a_timer(self):
        self.done = False
        self.timer = self.create_timer(0.05, self.timer_callback, callback_group=MutuallyExclusiveCallbackGroup())

    def timer_callback(self):
        self.timer.cancel()
        response = self.cli.call(AddTwoInts.Request(a=20, b=22))
        self.get_logger().info('in a callback: %d' % response.sum)
        self.done = True


def main():
    rclpy.init()
    minimal_client = MinimalClient()
    a, b = (int(sys.argv[1]), int(sys.argv[2])) if len(sys.argv) > 2 else (41, 1)
    response = minimal_client.send_request(a, b)
    minimal_client.get_logger().info('Result of add_two_ints: for %d + %d = %d' % (a, b, response.sum))

    # The synchronous call, while another thread spins.
    spin_thread = threading.Thread(target=rclpy.spin, args=(minimal_client,))
    spin_thread.start()
    response = minimal_client.cli.call(AddTwoInts.Request(a=2, b=3))
    minimal_client.get_logger().info('while a thread spins: %d' % response.sum)
    rclpy.shutdown()
    spin_thread.join()

    # The synchronous call in a callback, while another callback group takes the answer.
    rclpy.init()
    another = MinimalClient()
    another.ask_in_a_timer()
    executor = MultiThreadedExecutor()
    executor.add_node(another)
    # With a limit: when the callback ends, there may be nothing left that would end a turn without one.
    while not another.done:
        executor.spin_once(timeout_sec=0.1)
    executor.shutdown()
    another.destroy_node()
    rclpy.shutdown()


if __name__ == '__main__':
    main()
