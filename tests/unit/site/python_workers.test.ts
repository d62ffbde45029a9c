// Workers of Python programs: what they load ahead, and the one that waits for the next start.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { WorkerOrder, WorkerReport } from '../../../runtime/site/workers/worker_messages.ts';
import type { Platform, WorkerEvents } from '../../../runtime/site/workers/platform.ts';
import { PythonFiles } from '../../../runtime/site/python/python_files.ts';
import { PythonWorkers } from '../../../runtime/site/workers/python_workers.ts';
import type { SiteDescription } from '../../../runtime/site/contract/session.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';

const program = 'pyodide/pyodide.asm.wasm';
const files = ['python_worker.js', 'pyodide/pyodide.js', 'pyodide/pyodide.asm.js', 'pyodide/python_stdlib.zip'];
const watchdog = { timeout: 20_000 };

interface Begun {
  readonly name: string;
  readonly events: WorkerEvents;
  readonly orders: WorkerOrder[];
  ended: boolean;
}

/** In a browser, as something is kept. `wrong`: a file that is not the one that was packed. */
function place(wrong?: string): { readonly workers: PythonWorkers; readonly begun: Begun[]; readonly asked: string[]; } {
  const begun: Begun[] = [];
  const asked: string[] = [];
  const platform = {
    place: 'https://host/site/',
    kept: {},
    bytes: async (path: string) => {
      asked.push(path);
      if (path === wrong) throw new SiteError('R2W0724', path);
      return new ArrayBuffer(1);
    },
    startWorker: (name: string, events: WorkerEvents) => {
      const one: Begun = { name, events, orders: [], ended: false };
      begun.push(one);
      return {
        post: (order: WorkerOrder) => void one.orders.push(order),
        terminate: async () => {
          one.ended = true;
        },
      };
    },
  } as unknown as Platform;
  const site = { files: files.map((path) => ({ path, size: 1, sha256: '1', reason: '' })) } as unknown as SiteDescription;
  return { workers: new PythonWorkers(platform, new PythonFiles(site, platform)), begun, asked };
}

async function holds(condition: () => boolean): Promise<void> {
  while (!condition()) await new Promise((resolve) => setTimeout(resolve, 10));
}

const nobody: WorkerEvents = { report: () => undefined, failed: () => undefined };

test('a worker loads the scripts once they are found to be those that were packed, and waits for nothing else', watchdog, async () => {
  const { workers, begun, asked } = place();
  workers.start(program, 'a', nobody);
  await holds(() => begun[0]?.orders.length === 1);
  assert.deepEqual(begun[0]?.orders, [{ t: 'python', base: 'https://host/site/', home: 'pyodide/' }]);
  assert.deepEqual(asked, files.slice(0, 3));
});

test('a script that is another one than was packed is not loaded', watchdog, async () => {
  const { workers, begun } = place('pyodide/pyodide.js');
  workers.start(program, 'a', nobody);
  await new Promise((resolve) => setTimeout(resolve, 50));
  assert.deepEqual(begun[0]?.orders, []);
});

test('the next start has the worker that waits, with all that it reports', watchdog, async () => {
  const { workers, begun } = place();
  workers.start(program, 'a', nobody);
  workers.settled(program);
  workers.settled(program);
  await holds(() => begun.length === 2 && begun[1]?.orders.length === 1);
  await new Promise((resolve) => setTimeout(resolve, 50));
  assert.equal(begun.length, 2, 'one waits');
  const told: (WorkerReport | string)[] = [];
  const handle = workers.start(program, 'b', { report: (report) => void told.push(report), failed: (message) => void told.push(message) });
  assert.equal(begun.length, 2);
  handle.post({ t: 'bridge' } as unknown as WorkerOrder, []);
  assert.equal(begun[1]?.orders.at(-1)?.t, 'bridge');
  begun[1]?.events.report({ t: 'running' });
  begun[1]?.events.failed('gone');
  assert.deepEqual(told, [{ t: 'running' }, 'gone']);
  workers.start(program, 'c', nobody);
  assert.deepEqual(begun.map(({ name }) => name), ['a', 'python', 'c'], 'it is nobody else’s any more');
});

test('one that broke while it waited is nobody’s, and one that waits at the end is ended', watchdog, async () => {
  const { workers, begun } = place();
  workers.settled(program);
  await holds(() => begun.length === 1);
  begun[0]?.events.failed('gone');
  workers.start(program, 'a', nobody);
  assert.equal(begun[1]?.name, 'a');
  workers.settled(program);
  await holds(() => begun.length === 3);
  workers.close();
  assert.ok(begun[2]?.ended);
  workers.settled(program);
  await new Promise((resolve) => setTimeout(resolve, 50));
  assert.equal(begun.length, 3);
});
