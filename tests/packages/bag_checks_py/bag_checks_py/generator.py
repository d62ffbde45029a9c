"""Writes a bag of made data, reads it back, and plays none of it."""
import sys

from example_interfaces.msg import Int32
from rclpy.clock import Clock
from rclpy.duration import Duration
from rclpy.serialization import deserialize_message, serialize_message

import rosbag2_py


def write(uri):
    writer = rosbag2_py.SequentialWriter()
    storage_options = rosbag2_py._storage.StorageOptions(uri=uri, storage_id='mcap')
    converter_options = rosbag2_py._storage.ConverterOptions('', '')
    writer.open(storage_options, converter_options)
    topic_info = rosbag2_py._storage.TopicMetadata(
        id=0,
        name='synthetic',
        type='example_interfaces/msg/Int32',
        serialization_format='cdr')
    writer.create_topic(topic_info)
    time_stamp = Clock().now()
    for ii in range(0, 100):
        data = Int32()
        data.data = ii
        writer.write('synthetic', serialize_message(data), time_stamp.nanoseconds)
        time_stamp += Duration(seconds=1)


def main(args=None):
    write('big_synthetic_py')
    reader = rosbag2_py.SequentialReader()
    reader.open_uri('big_synthetic_py')
    found = []
    while reader.has_next():
        topic, data, _ = reader.read_next()
        found.append(deserialize_message(data, Int32).data)
    print(f'read {len(found)} of {topic}, {sum(found)} in all')
    print(reader.get_metadata())
    # A bag of another node, or of the package's share.
    for uri in sys.argv[1:]:
        reader = rosbag2_py.SequentialReader()
        reader.open_uri(uri)
        while reader.has_next():
            topic, data, stamp = reader.read_next()
            print(f'{topic} at {stamp}: {data[8:-1].decode()}')
    try:
        rosbag2_py.SequentialReader().open(
            rosbag2_py.StorageOptions(uri='old', storage_id='sqlite3'), rosbag2_py.ConverterOptions('', ''))
    except RuntimeError as error:
        print(f'refused: {error}')


if __name__ == '__main__':
    main()
