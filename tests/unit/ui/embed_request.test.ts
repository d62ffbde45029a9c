// The requests that an embedding page may send: only known shapes, bounded whatever it sends.
// Guarantee, hostile input: a page that shows a site in a frame: what it sends is bounded in size, depth and number, and it acts only
// when its origin is listed (R2W0750, R2W0751, R2W0752)
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Allowance, isReading, mayAct, readRequest, Refusal } from '../../../runtime/site/ui/model/embed_request.ts';
import { readJson } from '../../../runtime/site/ui/model/json.ts';

const request = (order: object): unknown => ({ ros2wasm: 1, id: 1, ...order });

function refusal(data: unknown): string {
  const order = readRequest(data)?.order;
  assert.ok(order instanceof Refusal, JSON.stringify(order));
  return `${order.code}: ${order.message}`;
}

test('what is not for the page is left alone', () => {
  for (
    const data of [null, 1, 'text', [], {}, { id: 1 }, { ros2wasm: 1 }, { ros2wasm: 1, id: {} }, { ros2wasm: 1, id: 'x'.repeat(65) }, { ros2wasm: 1, id: 1.5 }]
  )
    assert.equal(readRequest(data), null);
});

test('commands and their fields', () => {
  assert.deepEqual(readRequest(request({ do: 'hello', id: 'a' })), { id: 'a', order: { do: 'hello' } });
  assert.deepEqual(readRequest(request({ do: 'height' }))?.order, { do: 'height' });
  assert.deepEqual(readRequest(request({ do: 'start' }))?.order, { do: 'start', node: null });
  assert.deepEqual(readRequest(request({ do: 'stop', node: 'talker-1' }))?.order, { do: 'stop', node: 'talker-1' });
  assert.deepEqual(readRequest(request({ do: 'publish', topic: '/a', type: 'std_msgs/msg/String', message: { data: 'x' } }))?.order, {
    do: 'publish',
    topic: '/a',
    type: 'std_msgs/msg/String',
    message: { data: 'x' },
  });
  assert.deepEqual(readRequest(request({ do: 'subscribe', topic: '/a', rate: 1000 }))?.order, { do: 'subscribe', topic: '/a', rate: 30 });
  assert.deepEqual(readRequest(request({ do: 'call', service: '/a', type: 'std_srvs/srv/Empty', timeout_ms: -1 }))?.order, {
    do: 'call',
    service: '/a',
    type: 'std_srvs/srv/Empty',
    request: {},
    timeoutMs: 10_000,
  });
  assert.deepEqual(readRequest(request({ do: 'set_parameter', node: '/a', name: 'b', value: false }))?.order, {
    do: 'set_parameter',
    node: '/a',
    name: 'b',
    value: false,
  });
});

test('what is wrong with the others is said', () => {
  assert.match(refusal({ ros2wasm: 2, id: 1, do: 'hello' }), /R2W0750: this page speaks version 1/);
  assert.match(refusal(request({})), /no `do`/);
  for (const word of ['eval', 'constructor', '__proto__', 'toString']) assert.match(refusal(request({ do: word })), /is not a command/);
  assert.match(refusal(request({ do: 'start', node: 7 })), /`node` is not a valid name/);
  assert.match(refusal(request({ do: 'publish', topic: '/a', type: 'x'.repeat(300) })), /`type` is not a valid name/);
  assert.match(refusal(request({ do: 'publish', topic: '/a', type: 'a/msg/B', message: [1] })), /`message` has no fields/);
  assert.match(refusal(request({ do: 'set_parameter', node: '/a', name: 'b' })), /there is no `value`/);
});

test('values that are too large, too deep, no plain data or none at all', () => {
  const deep = (depth: number): unknown => (depth === 0 ? 1 : { a: deep(depth - 1) });
  const ring: Record<string, unknown> = {};
  ring['ring'] = ring;
  // The same list a hundred times in a list, six times over: small to send, 10^12 numbers to visit.
  let wide: unknown = Array(100).fill(1);
  for (let i = 0; i < 6; i += 1) wide = Array(100).fill(wide);
  const hostile: readonly unknown[] = [
    deep(9),
    ring,
    wide,
    new Array(4_000_000_000),
    'x'.repeat(70_000),
    { ['k'.repeat(70_000)]: 1 },
    NaN,
    1n,
    new Map([[1, 2]]),
    new Date(),
    new Uint8Array(8),
    () => 1,
  ];
  for (const message of hostile)
    assert.match(refusal(request({ do: 'publish', topic: '/a', type: 'a/msg/B', message })), /R2W0750: the message is not a plain value/);
  const own = JSON.parse('{"__proto__": {"polluted": 1}}') as object;
  const order = readRequest(request({ do: 'publish', topic: '/a', type: 'a/msg/B', message: own }))?.order;
  assert.ok(order !== undefined && !(order instanceof Refusal));
  assert.equal(Reflect.get({}, 'polluted'), undefined);
  assert.deepEqual(readJson({ a: [1, 'two', null] }, 100), { a: [1, 'two', null] });
});

test('who may act', () => {
  const own = 'https://site.org';
  assert.equal(mayAct('https://site.org', own, []), true);
  assert.equal(mayAct('https://course.org', own, []), false);
  assert.equal(mayAct('https://course.org', own, ['https://course.org']), true);
  for (const near of ['https://course.org.evil.org', 'http://course.org', 'https://course.org:8443', 'https://COURSE.org', ''])
    assert.equal(mayAct(near, own, ['https://course.org']), false, near);
  // Pages from disk and in sandboxes all have the origin `null`.
  assert.equal(mayAct('null', 'null', ['null']), false);
  assert.equal(mayAct('null', own, ['*']), true);
  assert.deepEqual((['hello', 'state', 'checks', 'run_checks'] as const).map((word) => isReading({ do: word })), [true, true, false, false]);
});

test('an allowance is used up and comes back', () => {
  const allowance = new Allowance(3, 10, 0);
  assert.deepEqual([0, 0, 0, 0].map((now) => allowance.take(now)), [true, true, true, false]);
  assert.equal(allowance.take(50), false);
  assert.deepEqual([200, 200, 200].map((now) => allowance.take(now)), [true, true, false]);
  // A clock that goes back gives nothing.
  assert.equal(allowance.take(100), false);
});
