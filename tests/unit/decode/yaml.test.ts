// YAML as `ros2 topic echo` prints it: scalars against PyYAML's own output, then whole messages.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { formatFloat, formatText, toYaml } from '../../../runtime/site/decode/yaml.ts';
import type { Shape } from '../../../runtime/site/decode/shape.ts';
import { floatVectors, textVectors } from './yaml_vectors.ts';

test('texts are quoted as PyYAML quotes them', () => {
  for (const [text, yaml] of textVectors) {
    assert.equal(formatText(text, '  '), yaml, JSON.stringify(text));
  }
});

test('floats are written as PyYAML writes them', () => {
  for (const [value, yaml] of floatVectors) {
    assert.equal(formatFloat(value), yaml);
  }
});

const field = (
  name: string,
  type: string,
  isArray = false,
  shape: Shape | null = null,
): Shape[number] => ({ name, type, isArray, shape });

test('messages nest as ros2 topic echo prints them', () => {
  const stamped: Shape = [
    field('header', 'std_msgs/msg/Header', false, [
      field('stamp', 'time'),
      field('frame_id', 'string'),
    ]),
    field('ranges', 'float32', true),
    field('points', 'geometry_msgs/msg/Point', true, [
      field('x', 'float64'),
      field('y', 'float64'),
    ]),
    field('names', 'string', true),
    field('ok', 'bool'),
    field('big', 'uint64'),
    field('nothing', 'std_msgs/msg/Empty', false, []),
    field('many', 'uint8', true),
  ];
  const value = {
    header: { stamp: { sec: 3, nanosec: 5 }, frame_id: 'base: link' },
    ranges: new Float32Array([1, 0.5]),
    points: [
      { x: 1, y: -2 },
      { x: 0.25, y: 3 },
    ],
    names: [],
    ok: true,
    big: 18446744073709551615n,
    nothing: {},
    many: new Uint8Array(200),
  };
  const yaml = toYaml(value, stamped, 2);
  assert.equal(
    yaml,
    'header:\n  stamp:\n    sec: 3\n    nanosec: 5\n  frame_id: ba...\nranges:\n- 1.0\n- 0.5\n'
      + 'points:\n- x: 1.0\n  y: -2.0\n- x: 0.25\n  y: 3.0\nnames: []\nok: true\nbig: 18446744073709551615\nnothing: {}\n'
      + "many:\n- 0\n- 0\n- '...'\n",
  );
  assert.equal(toYaml({}, []), '{}\n');
});

test('a long text is cut at 128 characters unless asked whole', () => {
  const shape: Shape = [field('data', 'string')];
  assert.equal(toYaml({ data: 'x'.repeat(200) }, shape), `data: ${'x'.repeat(128)}...\n`);
  assert.equal(toYaml({ data: 'x'.repeat(200) }, shape, null), `data: ${'x'.repeat(200)}\n`);
});
