// Calls at times of the site: in a stepped run they are part of its order, and nobody waits for real time.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SharedBroker, steppedBus } from '../../../runtime/site/bus/broker.ts';
import { PageParticipant } from '../../../runtime/site/page/page_participant.ts';
import { SteppedTime } from '../../../runtime/site/bus/stepped_time.ts';

test('in a stepped run timers of the page ring at their times, as far as time is let go', async () => {
  const broker = new SharedBroker(steppedBus(7));
  assert.ok(broker.conductor !== undefined);
  const time = new SteppedTime(broker, broker.conductor);
  const page = new PageParticipant(broker);
  const rung: number[] = [];
  const begin = time.view().now;
  const now = (): number => Math.round(time.view().now - begin);
  const timer = page.timer(1000, () => rung.push(now()));
  await Promise.resolve();
  assert.deepEqual(rung, []);
  time.step(3.5e9);
  assert.deepEqual(rung, [1000, 2000, 3000]);
  timer.close();
  time.step(5e9);
  assert.deepEqual(rung, [1000, 2000, 3000]);
  const late = page.client('/nowhere', 'demo/srv/Add').call(Uint8Array.of(0, 1, 0, 0), { timeoutMs: 60_000 });
  let code = '';
  void late.catch((error: { readonly code: string; }) => {
    code = error.code;
  });
  time.step(59e9);
  await Promise.resolve();
  assert.equal(code, '');
  time.step(2e9);
  await late.catch(() => undefined);
  assert.equal(code, 'R2W0716');
  page.close();
  time.close();
  broker.close();
});

test('a run in which the page made nothing has nothing of the page in its graph', () => {
  const broker = new SharedBroker(steppedBus(7));
  const page = new PageParticipant(broker);
  assert.deepEqual([...broker.link.graphReplica.nodes.values()], []);
  const publisher = page.publisher('/x', 'std_msgs/msg/Empty');
  assert.equal(publisher.problem, undefined);
  assert.equal(broker.link.graph().nodes.length, 1);
  page.close();
  assert.equal(broker.link.graph().nodes.length, 0);
  broker.close();
});
