from learn_interfaces.srv import AddThreeInts
import rclpy
from rclpy.node import Node


class Adder(Node):

    def __init__(self):
        super().__init__('adder')
        self.create_service(AddThreeInts, 'add_three_ints', self.add)

    def add(self, request, response):
        response.sum = request.a + request.b + request.c
        self.get_logger().info('Incoming request a: %d b: %d c: %d' % (request.a, request.b, request.c))
        return response


def main():
    rclpy.init()
    rclpy.spin(Adder())
