// The states of managed nodes as the page follows them: of one that answers late, and while a transition is made.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { LifecycleStore } from '../../../runtime/site/ui/parts/lifecycle_store.ts';
import type { GraphView, Session } from '../../../runtime/site/contract/session.ts';

const codec = createCodec(new Map([
  ['lifecycle_msgs/msg/State', 'uint8 id\nstring label\n'],
  ['lifecycle_msgs/msg/Transition', 'uint8 id\nstring label\n'],
  ['lifecycle_msgs/msg/TransitionDescription', 'Transition transition\nState start_state\nState goal_state\n'],
  ['lifecycle_msgs/srv/GetState', '---\nState current_state\n'],
  ['lifecycle_msgs/srv/GetAvailableTransitions', '---\nTransitionDescription[] available_transitions\n'],
  ['lifecycle_msgs/srv/ChangeState', 'Transition transition\n---\nbool success\n'],
]));
const watchdog = { timeout: 60_000 };
const configure = { id: 1, label: 'configure' };
const inactive = { id: 2, label: 'inactive' };

interface Call {
  readonly service: string;
  answer(value: unknown): void;
  fail(words: string): void;
}

/** A graph with one managed node, whose answers a test gives. */
function slowNode() {
  const calls: Call[] = [];
  const timers = new Set<() => void>();
  let event: () => void = () => undefined;
  const graph = {
    nodes: [{ name: '/driver', services: [{ name: '/driver/get_state', gid: 'a' }] }],
  } as unknown as GraphView;
  const node = {
    subscription: (_topic: string, _type: string, _qos: unknown, listener: (bytes: Uint8Array) => void) => {
      event = () => listener(new Uint8Array());
      return { close: () => undefined };
    },
    client: (service: string, type: string) => ({
      call: () =>
        new Promise<Uint8Array>((resolve, reject) => {
          calls.push({
            service: service.slice('/driver/'.length),
            answer(value) {
              const made = codec.encode(`${type}_Response`, value);
              assert.ok(made.kind !== 'failed');
              resolve(made.bytes);
            },
            fail: (words) => reject(new Error(words)),
          });
        }),
      close: () => undefined,
    }),
    timer: (_ms: number, ring: () => void) => {
      timers.add(ring);
      return { close: () => timers.delete(ring) };
    },
  };
  const session = { graph: () => graph, onGraph: () => () => undefined, node: () => node } as unknown as Session;
  /** Until the store has asked for these, and no others. */
  const asked = async (...services: readonly string[]): Promise<readonly Call[]> => {
    while (calls.length < services.length)
      await new Promise((next) => {
        setImmediate(next);
      });
    const all = calls.splice(0);
    assert.deepEqual(all.map(({ service }) => service), services);
    return all;
  };
  return { session, calls, timers, asked, event: () => event() };
}

const BOTH = ['get_state', 'get_available_transitions'] as const;

test('a state that could not be read is told until it is read, which is tried again', watchdog, async () => {
  const { session, timers, asked } = slowNode();
  const store = new LifecycleStore(session, codec, () => undefined);
  for (const call of await asked(...BOTH)) call.fail('no answer in time');
  const shown = () => store.nodes()[0] ?? assert.fail();
  while (shown().unread === '')
    await new Promise((next) => {
      setImmediate(next);
    });
  assert.equal(shown().unread, 'no answer in time');
  assert.equal(timers.size, 1);
  for (const ring of [...timers]) ring();
  const [state, transitions] = await asked(...BOTH);
  state?.answer({ current_state: inactive });
  transitions?.answer({ available_transitions: [] });
  while (shown().state === null)
    await new Promise((next) => {
      setImmediate(next);
    });
  assert.deepEqual([shown().unread, shown().problem, shown().state?.label, timers.size], ['', '', 'inactive', 0]);
  store.close();
});

test('while a transition is made nothing is read, and what was being read counts no more; then all is read once', watchdog, async () => {
  const { session, calls, timers, asked, event } = slowNode();
  const store = new LifecycleStore(session, codec, () => undefined);
  const early = await asked(...BOTH);
  const changed = store.change('/driver', configure);
  const [change] = await asked('change_state');
  for (const call of early) call.fail('no answer in time');
  event();
  event();
  await new Promise((next) => {
    setImmediate(next);
  });
  assert.deepEqual([calls.length, timers.size, store.nodes()[0]?.unread], [0, 0, '']);
  change?.answer({ success: false });
  const words = await changed;
  assert.notEqual(words, '');
  const [state, transitions] = await asked(...BOTH);
  state?.answer({ current_state: inactive });
  transitions?.answer({ available_transitions: [] });
  while (store.nodes()[0]?.state === null)
    await new Promise((next) => {
      setImmediate(next);
    });
  // Why the transition was not made stays.
  assert.equal(store.nodes()[0]?.problem, words);
  store.close();
});

test('a store that is closed tries nothing again', watchdog, async () => {
  const { session, timers, asked } = slowNode();
  const store = new LifecycleStore(session, codec, () => undefined);
  for (const call of await asked(...BOTH)) call.fail('no answer in time');
  while (timers.size === 0)
    await new Promise((next) => {
      setImmediate(next);
    });
  store.close();
  assert.equal(timers.size, 0);
});
