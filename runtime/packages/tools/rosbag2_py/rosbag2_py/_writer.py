"""Writes a bag: a folder with metadata.yaml and one file after the other, each an MCAP."""
from __future__ import annotations

import os
import sys
import weakref
from collections import deque
from typing import Any, NamedTuple

from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.time import Time
from ros2wasm import host
from rosbag2_py import _metadata_yaml
from rosbag2_py._formats import need_converter, refuse_sqlite
from rosbag2_py._mcap_writer import McapWriter
from rosbag2_py._message_definitions import LocalMessageDefinitionSource
from rosbag2_py._qos import profiles_yaml
from rosbag2_py._storage import (
    BagMetadata, ConverterOptions, FileInformation, MessageDefinition, StorageOptions, TopicInformation, TopicMetadata,
    get_default_storage_id,
)

NOT_OPEN = 'Bag is not open. Call open() before writing.'
#: Bytes; a bag is not split into smaller files.
LEAST_FILE = 1024
#: Before there is a message.
NO_TIME = Time(nanoseconds=(1 << 63) - 1)
NS = 1_000_000_000


class Message(NamedTuple):
    topic: str
    data: bytes
    recv_timestamp: int
    send_timestamp: int


def chunks_of(profile: str, config: str) -> bool:
    """Whether messages are written in chunks."""
    if profile in ('zstd_fast', 'zstd_small'):
        raise RuntimeError(
            f"MCAP storage preset profile '{profile}' needs a compression: bags are written without one here")
    if profile not in ('', 'none', 'fastwrite'):
        raise RuntimeError("unknown MCAP storage preset profile (valid options are 'none', 'fastwrite', 'zstd_fast', "
                           f"'zstd_small'): {profile}")
    if config:
        raise RuntimeError('storage_config_uri is not read for Python nodes: storage_preset_profile chooses the form')
    return profile != 'fastwrite'


class Bag:
    """A bag that is being written."""

    def __init__(self, options: StorageOptions) -> None:
        self.options = options
        self.in_chunks = chunks_of(options.storage_preset_profile, options.storage_config_uri)
        self.folder = options.uri
        if os.path.isdir(self.folder):
            raise RuntimeError(f"Bag directory already exists ({self.folder}), can't overwrite existing bag")
        try:
            os.makedirs(self.folder)
        except OSError as error:
            raise RuntimeError(f'Failed to create bag directory ({self.folder}).') from error
        self.logger = get_logger('rosbag2_cpp')
        self.topics: dict[str, TopicInformation] = {}
        self.definitions: dict[str, MessageDefinition] = {}
        self.kept: deque[Message] = deque()
        self.kept_bytes = 0
        self.metadata = BagMetadata(
            storage_identifier='mcap', starting_time=NO_TIME, custom_data=dict(options.custom_data),
            ros_distro=os.environ.get('ROS_DISTRO', ''))
        if not self.metadata.ros_distro:
            self.logger.warning("Environment variable ROS_DISTRO not set, can't store value in bag metadata.")
        self.begin_file()

    def begin_file(self) -> None:
        name = f'{os.path.basename(self.folder)}_{len(self.metadata.files)}.mcap'
        self.file = McapWriter(os.path.join(self.folder, name), self.in_chunks)
        #: Types and topics that are in it.
        self.schemas: dict[str, int] = {}
        self.channels: dict[str, int] = {}
        self.metadata.relative_file_paths.append(name)
        self.metadata.files.append(FileInformation(name, NO_TIME, Duration(), 0))
        self.write_metadata()

    def write_metadata(self) -> None:
        text = '\n'.join(_metadata_yaml.metadata_lines(self.metadata, ''))
        self.file.write_metadata('rosbag2', {'serialized_metadata': text})

    def end_file(self) -> None:
        for topic in self.topics.values():
            self.channel(topic.topic_metadata)
        self.write_metadata()
        self.file.close()

    def definition(self, type_name: str) -> MessageDefinition:
        if type_name not in self.definitions:
            try:
                found = LocalMessageDefinitionSource().get_full_text(type_name)
            except RuntimeError as missing:
                self.logger.warning(f'The program has no definition of {missing}, so that the bag has none')
                found = MessageDefinition(type_name, '', '', '')
            self.definitions[type_name] = found
        return self.definitions[type_name]

    def channel(self, topic: TopicMetadata) -> int:
        """Its number in the file."""
        if topic.name in self.channels:
            return self.channels[topic.name]
        if topic.type not in self.schemas:
            found = self.definition(topic.type)
            self.schemas[topic.type] = self.file.add_schema(
                topic.type, found.encoding, found.encoded_message_definition.encode())
        self.channels[topic.name] = self.file.add_channel(
            self.schemas[topic.type], topic.name, topic.serialization_format, {
                'offered_qos_profiles': profiles_yaml(topic.offered_qos_profiles),
                'topic_type_hash': topic.type_description_hash})
        return self.channels[topic.name]

    def write(self, message: Message) -> None:
        options, time = self.options, message.recv_timestamp
        if 0 <= options.start_time_ns and time < options.start_time_ns:
            return
        if 0 <= options.end_time_ns < time:
            return
        if message.topic not in self.topics:
            raise RuntimeError(
                f"Failed to write on topic '{message.topic}'. Call create_topic() before first write.")
        if not options.snapshot_mode:
            self.write_now(message)
            return
        self.kept.append(message)
        self.kept_bytes += len(message.data)
        while self.kept_bytes > options.max_cache_size and len(self.kept) > 1:
            self.kept_bytes -= len(self.kept.popleft().data)

    def must_split(self, time: int) -> bool:
        file, options = self.metadata.files[-1], self.options
        if options.max_bagfile_size and self.file.size >= options.max_bagfile_size:
            return True
        return bool(options.max_bagfile_duration and file.message_count
                    and time - file.starting_time.nanoseconds > options.max_bagfile_duration * NS)

    def write_now(self, message: Message) -> None:
        if self.must_split(message.recv_timestamp):
            self.split()
        topic = self.topics[message.topic]
        self.file.write(
            self.channel(topic.topic_metadata), message.recv_timestamp, message.send_timestamp, message.data)
        topic.message_count += 1
        file = self.metadata.files[-1]
        file.message_count += 1
        parts: tuple[BagMetadata | FileInformation, ...] = (self.metadata, file)
        for part in parts:
            begin = min(part.starting_time.nanoseconds, message.recv_timestamp)
            part.starting_time = Time(nanoseconds=begin)
            part.duration = Duration(nanoseconds=max(part.duration.nanoseconds, message.recv_timestamp - begin))

    def split(self) -> None:
        self.end_file()
        self.begin_file()

    def take_snapshot(self) -> bool:
        if not self.options.snapshot_mode:
            self.logger.warning('SequentialWriter take_snaphot called when snapshot mode is disabled')
            return False
        for message in self.kept:
            # Its topic may have been removed.
            if message.topic in self.topics:
                self.write_now(message)
        self.kept.clear()
        self.kept_bytes = 0
        return True

    def close(self) -> None:
        self.metadata.topics_with_message_count = list(self.topics.values())
        self.metadata.message_count = sum(one.message_count for one in self.topics.values())
        self.end_file()
        _metadata_yaml.write(self.folder, self.metadata)
        for name in (*self.metadata.relative_file_paths, _metadata_yaml.NAME):
            path = os.path.realpath(os.path.join(self.folder, name))
            with open(path, 'rb') as file:
                host.give_file(path, file.read())


def _close(bag: Bag) -> None:
    try:
        bag.close()
    except Exception as error:
        print(f'The bag {bag.folder} could not be closed: {error}', file=sys.stderr)


class SequentialWriter:
    """What is not closed is closed when the writer goes, or the program ends."""

    def __init__(self) -> None:
        self._bag: Bag | None = None
        self._end: Any = None

    def _open_bag(self) -> Bag:
        if self._bag is None:
            raise RuntimeError(NOT_OPEN)
        return self._bag

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions) -> None:
        """Nothing for one that is open."""
        if self._bag is not None:
            return
        formats = (converter_options.input_serialization_format, converter_options.output_serialization_format)
        if formats[0] != formats[1]:
            for one in formats:
                need_converter(one)
        refuse_sqlite(storage_options.storage_id)
        if storage_options.storage_id not in ('', get_default_storage_id()):
            get_logger('rosbag2_storage').error(
                f"Could not load/open plugin with storage id '{storage_options.storage_id}'")
            raise RuntimeError('No storage could be initialized. Abort')
        size = storage_options.max_bagfile_size
        if 0 < size < LEAST_FILE:
            raise RuntimeError(f'Invalid bag splitting size given. Please provide a value greater than {LEAST_FILE}. '
                               f'Specified value of {size}')
        if storage_options.snapshot_mode and not storage_options.max_cache_size:
            raise RuntimeError('Max cache size must be greater than 0 when snapshot mode is enabled')
        self._bag = Bag(storage_options)
        self._end = weakref.finalize(self, _close, self._bag)

    def close(self) -> None:
        """Write what is left, and metadata.yaml."""
        if self._bag is None:
            return
        bag, self._bag = self._bag, None
        self._end.detach()
        bag.close()

    def create_topic(self, topic_with_type: TopicMetadata) -> None:
        """Nothing for one that is there."""
        if self._bag is None or topic_with_type.name not in self._bag.topics:
            self._open_bag().topics[topic_with_type.name] = TopicInformation(topic_with_type, 0)

    def remove_topic(self, topic_with_type: TopicMetadata) -> None:
        if self._bag is None:
            raise RuntimeError('Bag is not open. Call open() before removing.')
        if topic_with_type.name not in self._bag.topics:
            raise RuntimeError(f'Failed to remove the non-existing topic "{topic_with_type.name}"!')
        del self._bag.topics[topic_with_type.name]
        self._bag.channels.pop(topic_with_type.name, None)

    def write(self, topic_name: str, message: bytes, recv_timestamp: int, send_timestamp: int | None = None) -> None:
        """A serialised message of a topic that was created; ns since 1970."""
        if not isinstance(message, (bytes, bytearray, memoryview)):
            raise TypeError(f'a serialised message is wanted, not {type(message).__name__}')
        sent = recv_timestamp if send_timestamp is None else send_timestamp
        self._open_bag().write(Message(topic_name, bytes(message), int(recv_timestamp), int(sent)))

    def take_snapshot(self) -> bool:
        """False when the bag is not written in snapshots."""
        return self._open_bag().take_snapshot()

    def split_bagfile(self) -> None:
        """Begin the next file."""
        self._open_bag().split()


def get_registered_writers() -> set[str]:
    return {get_default_storage_id()}


def get_registered_compressors() -> set[str]:
    return set()


def get_registered_serializers() -> set[str]:
    return {'cdr'}
