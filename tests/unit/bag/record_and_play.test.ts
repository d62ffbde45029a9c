// A bag that the page recorded is read back by @mcap/core, its messages by @foxglove/rosmsg2-serialization; when it is played,
// its messages are received. Over a real graph on which the page is alone.

import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { McapIndexedReader } from '@mcap/core';
import { parse } from '@foxglove/rosmsg';
import { MessageReader } from '@foxglove/rosmsg2-serialization';
import { openBag, type Bag } from '../../../runtime/site/bag/bag_file.ts';
import { BagPlayer } from '../../../runtime/site/bag/player.ts';
import { Recorder, recordsAll, type RecordOptions } from '../../../runtime/site/bag/recorder.ts';
import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { PortLink } from '../../../runtime/site/bus/port_link.ts';
import { defaultQos } from '../../../runtime/site/contract/qos.ts';
import type { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { FakeSession, stringBytes } from '../ui/fake_session.ts';
import { MemorySink, sourceOf, until } from './bag_parts.ts';

const watchdog = { timeout: 30_000 };
const interfaces = new Map([
  ['std_msgs/msg/String', '# A text.\nstring data\n'],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['demo/msg/Reading', 'std_msgs/Header header\nfloat64[2] values # both\n'],
]);

function newSession(): FakeSession {
  return new FakeSession({ nodes: [], interfaces });
}

async function mcap(bytes: Uint8Array): Promise<McapIndexedReader> {
  return McapIndexedReader.Initialize({
    readable: {
      size: () => Promise.resolve(BigInt(bytes.length)),
      read: (offset, size) => Promise.resolve(bytes.subarray(Number(offset), Number(offset + size))),
    },
  });
}

async function all<T>(items: AsyncIterable<T>): Promise<T[]> {
  const found: T[] = [];
  for await (const item of items) found.push(item);
  return found;
}

async function record(session: FakeSession, options: Partial<RecordOptions> = {}): Promise<{ recorder: Recorder; sink: MemorySink; }> {
  const sink = new MemorySink();
  return { sink, recorder: await Recorder.begin(session, sink, { wants: recordsAll(false), ...options }) };
}

/** A bag with a latched topic, one of many messages, and one that came later. */
async function recorded(): Promise<{ bytes: Uint8Array; before: number; after: number; }> {
  const session = newSession();
  const before = session.time.view().now;
  const node = session.node();
  const map = node.publisher('/map', 'std_msgs/msg/String', { durability: 'transient_local', depth: 1 });
  map.publish(stringBytes('the map'));
  const chatter = node.publisher('/chatter', 'std_msgs/msg/String', { reliability: 'best_effort', depth: 500 });
  node.publisher('/robot/_secret', 'std_msgs/msg/String').publish(stringBytes('hidden'));
  const { recorder, sink } = await record(session);
  await until(() => recorder.messages === 1);
  for (let i = 0; i < 200; i += 1) chatter.publish(stringBytes(`Hello World: ${i}`));
  await until(() => recorder.messages === 201);
  const late = node.publisher('/late', 'std_msgs/msg/String');
  session.graphChanged();
  await until(() => late.matched() === 1);
  late.publish(stringBytes('late'));
  await until(() => recorder.messages === 202);
  await recorder.stop();
  const after = session.time.view().now;
  session.close();
  return { bytes: sink.bytes(), before, after };
}

// Compatibility, works: bags as MCAP of the profile `ros2`, with definitions, recorded QoS and the site's time, as
// @mcap/core and @foxglove/rosmsg2-serialization read them

test('a recording is read back by @mcap/core and decoded by @foxglove', watchdog, async () => {
  const { bytes, before, after } = await recorded();
  const reader = await mcap(bytes);
  assert.equal(reader.header.profile, 'ros2');
  assert.equal(reader.header.library, 'ros2wasm 0.1.0');
  const topics = new Map([...reader.channelsById.values()].map((channel) => [channel.topic, channel]));
  assert.deepEqual([...topics.keys()].sort(), ['/chatter', '/late', '/map']);
  assert.match(topics.get('/map')!.metadata.get('offered_qos_profiles')!,
    /^- history: keep_last\n {2}depth: 1\n {2}reliability: reliable\n {2}durability: transient_local\n {2}deadline:\n {4}sec: 9223372036\n {4}nsec: 854775807\n/);
  const schema = reader.schemasById.get(topics.get('/chatter')!.schemaId)!;
  assert.deepEqual([schema.name, schema.encoding], ['std_msgs/msg/String', 'ros2msg']);
  const decode = new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true }));
  const messages = await all(reader.readMessages({ topics: ['/chatter'] }));
  assert.deepEqual(messages.map(({ data }) => (decode.readMessage(data) as { data: string; }).data),
    Array.from({ length: 200 }, (_, i) => `Hello World: ${i}`));
  assert.deepEqual(messages.map(({ sequence }) => sequence), Array.from({ length: 200 }, (_, i) => i + 1));
  for (const { logTime, publishTime } of messages) {
    assert.ok(publishTime <= logTime && Number(publishTime) >= (before - 1) * 1e6 && Number(logTime) <= (after + 1) * 1e6);
  }
  assert.equal(reader.statistics?.messageCount, 202n);
  const [metadata] = await all(reader.readMetadata({ name: 'rosbag2' }));
  assert.equal(metadata?.metadata.get('ROS_DISTRO'), 'jazzy');
});

test('a schema has the types inside it as rosbag2 writes them', watchdog, async () => {
  const session = newSession();
  const publisher = session.node().publisher('/reading', 'demo/msg/Reading');
  session.node().publisher('/unknown', 'demo/msg/Unknown');
  const { recorder, sink } = await record(session);
  await until(() => publisher.matched() === 1);
  const value = new Uint8Array(36);
  value[1] = 1;
  new DataView(value.buffer).setInt32(4, 5, true);
  new DataView(value.buffer).setUint32(12, 1, true);
  new DataView(value.buffer).setFloat64(20, 1.5, true);
  publisher.publish(value);
  await until(() => recorder.messages === 1);
  await recorder.stop();
  session.close();
  const reader = await mcap(sink.bytes());
  const schemas = new Map([...reader.schemasById.values()].map((one) => [one.name, one]));
  const line = '='.repeat(80);
  const text = new TextDecoder().decode(schemas.get('demo/msg/Reading')!.data);
  assert.equal(text,
    `std_msgs/Header header\nfloat64[2] values # both\n${line}\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n${line}\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec`);
  const [message] = await all(reader.readMessages());
  const decoded = new MessageReader(parse(text, { ros2: true })).readMessage(message!.data) as { header: { stamp: { sec: number; }; }; values: Float64Array; };
  assert.equal(decoded.header.stamp.sec, 5);
  assert.deepEqual([...decoded.values], [1.5, 0]);
  // Nobody knows that one: it is recorded without a definition.
  assert.equal(reader.channelsById.size, 2);
});

test('a recording ends at its limit, and is whole until there', watchdog, async () => {
  const session = newSession();
  const publisher = session.node().publisher('/chatter', 'std_msgs/msg/String', { depth: 100 });
  let ended: SiteError | undefined;
  const { recorder, sink } = await record(session, {
    mostBytes: 100_000,
    onEnd: (problem) => {
      ended = problem;
    },
  });
  await until(() => publisher.matched() === 1);
  while (ended === undefined) {
    publisher.publish(stringBytes('x'.repeat(1000)));
    await new Promise((done) => setTimeout(done, 0));
  }
  await recorder.stop();
  session.close();
  assert.equal(ended.code, 'R2W0742');
  const reader = await mcap(sink.bytes());
  assert.equal(Number(reader.statistics?.messageCount), recorder.messages);
  assert.ok(recorder.messages > 50 && recorder.messages < 200);
});

interface Heard {
  readonly topic: string;
  readonly text: string;
}

function listen(session: FakeSession, topic: string, latched = false): Heard[] {
  const heard: Heard[] = [];
  session.node().subscription(topic, 'std_msgs/msg/String', { durability: latched ? 'transient_local' : 'volatile', reliability: 'best_effort', depth: 1000 },
    (bytes) => heard.push({ topic, text: new TextDecoder().decode(bytes.subarray(8, -1)) }));
  return heard;
}

describe('playing', () => {
  async function opened(): Promise<Bag> {
    return openBag(sourceOf((await recorded()).bytes));
  }

  test('a bag says what it has', watchdog, async () => {
    const bag = await opened();
    assert.equal(bag.damage, undefined);
    assert.equal(bag.distro, 'jazzy');
    assert.equal(bag.messages, 202);
    assert.deepEqual(bag.channels.map(({ topic, type, count }) => [topic, type, count]), [
      ['/chatter', 'std_msgs/msg/String', 200],
      ['/late', 'std_msgs/msg/String', 1],
      ['/map', 'std_msgs/msg/String', 1],
    ]);
    assert.equal(bag.channels[2]!.offered[0]!.durability, 'transient_local');
    assert.equal(bag.definitions.get('std_msgs/msg/String'), '# A text.\nstring data');
  });

  test('all is heard in order, with the recorded QoS; then it has ended, and plays again', watchdog, async () => {
    const session = newSession();
    const player = new BagPlayer(session, await opened(), () => undefined, { rate: 100 });
    const heard = listen(session, '/chatter');
    player.play();
    assert.equal(player.state, 'playing');
    await until(() => player.state === 'ended' && heard.length === 200);
    assert.deepEqual(heard.map(({ text }) => text), Array.from({ length: 200 }, (_, i) => `Hello World: ${i}`));
    assert.equal(player.sent, 202);
    const [offered] = session.graph().nodes.flatMap(({ publishers }) => publishers.filter(({ name }) => name === '/map'));
    assert.equal(offered!.qos.durability, 'transient_local');
    // A late subscription receives the latched message.
    const map = listen(session, '/map', true);
    await until(() => map.length === 1);
    player.play();
    await until(() => heard.length === 400);
    player.close();
    session.close();
  });

  test('its place waits for what is not yet sent, and a pause loses nothing', watchdog, async () => {
    const session = newSession();
    const bag = await opened();
    const player = new BagPlayer(session, bag, () => undefined, { rate: 100 });
    const heard = listen(session, '/chatter');
    const places: bigint[] = [];
    const watch = (): boolean => {
      places.push(player.place());
      if (player.sent === 0) assert.equal(player.place(), bag.start);
      return player.state === 'ended';
    };
    player.play();
    await until(() => {
      watch();
      return places.length === 5;
    });
    player.pause();
    watch();
    player.play();
    await until(watch);
    await until(() => heard.length >= 200);
    assert.equal(new Set(heard.map(({ text }) => text)).size, 200);
    assert.ok(places.every((place, i) => i === 0 || place >= places[i - 1]!));
    player.close();
    session.close();
  });

  test('topics are chosen and named anew, and it goes round', watchdog, async () => {
    const session = newSession();
    const player = new BagPlayer(session, await opened(), () => undefined, { rate: 100, loop: true, topics: ['/map'], names: new Map([['/map', '/other']]) });
    const [chatter, other] = [listen(session, '/chatter'), listen(session, '/other')];
    player.play();
    await until(() => other.length >= 3);
    assert.equal(chatter.length, 0);
    player.pause();
    assert.equal(player.state, 'paused');
    player.close();
    session.close();
  });

  test('a seek plays what comes then, and what was latched before it', watchdog, async () => {
    const session = newSession();
    const bag = await opened();
    const player = new BagPlayer(session, bag, () => undefined, { rate: 100 });
    const [map, late, chatter] = [listen(session, '/map'), listen(session, '/late'), listen(session, '/chatter')];
    player.seek(bag.end);
    assert.equal(player.place(), bag.end);
    player.play();
    await until(() => late.length === 1 && map.length === 1);
    assert.equal(chatter.length, 0);
    await until(() => player.state === 'ended');
    player.seek(bag.start - 5n);
    assert.equal(player.place(), bag.start);
    player.close();
    session.close();
  });

  test('/clock tells the time of the bag', watchdog, async () => {
    const session = newSession();
    const bag = await opened();
    const player = new BagPlayer(session, bag, () => undefined, { rate: 0.01, clockHz: 100 });
    let seconds = 0;
    session.node().subscription('/clock', 'rosgraph_msgs/msg/Clock', { reliability: 'best_effort' }, (bytes) => {
      seconds = new DataView(bytes.buffer, bytes.byteOffset).getInt32(4, true);
    });
    player.play();
    await until(() => seconds !== 0);
    assert.ok(Math.abs(seconds - Number(bag.start / 1_000_000_000n)) <= 1);
    player.close();
    session.close();
  });
});

test('a topic that the page cannot subscribe to is tried once, and is not in the bag', watchdog, async (context) => {
  const session = newSession();
  const admission = session.broker.admit();
  assert.ok(admission?.ticket.kind === 'port');
  const other = new PortLink(admission.ticket);
  other.endpointCreate({
    kind: EndpointKind.publisher,
    node: other.nodeCreate('odd', '/'),
    name: '/odd',
    type: 'no type',
    hash: '',
    flags: 0,
    qos: defaultQos,
  });
  session.node().publisher('/right', 'std_msgs/msg/String');
  await until(() => session.graph().nodes.some(({ name }) => name === '/odd'));
  const subscriptions = context.mock.method(session.node(), 'subscription');
  const { recorder, sink } = await record(session);
  for (let i = 0; i < 5; i += 1) session.graphChanged();
  const asked = (name: string): number => subscriptions.mock.calls.filter(({ arguments: [topic] }) => topic === name).length;
  assert.deepEqual([asked('/odd'), asked('/right')], [1, 1]);
  await recorder.stop();
  other.close();
  session.close();
  assert.deepEqual([...(await mcap(sink.bytes())).channelsById.values()].map(({ topic }) => topic), ['/right']);
});
