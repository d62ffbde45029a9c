"""Reads a bag: a folder with metadata.yaml, one file after the other, or a file by itself."""
from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator

from rclpy.duration import Duration
from rclpy.logging import get_logger
from rclpy.time import Time
from rosbag2_py import _mcap_reader, _metadata_yaml
from rosbag2_py._formats import need_converter, refuse_sqlite
from rosbag2_py._mcap_reader import McapReader
from rosbag2_py._mcap_records import Channel
from rosbag2_py._qos import QoS, to_rclcpp_qos_vector
from rosbag2_py._storage import (
    BagMetadata, ConverterOptions, MessageDefinition, ReadOrder, ReadOrderSortBy, StorageFilter, StorageOptions,
    TopicInformation, TopicMetadata, get_default_storage_id,
)

NOT_OPEN = 'Bag is not open. Call open() before reading.'
SERVICE_EVENTS = '/_service_event'
LATEST = (1 << 64) - 1


def wanted_by(choice: StorageFilter) -> Callable[[Channel], bool]:
    regex = re.compile(choice.regex) if choice.regex else None
    unwanted = re.compile(choice.regex_to_exclude) if choice.regex_to_exclude else None

    def wants(channel: Channel) -> bool:
        topic, is_event = channel.topic, channel.topic.endswith(SERVICE_EVENTS)
        listed = choice.services_events if is_event else choice.topics
        excluded = choice.exclude_service_events if is_event else choice.exclude_topics
        if topic in excluded or (unwanted is not None and unwanted.fullmatch(topic)):
            return False
        return (not listed and regex is None) or topic in listed or \
            (regex is not None and regex.fullmatch(topic) is not None)
    return wants


def profiles_of(channel: Channel, version: int) -> list[QoS]:
    try:
        return to_rclcpp_qos_vector(channel.metadata.get('offered_qos_profiles', ''), version)
    except RuntimeError as error:
        get_logger('rosbag2_storage_mcap').warning(f'The QoS of topic {channel.topic} cannot be read: {error}')
        return []


class File:
    """An open file of a bag, and the place in it."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.reader = McapReader(path)
        self.logger = get_logger('rosbag2_storage_mcap')
        if self.reader.damage:
            self.logger.warning(f"'{path}' cannot be read to its end: {self.reader.damage}")
        self.order = _mcap_reader.FILE
        self.filter = StorageFilter()
        self.time = 0
        self.place: tuple[int, int] | None = None
        self.next: _mcap_reader.Message | None = None
        self.begin()

    def begin(self) -> None:
        """From the present place on."""
        time = max(0, self.time)
        first, last = (0, time) if self.order == _mcap_reader.TIME_REVERSED else (time, LATEST)
        self.next = None
        self.messages: Iterator[_mcap_reader.Message] = self.reader.messages(
            self.order, first, last, wanted_by(self.filter))

    def set_read_order(self, order: ReadOrder) -> bool:
        # The storage of ROS 2 refuses these orders too; the messages are the same.
        if order.sort_by == ReadOrderSortBy.PublishedTimestamp:
            self.logger.warning('publish timestamp order reading not implemented')
            return False
        if order.sort_by == ReadOrderSortBy.File:
            if order.reverse:
                self.logger.warning('reverse file-order reading not implemented')
                return False
            self.order = _mcap_reader.FILE
        else:
            if not self.reader.can_sort:
                self.logger.warning('attempted to read in receive timestamp order with no message index')
                return False
            self.order = _mcap_reader.TIME_REVERSED if order.reverse else _mcap_reader.TIME
        self.begin()
        return True

    def _is_known(self, message: _mcap_reader.Message) -> bool:
        """Was given before the present place was left."""
        if self.place is None or message.log_time != self.time:
            return False
        return message.place >= self.place if self.order == _mcap_reader.TIME_REVERSED else message.place <= self.place

    def has_next(self) -> bool:
        while self.next is None or self._is_known(self.next):
            self.next = next(self.messages, None)
            if self.next is None:
                return False
        return True

    def read_next(self) -> _mcap_reader.Message:
        if not self.has_next() or self.next is None:
            raise RuntimeError('No next message is available.')
        message, self.next = self.next, None
        self.time, self.place = message.log_time, message.place
        return message

    def seek(self, timestamp: int) -> None:
        if timestamp != self.time:
            self.place = None
        self.time = timestamp
        self.begin()

    def set_filter(self, choice: StorageFilter) -> None:
        self.filter = choice
        self.begin()

    def metadata(self) -> BagMetadata:
        metadata = BagMetadata(version=8)
        for values in self.reader.metadata('rosbag2'):
            try:
                if values.get('serialized_metadata'):
                    metadata = _metadata_yaml.parse_metadata(values['serialized_metadata'])
            except RuntimeError as error:
                self.logger.warning(f'What the file says of its bag cannot be read: {error}')
            metadata.ros_distro = values.get('ROS_DISTRO') or metadata.ros_distro
        counts = self.reader.statistics
        metadata.storage_identifier = get_default_storage_id()
        metadata.bag_size = self.reader.size
        metadata.relative_file_paths = [self.path]
        metadata.message_count = counts.messages
        metadata.starting_time = Time(nanoseconds=min(counts.first_time, (1 << 63) - 1))
        metadata.duration = Duration(nanoseconds=min(max(0, counts.last_time - counts.first_time), (1 << 63) - 1))
        metadata.topics_with_message_count = []
        for channel in self.reader.channels.values():
            schema = self.reader.schemas.get(channel.schema)
            if schema is None:
                raise RuntimeError(f'Could not find schema for topic {channel.topic}')
            topic = TopicMetadata(
                channel.id, channel.topic, schema.name, channel.encoding, profiles_of(channel, metadata.version),
                channel.metadata.get('topic_type_hash', ''))
            metadata.topics_with_message_count.append(
                TopicInformation(topic, counts.messages_of.get(channel.id, 0)))
        return metadata


def open_file(path: str, storage_id: str) -> File | None:
    """None, with the reason in the log: it cannot be opened."""
    refuse_sqlite(storage_id, path)
    logger = get_logger('rosbag2_storage')
    if storage_id not in ('', get_default_storage_id()):
        logger.error(f"Could not load/open plugin with storage id '{storage_id}'")
        return None
    try:
        return File(path)
    except (OSError, RuntimeError) as error:
        logger.error(f"Could not open '{path}' with '{get_default_storage_id()}'. Error: {error}")
        return None


def files_of(folder: str, metadata: BagMetadata) -> list[str]:
    # Older bags name their folder, too.
    base = os.path.dirname(folder) if metadata.version < 4 else folder
    return [os.path.join(base, path) for path in metadata.relative_file_paths]


class SequentialReader:
    def __init__(self) -> None:
        self._file: File | None = None
        self._files: list[str] = []
        self._index = 0
        self._storage_id = ''
        self._metadata = BagMetadata()
        self._order = ReadOrder()
        self._filter = StorageFilter()
        self._seek_time = 0

    def open_uri(self, uri: str) -> None:
        self.open(StorageOptions(uri=uri), ConverterOptions())

    def open(self, storage_options: StorageOptions, converter_options: ConverterOptions) -> None:
        """Open a bag's folder, or a file of one."""
        uri, self._storage_id, self._seek_time = storage_options.uri, storage_options.storage_id, 0
        logger = get_logger('rosbag2_cpp')
        if _metadata_yaml.is_there(uri):
            self._metadata = _metadata_yaml.read(uri)
            self._storage_id = self._storage_id or self._metadata.storage_identifier
            if self._metadata.compression_format:
                raise RuntimeError(f'bags that are compressed by file or message ({self._metadata.compression_format}) '
                                   'are not read in a site: `ros2 bag convert` makes another one')
            self._files = files_of(uri, self._metadata)
            if not self._files:
                logger.warning('No file paths were found in metadata.')
                return
            self._open_file(0)
        else:
            self._file = open_file(uri, self._storage_id)
            if self._file is None:
                raise RuntimeError('No storage could be initialized from the inputs.')
            self._files, self._index = [uri], 0
            if not self._file.set_read_order(self._order):
                logger.warning('Could not set read order on open(), falling back to file order')
                self.set_read_order(ReadOrder(ReadOrderSortBy.File, False))
            self._metadata = self._file.metadata()
        topics = self._metadata.topics_with_message_count
        if not topics:
            logger.warning('No topics were listed in metadata.')
            return
        formats = {one.topic_metadata.serialization_format for one in topics}
        if len(formats) > 1:
            raise RuntimeError('Topics with different rmw serialization format have been found. '
                               'All topics must have the same serialization format.')
        wanted = converter_options.output_serialization_format
        if wanted and wanted not in formats:
            need_converter(formats.pop())
            need_converter(wanted)

    def _open_file(self, index: int) -> None:
        self.close()
        self._index = index
        self._file = open_file(self._files[index], self._storage_id)
        if self._file is None:
            raise RuntimeError('No storage could be initialized. Abort')
        self._file.set_read_order(self._order)
        self._file.seek(self._seek_time)
        self._file.set_filter(self._filter)

    def _opened(self, what: str = NOT_OPEN) -> File:
        if self._file is None:
            raise RuntimeError(what)
        return self._file

    def close(self) -> None:
        if self._file is not None:
            self._file.reader.close()
        self._file = None

    def set_read_order(self, read_order: ReadOrder) -> bool:
        """False: the bag cannot be read so."""
        file = self._opened('read order can only be set after open()')
        self._order = read_order
        return file.set_read_order(read_order)

    def has_next(self) -> bool:
        while not self._opened().has_next():
            after = self._index + (-1 if self._order.reverse else 1)
            if not 0 <= after < len(self._files):
                return False
            self._open_file(after)
        return True

    def read_next(self) -> tuple[str, bytes, int]:
        """Topic, serialised message, and when it was received (ns since 1970)."""
        if not self.has_next():
            raise RuntimeError('Bag is at end. No next message.')
        message = self._opened().read_next()
        return message.channel.topic, message.data, message.log_time

    def get_metadata(self) -> BagMetadata:
        self._opened()
        return self._metadata

    def get_all_topics_and_types(self) -> list[TopicMetadata]:
        self._opened()
        return [one.topic_metadata for one in self._metadata.topics_with_message_count]

    def get_all_message_definitions(self) -> list[MessageDefinition]:
        return [MessageDefinition(one.name, one.encoding, one.data.decode(errors='replace'), '')
                for one in self._opened().reader.schemas.values()]

    def set_filter(self, storage_filter: StorageFilter) -> None:
        file = self._opened('Bag is not open. Call open() before setting filter.')
        self._filter = storage_filter
        file.set_filter(storage_filter)

    def reset_filter(self) -> None:
        self.set_filter(StorageFilter())

    def seek(self, timestamp: int) -> None:
        """Let the next message be the first one at that time (ns since 1970) or later."""
        self._opened('Bag is not open. Call open() before seeking time.')
        self._seek_time = timestamp

        def begins() -> int:
            return self._opened().reader.statistics.first_time

        # One way only: files may overlap.
        if timestamp < begins() and self._index > 0:
            while timestamp < begins() and self._index > 0:
                self._open_file(self._index - 1)
        else:
            while timestamp > self._opened().reader.statistics.last_time and self._index + 1 < len(self._files):
                self._open_file(self._index + 1)
        self._opened().seek(timestamp)


def get_registered_readers() -> set[str]:
    return {get_default_storage_id()}
