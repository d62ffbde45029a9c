// Message values typed as YAML, with PyYAML's reading of it and the conversions of `ros2 topic pub`.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inspect } from 'node:util';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { type Fill, readMessage, readYaml } from '../../../runtime/site/decode/read_yaml.ts';

const codec = createCodec(new Map([
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
  ['geometry_msgs/msg/Vector3', 'float64 x\nfloat64 y\nfloat64 z\n'],
  ['geometry_msgs/msg/Twist', 'Vector3 linear\nVector3 angular\n'],
  ['demo/msg/Mix', 'std_msgs/Header header\nstring text\nint32 count\nuint64 big\nbool lit\nfloat64 real\nfloat32[] reals\ngeometry_msgs/Vector3[] points\n'],
]));

function read(type: string, text: string, fill: Fill = {}): unknown {
  const parsed = codec.types.get(type);
  assert.ok(typeof parsed === 'object');
  const result = readMessage(text, parsed.shape, fill);
  assert.equal(result.kind, 'value', inspect(result));
  return result.kind === 'value' ? result.value : undefined;
}

test('flow and block style', () => {
  const moved = { linear: { x: 2, y: 0, z: 0 }, angular: { z: 1.8 } };
  assert.deepEqual(read('geometry_msgs/msg/Twist', '{linear: {x: 2.0, y: 0.0, z: 0.0}, angular: {z: 1.8}}'), moved);
  assert.deepEqual(read('geometry_msgs/msg/Twist', 'linear:\n  x: 2.0\n  y: 0\n  z: 0.0\nangular:\n  z: 1.8\n'), moved);
  assert.deepEqual(read('geometry_msgs/msg/Twist', '{}'), {});
  assert.deepEqual(read('geometry_msgs/msg/Twist', ''), {});
});

test('values become what their fields want', () => {
  assert.deepEqual(read('demo/msg/Mix', '{text: 5, count: 2.9, big: 18446744073709551615, lit: yes, real: 1e3, reals: [1, .5, .inf], points: [{x: 1}]}'), {
    text: '5',
    count: 2n,
    big: 18446744073709551615n,
    lit: true,
    real: 1000,
    reals: [1, 0.5, Infinity],
    points: [{ x: 1 }],
  });
  assert.deepEqual(read('demo/msg/Mix', '{text: true, lit: 0, count: "7"}'), { text: 'True', lit: false, count: 7n });
  assert.deepEqual(read('demo/msg/Mix', '{text: "yes", real: 3}'), { text: 'yes', real: 3 });
});

test('auto and now are the time where they are asked for', () => {
  const now = { sec: 12, nanosec: 34 };
  assert.deepEqual(read('demo/msg/Mix', '{header: auto}', { now }), { header: { stamp: now } });
  assert.deepEqual(read('demo/msg/Mix', '{header: {stamp: now, frame_id: map}}', { now }), { header: { stamp: now, frame_id: 'map' } });
  assert.deepEqual(read('demo/msg/Mix', '{header: auto}'), { header: 'auto' });
});

test('what is wrong is told, whatever the text', () => {
  const failed = (text: string): string => {
    const parsed = codec.types.get('geometry_msgs/msg/Twist');
    assert.ok(typeof parsed === 'object');
    const result = readMessage(text, parsed.shape);
    return result.kind === 'failed' ? result.reason : '';
  };
  assert.match(failed('{linear: {x: 1'), /\w/);
  assert.match(failed('[1, 2]'), /fields with their values/);
  assert.match(failed('5'), /fields with their values/);
  const bomb = ['a: &a [x, x, x, x, x, x, x, x, x]',
    ...'bcdefghi'.split('').map((name, i) => `${name}: &${name} [${Array.from({ length: 9 }, () => `*${'abcdefghi'[i]}`).join(', ')}]`)].join('\n');
  assert.equal(readYaml(bomb).kind, 'failed');
  const deep = readYaml('['.repeat(20_000));
  assert.equal(deep.kind, 'failed');
  const proto = readYaml('{__proto__: {polluted: true}}');
  assert.equal(proto.kind, 'value');
  assert.equal(({} as Record<string, unknown>)['polluted'], undefined);
});
