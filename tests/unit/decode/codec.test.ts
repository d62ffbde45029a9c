// Values to bytes and drafts, against @foxglove's own writer and back through the decoder.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { inspect } from 'node:util';
import { parse } from '@foxglove/rosmsg';
import { MessageWriter } from '@foxglove/rosmsg2-serialization';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { gatherDefinition } from '../../../runtime/site/decode/definitions.ts';

const interfaces = new Map([
  ['std_msgs/msg/String', 'string data\n'],
  ['std_msgs/msg/Empty', ''],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
  ['unique_identifier_msgs/msg/UUID', 'uint8[16] uuid\n'],
  ['geometry_msgs/msg/Point', 'float64 x\nfloat64 y\nfloat64 z\n'],
  ['demo/msg/All', [
    'int8 LOW=-3',
    'std_msgs/Header header',
    'bool on true',
    'byte raw',
    'char letter',
    'int8 a',
    'uint8 b 7',
    'int16 c',
    'uint16 d',
    'int32 e -5',
    'uint32 f',
    'int64 g',
    'uint64 h 18446744073709551615',
    'float32 i',
    'float64 j 2.5',
    'string k "hé"',
    'string<=3 l',
    'int32[] m',
    'float64[3] n [1.0, 2.0, 3.0]',
    'uint8[<=2] o',
    'string[] p',
    'geometry_msgs/Point[] q',
    'geometry_msgs/Point[2] r',
    'builtin_interfaces/Duration s',
    'bool[2] t',
    'std_msgs/Empty u',
  ].join('\n')],
  ['builtin_interfaces/msg/Duration', 'int32 sec\nuint32 nanosec\n'],
  ['demo/msg/Wide', 'wstring data\n'],
  ['demo/msg/Huge', 'uint8[4000000000] data\n'],
  ['demo/action/Count', 'int32 order\n---\nint32[] sequence\n---\nint32[] partial\n'],
  ['demo/msg/Odd', 'int32 constructor\nint32 a\n'],
]);
const codec = createCodec(interfaces);

function bytesOf(type: string, value: unknown): Uint8Array {
  const encoded = codec.encode(type, value);
  assert.equal(encoded.kind, 'bytes', inspect(encoded));
  return encoded.kind === 'bytes' ? encoded.bytes : new Uint8Array();
}

function valueOf(type: string, bytes: Uint8Array): unknown {
  const decoded = codec.decode(type, bytes);
  assert.equal(decoded.kind, 'value', inspect(decoded));
  return decoded.kind === 'value' ? decoded.value : undefined;
}

const full = {
  header: { stamp: { sec: -1, nanosec: 999_999_999 }, frame_id: 'map' },
  on: false,
  raw: 255,
  letter: 65,
  a: -128,
  b: 255,
  c: -32768,
  d: 65535,
  e: -(2 ** 31),
  f: 2 ** 32 - 1,
  g: -(2n ** 63n),
  h: 2n ** 64n - 1n,
  i: 1.5,
  j: -0.1,
  k: 'text',
  l: 'abc',
  m: [1, -2, 3],
  n: [0.5, -0.5, 1e300],
  o: [1, 2],
  p: ['a', '', 'ccc'],
  q: [{ x: 1, y: 2, z: 3 }],
  r: [{ x: 4, y: 5, z: 6 }, { x: 7, y: 8, z: 9 }],
  s: { sec: 3, nanosec: 4 },
  t: [true, false],
  u: {},
};

test('bytes are those of an independent writer', () => {
  const definition = gatherDefinition('demo/msg/All', interfaces);
  assert.ok('text' in definition);
  const expected = new MessageWriter(parse(definition.text, { ros2: true })).writeMessage(full);
  assert.deepEqual(bytesOf('demo/msg/All', full), expected);
  assert.deepEqual(bytesOf('std_msgs/msg/Empty', {}), Uint8Array.of(0, 1, 0, 0, 0));
});

test('what was decoded can be encoded again', () => {
  const bytes = bytesOf('demo/msg/All', full);
  assert.deepEqual(bytesOf('demo/msg/All', valueOf('demo/msg/All', bytes)), bytes);
});

test('texts that are not ASCII are whole', () => {
  for (const data of ['grüezi', '日本語', '🐢 turtle', 'a\0b']) {
    assert.deepEqual(valueOf('std_msgs/msg/String', bytesOf('std_msgs/msg/String', { data })), { data });
  }
});

test('a draft has the defaults of the definition, and is what is sent for what is skipped', () => {
  const drafted = codec.draft('demo/msg/All');
  assert.equal(drafted.kind, 'value');
  if (drafted.kind !== 'value') return;
  const { value } = drafted;
  assert.deepEqual(value, {
    header: { stamp: { sec: 0, nanosec: 0 }, frame_id: '' },
    on: true,
    raw: 0,
    letter: 0,
    a: 0,
    b: 7,
    c: 0,
    d: 0,
    e: -5,
    f: 0,
    g: 0n,
    h: 18446744073709551615n,
    i: 0,
    j: 2.5,
    k: 'hé',
    l: '',
    m: [],
    n: [1, 2, 3],
    o: [],
    p: [],
    q: [],
    r: [{ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 0 }],
    s: { sec: 0, nanosec: 0 },
    t: [false, false],
    u: {},
  });
  assert.deepEqual(bytesOf('demo/msg/All', {}), bytesOf('demo/msg/All', value));
  assert.deepEqual(codec.draft('demo/msg/Odd'), { kind: 'value', value: { constructor: 0, a: 0 } });
  assert.deepEqual(bytesOf('demo/msg/Odd', {}), Uint8Array.of(0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
});

test('the parts of an action, as they are on the wire', () => {
  const id = { uuid: Uint8Array.from({ length: 16 }, (_, i) => i) };
  const type = 'demo/action/Count';
  assert.deepEqual(bytesOf(`${type}_SendGoal_Request`, { goal_id: id, goal: { order: 5 } }), Uint8Array.of(0, 1, 0, 0, ...id.uuid, 5, 0, 0, 0));
  assert.deepEqual(valueOf(`${type}_SendGoal_Response`, Uint8Array.of(0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3, 0, 0, 0)), {
    accepted: true,
    stamp: { sec: 2, nanosec: 3 },
  });
  assert.deepEqual(bytesOf(`${type}_GetResult_Request`, { goal_id: id }), Uint8Array.of(0, 1, 0, 0, ...id.uuid));
  assert.deepEqual(valueOf(`${type}_GetResult_Response`, Uint8Array.of(0, 1, 0, 0, 4, 0, 0, 0, 1, 0, 0, 0, 9, 0, 0, 0)), {
    status: 4,
    result: { sequence: Int32Array.of(9) },
  });
});

test('what does not fit says where and why, and throws nothing', () => {
  const cases: readonly (readonly [unknown, string, RegExp])[] = [
    [{ b: 256 }, 'b', /256 is not a valid uint8: 0 to 255/],
    [{ a: -129 }, 'a', /is not a valid int8/],
    [{ a: 1.5 }, 'a', /whole number is wanted, not 1.5/],
    [{ h: -1n }, 'h', /is not a valid uint64/],
    [{ i: '1' }, 'i', /a number is wanted, not the text "1"/],
    [{ k: 7 }, 'k', /a text is wanted, not 7/],
    [{ l: 'äb!' }, 'l', /at most 3 bytes/],
    [{ on: 1 }, 'on', /true or false/],
    [{ m: 3 }, 'm', /a list is wanted/],
    [{ n: [1] }, 'n', /exactly 3 items/],
    [{ o: [1, 2, 3] }, 'o', /at most 2 items/],
    [{ q: [{}, { x: 'far' }] }, 'q[1].x', /a number/],
    [{ header: { stamp: { sec: 1, nsec: 2 } } }, 'header.stamp.nsec', /no such field/],
    [{ header: 4 }, 'header', /fields are wanted/],
    [{ nothing: 1 }, 'nothing', /no such field/],
    [null, '', /fields are wanted, not nothing/],
    [[1], '', /fields are wanted, not a list/],
  ];
  for (const [value, path, reason] of cases) {
    const encoded = codec.encode('demo/msg/All', value);
    assert.equal(encoded.kind, 'failed', path);
    if (encoded.kind === 'failed') {
      assert.equal(encoded.path, path);
      assert.match(encoded.reason, reason);
    }
  }
  assert.match(JSON.stringify(codec.encode('demo/msg/Wide', {})), /wstring cannot be sent/);
  assert.match(JSON.stringify(codec.draft('demo/msg/Huge')), /more than 1048576 items/);
  assert.match(JSON.stringify(codec.encode('demo/msg/Huge', {})), /more than 1048576 items/);
  assert.match(JSON.stringify(codec.draft('demo/msg/None')), /has no definition of demo\/msg\/None/);
});

test('a type that became known later is read, and what is known stays', () => {
  const known = new Map([['a/msg/A', 'b/B inner']]);
  const late = createCodec(known);
  const bytes = Uint8Array.from([0, 1, 0, 0, 7, 0, 0, 0]);
  const before = late.decode('a/msg/A', bytes);
  assert.match(before.kind === 'failed' ? before.reason : '', /no definition of b\/msg\/B/);
  known.set('b/msg/B', 'int32 x');
  const after = late.decode('a/msg/A', bytes);
  assert.deepEqual(after.kind === 'value' ? after.value : after.reason, { inner: { x: 7 } });
});
