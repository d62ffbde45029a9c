"""metadata.yaml: version 9 is written, all are read. And what `ros2 bag info` shows of it."""
from __future__ import annotations

import os
import re
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rclpy.duration import Duration
from rclpy.time import Time
from rosbag2_py import _qos
from ros2wasm.yaml import parse

if TYPE_CHECKING:
    from rosbag2_py import _storage

NAME = 'metadata.yaml'
ROOT = 'rosbag2_bagfile_information'
PLAIN = re.compile(r'[A-Za-z/_][\w./-]*\Z', re.ASCII)
#: What a plain text would be taken for.
OTHER = {'true', 'false', 'null', 'yes', 'no', 'on', 'off', 'y', 'n'}
S_TO_NS = 1_000_000_000
SERVICE_EVENTS = '/_service_event'


def scalar(text: str) -> str:
    if PLAIN.match(text) and text.lower() not in OTHER:
        return text
    quoted = text.replace('\\', '\\\\').replace('"', '\\"').replace('\n', '\\n')
    return '"' + re.sub(r'[\x00-\x1f\x7f]', lambda found: f'\\x{ord(found[0]):02x}', quoted) + '"'


def block(name: str, lines: list[str], indent: str, empty: str) -> list[str]:
    return [f'{indent}{name}:', *lines] if lines else [f'{indent}{name}: {empty}']


def item(lines: list[str]) -> list[str]:
    """As one of a list, by whose indentation its lines stand."""
    first = lines[0].lstrip()
    indent = lines[0][:len(lines[0]) - len(first) - 2]
    return [f'{indent}- {first}', *lines[1:]]


def nanoseconds(name: str, unit: str, value: int, indent: str) -> list[str]:
    return [f'{indent}{name}:', f'{indent}  {unit}: {value}']


def topic_lines(topic: _storage.TopicInformation, indent: str) -> list[str]:
    of, deeper = topic.topic_metadata, indent + '  '
    profiles = of.offered_qos_profiles
    return [
        f'{indent}topic_metadata:', f'{deeper}name: {scalar(of.name)}', f'{deeper}type: {scalar(of.type)}',
        f'{deeper}serialization_format: {scalar(of.serialization_format)}',
        *block('offered_qos_profiles', [_qos.profiles_yaml(profiles, deeper + '  ')] if profiles else [], deeper, '[]'),
        f'{deeper}type_description_hash: {scalar(of.type_description_hash)}',
        f'{indent}message_count: {topic.message_count}',
    ]


def file_lines(file: _storage.FileInformation, indent: str) -> list[str]:
    return [
        f'{indent}path: {scalar(file.path)}',
        *nanoseconds('starting_time', 'nanoseconds_since_epoch', file.starting_time.nanoseconds, indent),
        *nanoseconds('duration', 'nanoseconds', file.duration.nanoseconds, indent),
        f'{indent}message_count: {file.message_count}',
    ]


def metadata_lines(metadata: _storage.BagMetadata, indent: str) -> list[str]:
    deeper = indent + '    '
    topics = [line for one in metadata.topics_with_message_count for line in item(topic_lines(one, deeper))]
    files = [line for one in metadata.files for line in item(file_lines(one, deeper))]
    paths = [f'{indent}  - {scalar(one)}' for one in metadata.relative_file_paths]
    custom = [f'{indent}  {scalar(key)}: {scalar(value)}' for key, value in sorted(metadata.custom_data.items())]
    return [
        f'{indent}version: 9', f'{indent}storage_identifier: {scalar(metadata.storage_identifier)}',
        *nanoseconds('duration', 'nanoseconds', metadata.duration.nanoseconds, indent),
        *nanoseconds('starting_time', 'nanoseconds_since_epoch', metadata.starting_time.nanoseconds, indent),
        f'{indent}message_count: {metadata.message_count}',
        *block('topics_with_message_count', topics, indent, '[]'),
        f'{indent}compression_format: {scalar(metadata.compression_format)}',
        f'{indent}compression_mode: {scalar(metadata.compression_mode)}',
        *block('relative_file_paths', paths, indent, '[]'), *block('files', files, indent, '[]'),
        *block('custom_data', custom, indent, '~'), f'{indent}ros_distro: {scalar(metadata.ros_distro)}',
    ]


def is_there(uri: str) -> bool:
    return os.path.exists(os.path.join(uri, NAME))


def write(uri: str, metadata: _storage.BagMetadata) -> None:
    Path(uri, NAME).write_text('\n'.join([f'{ROOT}:', *metadata_lines(metadata, '  ')]) + '\n', encoding='utf-8')


def read(uri: str) -> _storage.BagMetadata:
    """RuntimeError: it is no such file."""
    try:
        metadata = _metadata(parse(Path(uri, NAME).read_text(encoding='utf-8'))[ROOT])
    except (OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        raise RuntimeError(f'Exception on parsing info file: {_reason(error)}') from error
    metadata.bag_size = sum(one.stat().st_size for one in Path(uri).iterdir() if one.is_file())
    return metadata


def parse_metadata(text: str) -> _storage.BagMetadata:
    """RuntimeError: it is none."""
    try:
        return _metadata(parse(text))
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
        raise RuntimeError(f'bad conversion: {_reason(error)}') from error


def _reason(error: Exception) -> str:
    return f"there is no '{error.args[0]}'" if isinstance(error, KeyError) else str(error)


def _text(value: Any) -> str:
    """A plain text may look like something else."""
    if value is None:
        return ''
    if not isinstance(value, (str, int, float)):
        raise ValueError(f'{str(value)[:40]!r} is not text')
    return str(value)


def _list(value: Any) -> list[Any]:
    if value is not None and not isinstance(value, list):
        raise ValueError(f'{str(value)[:40]!r} is not a list')
    return value or []


def _topic(node: Any, version: int) -> _storage.TopicInformation:
    from rosbag2_py._storage import TopicInformation, TopicMetadata
    of = node['topic_metadata']
    topic = TopicMetadata(0, _text(of['name']), _text(of['type']), _text(of['serialization_format']))
    if version >= 9:
        topic.offered_qos_profiles = _qos.read_profiles(of['offered_qos_profiles'])
    elif version >= 4:
        topic.offered_qos_profiles = _qos.to_rclcpp_qos_vector(_text(of['offered_qos_profiles']), version)
    if version >= 7:
        topic.type_description_hash = _text(of['type_description_hash'])
    return TopicInformation(topic, int(node['message_count']))


def _file(node: Any) -> _storage.FileInformation:
    from rosbag2_py._storage import FileInformation
    return FileInformation(
        _text(node['path']), Time(nanoseconds=int(node['starting_time']['nanoseconds_since_epoch'])),
        Duration(nanoseconds=int(node['duration']['nanoseconds'])), int(node['message_count']))


def _metadata(node: Any) -> _storage.BagMetadata:
    from rosbag2_py._storage import BagMetadata
    version = int(node['version'])
    metadata = BagMetadata(
        version=version, storage_identifier=_text(node['storage_identifier']),
        duration=Duration(nanoseconds=int(node['duration']['nanoseconds'])),
        starting_time=Time(nanoseconds=int(node['starting_time']['nanoseconds_since_epoch'])),
        message_count=int(node['message_count']),
        topics_with_message_count=[_topic(one, version) for one in _list(node['topics_with_message_count'])],
        relative_file_paths=[_text(one) for one in _list(node['relative_file_paths'])])
    if version >= 3:
        metadata.compression_format = _text(node['compression_format'])
        metadata.compression_mode = _text(node['compression_mode'])
    if version >= 5:
        metadata.files = [_file(one) for one in _list(node['files'])]
    if version >= 6:
        metadata.custom_data = {str(key): _text(value) for key, value in (node['custom_data'] or {}).items()}
    if version >= 8:
        metadata.ros_distro = _text(node['ros_distro'])
    return metadata


# ---- as `ros2 bag info` shows it

def _seconds(ns: int) -> str:
    return f'{ns // S_TO_NS}.{ns % S_TO_NS:09d}'


def _moment(ns: int) -> str:
    local = time.localtime(ns // S_TO_NS)
    return f'{time.strftime("%b %e %Y %H:%M:%S", local)}.{ns % S_TO_NS:09d} ({_seconds(ns)})'


def _size(count: int) -> str:
    units, size = ['B', 'KiB', 'MiB', 'GiB', 'TiB'], float(count)
    while size >= 1024 and len(units) > 1:
        size /= 1024
        del units[0]
    return f'{size:.0f} B' if units[0] == 'B' else f'{size:.1f} {units[0]}'


def _is_service(topic: _storage.TopicMetadata) -> bool:
    return topic.name.endswith(SERVICE_EVENTS) and '/srv/' in topic.type and topic.type.endswith('_Event')


def _table(title: str, width: int, rows: list[str]) -> list[str]:
    first, *rest = rows or ['']
    return [title.ljust(width) + first, *(' ' * width + one for one in rest)]


def shown(metadata: _storage.BagMetadata) -> str:
    start, services = metadata.starting_time.nanoseconds, []
    topics = []
    for one in metadata.topics_with_message_count:
        of = one.topic_metadata
        if _is_service(of):
            services.append(one)
        else:
            topics.append(f'Topic: {of.name} | Type: {of.type} | Count: {one.message_count} | '
                          f'Serialization Format: {of.serialization_format}')
    events = sum(one.message_count for one in services)
    lines = [
        '', *_table('Files:', 19, metadata.relative_file_paths), f'Bag size:          {_size(metadata.bag_size)}',
        f'Storage id:        {metadata.storage_identifier}', f'ROS Distro:        {metadata.ros_distro or "unknown"}',
        f'Duration:          {_seconds(metadata.duration.nanoseconds)}s', f'Start:             {_moment(start)}',
        f'End:               {_moment(start + metadata.duration.nanoseconds)}',
        f'Messages:          {metadata.message_count - events}', *_table('Topic information: ', 19, topics),
        f'Service:           {len(services)}',
        *_table('Service information: ', 21, [
            f'Service: {one.topic_metadata.name[:-len(SERVICE_EVENTS)]} | '
            f'Type: {one.topic_metadata.type[:-len("_Event")]} | Event Count: {one.message_count} | '
            f'Serialization Format: {one.topic_metadata.serialization_format}' for one in services]),
    ]
    return '\n'.join(lines) + ('\n' if services else '')
