// The sharded form of an index (CEP 16): one packed file per name, and the list of their hashes.
import { createHash } from 'node:crypto';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { zstdCompressSync } from 'node:zlib';

type Packable = string | number | Buffer | readonly Packable[] | { readonly [key: string]: Packable; };

/** First byte and number, in as many bytes as it takes; `short` stands for numbers below `limit`. */
function head(size: number, short: number, limit: number, first: readonly [one: number, two: number, four: number]): Buffer {
  if (size < limit) return Buffer.from([short | size]);
  const bytes = size < 1 << 8 && first[0] !== 0 ? 1 : size < 1 << 16 ? 2 : 4;
  const out = Buffer.alloc(1 + bytes, bytes === 1 ? first[0] : bytes === 2 ? first[1] : first[2]);
  out.writeUIntBE(size, 1, bytes);
  return out;
}

/** MessagePack, each value in its shortest form, as the usual writers do. */
function pack(value: Packable, out: Buffer[]): void {
  if (typeof value === 'string') {
    const text = Buffer.from(value);
    out.push(head(text.length, 0xa0, 32, [0xd9, 0xda, 0xdb]), text);
  } else if (typeof value === 'number' && value < 2 ** 32) {
    out.push(head(value, 0, 128, [0xcc, 0xcd, 0xce]));
  } else if (typeof value === 'number') {
    const bytes = Buffer.alloc(9, 0xcf);
    bytes.writeBigUInt64BE(BigInt(value), 1);
    out.push(bytes);
  } else if (Buffer.isBuffer(value)) {
    out.push(head(value.length, 0, 0, [0xc4, 0xc5, 0xc6]), value);
  } else if (value instanceof Array) {
    out.push(head(value.length, 0x90, 16, [0, 0xdc, 0xdd]));
    for (const one of value) pack(one, out);
  } else {
    const entries = Object.entries(value);
    out.push(head(entries.length, 0x80, 16, [0, 0xde, 0xdf]));
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
      [file, { ...record, md5: Buffer.from(record.md5, 'hex'), sha256: Buffer.from(record.sha256, 'hex') }] as const
    );
    const bytes = zstdCompressSync(packed({ packages: {}, 'packages.conda': Object.fromEntries(binary), removed: [] }));
    const hash = createHash('sha256').update(bytes).digest();
    writeFileSync(join(folder, `${hash.toString('hex')}.msgpack.zst`), bytes);
    shards[name] = hash;
  }
  const list = packed({ version: 1, info: { subdir, base_url: '', shards_base_url: '' }, shards });
  writeFileSync(join(folder, 'repodata_shards.msgpack.zst'), zstdCompressSync(list));
}
