"""
The records of MCAP files, of version 0 of the format: little-endian, texts and lists behind their length in 32 bits.

What is read is of unknown origin, so a length is looked at before anything is done with it.
"""
from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass, field

MAGIC = b'\x89MCAP0\r\n'
#: Kind and length, before each record.
HEAD = struct.Struct('<BQ')

HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END = range(11, 16)

MESSAGE_HEAD = struct.Struct('<HIQQ')
LZ4_MAGIC = 0x184D2204
#: What a byte of LZ4 can grow to.
LZ4_GROWTH = 255


class Damaged(RuntimeError):
    """What a file says cannot be."""


@dataclass
class Schema:
    id: int
    name: str
    encoding: str
    data: bytes


@dataclass
class Channel:
    id: int
    schema: int
    topic: str
    encoding: str
    metadata: dict[str, str]


@dataclass
class ChunkPlace:
    """What a chunk's head says, and where its record lies."""

    first_time: int
    last_time: int
    offset: int
    length: int
    message_indexes: dict[int, int] = field(default_factory=dict)
    message_indexes_length: int = 0
    compression: str = ''
    compressed_size: int = 0
    size: int = 0


@dataclass
class Statistics:
    messages: int = 0
    schemas: int = 0
    channels: int = 0
    attachments: int = 0
    metadata: int = 0
    chunks: int = 0
    first_time: int = 0
    last_time: int = 0
    messages_of: dict[int, int] = field(default_factory=dict)

    def count(self, channel: int, time: int) -> None:
        """One more message."""
        self.first_time = min(self.first_time, time) if self.messages else time
        self.last_time = max(self.last_time, time) if self.messages else time
        self.messages += 1
        self.messages_of[channel] = self.messages_of.get(channel, 0) + 1


class Bytes:
    """Values out of bytes, one after the other."""

    def __init__(self, data: bytes | memoryview) -> None:
        self.data = memoryview(data)
        self.at = 0

    def take(self, size: int) -> memoryview:
        if size > len(self.data) - self.at:
            raise Damaged('a record is shorter than it says')
        self.at += size
        return self.data[self.at - size:self.at]

    def number(self, size: int) -> int:
        return int.from_bytes(self.take(size), 'little')

    def block(self) -> memoryview:
        return self.take(self.number(4))

    def text(self) -> str:
        return bytes(self.block()).decode(errors='replace')

    def texts(self) -> dict[str, str]:
        inner, found = Bytes(self.block()), {}
        while not inner.at_end():
            key = inner.text()
            found[key] = inner.text()
        return found

    def numbers(self) -> dict[int, int]:
        inner, found = Bytes(self.block()), {}
        while not inner.at_end():
            key = inner.number(2)
            found[key] = inner.number(8)
        return found

    def at_end(self) -> bool:
        return self.at >= len(self.data)


def records(data: bytes | memoryview) -> Iterator[tuple[int, memoryview, int]]:
    """Kind, content and place of each record of a chunk or a summary."""
    every = Bytes(data)
    while not every.at_end():
        at = every.at
        kind = every.number(1)
        yield kind, every.take(every.number(8)), at


def read_schema(data: bytes | memoryview) -> Schema:
    from_ = Bytes(data)
    return Schema(from_.number(2), from_.text(), from_.text(), bytes(from_.block()))


def read_channel(data: bytes | memoryview) -> Channel:
    from_ = Bytes(data)
    return Channel(from_.number(2), from_.number(2), from_.text(), from_.text(), from_.texts())


def read_message(data: bytes | memoryview) -> tuple[int, int, int, memoryview]:
    """Channel, log time, publish time and bytes."""
    from_ = Bytes(data)
    channel, _, log_time, publish_time = MESSAGE_HEAD.unpack(from_.take(MESSAGE_HEAD.size))
    return channel, log_time, publish_time, from_.data[from_.at:]


def read_chunk_place(data: bytes | memoryview) -> ChunkPlace:
    from_ = Bytes(data)
    first, last, offset, length = (from_.number(8) for _ in range(4))
    return ChunkPlace(
        first, last, offset, length, from_.numbers(), from_.number(8), from_.text(), from_.number(8), from_.number(8))


def read_statistics(data: bytes | memoryview) -> Statistics:
    from_ = Bytes(data)
    messages, schemas, channels, attachments, metadata, chunks, first, last = (
        from_.number(size) for size in (8, 2, 4, 4, 4, 4, 8, 8))
    return Statistics(messages, schemas, channels, attachments, metadata, chunks, first, last, from_.numbers())


def read_metadata(data: bytes | memoryview) -> tuple[str, dict[str, str]]:
    from_ = Bytes(data)
    return from_.text(), from_.texts()


def read_metadata_place(data: bytes | memoryview) -> tuple[int, str]:
    """Where it lies, and its name."""
    from_ = Bytes(data)
    offset, _ = from_.number(8), from_.number(8)
    return offset, from_.text()


def block(data: bytes) -> bytes:
    return struct.pack('<I', len(data)) + data


def text(value: str) -> bytes:
    return block(value.encode())


def texts(values: dict[str, str]) -> bytes:
    return block(b''.join(text(key) + text(value) for key, value in sorted(values.items())))


def numbers(values: dict[int, int]) -> bytes:
    return block(b''.join(struct.pack('<HQ', key, value) for key, value in sorted(values.items())))


def record(kind: int, content: bytes) -> bytes:
    return HEAD.pack(kind, len(content)) + content


def schema_bytes(one: Schema) -> bytes:
    return record(SCHEMA, struct.pack('<H', one.id) + text(one.name) + text(one.encoding) + block(one.data))


def channel_bytes(one: Channel) -> bytes:
    return record(
        CHANNEL, struct.pack('<HH', one.id, one.schema) + text(one.topic) + text(one.encoding) + texts(one.metadata))


def chunk_place_bytes(one: ChunkPlace) -> bytes:
    return record(CHUNK_INDEX, (
        struct.pack('<QQQQ', one.first_time, one.last_time, one.offset, one.length) + numbers(one.message_indexes)
        + struct.pack('<Q', one.message_indexes_length) + text(one.compression)
        + struct.pack('<QQ', one.compressed_size, one.size)))


def statistics_bytes(one: Statistics) -> bytes:
    return record(STATISTICS, struct.pack(
        '<QHIIIIQQ', one.messages, one.schemas, one.channels, one.attachments, one.metadata, one.chunks, one.first_time,
        one.last_time) + numbers(one.messages_of))


def _lz4_length(first: int, from_: Bytes) -> int:
    """15 goes on in the bytes behind it."""
    if first < 15:
        return first
    more = 255
    while more == 255:
        more = from_.number(1)
        first += more
    return first


def _lz4_block(data: memoryview, out: bytearray, size: int) -> None:
    """Matches may reach back into earlier blocks."""
    from_ = Bytes(data)
    while not from_.at_end():
        token = from_.number(1)
        out += from_.take(_lz4_length(token >> 4, from_))
        # The last part of a block has no match.
        if from_.at_end():
            break
        back = from_.number(2)
        match = 4 + _lz4_length(token & 15, from_)
        if not 0 < back <= len(out) or match > size - len(out):
            raise Damaged('LZ4 data point outside of what they made')
        # A match may overlap itself.
        while match > 0:
            part = min(match, back)
            start = len(out) - back
            out += out[start:start + part]
            match -= part


def unpack_lz4(data: bytes | memoryview, size: int) -> bytes:
    """What frames of LZ4 make, which must be so many bytes. Checksums are passed over: chunks have their own."""
    from_, out = Bytes(data), bytearray()
    if size // LZ4_GROWTH > len(from_.data):
        raise Damaged('LZ4 data are too short for what they say')
    while not from_.at_end():
        if from_.number(4) != LZ4_MAGIC:
            raise Damaged('a chunk is not a frame of LZ4')
        flags = from_.number(1)
        if flags >> 6 != 1 or flags & 1:
            raise Damaged('an LZ4 of another version, or with a dictionary')
        # Size of blocks, size of the content, checksum of the head.
        from_.take(10 if flags & 8 else 2)
        while head := from_.number(4):
            part = from_.take(head & 0x7FFFFFFF)
            if head >> 31:
                out += part
            else:
                _lz4_block(part, out, size)
            if len(out) > size:
                raise Damaged('LZ4 data make more than they say')
            from_.take(4 if flags & 16 else 0)
        from_.take(4 if flags & 4 else 0)
    if len(out) != size:
        raise Damaged('a chunk has other bytes than it says')
    return bytes(out)
