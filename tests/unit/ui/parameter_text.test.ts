// Values of parameters as texts and back: types, limits of 64 bits, lists, and ranges that a slider can have.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readYaml } from '../../../runtime/site/decode/read_yaml.ts';
import { needsYaml, parameterText, rangeText, readParameter, sliderRange } from '../../../runtime/site/ui/model/parameter_text.ts';
import { readPageAction } from '../../../runtime/site/ui/model/page_action.ts';

const read = (text: string, type: number): unknown => {
  const result = readParameter(text, type, readYaml);
  return result.kind === 'value' ? result.value : result.reason;
};

test('what a field shows means the same when it is read', () => {
  for (
    const value of [
      { type: 2, integer_value: -9223372036854775808n },
      { type: 3, double_value: 1 },
      { type: 3, double_value: -Infinity },
      { type: 3, double_value: 1e-7 },
      { type: 4, string_value: ' true ' },
      { type: 6, bool_array_value: [true, false] },
      { type: 7, integer_array_value: [1n, -2n] },
      { type: 8, double_array_value: [1, 0.5, 1e300] },
      { type: 9, string_array_value: ['a, b', 'yes', '1', '"\\\u2028\n', ''] },
      { type: 9, string_array_value: [] },
    ]
  ) assert.deepEqual(read(parameterText(value), value.type), value);
});

test('what does not fit its type is refused', () => {
  assert.equal(read('9223372036854775808', 2), 'not an integer of 64 bits');
  assert.equal(read('1.5', 2), 'not an integer of 64 bits');
  assert.equal(read('', 3), 'not a number');
  assert.equal(read('[1.5]', 7), 'no integer array: a list is written as [1, 2]');
  assert.equal(read('[1, 99999999999999999999]', 7), 'no integer array: a list is written as [1, 2]');
  assert.equal(read('{a: 1}', 9), 'no string array: a list is written as [1, 2]');
  assert.match(String(read('[1', 8)), /./);
  assert.equal(read('perhaps', 1), 'neither true nor false');
});

test('a double takes whole numbers; one of any type takes what YAML makes of the text', () => {
  assert.deepEqual(read('[1, 2.5]', 8), { type: 8, double_array_value: [1, 2.5] });
  assert.deepEqual(read('2', 3), { type: 3, double_value: 2 });
  assert.deepEqual(read('2', 0), { type: 2, integer_value: 2n });
  assert.deepEqual(read('on', 1), { type: 1, bool_value: true });
  assert.deepEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9].filter(needsYaml), [0, 1, 5, 6, 7, 8, 9]);
});

test('bytes are shown, the first of many', () => {
  assert.equal(parameterText({ type: 5, byte_array_value: new Uint8Array([0, 255]) }), '00 ff');
  assert.match(parameterText({ type: 5, byte_array_value: new Uint8Array(1000) }), /^(00 ){64}\u2026$/);
});

const descriptor = {
  name: 'x',
  type: 2,
  description: '',
  additional_constraints: '',
  read_only: false,
  dynamic_typing: false,
  floating_point_range: [],
  integer_range: [],
};

test('ranges become sliders when they can', () => {
  const whole = { ...descriptor, integer_range: [{ from_value: -2n, to_value: 8n, step: 0n }] };
  assert.deepEqual(sliderRange(whole, 2), { least: -2, most: 8, step: 1 });
  assert.equal(sliderRange(whole, 3), null);
  assert.equal(rangeText(whole), 'from -2 to 8');
  const wide = { ...descriptor, integer_range: [{ from_value: -(1n << 63n), to_value: (1n << 63n) - 1n, step: 1n }] };
  assert.equal(sliderRange(wide, 2), null);
  const endless = { ...descriptor, floating_point_range: [{ from_value: 0, to_value: Infinity, step: 0.5 }] };
  assert.equal(sliderRange(endless, 3), null);
  assert.equal(rangeText(endless), 'from 0.0 to .inf in steps of 0.5');
  assert.equal(sliderRange({ ...descriptor, floating_point_range: [{ from_value: 1, to_value: 1, step: 0 }] }, 3), null);
  assert.equal(sliderRange(undefined, 3), null);
});

test('a link that sets a parameter has a node, a name and a value', () => {
  assert.deepEqual(readPageAction('ros2wasm:set_param?node=/robot&name=speed&value=1.5'), { kind: 'set_param', node: '/robot', name: 'speed', value: '1.5' });
  assert.deepEqual(readPageAction('ros2wasm:set_param?node=a&name=b&value='), { kind: 'set_param', node: 'a', name: 'b', value: '' });
  assert.equal(readPageAction('ros2wasm:set_param?node=a&name=b'), null);
  assert.equal(readPageAction('ros2wasm:set_param?name=b&value=1'), null);
});
