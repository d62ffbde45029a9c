// Functions behind an opened topic: pairs of QoS that do not fit, differences between messages, a message as a command.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { readMessage } from '../../../runtime/site/decode/read_yaml.ts';
import { splitLine } from '../../../runtime/site/ros2cli/parse.ts';
import { partOf, sameValue } from '../../../runtime/site/ui/model/message_change.ts';
import { pubCommand } from '../../../runtime/site/ui/model/pub_command.ts';
import { misfitsOf, topicEndsOf } from '../../../runtime/site/ui/model/topic_qos.ts';
import type { EndpointQosView, GraphEndpointView, GraphNodeView } from '../../../runtime/site/contract/session.ts';

const USUAL: EndpointQosView = {
  reliability: 'reliable',
  durability: 'volatile',
  history: 'keep_last',
  depth: 10,
  liveliness: 'automatic',
  deadlineNs: 0,
  lifespanNs: 0,
  leaseNs: 0,
};

function endpoint(qos: Partial<EndpointQosView> = {}, type = 'std_msgs/msg/String'): GraphEndpointView {
  return { name: '/topic', type, hash: '', gid: '', qos: { ...USUAL, ...qos } };
}

function node(name: string, has: Partial<GraphNodeView>): GraphNodeView {
  return { name, process: undefined, publishers: [], subscriptions: [], services: [], clients: [], actionServers: [], actionClients: [], ...has };
}

function policies(offered: GraphEndpointView, asked: GraphEndpointView): readonly string[] {
  const graph = { nodes: [node('/from', { publishers: [offered] }), node('/to', { subscriptions: [asked] })] };
  return misfitsOf(topicEndsOf(graph).get('/topic') ?? []).map(({ publisher, subscription, policy }) => `${publisher.node} ${subscription.node} ${policy}`);
}

test('a pair that does not fit is named with the first policy that stands between them', () => {
  assert.deepEqual(policies(endpoint(), endpoint()), []);
  assert.deepEqual(policies(endpoint(), endpoint({ reliability: 'best_effort' })), []);
  assert.deepEqual(policies(endpoint({ reliability: 'best_effort' }), endpoint({ durability: 'transient_local' })), ['/from /to reliability']);
  assert.deepEqual(policies(endpoint(), endpoint({ durability: 'transient_local' })), ['/from /to durability']);
  assert.deepEqual(policies(endpoint(), endpoint({ deadlineNs: 1e8 })), ['/from /to deadline']);
  assert.deepEqual(policies(endpoint({ deadlineNs: 5e7 }), endpoint({ deadlineNs: 1e8 })), []);
  assert.deepEqual(policies(endpoint(), endpoint({ liveliness: 'manual_by_topic' })), ['/from /to liveliness']);
  assert.deepEqual(policies(endpoint({ leaseNs: 2e9 }), endpoint({ leaseNs: 1e9 })), ['/from /to lease']);
  assert.deepEqual(policies(endpoint(), endpoint({}, 'std_msgs/msg/Int32')), ['/from /to type']);
  assert.deepEqual(policies(endpoint(), endpoint({}, '')), []);
});

test('values are the same by what is in them', () => {
  assert.equal(sameValue({ a: [1, { b: Number.NaN }] }, { a: [1, { b: Number.NaN }] }), true);
  assert.equal(sameValue(new Float32Array([1, 2]), new Float32Array([1, 3])), false);
  assert.equal(sameValue([1], [1, 2]), false);
  assert.equal(sameValue({ a: 1 }, { b: 1 }), false);
  assert.equal(sameValue(undefined, { a: 1 }), false);
  assert.equal(partOf({ list: [3] }, 'list') !== undefined, true);
  assert.equal(partOf({}, 'constructor'), undefined);
  assert.equal(partOf('text', 0), undefined);
});

test('a message copied as a command comes back the same, whatever is in its texts', () => {
  const codec = createCodec(new Map([
    ['demo/msg/All', 'string text\nfloat64 number\nint64 big\nbool flag\nfloat32[] list\nuint8[] bytes\nInner inner\nInner[] more\nstring[] words\n'],
    ['demo/msg/Inner', 'float64 x\nstring name\n'],
  ]));
  const value = {
    text: "it's {a: 1}, [x] \"q\" \\ # \n\t\u2028 yes \u0085 null 'quoted'",
    number: -0.5,
    big: -9223372036854775808n,
    flag: true,
    list: [Number.NaN, Number.POSITIVE_INFINITY, 1e-7],
    bytes: [0, 255],
    inner: { x: 1e300, name: '' },
    more: [{ x: 0, name: 'no' }, { x: 2, name: '~' }],
    words: ['1', '1.0', 'true', ''],
  };
  const made = codec.encode('demo/msg/All', value);
  assert.equal(made.kind, 'bytes');
  const read = codec.decode('demo/msg/All', made.kind === 'bytes' ? made.bytes : new Uint8Array());
  assert.ok(read.kind === 'value');
  const words = splitLine(pubCommand('/all', 'demo/msg/All', read.value, read.shape));
  assert.deepEqual(words?.slice(0, -1), ['ros2', 'topic', 'pub', '--once', '/all', 'demo/msg/All']);
  const back = readMessage(words?.at(-1) ?? '', read.shape);
  assert.ok(back.kind === 'value', JSON.stringify(back.kind === 'failed' ? back.reason : ''));
  const again = codec.encode('demo/msg/All', back.value);
  assert.deepEqual(again, made);
});
