"""
Writes an MCAP file of the profile "ros2": in chunks with an index, not compressed.

The file is whole when it is closed; cut before, its chunks can be read.
"""
from __future__ import annotations

import struct
import zlib

from rosbag2_py import _mcap_records as mcap

CHUNK_SIZE = 768 * 1024
MOST_IDS = 0xFFFF


class McapWriter:
    """OSError, as of files: it cannot be written."""

    def __init__(self, path: str, in_chunks: bool = True) -> None:
        self._file = open(path, 'wb')
        self._in_chunks = in_chunks
        self._written = 0
        self._schemas: list[mcap.Schema] = []
        self._channels: list[mcap.Channel] = []
        self._out: set[tuple[int, int]] = set()
        self._chunk = bytearray()
        self._places: dict[int, list[tuple[int, int]]] = {}
        self._times: list[int] = []
        self._chunks: list[mcap.ChunkPlace] = []
        self._metadata: list[bytes] = []
        self.statistics = mcap.Statistics()
        self._write(mcap.MAGIC + mcap.record(mcap.HEADER, mcap.text('ros2') + mcap.text('ros2wasm')))

    @property
    def size(self) -> int:
        """What went out, and what waits in the chunk."""
        return self._written + len(self._chunk)

    def _write(self, data: bytes | bytearray) -> None:
        self._file.write(data)
        self._written += len(data)

    def add_schema(self, name: str, encoding: str, data: bytes) -> int:
        """Give its id. It goes out with its first message, and at the end."""
        # 0 is not a schema.
        self._schemas.append(mcap.Schema(len(self._schemas) + 1, name, encoding, data))
        return len(self._schemas)

    def add_channel(self, schema: int, topic: str, encoding: str, metadata: dict[str, str]) -> int:
        if len(self._channels) >= MOST_IDS:
            raise RuntimeError('an MCAP file has no room for more topics')
        self._channels.append(mcap.Channel(len(self._channels) + 1, schema, topic, encoding, metadata))
        return len(self._channels)

    def _introduction(self, channel: mcap.Channel) -> bytes:
        """What messages are read with, before the first of them."""
        data = b''
        for kind, number in ((mcap.SCHEMA, channel.schema), (mcap.CHANNEL, channel.id)):
            if (kind, number) not in self._out:
                self._out.add((kind, number))
                data += mcap.schema_bytes(self._schemas[number - 1]) if kind == mcap.SCHEMA else \
                    mcap.channel_bytes(channel)
        return data

    def write(self, channel: int, log_time: int, publish_time: int, data: bytes) -> None:
        """Of a channel that was added."""
        begin = self._introduction(self._channels[channel - 1])
        content = mcap.MESSAGE_HEAD.pack(channel, 0, log_time, publish_time) + data
        if self._in_chunks:
            self._chunk += begin
            self._places.setdefault(channel, []).append((log_time, len(self._chunk)))
            self._times.append(log_time)
            self._chunk += mcap.record(mcap.MESSAGE, content)
        else:
            self._write(begin + mcap.record(mcap.MESSAGE, content))
        self.statistics.count(channel, log_time)
        if len(self._chunk) >= CHUNK_SIZE:
            self._end_chunk()

    def _end_chunk(self) -> None:
        if not self._chunk:
            return
        size = len(self._chunk)
        place = mcap.ChunkPlace(
            min(self._times), max(self._times), self._written, 0, compressed_size=size, size=size)
        head = struct.pack('<QQQI', place.first_time, place.last_time, size, zlib.crc32(self._chunk)) \
            + mcap.text('') + struct.pack('<Q', size)
        self._write(mcap.HEAD.pack(mcap.CHUNK, len(head) + size) + head)
        self._write(self._chunk)
        place.length = self._written - place.offset
        for channel, places in sorted(self._places.items()):
            place.message_indexes[channel] = self._written
            entries = b''.join(struct.pack('<QQ', *one) for one in places)
            self._write(mcap.record(mcap.MESSAGE_INDEX, struct.pack('<H', channel) + mcap.block(entries)))
        place.message_indexes_length = self._written - place.offset - place.length
        self._chunks.append(place)
        self.statistics.chunks += 1
        self._chunk = bytearray()
        self._places.clear()
        self._times.clear()

    def write_metadata(self, name: str, values: dict[str, str]) -> None:
        data = mcap.record(mcap.METADATA, mcap.text(name) + mcap.texts(values))
        self._metadata.append(
            mcap.record(mcap.METADATA_INDEX, struct.pack('<QQ', self._written, len(data)) + mcap.text(name)))
        self.statistics.metadata += 1
        self._write(data)

    def close(self) -> None:
        """Nothing for one that is closed."""
        if self._file.closed:
            return
        self._end_chunk()
        self._write(mcap.record(mcap.DATA_END, struct.pack('<I', 0)))
        self.statistics.schemas = len(self._schemas)
        self.statistics.channels = len(self._channels)
        begin, summary, offsets = self._written, b'', b''
        for kind, parts in (
            (mcap.SCHEMA, [mcap.schema_bytes(one) for one in self._schemas]),
            (mcap.CHANNEL, [mcap.channel_bytes(one) for one in self._channels]),
            (mcap.STATISTICS, [mcap.statistics_bytes(self.statistics)]),
            (mcap.CHUNK_INDEX, [mcap.chunk_place_bytes(one) for one in self._chunks]),
            (mcap.METADATA_INDEX, self._metadata),
        ):
            group = b''.join(parts)
            if group:
                offsets += mcap.record(
                    mcap.SUMMARY_OFFSET, struct.pack('<BQQ', kind, begin + len(summary), len(group)))
            summary += group
        # The checksum is of all from the summary to the footer's places of it.
        footer = mcap.HEAD.pack(mcap.FOOTER, 20) + struct.pack('<QQ', begin, begin + len(summary))
        whole = summary + offsets + footer
        self._write(whole + struct.pack('<I', zlib.crc32(whole)) + mcap.MAGIC)
        self._file.close()
