// The port link beside what its scenes show: long waits, what is kept, places that come again.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import { PortBroker } from '../../../runtime/wasm_js/broker.ts';
import { PortLink } from '../../../runtime/wasm_js/port_link.ts';
import { PortWaits } from '../../../runtime/wasm_js/port_waits.ts';

const watchdog = { timeout: 240_000 };
const thirtyDaysMs = 30 * 86_400_000;

function join(broker: PortBroker): { link: PortLink; participant: number } {
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
  const waits = new PortWaits();
  for (let round = 0; round < 20; round += 1) {
    await waits.sleep(1);
    assert.equal(await waits.wait(waits.token, 1), WaitResult.timeout);
  }
  const { waiters, sleepers } = waits as unknown as Record<'waiters' | 'sleepers', Set<unknown>>;
  assert.equal(waiters.size + sleepers.size, 0);
  waits.close();
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
