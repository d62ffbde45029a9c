// The desk that panel and terminal share: what goes on when nobody sees it any more. Over a real graph on which the page is
// alone.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BagDesk } from '../../../runtime/ui/parts/bag_desk.ts';
import { FakeSession, stringBytes } from '../ui/fake_session.ts';
import { until } from './bag_parts.ts';

const watchdog = { timeout: 30_000 };

function publishes(session: FakeSession, topic: string): boolean {
  return session.graph().nodes.some(({ publishers }) => publishers.some(({ name }) => name === topic));
}

test('a desk that is left publishes nothing, and its bags stay', watchdog, async () => {
  const session = new FakeSession({ nodes: [] });
  const desk = new BagDesk(session);
  const chatter = session.node().publisher('/chatter', 'std_msgs/msg/String', { durability: 'transient_local', depth: 1 });
  chatter.publish(stringBytes('hello'));
  await desk.record(() => true);
  await until(() => desk.recorder?.messages === 1);
  const bag = (await desk.stopRecording())!;
  chatter.close();
  const player = (await desk.load(bag))!;
  player.set({ clockHz: 100, loop: true });
  player.play();
  await until(() => publishes(session, '/chatter') && publishes(session, '/clock'));
  desk.leave();
  await until(() => !publishes(session, '/chatter') && !publishes(session, '/clock'));
  assert.equal(desk.player, undefined);
  assert.deepEqual(desk.shelf, [bag]);
  assert.notEqual(await desk.load(bag), player);
  session.close();
});

test('a recording that begins while the desk is left ends', watchdog, async () => {
  const session = new FakeSession({ nodes: [] });
  const desk = new BagDesk(session);
  const begun = desk.record(() => true);
  desk.leave();
  await begun;
  assert.equal(desk.recorder, undefined);
  assert.equal(desk.shelf.length, 1);
  session.close();
});
