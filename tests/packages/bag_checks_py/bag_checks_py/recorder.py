"""Records a topic, as the tutorial "Recording a bag from a node" does."""

# Compatibility, works: rosbag2_py: `SequentialWriter` and `SequentialReader` with options, filters, read orders and
# seek, `Info`, `MetadataIo`, `LocalMessageDefinitionSource`, QoS profiles; a bag as text is what `ros2 bag info` prints

# Compatibility, differs: rosbag2_py -> `Player`, `Recorder`, `Reindexer`, `bag_rewrite` and what compresses are missing

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.serialization import serialize_message
from std_msgs.msg import String

import rosbag2_py


class SimpleBagRecorder(Node):
    def __init__(self):
        super().__init__('simple_bag_recorder')
        self.writer = rosbag2_py.SequentialWriter()
        storage_options = rosbag2_py.StorageOptions(uri='py_bag', storage_id='mcap')
        converter_options = rosbag2_py.ConverterOptions('', '')
        self.writer.open(storage_options, converter_options)
        topic_info = rosbag2_py.TopicMetadata(
            id=0,
            name='chatter',
            type='std_msgs/msg/String',
            serialization_format='cdr')
        self.writer.create_topic(topic_info)
        self.subscription = self.create_subscription(String, 'chatter', self.topic_callback, 10)
        self.subscription

    def topic_callback(self, msg):
        self.writer.write('chatter', serialize_message(msg), self.get_clock().now().nanoseconds)
        self.get_logger().info('recorded ' + msg.data)


def main(args=None):
    rclpy.init(args=args)
    sbr = SimpleBagRecorder()
    try:
        rclpy.spin(sbr)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == '__main__':
    main()
