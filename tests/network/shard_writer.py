"""Writes the sharded form (CEP 16) of a flat index, with nothing but the standard library: MessagePack, and zstd frames
whose blocks are stored as they are."""
from __future__ import annotations

import hashlib
import json
import struct
from pathlib import Path
from typing import Any

BLOCK = 1 << 16


def msgpack(value: Any) -> bytes:
    if value is None:
        return b"\xc0"
    if isinstance(value, bool):
        return b"\xc3" if value else b"\xc2"
    if isinstance(value, int):
        return b"\xd3" + struct.pack(">q", value)
    if isinstance(value, str):
        data = value.encode()
        return b"\xdb" + struct.pack(">I", len(data)) + data
    if isinstance(value, bytes):
        return b"\xc6" + struct.pack(">I", len(value)) + value
    if isinstance(value, list):
        return b"\xdd" + struct.pack(">I", len(value)) + b"".join(msgpack(one) for one in value)
    if isinstance(value, dict):
        packed = b"".join(msgpack(key) + msgpack(one) for key, one in value.items())
        return b"\xdf" + struct.pack(">I", len(value)) + packed
    raise TypeError(type(value))


def zstd_stored(data: bytes) -> bytes:
    blocks = [data[i:i + BLOCK] for i in range(0, len(data), BLOCK)] or [b""]
    out = b"\x28\xb5\x2f\xfd" + bytes([0xA0]) + struct.pack("<I", len(data))  # one segment, 4 bytes of size
    for number, block in enumerate(blocks):
        last = 1 if number == len(blocks) - 1 else 0
        out += struct.pack("<I", len(block) << 3 | last)[:3] + block
    return out


def write_shards(subdir: Path, base_url: str = "", shards_base_url: str = "") -> None:
    """From `repodata.json` of the folder; hashes become binary, as real shards have them."""
    flat = json.loads((subdir / "repodata.json").read_text())
    by_name: dict[str, dict[str, Any]] = {}
    for key in ("packages", "packages.conda"):
        for file_name, record in flat.get(key, {}).items():
            for kind in ("sha256", "md5"):
                if record.get(kind):
                    record[kind] = bytes.fromhex(record[kind])
            shard = by_name.setdefault(record["name"], {"packages": {}, "packages.conda": {}, "removed": []})
            shard[key][file_name] = record
    shards = {}
    for name, shard in by_name.items():
        data = zstd_stored(msgpack(shard))
        shards[name] = hashlib.sha256(data).digest()
        (subdir / f"{shards[name].hex()}.msgpack.zst").write_bytes(data)
    listed = {"version": 1, "shards": shards,
              "info": {"subdir": subdir.name, "base_url": base_url, "shards_base_url": shards_base_url}}
    (subdir / "repodata_shards.msgpack.zst").write_bytes(zstd_stored(msgpack(listed)))
