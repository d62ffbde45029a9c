// The messages of a worker that are accepted as reports: only the forms that programs use, nothing that is merely similar.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { TerminalMode } from '../../../runtime/protocol/generated/constants.ts';
import { tellThreads } from '../../../runtime/site/program/thread_waits.ts';
import { readReport } from '../../../runtime/site/workers/worker_reports.ts';

const memory = new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true });
const line = [1, 1_700_000_000_000, 'text'];
const request = { thread: 4, entry: 1, argument: 0, stackTop: 65536, stackSize: 1024 };
const rest = { untilNs: Infinity, token: undefined, stops: 0 };
const message = { name: '/chatter', sequence: '1', stamp: '2', bytes: 3, hash: 'ab' };

const right: readonly unknown[] = [
  { t: 'running' },
  { t: 'waits' },
  { t: 'broken_image' },
  { t: 'terminal', mode: TerminalMode.raw },
  { t: 'lines', lines: [line, [2, 0, '']], dropped: 0 },
  { t: 'lines', lines: [], dropped: 3 },
  { t: 'file', path: '/home/a', bytes: new Uint8Array(3), at: 1.5 },
  { t: 'event', event: '{}' },
  { t: 'thread', request, memory },
  { t: 'memory', memory: { memory, waits: 16 } },
  { t: 'rest', rest },
  { t: 'rest', rest: { untilNs: 5, token: -3, stops: 1 } },
  { t: 'sent', message },
  { t: 'image', image: undefined },
  { t: 'image', image: new Blob([]) },
  { t: 'launch', answer: { any: 1 } },
  { t: 'launch', failed: 'why' },
  { t: 'source', path: 'lib/x.py' },
  { t: 'end', end: { kind: 'exit', code: -2 }, closed: true },
  { t: 'end', end: { kind: 'thread' }, closed: false },
  { t: 'end', end: { kind: 'crash', code: 'R2W0701', message: 'm' }, closed: false },
];

const wrong: readonly unknown[] = [
  undefined,
  null,
  0,
  'running',
  [],
  {},
  ['running'],
  new Map([['t', 'running']]),
  { t: undefined },
  { t: 'constructor' },
  { t: '__proto__' },
  { t: 'toString' },
  { t: { toString: () => 'running' } },
  { t: 'other' },
  { t: 'terminal' },
  { t: 'terminal', mode: 7 },
  { t: 'lines' },
  { t: 'lines', lines: 'abc', dropped: 0 },
  { t: 'lines', lines: [null], dropped: 0 },
  { t: 'lines', lines: [line] },
  { t: 'lines', lines: [line], dropped: -1 },
  { t: 'lines', lines: [line], dropped: NaN },
  { t: 'lines', lines: [[3, 0, '']], dropped: 0 },
  { t: 'lines', lines: [[1, NaN, '']], dropped: 0 },
  { t: 'lines', lines: [[1, 1e300, '']], dropped: 0 },
  { t: 'lines', lines: [[1, 0, {}]], dropped: 0 },
  { t: 'lines', lines: [[1, 0, 'x'.repeat(2 << 20)]], dropped: 0 },
  { t: 'lines', lines: Array.from({ length: 10_001 }, () => line), dropped: 0 },
  { t: 'file' },
  { t: 'file', path: 3, bytes: new Uint8Array(), at: 0 },
  { t: 'file', path: 'a', bytes: 'b', at: 0 },
  { t: 'file', path: 'a', bytes: new Uint8Array(new SharedArrayBuffer(1)), at: 0 },
  { t: 'file', path: 'a', bytes: new Uint8Array(), at: NaN },
  { t: 'event' },
  { t: 'event', event: {} },
  { t: 'thread' },
  { t: 'thread', request, memory: {} },
  { t: 'thread', request: { ...request, entry: 'x' }, memory },
  { t: 'memory' },
  { t: 'memory', memory: { memory: new ArrayBuffer(1), waits: 0 } },
  { t: 'memory', memory: { memory, waits: -4 } },
  { t: 'rest' },
  { t: 'rest', rest: { ...rest, untilNs: NaN } },
  { t: 'rest', rest: { ...rest, token: 'x' } },
  { t: 'sent' },
  { t: 'sent', message: { ...message, bytes: -1 } },
  { t: 'sent', message: { ...message, name: 1 } },
  { t: 'image', image: 'bytes' },
  { t: 'launch', failed: 3 },
  { t: 'source' },
  { t: 'end' },
  { t: 'end', end: null, closed: true },
  { t: 'end', end: { kind: 'exit' }, closed: true },
  { t: 'end', end: { kind: 'exit', code: 0.5 }, closed: true },
  { t: 'end', end: { kind: 'exit', code: 0 } },
  { t: 'end', end: { kind: 'crash', code: '<img>', message: '' }, closed: false },
  { t: 'end', end: { kind: 'crash', code: 'R2W0701' }, closed: false },
];

test('what programs report is read as it is', () => {
  for (const report of right)
    assert.equal(readReport(report), report, JSON.stringify(report, (_key, value: unknown) => value instanceof WebAssembly.Memory ? 'memory' : value));
});

test('anything else is not a report', () => {
  for (const [i, data] of wrong.entries()) assert.equal(readReport(data), undefined, `number ${i}`);
});

test('a list of waits that leads in a circle or out of the memory ends', () => {
  const words = new Int32Array(memory.buffer);
  const at = 64;
  // The list's head, at 16, and one entry: address, version, next.
  words[4] = at;
  words.set([at, 1, at], at >> 2);
  assert.equal(tellThreads({ memory, waits: 16 }, 2), true);
  words.set([0x7ffffff0, 1, 0x7ffffff0], at >> 2);
  assert.equal(tellThreads({ memory, waits: 16 }, 2), true);
  assert.equal(tellThreads({ memory, waits: 0x7ffffff0 }, 2), true);
  // One that is right is told.
  words.set([128, 1, 0], at >> 2);
  assert.equal(tellThreads({ memory, waits: 16 }, 2), false);
  assert.equal(tellThreads({ memory, waits: 16 }, 1), true);
});
