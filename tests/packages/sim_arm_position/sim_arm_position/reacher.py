"""Sends the joints to angles, and looks where the tip of the arm is then."""
import math

import rclpy
from rclpy.node import Node
from rclpy.time import Time
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from tf2_ros import Buffer, TransformException, TransformListener

POSES = [
    ('up', (0.0, 0.0, 0.0)),
    ('ahead', (0.0, math.radians(30), math.radians(60))),
    ('left', (math.radians(90), math.radians(30), math.radians(60))),
]
JOINTS = ('base', 'upper', 'fore')


class Reacher(Node):

    def __init__(self):
        super().__init__('reacher')
        self.publishers_of_joints = [self.create_publisher(Float64, f'/{name}_cmd', 10) for name in JOINTS]
        self.create_subscription(JointState, '/joint_states', self.on_joints, 10)
        self.tf_buffer = Buffer()
        self.tf_listener = TransformListener(self.tf_buffer, self)
        self.angles = {}
        self.index = 0
        self.rested = 0
        self.timer = self.create_timer(0.1, self.tick)

    def on_joints(self, msg):
        self.angles = dict(zip(msg.name, msg.position))

    def tick(self):
        if not self.angles or self.index == len(POSES):
            return
        name, targets = POSES[self.index]
        for publisher, target in zip(self.publishers_of_joints, targets):
            publisher.publish(Float64(data=target))
        worst = max(abs(self.angles[f'{joint}_joint'] - target) for joint, target in zip(JOINTS, targets))
        self.rested = self.rested + 1 if worst < 0.01 else 0
        if self.rested < 10:
            return
        try:
            tip = self.tf_buffer.lookup_transform('world', 'tip', Time()).transform.translation
        except TransformException as error:
            self.get_logger().info(f'no tip yet: {error}', throttle_duration_sec=1.0)
            return
        self.get_logger().info(f'{name}: the tip is at {tip.x + 0.0:.2f} {tip.y + 0.0:.2f} {tip.z:.2f}')
        self.index += 1
        self.rested = 0


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Reacher())


if __name__ == '__main__':
    main()
