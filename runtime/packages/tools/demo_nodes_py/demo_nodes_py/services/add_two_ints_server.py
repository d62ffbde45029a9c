"""Adds two numbers for whoever asks."""
import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class AddTwoIntsServer(Node):

    def __init__(self):
        super().__init__('add_two_ints_server')
        self.service = self.create_service(AddTwoInts, 'add_two_ints', self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        self.get_logger().info(f'Incoming request\na: {request.a} b: {request.b}')
        return response


def main(args=None):
    try:
        with rclpy.init(args=args):
            rclpy.spin(AddTwoIntsServer())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
