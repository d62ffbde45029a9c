// Messages of commands: what was typed, filled up with the type's defaults.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { fillMessage } from '../../../runtime/site/ros2cli/filled_message.ts';

const codec = createCodec(new Map([
  ['pkg/msg/Spot', 'float32 x\nfloat64 y\nint32 n'],
  ['pkg/msg/Path', 'float32 width 1.5\nSpot[] spots\nfloat32[2] ends\nstring name'],
]));

test('single precision is printed as it was typed, and sent as it is', async () => {
  const { value, bytes } = await fillMessage(codec, 'pkg/msg/Path', '{width: 0.2, spots: [{x: 0.1, y: 0.1, n: 3}], ends: [0.5, 0.7]}');
  assert.deepEqual(value, {
    width: 0.2,
    spots: [{ x: 0.1, y: 0.1, n: 3 }],
    ends: Float32Array.of(0.5, 0.7),
    name: '',
  });
  const sent = codec.decode('pkg/msg/Path', bytes);
  assert.equal(sent.kind === 'value' ? (sent.value as { width: number; }).width : 0, Math.fround(0.2));
});

test('what was not typed is the default', async () => {
  const { value } = await fillMessage(codec, 'pkg/msg/Path', '');
  assert.deepEqual(value, { width: 1.5, spots: [], ends: Float32Array.of(0, 0), name: '' });
});
