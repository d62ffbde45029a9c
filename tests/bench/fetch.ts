// Fetching, verifying and unpacking 200 archives of 1 GB in all: `ros2wasm cache fetch` from a folder and over HTTP,
// beside sha256sum of the archives and bsdtar of the same bytes. ros2wasm also checks every unpacked file's sha256;
// what that costs with sha256sum is a figure of its own. FETCH_ARCHIVES and FETCH_MB make it smaller.
import { spawn, spawnSync } from 'node:child_process';
import { createHash, randomBytes } from 'node:crypto';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { measure } from './measured_process.ts';
import type { Measured } from './measured_process.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const FILES_EACH = 8;
const RUNS = 3;

/** sha256sum of all archives, then bsdtar of both parts of each, as a script: the folder and the output are $1, $2. */
const PEER = `set -e; cd "$1"; sha256sum noarch/*.conda >/dev/null
for f in noarch/*.conda; do n=$(basename "$f" .conda); mkdir -p "$2/$n"
  for part in pkg info; do bsdtar -xOf "$f" "$part-$n.tar.zst" | bsdtar -xf - -C "$2/$n"; done; done`;
const PEER_FILES = 'cd "$1"; find . -type f -print0 | xargs -0 sha256sum >/dev/null';

interface Package {
  readonly file: string;
  readonly sha256: string;
  readonly size: number;
}

function run(program: string, words: readonly string[]): void {
  const done = spawnSync(program, words, { encoding: 'utf8' });
  if (done.status !== 0) throw new Error(`${program}: ${done.stderr || String(done.error)}`);
}

function sha256(bytes: Buffer): string {
  return createHash('sha256').update(bytes).digest('hex');
}

/** A package of half random bytes and half text, which is what libraries look like to a compressor. */
function makePackage(folder: string, number: number, bytes: number): Package {
  const name = `p${String(number)}`;
  const dist = `${name}-1.0-h_0`;
  const stage = join(folder, 'stage');
  rmSync(stage, { recursive: true, force: true });
  const paths = [];
  for (let i = 0; i < FILES_EACH; ++i) {
    const path = `lib/${name}/file${String(i)}`;
    const size = Math.floor(bytes / FILES_EACH);
    const text = Buffer.from(`line ${String(i)} of a file with text in it\n`.repeat(Math.ceil(size / 70)));
    const content = Buffer.concat([randomBytes(size), text]);
    mkdirSync(dirname(join(stage, path)), { recursive: true });
    writeFileSync(join(stage, path), content);
    paths.push({ _path: path, path_type: 'hardlink', sha256: sha256(content), size_in_bytes: content.length });
  }
  mkdirSync(join(stage, 'info'));
  writeFileSync(join(stage, 'info/paths.json'), JSON.stringify({ paths, paths_version: 1 }));
  writeFileSync(join(stage, 'info/index.json'), JSON.stringify({ name, version: '1.0', build: 'h_0', build_number: 0, depends: [] }));
  const parts = join(folder, 'parts');
  mkdirSync(parts, { recursive: true });
  const pack = (part: string, what: string): void =>
    run('bsdtar', ['-cf', join(parts, `${part}-${dist}.tar.zst`), '--zstd', '--options', 'zstd:compression-level=3', '-C', stage, what]);
  pack('pkg', 'lib');
  pack('info', 'info');
  writeFileSync(join(parts, 'metadata.json'), '{"conda_pkg_format_version": 2}');
  const file = join(folder, 'channel/noarch', `${dist}.conda`);
  run('bsdtar', ['-cf', file, '--format', 'zip', '--options', 'zip:compression=store', '-C', parts, 'metadata.json', `pkg-${dist}.tar.zst`,
    `info-${dist}.tar.zst`]);
  rmSync(parts, { recursive: true });
  rmSync(stage, { recursive: true });
  return { file: `${dist}.conda`, sha256: sha256(readFileSync(file)), size: statSync(file).size };
}

/** A lock is YAML, and so is JSON. */
function lockText(packages: readonly Package[], channel: string): string {
  return JSON.stringify({
    schema: 1,
    platform: 'emscripten-wasm32',
    channels: [channel],
    specs: [],
    packages: packages.map((one) => ({
      name: one.file.split('-')[0],
      version: '1.0',
      build: 'h_0',
      build_number: 0,
      subdir: 'noarch',
      channel,
      file: one.file,
      url: `${channel}/noarch/${one.file}`,
      sha256: one.sha256,
      size: one.size,
    })),
  });
}

interface ChildServer {
  readonly url: string;
  close(): void;
}

/** A file server in a process of its own: measuring blocks this one. */
function childServer(folder: string): Promise<ChildServer> {
  const program = `import { serveFolder } from ${JSON.stringify(join(import.meta.dirname, '../support/static_server.ts'))};
    console.log((await serveFolder(process.argv[1])).url);`;
  const child = spawn(process.execPath, ['--input-type=module', '-e', program, folder], { stdio: ['ignore', 'pipe', 'inherit'] });
  return new Promise((resolve, reject) => {
    child.once('error', reject);
    child.stdout.once('data', (line: Buffer) => {
      resolve({ url: line.toString().trim(), close: () => void child.kill() });
    });
  });
}

export async function benchFetch(context: BenchContext): Promise<void> {
  const archives = Number(process.env['FETCH_ARCHIVES'] ?? '200');
  const bytes = Number(process.env['FETCH_MB'] ?? '1000') * 1e6;
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-fetch-'));
  try {
    mkdirSync(join(folder, 'channel/noarch'), { recursive: true });
    const packages = Array.from({ length: archives }, (_, i) => makePackage(folder, i, bytes / archives));
    const cache = join(folder, 'cache');
    const fetchFrom = (channel: string): Measured => {
      rmSync(cache, { recursive: true, force: true });
      return again(channel);
    };
    const again = (channel: string): Measured => {
      const lock = join(folder, 'bench.lock');
      writeFileSync(lock, lockText(packages, channel));
      const done = measure([join(context.build, 'ros2wasm'), '--quiet', 'cache', 'fetch', lock], { ...process.env, XDG_CACHE_HOME: cache });
      if (done.exitCode !== 0) throw new Error(done.stderr);
      return done;
    };
    const peer = (): Measured => {
      rmSync(join(folder, 'out'), { recursive: true, force: true });
      mkdirSync(join(folder, 'out'));
      return measure(['sh', '-c', PEER, 'sh', join(folder, 'channel'), join(folder, 'out')]);
    };
    const rounds = { file: [] as Measured[], http: [] as Measured[], cached: [] as Measured[], peer: [] as Measured[], peerFiles: [] as Measured[] };
    const server = await childServer(join(folder, 'channel'));
    try {
      for (let i = 0; i < RUNS; ++i) {
        rounds.peer.push(peer());
        rounds.peerFiles.push(measure(['sh', '-c', PEER_FILES, 'sh', join(folder, 'out')]));
        rounds.file.push(fetchFrom(join(folder, 'channel')));
        rounds.cached.push(again(join(folder, 'channel')));
        rounds.http.push(fetchFrom(server.url.replace(/\/$/, '')));
      }
    } finally {
      server.close();
    }
    const wall = (runs: readonly Measured[]): number => summary(runs.map((one) => one.wallMs)).median;
    context.emit({
      bench: 'fetch',
      archives,
      archive_bytes: packages.reduce((sum, one) => sum + one.size, 0),
      folder_ms: summary(rounds.file.map((one) => one.wallMs)),
      http_ms: summary(rounds.http.map((one) => one.wallMs)),
      cached_ms: summary(rounds.cached.map((one) => one.wallMs)),
      peak_kb: Math.max(...rounds.file.map((one) => one.peakKb), ...rounds.http.map((one) => one.peakKb)),
      peer: 'sha256sum of the archives, then bsdtar',
      peer_ms: summary(rounds.peer.map((one) => one.wallMs)),
      peer_files: 'sha256sum of the unpacked files',
      peer_files_ms: summary(rounds.peerFiles.map((one) => one.wallMs)),
      ratio: Math.round((wall(rounds.file) / wall(rounds.peer)) * 100) / 100,
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
