"""
Reads an MCAP file: by its index, or when it has none that holds, from front to back as far as it is whole.

What it says of itself may be a lie: each length is looked at before memory is made for it.
"""
from __future__ import annotations

import heapq
import os
import zlib
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from rosbag2_py import _mcap_records as mcap
from rosbag2_py._mcap_records import Damaged

MOST_SUMMARY = 64 << 20
MOST_METADATA = 16 << 20
MOST_SCHEMAS = 16 << 20
MOST_RECORD = 128 << 20
MOST_CHUNK = 128 << 20
#: Chunks whose times overlap are held side by side.
MOST_HELD = 256 << 20
FOOTER_LENGTH = 20
#: Of a chunk's record, before its records: with the longest name of a compression.
MOST_CHUNK_HEAD = 8 + 8 + 8 + 4 + 4 + 32 + 8

FILE, TIME, TIME_REVERSED = range(3)


class Message(NamedTuple):
    #: Its record or its chunk in the file, and its record in that chunk.
    place: tuple[int, int]
    channel: mcap.Channel
    log_time: int
    publish_time: int
    data: bytes


class Record(NamedTuple):
    kind: int
    content: int
    length: int


class ChunkHead(NamedTuple):
    first_time: int
    last_time: int
    size: int
    crc: int
    compression: str
    compressed_size: int
    #: Where its records begin.
    records: int


class McapReader:
    """RuntimeError: it is not an MCAP file, or nothing of it can be read."""

    def __init__(self, path: str) -> None:
        self._file = open(path, 'rb')
        self.size = os.fstat(self._file.fileno()).st_size
        if self.size < len(mcap.MAGIC) or self._bytes(0, len(mcap.MAGIC)) != mcap.MAGIC:
            raise RuntimeError(f'invalid magic bytes: "{path}" is not an MCAP file')
        #: Why not all of it can be read; empty: it is whole, as far as its index says.
        self.damage = ''
        self._forget()
        try:
            self._read_summary()
        except Damaged as reason:
            self._forget()
            self._scan()
            if not self.channels and self.damage:
                raise RuntimeError(f'{reason}; {self.damage}') from None

    def _forget(self) -> None:
        self.schemas: dict[int, mcap.Schema] = {}
        self._schema_bytes = 0
        self.channels: dict[int, mcap.Channel] = {}
        self.chunks: list[mcap.ChunkPlace] = []
        self._metadata: list[tuple[int, str]] = []
        self.statistics = mcap.Statistics()

    def close(self) -> None:
        self._file.close()

    @property
    def can_sort(self) -> bool:
        """Messages lie in chunks, which are known: they can be given in order of their times."""
        return bool(self.chunks) or self.statistics.messages == 0

    def metadata(self, name: str) -> list[dict[str, str]]:
        """Of that name; what cannot be read of them is skipped."""
        found = []
        # Together they are no larger than the file: none is there twice.
        left = self.size
        for offset, own_name in self._metadata:
            try:
                record = self._record(offset) if own_name == name else None
                if record is not None and record.kind == mcap.METADATA and record.length <= min(MOST_METADATA, left):
                    left -= record.length
                    found.append(mcap.read_metadata(self._bytes(record.content, record.length))[1])
            except Damaged:
                continue
        return found

    def _bytes(self, offset: int, length: int) -> bytes:
        if offset + length > self.size:
            raise Damaged('it points behind its end')
        if length > MOST_RECORD:
            raise Damaged(f'a part of {length} bytes is too large')
        self._file.seek(offset)
        data = self._file.read(length)
        if len(data) != length:
            raise Damaged('the file is shorter than it was')
        return data

    def _record(self, offset: int) -> Record | None:
        """None: there is no whole one."""
        content = offset + mcap.HEAD.size
        if content > self.size:
            return None
        kind, length = mcap.HEAD.unpack(self._bytes(offset, mcap.HEAD.size))
        return Record(kind, content, length) if length <= self.size - content else None

    def _take(self, kind: int, content: bytes | memoryview) -> None:
        """What a record says of types and topics."""
        if kind == mcap.SCHEMA:
            if len(content) > MOST_SCHEMAS - self._schema_bytes:
                raise Damaged('its definitions of types are too large')
            schema = mcap.read_schema(content)
            # Each chunk may say it again.
            if schema.id not in self.schemas:
                self.schemas[schema.id] = schema
                self._schema_bytes += len(content)
        elif kind == mcap.CHANNEL:
            if len(content) > MOST_SCHEMAS:
                raise Damaged('what it says of a topic is too large')
            channel = mcap.read_channel(content)
            self.channels.setdefault(channel.id, channel)

    def _read_summary(self) -> None:
        end = len(mcap.MAGIC) + mcap.HEAD.size + FOOTER_LENGTH
        footer = self.size - end
        if footer < len(mcap.MAGIC) or self._bytes(self.size - len(mcap.MAGIC), len(mcap.MAGIC)) != mcap.MAGIC:
            raise Damaged('it ends early')
        footer_bytes = self._bytes(footer, mcap.HEAD.size + FOOTER_LENGTH)
        from_ = mcap.Bytes(footer_bytes)
        if (from_.number(1), from_.number(8)) != (mcap.FOOTER, FOOTER_LENGTH):
            raise Damaged('it has no footer')
        begin, _, crc = from_.number(8), from_.number(8), from_.number(4)
        if begin == 0:
            raise Damaged('it has no index')
        if begin > footer or footer - begin > MOST_SUMMARY:
            raise Damaged('its index lies elsewhere than it says')
        summary = self._bytes(begin, footer - begin)
        if crc and zlib.crc32(summary + footer_bytes[:-4]) != crc:
            raise Damaged('its index is not as it was written')
        counted = None
        for kind, content, _ in mcap.records(summary):
            self._take(kind, content)
            if kind == mcap.STATISTICS:
                counted = mcap.read_statistics(content)
            elif kind == mcap.CHUNK_INDEX:
                self.chunks.append(mcap.read_chunk_place(content))
            elif kind == mcap.METADATA_INDEX:
                self._metadata.append(mcap.read_metadata_place(content))
        if counted is None:
            raise Damaged('its index has no counts')
        self.statistics = counted
        self._check_index()

    def _check_index(self) -> None:
        # Together they are no larger than the file: none is there twice.
        is_whole = sum(chunk.length for chunk in self.chunks) <= self.size
        for chunk in self.chunks:
            is_whole = is_whole and chunk.first_time <= chunk.last_time and chunk.length >= mcap.HEAD.size \
                and all(channel in self.channels for channel in chunk.message_indexes)
        if self.statistics.messages:
            is_whole = is_whole and self.statistics.chunks == len(self.chunks) and bool(self.channels)
        if not is_whole:
            raise Damaged('its index is not whole')

    def _chunk_head(self, record: Record) -> ChunkHead:
        from_ = mcap.Bytes(self._bytes(record.content, min(record.length, MOST_CHUNK_HEAD)))
        first, last, size, crc = from_.number(8), from_.number(8), from_.number(8), from_.number(4)
        compression, compressed_size = from_.text(), from_.number(8)
        if compressed_size > record.length - from_.at:
            raise Damaged('a chunk is shorter than it says')
        return ChunkHead(first, last, size, crc, compression, compressed_size, record.content + from_.at)

    def _chunk(self, head: ChunkHead) -> bytes:
        """Its records, unpacked."""
        if head.size > MOST_CHUNK:
            raise Damaged(f'a chunk of {head.size} bytes is too large')
        data = self._bytes(head.records, head.compressed_size)
        if head.compression == 'lz4':
            data = mcap.unpack_lz4(data, head.size)
        elif head.compression:
            raise Damaged(f'its chunks are compressed with {head.compression[:32]}, which is not read here: '
                          '`ros2 bag convert` makes another bag of it')
        if len(data) != head.size:
            raise Damaged('a chunk has other bytes than it says')
        if head.crc and zlib.crc32(data) != head.crc:
            raise Damaged('a chunk is not as it was written')
        return data

    def _count(self, kind: int, content: bytes | memoryview) -> None:
        self._take(kind, content)
        if kind == mcap.MESSAGE:
            channel, time, _, _ = mcap.read_message(content)
            self.statistics.count(channel, time)

    def _scan(self) -> None:
        """From front to back, until the end or what cannot be."""
        at, has_loose = len(mcap.MAGIC), False
        try:
            while (record := self._record(at)) is not None and record.kind not in (mcap.DATA_END, mcap.FOOTER):
                if record.kind == mcap.CHUNK:
                    head = self._chunk_head(record)
                    for kind, content, _ in mcap.records(self._chunk(head)):
                        self._count(kind, content)
                    self.chunks.append(mcap.ChunkPlace(
                        head.first_time, head.last_time, at, mcap.HEAD.size + record.length))
                elif record.kind == mcap.METADATA and record.length <= MOST_METADATA:
                    name, _ = mcap.read_metadata(self._bytes(record.content, record.length))
                    self._metadata.append((at, name))
                elif record.kind in (mcap.SCHEMA, mcap.CHANNEL, mcap.MESSAGE):
                    self._count(record.kind, self._bytes(record.content, record.length))
                    has_loose = has_loose or record.kind == mcap.MESSAGE
                at = record.content + record.length
            if record is None:
                self.damage = 'it ends early'
        except Damaged as reason:
            self.damage = str(reason)
        # Those that lie in no chunk would be missing.
        if has_loose:
            self.chunks = []

    def messages(
        self, order: int, first_time: int, last_time: int, wants: Callable[[mcap.Channel], bool]
    ) -> Iterator[Message]:
        """All of them from the begin; a Damaged may come in their midst."""
        def wanted(channel: int, time: int) -> mcap.Channel | None:
            found = self.channels.get(channel)
            if found is None:
                raise Damaged('a message is of a topic that it does not tell of')
            return found if first_time <= time <= last_time and wants(found) else None

        if order == FILE:
            return self._in_file(wanted)
        chunks = [one for one in self.chunks if one.last_time >= first_time and one.first_time <= last_time]
        return self._by_time(chunks, -1 if order == TIME_REVERSED else 1, wanted)

    def _by_time(
        self, chunks: list[mcap.ChunkPlace], sign: int, wanted: Callable[[int, int], mcap.Channel | None]
    ) -> Iterator[Message]:
        # A chunk is opened before messages of that time are given: it may have such, too.
        ahead: list[tuple[int, bool, int, int, Any]] = [
            (sign * (one.first_time if sign > 0 else one.last_time), False, sign * one.offset, number, one)
            for number, one in enumerate(chunks)]
        heapq.heapify(ahead)
        unread: dict[int, int] = {}
        sizes: dict[int, int] = {}
        while ahead:
            _, is_message, place, _, what = heapq.heappop(ahead)
            offset = sign * place
            if is_message:
                unread[offset] -= 1
                if unread[offset] == 0:
                    del sizes[offset]
                yield what
                continue
            record = self._record(offset)
            if record is None or record.kind != mcap.CHUNK or offset in sizes:
                raise Damaged('a chunk lies elsewhere than its index says')
            head = self._chunk_head(record)
            if head.size > MOST_HELD - sum(sizes.values()):
                raise Damaged('too many of its chunks overlap')
            unread[offset], sizes[offset] = 0, head.size
            for kind, content, at in mcap.records(self._chunk(head)):
                self._take(kind, content)
                if kind != mcap.MESSAGE:
                    continue
                number, log_time, publish_time, data = mcap.read_message(content)
                channel = wanted(number, log_time)
                if channel is not None:
                    message = Message((offset, at), channel, log_time, publish_time, bytes(data))
                    heapq.heappush(ahead, (sign * log_time, True, place, sign * at, message))
                    unread[offset] += 1
            if unread[offset] == 0:
                del sizes[offset]

    def _in_file(self, wanted: Callable[[int, int], mcap.Channel | None]) -> Iterator[Message]:
        at = len(mcap.MAGIC)
        while (record := self._record(at)) is not None and record.kind not in (mcap.DATA_END, mcap.FOOTER):
            inside: Iterator[tuple[int, bytes | memoryview, int]] = iter(())
            if record.kind == mcap.CHUNK:
                inside = mcap.records(self._chunk(self._chunk_head(record)))
            elif record.kind in (mcap.SCHEMA, mcap.CHANNEL, mcap.MESSAGE):
                inside = iter([(record.kind, self._bytes(record.content, record.length), 0)])
            for kind, content, within in inside:
                self._take(kind, content)
                if kind == mcap.MESSAGE:
                    number, log_time, publish_time, data = mcap.read_message(content)
                    channel = wanted(number, log_time)
                    if channel is not None:
                        yield Message((at, within), channel, log_time, publish_time, bytes(data))
            at = record.content + record.length
