"""Bags: their writer, their reader, and what they say of themselves."""
from rosbag2_py._info import Info
from rosbag2_py._message_definitions import LocalMessageDefinitionSource
from rosbag2_py._reader import SequentialReader, get_registered_readers
from rosbag2_py._storage import (
    BagMetadata,
    ConverterOptions,
    FileInformation,
    MessageDefinition,
    MetadataIo,
    ReadOrder,
    ReadOrderSortBy,
    StorageFilter,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
    convert_rclcpp_qos_to_rclpy_qos,
    get_default_storage_id,
    to_rclcpp_qos_vector,
)
from rosbag2_py._writer import (
    SequentialWriter,
    get_registered_compressors,
    get_registered_serializers,
    get_registered_writers,
)

__all__ = [
    'BagMetadata', 'ConverterOptions', 'FileInformation', 'Info', 'LocalMessageDefinitionSource', 'MessageDefinition',
    'MetadataIo', 'ReadOrder', 'ReadOrderSortBy', 'SequentialReader', 'SequentialWriter', 'StorageFilter',
    'StorageOptions', 'TopicInformation', 'TopicMetadata', 'convert_rclcpp_qos_to_rclpy_qos', 'get_default_storage_id',
    'get_registered_compressors', 'get_registered_readers', 'get_registered_serializers', 'get_registered_writers',
    'to_rclcpp_qos_vector',
]
