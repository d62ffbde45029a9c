// A message being written: numbers as they are typed, `now`, and YAML put onto what a type begins with.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { draftBytes, onto, readNumber, refusal, stampOf, withNow } from '../../../runtime/site/ui/model/draft_value.ts';

const codec = createCodec(new Map([
  ['demo/msg/Stamped', 'std_msgs/Header header\nfloat64 x\nint64 big\nbuiltin_interfaces/Time[] times\nint8[] list\n'],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
]));

test('what is typed is a number, or stays what was typed', () => {
  assert.equal(readNumber('1.5', 'float64'), 1.5);
  assert.equal(readNumber(' -3e2 ', 'float32'), -300);
  assert.equal(readNumber('-.inf', 'float64'), -Infinity);
  assert.ok(Number.isNaN(readNumber('nan', 'float64')));
  assert.equal(readNumber('12', 'int32'), 12n);
  for (const text of ['', '-', '1.', 'x', '1.5']) {
    if (text !== '1.') assert.equal(readNumber(text, 'int32'), text);
  }
  assert.equal(readNumber('1,5', 'float64'), '1,5');
});

test('now becomes the time of the site, wherever a time stands', () => {
  const parsed = codec.types.get('demo/msg/Stamped');
  assert.ok(typeof parsed !== 'string');
  const value = withNow({ header: { stamp: 'now', frame_id: 'now' }, times: ['now'], x: 'now' }, parsed.shape, stampOf(1500.25));
  assert.deepEqual(value, { header: { stamp: { sec: 1, nanosec: 500_250_000 }, frame_id: 'now' }, times: [{ sec: 1, nanosec: 500_250_000 }], x: 'now' });
});

test('a form and its YAML come to the same bytes', async () => {
  const form = codec.draft('demo/msg/Stamped');
  assert.ok(form.kind === 'value');
  const value = onto(form.value, { x: 2.5, header: { stamp: 'now' }, list: [1n, 2n] });
  const one = await draftBytes(codec, 'demo/msg/Stamped', { view: 'form', value }, 5000);
  const other = await draftBytes(codec, 'demo/msg/Stamped', { view: 'yaml', text: '{x: 2.5, header: {stamp: now}, list: [1, 2]}' }, 5000);
  assert.ok(one.kind === 'bytes' && other.kind === 'bytes');
  assert.deepEqual(one.bytes, other.bytes);
});

test('what does not fit is refused with its place', async () => {
  const failed = async (text: string): Promise<string> => {
    const made = await draftBytes(codec, 'demo/msg/Stamped', { view: 'yaml', text }, 0);
    assert.equal(made.kind, 'failed');
    return made.kind === 'failed' ? refusal(made) : '';
  };
  assert.match(await failed('{y: 1}'), /^y: there is no such field/);
  assert.match(await failed('{list: [1, 300]}'), /^list\[1\]: /);
  assert.notEqual(await failed('{x: '), '');
  assert.match((await draftBytes(codec, 'demo/msg/None', { view: 'yaml', text: '' }, 0) as { reason: string; }).reason, /no definition/);
  assert.deepEqual(onto({ a: 1 }, { __proto__: null, b: 2 } as unknown as Record<string, unknown>), { a: 1, b: 2 });
});
