// Bytes of the packed example 01, raw and compressed, by file and in sums: of what a visit loads, and of what is
// fetched when a node crashed (the names of its functions).
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';
import type { BenchContext } from './run.ts';

/** Upper bound for the first C++ node of most people, compressed with gzip: bytes. */
const AIMS: Readonly<Record<string, number>> = { 'programs/tutorial_talker/talker.wasm': 150_000 };

export function packedExample(context: BenchContext, folder: string, example = '01_talker_listener'): string {
  const site = join(folder, 'site');
  const run = spawnSync(
    join(context.build, 'ros2wasm'),
    ['pack', join(context.root, 'examples', example, 'workspace.yaml'), '-o', site],
    { encoding: 'utf8' },
  );
  if (run.status !== 0) throw new Error(`pack failed: ${run.stderr}`);
  return site;
}

export function benchBytes(context: BenchContext): void {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const site = packedExample(context, folder);
    const files = readdirSync(site, { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map((entry) => join(entry.parentPath, entry.name))
      .sort();
    const visit = { files: 0, raw: 0, gzip: 0, brotli: 0 };
    const crash = { files: 0, raw: 0, gzip: 0, brotli: 0 };
    for (const file of files) {
      const bytes = readFileSync(file);
      const raw = bytes.length;
      const gzip = gzipSync(bytes, { level: 9 }).length;
      const brotli = brotliCompressSync(bytes, {
        params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_SIZE_HINT]: raw },
      }).length;
      const total = file.endsWith('.names') ? crash : visit;
      total.files += 1;
      total.raw += raw;
      total.gzip += gzip;
      total.brotli += brotli;
      const name = relative(site, file);
      const aim = AIMS[name];
      context.emit({ bench: 'bytes', file: name, raw, gzip, brotli, ...(aim === undefined ? {} : { gzip_aim: aim }) });
      if (aim !== undefined && gzip >= aim) context.fail(`${name} has ${String(gzip)} bytes compressed, ${String(aim)} are the aim`);
    }
    context.emit({ bench: 'bytes', file: 'all', ...visit });
    context.emit({ bench: 'bytes', file: 'all, for crash reports', ...crash });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
