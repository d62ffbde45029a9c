import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import String


def main():
    rclpy.init()
    node = rclpy.create_node('waiter')
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    success, msg = wait_for_message(String, node, '/robot_description', qos_profile=kept, time_to_wait=10.0)
    node.get_logger().info('described: %s %s' % (success, msg.data))
    success, msg = wait_for_message(String, node, '/silence', time_to_wait=0.2)
    node.get_logger().info('silence: %s %s' % (success, msg))

    def heard(msg, info):
        node.get_logger().info('%s was sent before it came: %s' % (
            msg.data, 0 < info['source_timestamp'] <= info['received_timestamp']))
        node.heard = True

    node.heard = False
    node.create_subscription(String, '/robot_description', heard, kept)
    while not node.heard:
        rclpy.spin_once(node, timeout_sec=0.1)
    node.destroy_node()
    rclpy.shutdown()
