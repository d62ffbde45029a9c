"""Asks for 2 + 3, and waits for the answer."""
import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import ExternalShutdownException


def main(args=None):
    try:
        with rclpy.init(args=args):
            ask(rclpy.create_node('add_two_ints_client'))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


def ask(node):
    client = node.create_client(AddTwoInts, 'add_two_ints')
    while not client.wait_for_service(timeout_sec=1.0):
        print('service not available, waiting again...', flush=True)
    answer = client.call_async(AddTwoInts.Request(a=2, b=3))
    rclpy.spin_until_future_complete(node, answer)
    if answer.result() is not None:
        node.get_logger().info(f'Result of add_two_ints: {answer.result().sum}')
    else:
        node.get_logger().error(f'Exception while calling service: {answer.exception()!r}')
