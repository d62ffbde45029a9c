// The sharded form of an index (CEP 16): one packed file per name, and the list of their hashes.
import { createHash } from 'node:crypto';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { zstdCompressSync } from 'node:zlib';

type Packable = string | number | Buffer | readonly Packable[] | { readonly [key: string]: Packable };

function head(first: number, size: number): Buffer {
  const bytes = Buffer.alloc(5, first);
  bytes.writeUInt32BE(size, 1);
  return bytes;
}

/** MessagePack, each value in its 32-bit form. */
function pack(value: Packable, out: Buffer[]): void {
  if (typeof value === 'string') {
    const text = Buffer.from(value);
    out.push(head(0xdb, text.length), text);
  } else if (typeof value === 'number') {
    const bytes = Buffer.alloc(9, 0xd3);
    bytes.writeBigInt64BE(BigInt(value), 1);
    out.push(bytes);
  } else if (Buffer.isBuffer(value)) {
    out.push(head(0xc6, value.length), value);
  } else if (value instanceof Array) {
    out.push(head(0xdd, value.length));
    for (const one of value) pack(one, out);
  } else {
    const entries = Object.entries(value);
    out.push(head(0xdf, entries.length));
    for (const [key, one] of entries) {
      pack(key, out);
      pack(one, out);
    }
  }
}

function packed(value: Packable): Buffer {
  const parts: Buffer[] = [];
  pack(value, parts);
  return Buffer.concat(parts);
}

export interface ShardedRecord {
  readonly md5: string;
  readonly sha256: string;
  readonly [key: string]: Packable;
}

export interface Shard {
  readonly name: string;
  /** By file name. */
  readonly records: Readonly<Record<string, ShardedRecord>>;
}

/** Writes the shards of one folder of a channel. */
export function writeShards(folder: string, subdir: string, all: Iterable<Shard>): void {
  mkdirSync(folder, { recursive: true });
  const shards: Record<string, Buffer> = {};
  for (const { name, records } of all) {
    const binary = Object.entries(records).map(([file, record]) =>
      [file, { ...record, md5: Buffer.from(record.md5, 'hex'), sha256: Buffer.from(record.sha256, 'hex') }] as const);
    const bytes = zstdCompressSync(packed({ packages: {}, 'packages.conda': Object.fromEntries(binary), removed: [] }));
    const hash = createHash('sha256').update(bytes).digest();
    writeFileSync(join(folder, `${hash.toString('hex')}.msgpack.zst`), bytes);
    shards[name] = hash;
  }
  const list = packed({ version: 1, info: { subdir, base_url: '', shards_base_url: '' }, shards });
  writeFileSync(join(folder, 'repodata_shards.msgpack.zst'), zstdCompressSync(list));
}
