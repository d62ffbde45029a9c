from geometry_msgs.msg import Point
from learn_interfaces.msg import Num, Sphere
import rclpy
from rclpy.node import Node


class NumPublisher(Node):

    def __init__(self):
        super().__init__('num_publisher')
        self.publisher_ = self.create_publisher(Num, 'num', 10)
        self.spheres = self.create_publisher(Sphere, 'sphere', 10)
        self.timer = self.create_timer(0.1, self.timer_callback)
        self.i = 0

    def timer_callback(self):
        self.publisher_.publish(Num(num=self.i))
        self.spheres.publish(Sphere(center=Point(x=1.0, y=2.0, z=float(self.i)), radius=0.5, kind=Sphere.HOLLOW))
        self.get_logger().info('Publishing: "%d"' % self.i)
        self.i += 1


def main():
    rclpy.init()
    rclpy.spin(NumPublisher())
