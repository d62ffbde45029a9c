import threading
import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int32


class Groups(Node):

    def __init__(self):
        super().__init__('groups')
        self.lock = threading.Lock()
        self.inside = 0
        self.most = 0
        self.alone = 0
        self.most_alone = 0
        self.counts = []
        reentrant = ReentrantCallbackGroup()
        exclusive = MutuallyExclusiveCallbackGroup()
        for _ in range(3):
            self.create_timer(0.05, self.together, callback_group=reentrant)
            self.create_timer(0.05, self.one_by_one, callback_group=exclusive)
        self.publisher = self.create_publisher(Int32, 'count', 10)
        self.create_subscription(Int32, 'count', lambda msg: self.counts.append(msg.data), 10)

    def together(self):
        with self.lock:
            self.inside += 1
            self.most = max(self.most, self.inside)
        time.sleep(0.05)
        with self.lock:
            self.inside -= 1

    def one_by_one(self):
        self.alone += 1
        self.most_alone = max(self.most_alone, self.alone)
        time.sleep(0.02)
        self.alone -= 1


def count(node):
    rate = node.create_rate(20)
    for i in range(5):
        node.publisher.publish(Int32(data=i))
        rate.sleep()


def main():
    rclpy.init()
    node = Groups()
    executor = MultiThreadedExecutor(num_threads=8)
    executor.add_node(node)
    spinning = threading.Thread(target=executor.spin, daemon=True)
    spinning.start()
    counting = threading.Thread(target=count, args=(node,))
    counting.start()
    counting.join()
    time.sleep(0.3)
    node.get_logger().info('together: %s' % (node.most > 1))
    node.get_logger().info('one by one: %d' % node.most_alone)
    node.get_logger().info('counted: %s' % node.counts)
    rclpy.shutdown()
    spinning.join()


if __name__ == '__main__':
    main()
