"""What bags are told with: options, topics, filters, and what a bag says of itself."""
from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from rclpy.duration import Duration as RclpyDuration
from rclpy.time import Time
from rosbag2_py import _metadata_yaml
from rosbag2_py._qos import (
    Duration,
    QoS,
    convert_rclcpp_qos_to_rclpy_qos,
    rmw_qos_durability_policy_t,
    rmw_qos_history_policy_t,
    rmw_qos_liveliness_policy_t,
    rmw_qos_reliability_policy_t,
    to_rclcpp_qos_vector,
)

__all__ = [
    'BagMetadata', 'ConverterOptions', 'Duration', 'FileInformation', 'MessageDefinition', 'MetadataIo', 'QoS',
    'ReadOrder', 'ReadOrderSortBy', 'StorageFilter', 'StorageOptions', 'TopicInformation', 'TopicMetadata',
    'convert_rclcpp_qos_to_rclpy_qos', 'get_default_storage_id', 'rmw_qos_durability_policy_t',
    'rmw_qos_history_policy_t', 'rmw_qos_liveliness_policy_t', 'rmw_qos_reliability_policy_t', 'to_rclcpp_qos_vector',
]


def get_default_storage_id() -> str:
    """The only one."""
    return 'mcap'


@dataclass
class ConverterOptions:
    """The forms of messages before and after a bag. There is one, `cdr`; nothing is converted."""

    input_serialization_format: str = ''
    output_serialization_format: str = ''


@dataclass
class StorageOptions:
    """How a bag is written or read."""

    uri: str
    #: Empty: `mcap`.
    storage_id: str = ''
    #: Bytes after which the next file begins; 0: one file.
    max_bagfile_size: int = 0
    #: Seconds, as well.
    max_bagfile_duration: int = 0
    #: Bytes that a snapshot has; messages go to the file at once whatever it says.
    max_cache_size: int = 0
    #: `none`, or `fastwrite`: without chunks and index. Others need zstd, and are refused.
    storage_preset_profile: str = ''
    storage_config_uri: str = ''
    #: Messages are kept in memory, and written by take_snapshot().
    snapshot_mode: bool = False
    #: ns since 1970; messages before and after are not written. Negative: no limit.
    start_time_ns: int = -1
    end_time_ns: int = -1
    custom_data: dict[str, str] = field(default_factory=dict)


@dataclass
class StorageFilter:
    """Which topics of a bag are read. Empty: all."""

    topics: list[str] = field(default_factory=list)
    #: Event topics of services, which `topics` says nothing of.
    services_events: list[str] = field(default_factory=list)
    #: Of whole names; those of the lists are read too.
    regex: str = ''
    exclude_topics: list[str] = field(default_factory=list)
    exclude_service_events: list[str] = field(default_factory=list)
    regex_to_exclude: str = ''


@dataclass
class MessageDefinition:
    topic_type: str
    #: `ros2msg`, or empty: there is none.
    encoding: str
    encoded_message_definition: str
    type_hash: str


@dataclass
class TopicMetadata:
    id: int
    name: str
    #: `std_msgs/msg/String`
    type: str
    #: `cdr`
    serialization_format: str
    #: Of its publishers.
    offered_qos_profiles: list[QoS] = field(default_factory=list)
    #: `RIHS01_...`, or empty.
    type_description_hash: str = ''

    def equals(self, other: TopicMetadata) -> bool:
        return (self.id, self.name, self.type, self.serialization_format, self.type_description_hash) == \
            (other.id, other.name, other.type, other.serialization_format, other.type_description_hash)


@dataclass
class TopicInformation:
    topic_metadata: TopicMetadata
    message_count: int


@dataclass
class FileInformation:
    path: str
    starting_time: Time
    duration: RclpyDuration
    message_count: int


@dataclass(repr=False)
class BagMetadata:
    """What metadata.yaml says. As a text it is what `ros2 bag info` prints."""

    version: int = 9
    #: Bytes; not written.
    bag_size: int = 0
    storage_identifier: str = ''
    relative_file_paths: list[str] = field(default_factory=list)
    files: list[FileInformation] = field(default_factory=list)
    duration: RclpyDuration = field(default_factory=RclpyDuration)
    starting_time: Time = field(default_factory=Time)
    message_count: int = 0
    topics_with_message_count: list[TopicInformation] = field(default_factory=list)
    compression_format: str = ''
    compression_mode: str = ''
    custom_data: dict[str, str] = field(default_factory=dict)
    ros_distro: str = ''

    def __repr__(self) -> str:
        return _metadata_yaml.shown(self)


class ReadOrderSortBy(Enum):
    """By PublishedTimestamp no storage reads."""

    ReceivedTimestamp = 0
    PublishedTimestamp = 1
    File = 2


@dataclass
class ReadOrder:
    sort_by: ReadOrderSortBy = ReadOrderSortBy.ReceivedTimestamp
    reverse: bool = False


class MetadataIo:
    """Reads and writes metadata.yaml of a bag's folder."""

    def write_metadata(self, uri: str, metadata: BagMetadata) -> None:
        _metadata_yaml.write(uri, metadata)

    def read_metadata(self, uri: str) -> BagMetadata:
        return _metadata_yaml.read(uri)

    def metadata_file_exists(self, uri: str) -> bool:
        return _metadata_yaml.is_there(uri)

    def serialize_metadata(self, metadata: BagMetadata) -> str:
        return '\n'.join(_metadata_yaml.metadata_lines(metadata, ''))

    def deserialize_metadata(self, serialized_metadata: str) -> BagMetadata:
        return _metadata_yaml.parse_metadata(serialized_metadata)
