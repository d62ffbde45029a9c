// Python programs in this process: how one ends when Python itself could not go on, and its view of the site's files.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { loadPyodide } from 'pyodide';
import { PortWaits } from '../../../runtime/site/bus/port_waits.ts';
import type { ProgramEnd, ProgramHost } from '../../../runtime/site/program/program.ts';
import { failure, look, mountShare, runPython } from '../../../runtime/site/python/python_program.ts';
import { ProgramMemory } from '../../../runtime/site/program/program_memory.ts';
import type { SiteFile } from '../../../runtime/site/contract/session.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const pyodide = `${dirname(createRequire(import.meta.url).resolve('pyodide'))}/`;
const watchdog = { timeout: 240_000 };

function deeper(): number {
  return 1 + deeper();
}

test('a full stack is not taken for a lack of memory', () => {
  let caught: unknown;
  try {
    deeper();
  } catch (error) {
    caught = error;
  }
  assert.deepEqual(failure(caught), { kind: 'crash', code: 'R2W0701', message: 'the stack is full: too deep a recursion?' });
  assert.equal((failure(new RangeError('could not allocate memory')) as { code: string; }).code, 'R2W0710');
  assert.deepEqual(failure('gone'), { kind: 'crash', code: 'R2W0701', message: 'gone' });
});

test('a share file that cannot be read is an error, not zeros, and is tried again', watchdog, async () => {
  const python = await loadPyodide({ indexURL: pyodide });
  const site = new Map<string, Uint8Array>([['share/short.txt', new Uint8Array(2)]]);
  mountShare(python, {
    files: { prefix: '/opt/ros/jazzy', place: '', files: [['share/late.txt', 3], ['share/short.txt', 3]] },
    readNow: (_place, path) => site.get(path),
  });
  const read = (path: string): unknown =>
    python.runPython(`
try:
    found = open('/opt/ros/jazzy/share/${path}', 'rb').read().decode()
except OSError as error:
    import errno
    found = errno.errorcode[error.errno]
found`);
  assert.equal(read('late.txt'), 'EIO');
  assert.equal(read('short.txt'), 'EIO');
  site.set('share/late.txt', new TextEncoder().encode('yes'));
  assert.equal(read('late.txt'), 'yes');
});

test('a look takes a message only of the reader that is expected, alone, with the statuses as they were', () => {
  const heap = new ProgramMemory(new WebAssembly.Memory({ initial: 1 }));
  const at = 64;
  for (const [i, word] of [4096, 100, 8192].entries()) heap.set(at + 8 + 4 * i, word);
  const seen = (ready: readonly number[], statuses: number, length: number): readonly unknown[] => {
    const taken: number[][] = [];
    const link = {
      wakeToken: () => 7,
      ready: () => ready,
      statusVersion: () => statuses,
      take: (endpoint: number, _heap: unknown, ...places: number[]) => {
        taken.push([endpoint, ...places]);
        return length;
      },
    };
    const result = look(link, heap, at, 2, 5, 3);
    assert.deepEqual([heap.u32(at), heap.u32(at + 4), heap.u32(at + 8)], [7, statuses, 4096]);
    return [result, taken, Array.from({ length: Math.max(result, 0) }, (_, i) => heap.u32(at + 24 + 4 * i))];
  };
  const take = [[5, 4096, 100, 8192]];
  assert.deepEqual(seen([5], 3, 12), [-13, take, []]);
  assert.deepEqual(seen([5], 3, 0), [-1, take, []]);
  // Too large, and gone meanwhile.
  assert.deepEqual(seen([5], 3, 101), [1, take, [5]]);
  assert.deepEqual(seen([5], 3, -1), [1, take, [5]]);
  assert.deepEqual(seen([5], 4, 12), [1, [], [5]]);
  assert.deepEqual(seen([6], 3, 12), [1, [], [6]]);
  assert.deepEqual(seen([], 3, 12), [0, [], []]);
  assert.deepEqual(seen([5, 6, 8], 3, 12), [2, [], [5, 6]]);
});

/** Runs a script on a link to nobody, which suspends. `listed`: what the archive must be. */
async function runScript(script: string, listed: readonly SiteFile[] = []): Promise<{ readonly end: ProgramEnd; readonly lines: readonly string[]; }> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-python-'));
  try {
    mkdirSync(join(folder, 'lib'));
    writeFileSync(join(folder, 'lib/script'), script);
    execFileSync('python3', [
      join(root, 'tests/support/make_archive.py'),
      join(folder, 'all.zip'),
      `${join(folder, 'lib')}=lib/test`,
      ...['rclpy', 'ros2wasm'].map((name) => `${join(root, 'runtime/packages/client/rclpy', name)}=lib/python3.12/site-packages/${name}`),
    ]);
    const lines: string[] = [];
    const clock = {
      systemNs: () => Date.now() * 1e6,
      steadyNs: () => performance.now() * 1e6,
      lawVersion: () => 0,
      realMsUntil: (steadyNs: number) => Math.max(0, steadyNs / 1e6 - performance.now()),
    };
    const waits = new PortWaits(clock as never);
    const link = {
      kind: 'port',
      clock,
      wakeToken: () => waits.token,
      wake: () => waits.wake(),
      stopRequested: () => waits.stops > 0,
      wait: (token: number, ms: number) => waits.wait(token, ms),
      sleep: (ms: number) => waits.sleep(ms),
    };
    const host = {
      link,
      arguments: ['script'],
      environment: {},
      line: (_: string, text: string) => lines.push(text),
      idle: () => undefined,
      files: { prefix: '/opt/ros/jazzy', place: '', files: [] },
      readNow: () => undefined,
      random: undefined,
      sent: undefined,
      stepped: false,
      input: {},
    } as unknown as ProgramHost;
    const module = await WebAssembly.compile(readFileSync(`${pyodide}pyodide.asm.wasm`));
    const start = {
      base: `${folder}/`,
      home: '',
      archives: ['all.zip'],
      entry: 'lib/test/script',
      image: undefined,
      sources: undefined,
      parts: { found: new Map(), listed },
    };
    const end = await runPython(module, start, host, {
      pyodide: async () => (options) => loadPyodide({ ...options, indexURL: pyodide }),
      bytes: async (place) => Uint8Array.from(readFileSync(place)),
    }, { broken: () => assert.fail('there is no image'), read: () => undefined });
    waits.close();
    return { end, lines };
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('a thread that Python cannot go on from ends the program, with the reason', watchdog, async () => {
  const { end, lines } = await runScript(`
import ctypes
import threading
import time


def fall():
    time.sleep(0.01)
    print('falls')
    ctypes.string_at(0xFFFFFFF0, 8)


thread = threading.Thread(target=fall)
thread.start()
thread.join()
print('nobody goes on')
`);
  assert.deepEqual(lines.slice(0, 1), ['falls']);
  assert.ok(!lines.includes('nobody goes on'));
  assert.equal(end.kind, 'crash');
  assert.match((end as { message: string; }).message, /out of bounds/);
});

test('an archive that the worker has to fetch itself is the one that was packed, or is not run', watchdog, async () => {
  const { end, lines } = await runScript("print('runs')", [{ path: 'all.zip', size: 1, sha256: '0'.repeat(64), reason: '' }]);
  assert.deepEqual(lines, []);
  assert.equal((end as { code: unknown; }).code, 'R2W0724');
});

// Compatibility, differs: `time.tzname`, and `%Z` of local times -> the distance of the zone, as `('+01', '+02')`; browsers know no letters of zones, Debian's `tzdata` does (`zoneinfo`)
test("a zone's name is as the time zone database has it for those without letters", watchdog, async () => {
  const before = process.env['TZ'];
  try {
    for (
      const [zone, told] of [['UTC', "('UTC', 'UTC') 0 0"], ['America/Sao_Paulo', "('-03', '-03') 10800 0"], ['Europe/Berlin', "('+01', '+02') -3600 1"], [
        'Asia/Kolkata',
        "('+0530', '+0530') -19800 0",
      ]] as const
    ) {
      process.env['TZ'] = zone;
      const { lines } = await runScript('import time\nprint(time.tzname, time.timezone, time.daylight)');
      assert.deepEqual(lines, [told]);
    }
  } finally {
    if (before === undefined) delete process.env['TZ'];
    else process.env['TZ'] = before;
  }
});
