// The port link beside what its scenes show: long waits, what is kept, places that come again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EndpointKind, flagHidden, History, keepAllLimit, Reliability, WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import { PortBroker } from '../../../runtime/site/bus/broker.ts';
import { SiteClock } from '../../../runtime/site/bus/clock.ts';
import { PortLink } from '../../../runtime/site/bus/port_link.ts';
import { readPeer } from '../../../runtime/site/bus/peer_reader.ts';
import { windowFrames } from '../../../runtime/site/bus/port_writer.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/site/contract/qos.ts';
import { PortWaits } from '../../../runtime/site/bus/port_waits.ts';
import { eventually } from '../../support/eventually.ts';

const watchdog = { timeout: 240_000 };
const thirtyDaysMs = 30 * 86_400_000;

function join(broker: PortBroker): { link: PortLink; participant: number; } {
  const admission = broker.admit();
  assert.ok(admission?.ticket.kind === 'port');
  return { link: new PortLink(admission.ticket), participant: admission.participant };
}

test('a wait or sleep longer than a timer can be lasts until it is ended', watchdog, async (context) => {
  const timers = context.mock.method(globalThis, 'setTimeout');
  const broker = new PortBroker();
  const { link } = join(broker);
  const ended: string[] = [];
  const wait = link.wait(link.wakeToken(), thirtyDaysMs).then((result) => ended.push(`wait ${result}`));
  const sleep = link.sleep(thirtyDaysMs).then((result) => ended.push(`sleep ${result}`));
  // A timer set for more than 2^31 - 1 ms would fire after one.
  assert.deepEqual(timers.mock.calls.map((call) => call.arguments[1]), [2 ** 31 - 1, 2 ** 31 - 1]);
  assert.deepEqual(ended, []);
  link.wake();
  await wait;
  assert.deepEqual(ended, [`wait ${WaitResult.woken}`]);
  broker.stop(1);
  await sleep;
  assert.equal(ended[1], `sleep ${WaitResult.stop}`);
  link.close();
  broker.close();
});

test('waits and sleeps that are over leave nothing behind', watchdog, async () => {
  const waits = new PortWaits(new SiteClock());
  for (let round = 0; round < 20; round += 1) {
    await waits.sleep(1);
    assert.equal(await waits.wait(waits.token, 1), WaitResult.timeout);
  }
  const { waiters, sleepers, timed } = waits as unknown as Record<'waiters' | 'sleepers' | 'timed', Set<unknown>>;
  assert.equal(waiters.size + sleepers.size + timed.size, 0);
  waits.close();
});

test('a best_effort keep_all reader that takes nothing blocks no writer, and may miss what is beyond the limit', watchdog, async () => {
  const broker = new PortBroker();
  const [a, b] = [join(broker).link, join(broker).link];
  const make = (link: PortLink, kind: number, qos: Partial<EndpointQos>): number =>
    link.endpointCreate({
      kind,
      node: link.nodeCreate('n', '/'),
      name: '/x',
      type: 't',
      hash: '',
      flags: 0,
      qos: { ...defaultQos, history: History.keepAll, ...qos },
    });
  const buffer = new ArrayBuffer(256);
  const heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  const pub = make(a, EndpointKind.publisher, {});
  const sub = make(b, EndpointKind.subscription, { reliability: Reliability.bestEffort });
  while (a.matched(pub) === 0) await a.wait(a.wakeToken(), 1000);
  while (b.matched(sub) === 0) await b.wait(b.wakeToken(), 1000);
  const most = 3 * keepAllLimit;
  for (let i = 1; i <= most; i += 1) {
    heap.i32.fill(0, 0, 16);
    assert.equal(a.write(pub, heap, 64, 8, 0), 0, `write ${i}`);
  }
  const taken: number[] = [];
  while (taken.at(-1) !== most) {
    if (b.take(sub, heap, 64, 100, 0) >= 0) taken.push(heap.i32[2]!);
    else await b.wait(b.wakeToken(), 1000);
  }
  const kept = Array.from({ length: keepAllLimit }, (_, i) => most - keepAllLimit + 1 + i);
  assert.deepEqual(taken.slice(windowFrames), kept);
  for (const link of [a, b]) link.close();
  broker.close();
});

test('the page says on the control port which batches of lines it has dealt with', watchdog, async () => {
  const broker = new PortBroker();
  const { link, participant } = join(broker);
  const credit = link.consoleCredit;
  for (let batch = 0; batch < 3; batch += 1) credit.posted();
  broker.consoleSeen(participant);
  broker.consoleSeen(participant);
  while (credit.ahead() > 1) await link.wait(link.wakeToken(), 0);
  assert.equal(credit.ahead(), 1);
  link.close();
  broker.close();
});

test('a node may start more often than there are places', watchdog, () => {
  const broker = new PortBroker();
  const seen = new Set<number>();
  let again = 0;
  for (let start = 0; start < 5000; start += 1) {
    const admission = broker.admit();
    assert.ok(admission !== undefined, `start ${start}`);
    if (seen.has(admission.participant)) again += 1;
    seen.add(admission.participant);
    broker.end(admission.participant, true);
  }
  assert.ok(seen.size > 2000 && again > 0, 'numbers rest as long as may be');
  broker.close();
});

test('who comes under the number of another inherits nothing of it', watchdog, async () => {
  const broker = new PortBroker();
  const watcher = join(broker).link;
  const first = join(broker);
  first.link.nodeCreate('first', '/');
  while (watcher.graph().nodes.length === 0) await watcher.wait(watcher.wakeToken(), 1000);
  // Its goodbye is on the way when the number comes again.
  first.link.close();
  broker.end(first.participant, true);
  let next = join(broker);
  while (next.participant !== first.participant) {
    next.link.close();
    broker.end(next.participant, true);
    next = join(broker);
  }
  next.link.nodeCreate('next', '/');
  const names = (): string[] => watcher.graph().nodes.map((node) => node.name);
  while (!names().includes('next')) await watcher.wait(watcher.wakeToken(), 1000);
  for (let turn = 0; turn < 20; turn += 1) await watcher.wait(watcher.wakeToken(), 0);
  assert.deepEqual(names(), ['next']);
  for (const link of [next.link, watcher]) link.close();
  broker.close();
});

test('the page hears of a program that publishes and ends before it ever waits, whatever the type', watchdog, async () => {
  const broker = new PortBroker();
  const page = broker.link;
  const buffer = new ArrayBuffer(256);
  const heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  const qos = { ...defaultQos, reliability: Reliability.bestEffort, depth: 100 };
  const sub = page.endpointCreate({
    kind: EndpointKind.subscription,
    node: page.nodeCreate('page', '/_ros2wasm'),
    name: '/x',
    type: '',
    hash: '',
    flags: flagHidden,
    qos,
  });
  const { link } = join(broker);
  // Nothing arrives at the program from here on: it never lets the event loop run.
  const pub = link.endpointCreate({
    kind: EndpointKind.publisher,
    node: link.nodeCreate('n', '/'),
    name: '/x',
    type: 'some/msg/Type',
    hash: '',
    flags: 0,
    qos: defaultQos,
  });
  for (let i = 1; i <= 3; i += 1) {
    heap.i32.fill(0, 0, 16);
    heap.u8[64] = i;
    assert.equal(link.write(pub, heap, 64, 8, 0), 0);
  }
  link.close();
  const taken: number[] = [];
  while (taken.length < 3) {
    const token = page.wakeToken();
    while (page.take(sub, heap, 64, 128, 0) > 0) taken.push(heap.u8[64]!);
    if (taken.length < 3) await page.wait(token, -1);
  }
  assert.deepEqual(taken, [1, 2, 3]);
  broker.close();
});

const record = {
  key: (1 << 20) | 2,
  participant: 1,
  nodeKey: (1 << 20) | 1,
  kind: EndpointKind.publisher,
  name: '/x',
  type: 't',
  hash: '',
  qos: defaultQos,
  flags: 0,
  gid: new Int32Array(4),
};
const node = { key: (1 << 20) | 1, participant: 1, namespace: '/', name: 'n' };

/** A frame whose header names that writer. */
function frameOf(writer: number, bytes = 64): ArrayBuffer {
  const frame = new ArrayBuffer(bytes);
  if (bytes >= 60) new Int32Array(frame, 0, 15)[14] = writer;
  return frame;
}

test('what comes through a port is read: only what its sender may say', () => {
  const good: readonly unknown[] = [
    { t: 'node+', node },
    { t: 'node-', key: node.key },
    { t: 'ep+', record },
    { t: 'ep-', key: record.key },
    { t: 'ep-', key: record.key, last: { key: record.key, count: 1, bytes: 2, time: 0.5, payload: undefined } },
    { t: 'match', mine: record.key, yours: 5, after: 0 },
    { t: 'late', reader: 5, frames: [frameOf(record.key)] },
    { t: 'ack', writer: 5, sequence: -1 },
    { t: 'alive', writer: record.key },
    { t: 'sample', topics: ['/x'] },
    { t: 'samples', writers: [{ key: record.key, count: 1, bytes: 2, time: 3, payload: new Uint8Array(1) }] },
    { t: 'bye' },
    frameOf(record.key),
    frameOf(record.key, 100),
  ];
  for (const [i, message] of good.entries()) assert.equal(readPeer(1, message), message, `number ${i}`);
  const other = (2 << 20) | 2;
  const bad: readonly unknown[] = [
    undefined,
    null,
    3,
    'bye',
    [],
    {},
    { t: 'constructor' },
    { t: 'gone', participant: 2 },
    new Uint8Array(64),
    frameOf(record.key, 8),
    frameOf(other),
    { t: 'node+' },
    { t: 'node+', node: { ...node, key: other } },
    { t: 'node+', node: { ...node, name: '' } },
    { t: 'node+', node: { ...node, participant: 2 } },
    { t: 'node-', key: other },
    { t: 'node-', key: 'x' },
    { t: 'ep+', record: null },
    { t: 'ep+', record: { ...record, key: other } },
    { t: 'ep+', record: { ...record, qos: undefined } },
    { t: 'ep+', record: { ...record, qos: { ...defaultQos, lifespan: 5 } } },
    { t: 'ep+', record: { ...record, gid: [1, 2, 3, 4] } },
    { t: 'ep+', record: { ...record, kind: 9 } },
    { t: 'ep+', record: { ...record, name: {} } },
    { t: 'ep-', key: other },
    { t: 'ep-', key: record.key, last: { key: other } },
    { t: 'match', mine: other, yours: 5, after: 0 },
    { t: 'match', mine: record.key, yours: NaN, after: 0 },
    { t: 'late', reader: 5, frames: [frameOf(other)] },
    { t: 'late', reader: 5 },
    { t: 'ack', writer: {}, sequence: 1 },
    { t: 'alive', writer: other },
    { t: 'sample' },
    { t: 'samples', writers: [{ key: other }] },
  ];
  for (const [i, message] of bad.entries()) assert.equal(readPeer(1, message), undefined, `number ${i}`);
});

// Guarantee, hostile input: a program that sends junk through the ports to the page and to other programs is not heard any more, and the page ends it (R2W0727); the others go on
test('who sends junk to its peers is dropped by each, and the page is told who it was', watchdog, async () => {
  const broker = new PortBroker();
  const strangers: number[] = [];
  broker.onStrange((participant) => strangers.push(participant));
  const admission = broker.admit();
  assert.ok(admission?.ticket.kind === 'port');
  const a = join(broker);
  const b = join(broker);
  const make = (link: PortLink, kind: number): number =>
    link.endpointCreate({
      kind,
      node: link.nodeCreate('n', '/'),
      name: '/x',
      type: 't',
      hash: '',
      flags: 0,
      qos: defaultQos,
    });
  const [writer, reader] = [make(a.link, EndpointKind.publisher), make(b.link, EndpointKind.subscription)];
  await eventually('they match', async () => a.link.matched(writer) === 1 && b.link.matched(reader) === 1);
  // It plays by no rules: its ports are used as they are. Those to who came later come through its control port.
  const ports = admission.ticket.peers.map(({ port }) => port);
  admission.ticket.control.addEventListener('message', (event) => {
    const { t, peer } = (event as MessageEvent<{ readonly t: string; readonly peer?: { readonly port: MessagePort; }; }>).data;
    if (t === 'peer' && peer !== undefined) ports.push(peer.port);
  });
  admission.ticket.control.start();
  await eventually('it has a port to each', async () => ports.length === 3);
  for (const port of ports) port.postMessage(null);
  await eventually('the page knows who it was', async () => strangers.length > 0);
  assert.deepEqual(strangers, [admission.participant]);
  const buffer = new ArrayBuffer(256);
  const heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
  assert.equal(await a.link.write(writer, heap, 128, 4, 0), 0);
  await eventually('the others go on', async () => b.link.ready().includes(reader));
  a.link.close();
  b.link.close();
  broker.close();
});
