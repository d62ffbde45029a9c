// Channels to solve in: a real index of 4,211 records, and a made one of any size whose names, versions
// and dependencies are spread as in large public channels. The same numbers give the same bytes.
import { execFileSync } from 'node:child_process';
import { closeSync, mkdirSync, openSync, readFileSync, writeFileSync, writeSync } from 'node:fs';
import { join } from 'node:path';
import { zstdCompressSync } from 'node:zlib';
import { writeShards } from './shards.ts';
import type { Shard, ShardedRecord } from './shards.ts';

interface IndexRecord {
  readonly name: string;
  readonly version: string;
  readonly build: string;
  readonly build_number: number;
  readonly depends: readonly string[];
}

function writeIndex(channel: string, subdir: string, text: string): void {
  mkdirSync(join(channel, subdir), { recursive: true });
  writeFileSync(join(channel, subdir, 'repodata.json'), text);
  writeFileSync(join(channel, subdir, 'repodata.json.zst'), zstdCompressSync(text));
}

/** A version that the spec takes: its first number, or 1. */
function fittingVersion(spec: string): readonly [version: string, build: string] {
  const [, version = '1', build = 'stub_0'] = spec.split(' ');
  const number = /[0-9][0-9a-z._]*/.exec(version)?.[0] ?? '1';
  return [number.replace(/\.$/, ''), build];
}

/**
 * The real index (xz of a repodata.json), as if it were for emscripten-wasm32. It leans on packages of
 * another channel: those become empty noarch packages, one for each version that is asked for.
 */
export function makeRealChannel(channel: string, source: string): number {
  const program = 'import lzma, sys; sys.stdout.buffer.write(lzma.open(sys.argv[1]).read())';
  const text = execFileSync('python3', ['-c', program, source], { encoding: 'utf8', maxBuffer: 1 << 28 });
  writeIndex(channel, 'emscripten-wasm32', text.replaceAll('"linux-64"', '"emscripten-wasm32"'));
  const { packages } = JSON.parse(text) as { packages: Readonly<Record<string, IndexRecord>>; };
  const names = new Set(Object.values(packages).map((record) => record.name));
  const stubs: Record<string, unknown> = {};
  for (const spec of new Set(Object.values(packages).flatMap((record) => record.depends))) {
    const name = spec.split(' ')[0] ?? spec;
    if (names.has(name)) continue;
    const [version, build] = fittingVersion(spec);
    stubs[`${name}-${version}-${build}.tar.bz2`] = {
      name,
      version,
      build,
      build_number: 0,
      depends: [],
      noarch: 'generic',
      subdir: 'noarch',
      md5: '0'.repeat(32),
      sha256: '0'.repeat(64),
      size: 1,
    };
  }
  writeIndex(channel, 'noarch', JSON.stringify({ info: { subdir: 'noarch' }, packages: stubs }));
  return Object.keys(packages).length;
}

/** A small generator of numbers in [0, 1) (mulberry32). */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let x = Math.imul(state ^ (state >>> 15), state | 1);
    x ^= x + Math.imul(x ^ (x >>> 7), x | 61);
    return ((x ^ (x >>> 14)) >>> 0) / 4294967296;
  };
}

export interface LargeChannel {
  readonly records: number;
  readonly names: number;
}

/** Name of a package; low ranks are what others build on. */
export function largeName(rank: number): string {
  return `${['lib', 'py', 'ros-jazzy-', 'r-'][rank % 4] ?? ''}pkg${String(rank).padStart(5, '0')}`;
}

/** Version number `index` of a package: a new major about every 40 releases. */
function versionAt(rank: number, index: number): string {
  return `${1 + Math.floor((index + (rank % 17)) / 40)}.${index}.0`;
}

function specFor(rank: number, newest: number, draw: () => number): string {
  const name = largeName(rank);
  const dice = draw();
  if (dice < 0.25 || newest < 1) return name;
  const lowest = Math.floor(newest * 0.7 * draw());
  if (dice < 0.75) return `${name} >=${versionAt(rank, lowest)}`;
  const major = Number(versionAt(rank, newest).split('.')[0]);
  return `${name} >=${versionAt(rank, lowest)},<${major + 1}.0a0`;
}

/** The records of one name after the other. */
function* largeShards(size: LargeChannel): Generator<Shard> {
  const draw = numbers(20260101);
  const hex = (digits: number): string => {
    let text = '';
    while (text.length < digits) text += Math.floor(draw() * 0x100000000).toString(16).padStart(8, '0');
    return text.slice(0, digits);
  };
  const weights = Array.from({ length: size.names }, (_, rank) => 1 / (rank + 30) ** 0.5);
  const unit = (size.records - size.names) / weights.reduce((sum, weight) => sum + weight, 0);
  const releases = weights.map((weight) => 1 + Math.floor(unit * weight));
  for (let missing = size.records - releases.reduce((sum, count) => sum + count, 0), rank = 0; missing > 0; missing -= 1) {
    releases[rank] = (releases[rank] ?? 0) + 1;
    rank = (rank + 1) % size.names;
  }
  for (let rank = 0; rank < size.names; rank += 1) {
    const name = largeName(rank);
    const count = releases[rank] ?? 1;
    const leaned = rank < 4 ? [] : Array.from({ length: 2 + Math.floor(draw() * 5) }, () => Math.floor(rank * draw() ** 4));
    const records: Record<string, ShardedRecord> = {};
    for (let index = 0; index < count; index += 1) {
      const depends = ['emscripten-abi >=4,<5', ...[...new Set(leaned)].map((other) =>
        specFor(other, Math.floor(((releases[other] ?? 1) - 1) * ((index + 1) / count)), draw)
      )];
      const build = `h${hex(7)}_0`;
      records[`${name}-${versionAt(rank, index)}-${build}.conda`] = {
        build,
        build_number: 0,
        depends: rank === 0 ? [] : depends,
        license: 'BSD-3-Clause',
        license_family: 'BSD',
        md5: hex(32),
        name,
        sha256: hex(64),
        size: 1000 + Math.floor(draw() * 1e6),
        subdir: 'emscripten-wasm32',
        timestamp: 1700000000000 + index * 1000,
        version: versionAt(rank, index),
      };
    }
    yield { name, records };
  }
  const abi = {
    build: '0',
    build_number: 0,
    depends: [],
    name: 'emscripten-abi',
    version: '4.0.9',
    subdir: 'emscripten-wasm32',
    size: 1,
    md5: hex(32),
    sha256: hex(64),
  };
  yield { name: abi.name, records: { 'emscripten-abi-4.0.9-0.conda': abi } };
}

/** Writes `emscripten-wasm32/repodata.json(.zst)`, or the same as shards; noarch is empty. */
export function makeLargeChannel(channel: string, size: LargeChannel, form: 'zst' | 'shards'): void {
  const subdir = 'emscripten-wasm32';
  if (form === 'shards') {
    writeShards(join(channel, subdir), subdir, largeShards(size));
    writeShards(join(channel, 'noarch'), 'noarch', []);
    return;
  }
  writeIndex(channel, 'noarch', JSON.stringify({ info: { subdir: 'noarch' }, packages: {} }));
  mkdirSync(join(channel, subdir), { recursive: true });
  const path = join(channel, subdir, 'repodata.json');
  const file = openSync(path, 'w');
  writeSync(file, `{"info":{"subdir":"${subdir}"},"packages":{},"packages.conda":{`);
  let comma = '';
  for (const { records } of largeShards(size)) {
    const lines = Object.entries(records).map(([name, record]) => `${JSON.stringify(name)}:${JSON.stringify(record)}`);
    writeSync(file, comma + lines.join(',\n'));
    comma = ',\n';
  }
  writeSync(file, '},"repodata_version":1}\n');
  closeSync(file);
  writeFileSync(`${path}.zst`, zstdCompressSync(readFileSync(path)));
}
