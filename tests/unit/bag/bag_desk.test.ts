// The desk that panel and terminal share: what goes on when nobody sees it any more. Over a real graph on which the page is
// alone.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { BagDesk } from '../../../runtime/site/ui/parts/bag_desk.ts';
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

test('bags that nodes wrote lie on the shelf, also those from before somebody looked', watchdog, async () => {
  const session = new FakeSession({ nodes: [] });
  const write = (path: string): void => session.written.add({ node: 'recorder-1', path, content: new Blob(['x']) });
  write('/home/user/my_bag/my_bag_0.mcap');
  write('/home/user/my_bag/metadata.yaml');
  const desk = new BagDesk(session);
  let changes = 0;
  desk.onChange(() => {
    changes += 1;
  });
  write('/tmp/other/my_bag_0.mcap');
  assert.equal(changes, 1);
  assert.deepEqual(desk.shelf.map(({ name, origin }) => `${name} ${origin}`), ['my_bag_0.mcap written', 'my_bag_0_2.mcap written']);
  write('/home/user/log.csv');
  write('/home/user/log.csv');
  assert.deepEqual([changes, desk.files.map(({ path }) => path)], [3, ['/home/user/log.csv']]);
  for (const name of ['my_bag', 'my_bag/', 'my_bag_0', 'my_bag_0.mcap']) assert.equal((await desk.place.open(name))?.name, 'my_bag_0.mcap', name);
  assert.equal(await desk.place.open('your_bag'), undefined);
  session.close();
});
