// Bytes to values, through the definitions that a site ships. Writers of @foxglove make the bytes.

// Compatibility, works: `configure_introspection` of services and clients:
// `<service>/_service_event` with the `_Event` type, off, metadata or contents; the page shows it

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { parse } from '@foxglove/rosmsg';
import { MessageWriter } from '@foxglove/rosmsg2-serialization';
import { createDecoder } from '../../../runtime/site/decode/decoder.ts';
import type { Decoded } from '../../../runtime/site/decode/decoder.ts';
import { gatherDefinition, qualify } from '../../../runtime/site/decode/definitions.ts';
import { inFlow } from '../../../runtime/site/decode/flow_yaml.ts';
import { toYaml } from '../../../runtime/site/decode/yaml.ts';

const interfaces = new Map([
  ['std_msgs/msg/String', '# a text\nstring data\n'],
  ['std_msgs/msg/Empty', ''],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
  ['geometry_msgs/msg/Point', 'float64 x\nfloat64 y\nfloat64 z\n'],
  ['other_msgs/msg/Point', 'string label\n'],
  [
    'demo/msg/Track',
    'int8 KIND=3 # constant\nstd_msgs/Header header\ngeometry_msgs/Point[] points\nother_msgs/msg/Point own\nfloat32 gain 1.5\nuint8[<=4] tail\n',
  ],
  ['demo/action/Count', 'int32 order\n---\nint32[] sequence\n---\nint32[] partial_sequence\n'],
  ['unique_identifier_msgs/msg/UUID', 'uint8[16] uuid\n'],
  ['demo/srv/Add', 'int64 a\nint64 b\n---\nint64 sum\n'],
  ['service_msgs/msg/ServiceEventInfo', 'uint8 REQUEST_SENT=0\nuint8 event_type\nbuiltin_interfaces/Time stamp\nchar[16] client_gid\nint64 sequence_number\n'],
  ['demo/msg/Broken', 'float64 x twelve\n'],
  ['demo/msg/Lost', 'nowhere_msgs/Thing thing\n'],
]);

function bytesOf(type: string, value: unknown): Uint8Array {
  const definition = gatherDefinition(type, interfaces);
  assert.ok('text' in definition);
  return new MessageWriter(parse(definition.text, { ros2: true })).writeMessage(value);
}

function yamlOf(decoded: Decoded): string {
  assert.equal(decoded.kind, 'value');
  return decoded.kind === 'value' ? toYaml(decoded.value, decoded.shape) : '';
}

test('a String is decoded', () => {
  const decoded = createDecoder(interfaces).decode(
    'std_msgs/msg/String',
    bytesOf('std_msgs/msg/String', { data: 'Hello World: 0' }),
  );
  assert.equal(yamlOf(decoded), "data: 'Hello World: 0'\n");
});

test('nested types of equal name in two packages, constants, defaults and bounds', () => {
  const value = {
    header: { stamp: { sec: 1, nanosec: 2 }, frame_id: 'map' },
    points: [{ x: 1, y: 2, z: 3 }],
    own: { label: 'mine' },
    gain: 1,
    tail: new Uint8Array([9]),
  };
  const decoded = createDecoder(interfaces).decode(
    'demo/msg/Track',
    bytesOf('demo/msg/Track', value),
  );
  assert.equal(
    yamlOf(decoded),
    'header:\n  stamp:\n    sec: 1\n    nanosec: 2\n  frame_id: map\npoints:\n- x: 1.0\n  y: 2.0\n  z: 3.0\n'
      + 'own:\n  label: mine\ngain: 1.0\ntail:\n- 9\n',
  );
});

test('the feedback of an action, which has no definition of its own', () => {
  const type = 'demo/action/Count_FeedbackMessage';
  const value = {
    goal_id: { uuid: new Uint8Array(16) },
    feedback: { partial_sequence: new Int32Array([0, 1, 1]) },
  };
  assert.match(
    yamlOf(createDecoder(interfaces).decode(type, bytesOf(type, value))),
    /partial_sequence:\n {2}- 0\n {2}- 1\n {2}- 1/,
  );
});

test('the event of a service, which has no definition of its own', () => {
  const type = 'demo/srv/Add_Event';
  const info = { event_type: 1, stamp: { sec: 3, nanosec: 4 }, client_gid: new Uint8Array(16), sequence_number: 7n };
  const value = { info, request: [{ a: 2n, b: 3n }], response: [] };
  const text = yamlOf(createDecoder(interfaces).decode(type, bytesOf(type, value)));
  assert.match(text, /event_type: 1\n[^]*sequence_number: 7\n/);
  assert.match(text, /request:\n- a: 2\n {2}b: 3\nresponse: \[\]/);
  // As PyYAML with default_flow_style=True, below mappings that a representer makes.
  const shown = toYaml({ request: [{ 'a': 2n, 'text': 'a,' }], list: [1, 2, 3] }, null, 2, inFlow);
  assert.equal(shown, "request: [{a: 2, text: 'a,'}]\nlist: [1, 2, '...']\n");
});

test('shared memory is decoded too', () => {
  const own = bytesOf('std_msgs/msg/String', { data: 'shared' });
  const shared = new Uint8Array(new SharedArrayBuffer(own.length));
  shared.set(own);
  assert.equal(
    yamlOf(createDecoder(interfaces).decode('std_msgs/msg/String', shared)),
    'data: shared\n',
  );
});

test('an empty message', () => {
  assert.equal(
    yamlOf(createDecoder(interfaces).decode('std_msgs/msg/Empty', new Uint8Array([0, 1, 0, 0, 0]))),
    '{}\n',
  );
});

test('what cannot be decoded says why and throws nothing', () => {
  const decoder = createDecoder(interfaces);
  const reason = (type: string, bytes: Uint8Array): string => {
    const decoded = decoder.decode(type, bytes);
    assert.equal(decoded.kind, 'failed');
    return decoded.kind === 'failed' ? decoded.reason : '';
  };
  const whole = bytesOf('std_msgs/msg/String', { data: 'Hello' });
  for (let length = 0; length < whole.length - 1; length += 1) {
    assert.match(
      reason('std_msgs/msg/String', whole.slice(0, length)),
      /are no std_msgs\/msg\/String/,
    );
  }
  assert.match(
    reason('std_msgs/msg/String', new Uint8Array([0, 1, 0, 0, 255, 255, 255, 255])),
    /are no/,
  );
  assert.match(reason('no_msgs/msg/Such', whole), /has no definition of no_msgs\/msg\/Such/);
  assert.match(
    reason('demo/msg/Lost', whole),
    /nowhere_msgs\/msg\/Thing, which demo\/msg\/Lost uses/,
  );
  assert.match(reason('demo/msg/Broken', whole), /cannot be read/);
});

test('type names are qualified within their package', () => {
  assert.equal(qualify('float64', 'a/msg/B'), null);
  assert.equal(qualify('Point', 'geometry_msgs/msg/Pose'), 'geometry_msgs/msg/Point');
  assert.equal(qualify('std_msgs/Header', 'a/msg/B'), 'std_msgs/msg/Header');
  assert.equal(qualify('std_msgs/msg/Header', 'a/msg/B'), 'std_msgs/msg/Header');
  assert.equal(
    qualify('Count_Feedback', 'demo/action/Count_FeedbackMessage'),
    'demo/action/Count_Feedback',
  );
});
