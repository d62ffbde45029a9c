"""Says hello once a second."""
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Talker(Node):

    def __init__(self):
        super().__init__('talker')
        self.count = 0
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.timer = self.create_timer(1.0, self.talk)

    def talk(self):
        message = String(data=f'Hello World: {self.count}')
        self.count += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self.publisher.publish(message)


def main(args=None):
    try:
        with rclpy.init(args=args):
            rclpy.spin(Talker())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
