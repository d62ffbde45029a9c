import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String


def main():
    with rclpy.init():
        node = rclpy.create_node('describer')
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        publisher = node.create_publisher(String, '/robot_description', kept)
        publisher.publish(String(data='<robot/>'))
        rclpy.spin(node)
