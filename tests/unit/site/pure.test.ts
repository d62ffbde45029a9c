// The parts of the runtime that need no worker.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EndpointKind, ErrorCode, PolicyKind } from '../../../runtime/protocol/generated/constants.ts';
import { Bus, createBus } from '../../../runtime/site/bus/bus.ts';
import { putNanoseconds, SiteClock } from '../../../runtime/site/bus/clock.ts';
import { mostConsoleLines, NodeConsole } from '../../../runtime/site/program/console_log.ts';
import { ConsoleSender, LocalCredit, type SentLine } from '../../../runtime/site/bus/console_sender.ts';
import { type EndpointRecord, Graph, hiddenNamespace, relate } from '../../../runtime/site/bus/graph.ts';
import { encodeGraph } from '../../../runtime/site/bus/graph_snapshot.ts';
import { LineWriter } from '../../../runtime/site/program/line_writer.ts';
import type { Link } from '../../../runtime/site/bus/link.ts';
import { defaultQos, incompatiblePolicy } from '../../../runtime/site/contract/qos.ts';
import type { ConsoleLine } from '../../../runtime/site/contract/session.ts';
import { packRing, ringGeneration, ringLog2, ringPage } from '../../../runtime/site/bus/shared_ring.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';

function record(over: Partial<EndpointRecord>): EndpointRecord {
  return {
    key: 1,
    participant: 1,
    nodeKey: 1,
    kind: EndpointKind.publisher,
    name: '/a',
    type: 'p/msg/T',
    hash: '',
    qos: defaultQos,
    flags: 0,
    gid: new Int32Array(4),
    ...over,
  };
}

test('QoS: every policy is compared as ROS 2 does', () => {
  const best = { ...defaultQos, reliability: 2 };
  const transient = { ...defaultQos, durability: 1 };
  assert.equal(incompatiblePolicy(defaultQos, defaultQos), PolicyKind.none);
  assert.equal(incompatiblePolicy(best, defaultQos), PolicyKind.reliability);
  assert.equal(incompatiblePolicy(defaultQos, best), PolicyKind.none);
  assert.equal(incompatiblePolicy(defaultQos, transient), PolicyKind.durability);
  assert.equal(incompatiblePolicy(transient, defaultQos), PolicyKind.none);
  assert.equal(incompatiblePolicy({ ...defaultQos, deadline: 5n }, { ...defaultQos, deadline: 5n }), PolicyKind.none);
  assert.equal(incompatiblePolicy({ ...defaultQos, deadline: 6n }, { ...defaultQos, deadline: 5n }), PolicyKind.deadline);
  assert.equal(incompatiblePolicy({ ...defaultQos, deadline: 6n }, defaultQos), PolicyKind.none);
  assert.equal(incompatiblePolicy(defaultQos, { ...defaultQos, liveliness: 3 }), PolicyKind.liveliness);
  assert.equal(incompatiblePolicy(defaultQos, { ...defaultQos, lease: 1n }), PolicyKind.livelinessLease);
  assert.equal(incompatiblePolicy({ ...defaultQos, depth: 1, history: 2 }, { ...defaultQos, depth: 9 }), PolicyKind.none);
});

test('endpoints relate by kind, name, type, hash and locality', () => {
  const pub = record({});
  const sub = record({ key: 2, participant: 2, kind: EndpointKind.subscription });
  assert.equal(relate(pub, sub).kind, 'match');
  assert.equal(relate(sub, pub).kind, 'match');
  assert.equal(relate(pub, record({ ...sub, name: '/b' })).kind, 'none');
  assert.equal(relate(pub, record({ ...sub, type: 'p/msg/U' })).kind, 'wrong_type');
  assert.equal(relate(record({ hash: 'x' }), record({ ...sub, hash: 'y' })).kind, 'wrong_type');
  assert.equal(relate(record({ hash: 'x' }), sub).kind, 'match');
  assert.equal(relate(pub, record({ kind: EndpointKind.server })).kind, 'none');
  assert.equal(relate(pub, record({ ...sub, participant: 1, flags: 1 })).kind, 'none');
  assert.equal(relate(pub, record({ ...sub, flags: 1 })).kind, 'match');
});

test('a graph snapshot has the form of the specification', () => {
  const graph = new Graph();
  graph.nodes.set(7, { key: 7, participant: 3, namespace: '/', name: 'né' });
  graph.nodes.set(8, { key: 8, participant: 3, namespace: hiddenNamespace, name: 'stdin' });
  graph.add(record({ key: 9, nodeKey: 7, gid: new Int32Array([1, 2, 3, 4]), qos: { ...defaultQos, lifespan: 5n } }));
  graph.add(record({ key: 10, nodeKey: 8 }));
  const bytes = encodeGraph(graph.snapshot());
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  assert.deepEqual([view.getUint32(0, true), view.getUint32(4, true), view.getUint32(8, true)], [1, 3, 1]);
  assert.equal(new TextDecoder().decode(bytes.subarray(17, 20)), 'né');
  assert.equal(view.getUint32(20, true), 1);
  assert.equal(bytes.length, 20 + 4 + 8 + (4 + 2) + (4 + 7) + 4 + 5 * 4 + 3 * 8 + 16);
  assert.deepEqual([...bytes.subarray(-16)], [1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0, 4, 0, 0, 0]);
});

test('lines are cut where they end, whatever pieces they come in', () => {
  const lines: string[] = [];
  const writer = new LineWriter((line) => lines.push(line));
  const bytes = new TextEncoder().encode('one\ntwö\r\n\nlast');
  for (const byte of bytes) writer.write(new Uint8Array([byte]));
  assert.deepEqual(lines, ['one', 'twö', '']);
  writer.flush();
  writer.flush();
  assert.deepEqual(lines, ['one', 'twö', '', 'last']);
  writer.write(new Uint8Array(100_000).fill(65));
  assert.equal(lines.at(-1)?.length, 100_000);
});

test('a console sender goes ahead of the page by a few batches, then keeps the newest', () => {
  const batches: (readonly SentLine[])[] = [];
  let dropped = 0;
  const credit = new LocalCredit();
  const link = { clock: new SiteClock(), consoleCredit: credit } as Partial<Link> as Link;
  const sender = new ConsoleSender(link, (lines, lost) => {
    batches.push(lines);
    dropped += lost;
  });
  for (let i = 0; i < 12_000; i += 1) sender.line('stdout', `${i}`);
  assert.equal(batches.length, 8);
  credit.seen();
  sender.line('stderr', 'more');
  assert.equal(batches.length, 9);
  assert.equal(batches[8]?.length, 10_000);
  assert.equal(dropped, 12_001 - 8 - 10_000);
  assert.equal(batches[8]?.at(-1)?.[2], 'more');
});

test('a console finds the level of ROS 2 log lines, coloured ones too', () => {
  const tasks: (() => void)[] = [];
  const log = new NodeConsole((task) => tasks.push(task));
  const told: ConsoleLine[] = [];
  const off = log.onLines((lines) => told.push(...lines));
  log.add([[2, 1, '[INFO] [1.2] [a]: x'], [2, 1, '\u001b[33m[WARN] [1.2] [a]: y\u001b[0m'], [1, 1, 'plain [ERROR] [']], 0);
  assert.deepEqual(log.lines().map(({ level }) => level), ['INFO', 'WARN', undefined]);
  assert.equal(told.length, 0);
  for (const task of tasks) task();
  assert.equal(told.length, 3);
  off();
  log.add([[1, 1, 'after']], 0);
  assert.equal(told.length, 3);
});

test('a console keeps its newest hundred thousand lines, and says how many fell off', () => {
  const console = new NodeConsole((task) => task());
  const batch = 500;
  for (let from = 0; from < 240_000; from += batch) {
    console.add(Array.from({ length: batch }, (_, i) => [1, 1000, `line ${from + i}`] as const), 0);
  }
  const lines = console.lines();
  assert.equal(lines.length, mostConsoleLines);
  assert.ok(mostConsoleLines >= 100_000);
  assert.equal(lines[0]?.text, `line ${240_000 - mostConsoleLines}`);
  assert.equal(lines.at(-1)?.text, 'line 239999');
  assert.equal(console.dropped(), 240_000 - mostConsoleLines);
});

test('pages: runs are found, freed, merged; the ceiling is an error', () => {
  const bus = createBus({ ceiling: 16 << 20, endpoints: 64, nodes: 16, participants: 8 });
  const first = bus.allocate(3, 11);
  const second = bus.allocate(2, 12);
  assert.ok(first >= 0 && second >= 0 && first !== second);
  bus.free(first, 3);
  assert.equal(bus.usage().used, 2);
  const all: number[] = [];
  for (let page = bus.allocate(100, 13); page >= 0; page = bus.allocate(100, 13)) all.push(page);
  assert.equal(bus.allocate(100, 13), ErrorCode.outOfMemory);
  assert.equal(bus.usage().used, 2 + 100 * all.length);
  assert.ok(bus.allocate(1, 14) >= 0);
  bus.freeAll(13);
  assert.equal(bus.usage().used, 3);
  assert.ok(bus.allocate(200, 15) >= 0);
  assert.throws(() => createBus({ ceiling: 1 << 20 }), RangeError);
});

test('a bus of another version is refused', () => {
  assert.throws(() => new Bus(new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true })), RangeError);
});

test('ring words keep their three parts', () => {
  const ring = packRing(0xfffff, 15, 200);
  assert.deepEqual([ringPage(ring), ringLog2(ring), ringGeneration(ring)], [0xfffff, 15, 200 & 127]);
});

test('times fill two words', () => {
  const words = new Int32Array(2);
  putNanoseconds(words, 0, 2 ** 32 + 5);
  assert.deepEqual([...words], [5, 1]);
  putNanoseconds(words, 0, 2 ** 31);
  assert.deepEqual([...words], [-(2 ** 31), 0]);
  const from = Date.now();
  const clock = new SiteClock();
  const system = clock.systemNs() / 1e6;
  assert.ok(system > from - 1000 && system < Date.now() + 1000);
});

const node = { id: 'a-1', package: 'p', executable: 'a', program: 'programs/p/a.wasm' };
const site = { schema: 1, protocol: 1, name: 'n', nodes: [node] };

test('site.json: what may be omitted has a value', () => {
  const read = readSite(site);
  assert.deepEqual(read.nodes[0], {
    id: 'a-1',
    package: 'p',
    executable: 'a',
    label: 'a-1',
    kind: 'cpp',
    program: 'programs/p/a.wasm',
    threads: false,
    arguments: [],
    environment: {},
    output: 'screen',
    respawn: false,
    respawnDelay: 0,
    startAfter: 0,
    shutdownOnExit: false,
  });
});

test('site.json: a Python node', () => {
  const python = { archives: ['python/a.zip'], entry: 'm.n:main' };
  const [read] = readSite({ ...site, nodes: [{ ...node, kind: 'python', python }] }).nodes;
  assert.deepEqual(read?.kind === 'python' ? read.python : undefined, python);
});

test('site.json: a command of ros2, which has no program', () => {
  const command = { id: 'ros2-1', package: '', executable: 'ros2', label: 'ros2 topic list', kind: 'command', arguments: ['topic', 'list'] };
  assert.deepEqual(readSite({ ...site, nodes: [command] }).nodes[0], {
    ...command,
    environment: {},
    output: 'screen',
    respawn: false,
    respawnDelay: 0,
    startAfter: 0,
    shutdownOnExit: false,
  });
});

const broken: readonly [string, unknown, RegExp][] = [
  ['no object', [], /not an object/],
  ['another schema', { ...site, schema: 2 }, /schema 2/],
  ['a node without id', { ...site, nodes: [{ ...node, id: 7 }] }, /nodes\[0\]\.id/],
  ['two nodes of one id', { ...site, nodes: [node, node] }, /same id/],
  ['a program elsewhere', { ...site, nodes: [{ ...node, program: 'https://x/y.wasm' }] }, /inside the site/],
  ['a program above', { ...site, nodes: [{ ...node, program: '../y.wasm' }] }, /inside the site/],
  ['an absolute program', { ...site, nodes: [{ ...node, program: '/y.wasm' }] }, /inside the site/],
  ['another kind', { ...site, nodes: [{ ...node, kind: 'cobol' }] }, /cobol/],
  ['a Python node that is not described', { ...site, nodes: [{ ...node, kind: 'python' }] }, /nodes\[0\]\.python/],
  ['an archive elsewhere', { ...site, nodes: [{ ...node, kind: 'python', python: { archives: ['../a.zip'], entry: 'm:f' } }] }, /inside the site/],
  ['a script elsewhere', { ...site, nodes: [{ ...node, kind: 'python', python: { archives: [], entry: '/etc/x' } }] }, /inside the site/],
];

for (const [what, value, message] of broken) {
  test(`site.json with ${what} is refused`, () => {
    assert.throws(() => readSite(value), (error: Error & { code?: string; }) => error.code === 'R2W0700' && message.test(error.message));
  });
}

test('site.json of another protocol is refused with its own code', () => {
  assert.throws(() => readSite({ ...site, protocol: 2 }), { code: 'R2W0709' });
});
