// The visitor's gamepads for nodes: layouts, numbers, and a desk that reads a browser's gamepads while nodes wait for them.

// Compatibility, differs: joy: the order of axes and buttons -> that of an Xbox gamepad, if the browser knows the gamepad's layout; others
// come as the browser lists them

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { TopicView } from '../../../runtime/site/contract/session.ts';
import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { atRest, frameOf, gamepadNumbers, joyReading, RUMBLE_TOPIC, wantedGamepads } from '../../../runtime/site/ui/model/gamepads.ts';
import { gamepadDesk } from '../../../runtime/site/ui/parts/gamepad_desk.ts';
import type { DeskGamepad, GamepadWorld } from '../../../runtime/site/ui/parts/gamepad_desk.ts';
import { FakeSession } from './fake_session.ts';

const JOY = 'sensor_msgs/msg/Joy';
const FEEDBACK = 'sensor_msgs/msg/JoyFeedback';
const interfaces = new Map([
  [JOY, 'std_msgs/Header header\nfloat32[] axes\nint32[] buttons\n'],
  [FEEDBACK, 'uint8 TYPE_RUMBLE=1\nuint8 type\nuint8 id\nfloat32 intensity\n'],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
]);
const codec = createCodec(interfaces);

const topic = (name: string, subscriptions = 1, type = JOY) =>
  ({
    name,
    type,
    subscriptions,
    publishers: 0,
    qos: [{ reliability: 'reliable', durability: 'volatile', history: 'keep_last', depth: 10 }],
  }) as unknown as TopicView;

interface Held {
  readonly axes?: readonly number[];
  /** Values by the buttons' indexes. */
  readonly buttons?: Readonly<Record<number, number>>;
  readonly mapping?: string;
  readonly index?: number;
  readonly id?: string;
}

function pad({ axes = [0, 0, 0, 0], buttons = {}, mapping = 'standard', index = 0, id = 'Pad' }: Held = {}): DeskGamepad {
  const all = Array.from({ length: 18 }, (_, each) => ({ value: buttons[each] ?? 0, pressed: (buttons[each] ?? 0) > 0.5 }));
  return { id, index, mapping, axes, buttons: all, connected: true };
}

test('gamepads are wanted while somebody subscribes', () => {
  const names = wantedGamepads([
    topic('/_gamepad/joystick_0'),
    topic('/_gamepad/controller_3'),
    topic('/_gamepad/joystick_1', 0),
    topic('/_gamepad/joystick_2', 1, 'std_msgs/msg/String'),
    topic('/_gamepad/joystick_4'),
    topic('/_gamepad/rumble'),
    topic('/joy'),
  ]);
  assert.deepEqual(names, [
    { topic: '/_gamepad/joystick_0', layout: 'joystick', number: 0 },
    { topic: '/_gamepad/controller_3', layout: 'controller', number: 3 },
  ]);
});

test('a standard gamepad is an Xbox gamepad to joy_node', () => {
  const rest = joyReading(pad(), 'joystick');
  assert.deepEqual(rest, { axes: [0, 0, -1, 0, 0, -1, 0, 0], buttons: Array(11).fill(0) });
  const held = joyReading(pad({ axes: [-1, -0.5, 0.25, 1], buttons: { 6: 0.5, 7: 1, 12: 1, 14: 1 } }), 'joystick');
  assert.deepEqual(held?.axes, [-1, -0.5, 0, 0.25, 1, 1, -1, -1]);
  const order = [0, 1, 2, 3, 4, 5, 8, 9, 16, 10, 11];
  for (const [place, index] of order.entries())
    assert.equal(joyReading(pad({ buttons: { [index]: 1 } }), 'joystick')?.buttons.indexOf(1), place, `button ${index}`);
});

test('a standard gamepad has the order of SDL to game_controller_node', () => {
  const held = joyReading(pad({ axes: [-1, -0.5, 0.25, 1], buttons: { 6: 0.5, 7: 1 } }), 'controller');
  assert.deepEqual(held, { axes: [-1, -0.5, 0.25, 1, 0.5, 1], buttons: Array(21).fill(0) });
  const order = [0, 1, 2, 3, 8, 16, 9, 10, 11, 4, 5, 12, 13, 14, 15];
  for (const [place, index] of [...order.entries(), [20, 17] as const])
    assert.equal(joyReading(pad({ buttons: { [index]: 1 } }), 'controller')?.buttons.indexOf(1), place, `button ${index}`);
});

test('other gamepads are read as they are, and are no game controllers', () => {
  const wheel = pad({ mapping: '', axes: [0.5, -1, 3.2857], buttons: { 2: 1 } });
  assert.deepEqual(joyReading(wheel, 'joystick')?.axes, [0.5, -1, 3.2857]);
  assert.equal(joyReading(wheel, 'joystick')?.buttons.indexOf(1), 2);
  assert.equal(joyReading(wheel, 'controller'), undefined);
  assert.deepEqual(joyReading(atRest(wheel), 'joystick'), { axes: [0, 0, 0], buttons: Array(18).fill(0) });
});

test('a gamepad keeps its number while others come and go', () => {
  const first = gamepadNumbers(new Map(), [2, 5]);
  assert.deepEqual([...first], [[2, 0], [5, 1]]);
  const second = gamepadNumbers(first, [5]);
  assert.deepEqual([...second], [[5, 1]]);
  assert.deepEqual([...gamepadNumbers(second, [0, 5])], [[5, 1], [0, 0]]);
  assert.equal(frameOf('x'.repeat(999), true).length, 'rumble '.length + 200);
});

/** A browser with these gamepads, whose frames a test draws. */
class FakeWorld implements GamepadWorld {
  pads: (DeskGamepad | null)[] = [];
  used = true;
  reads = 0;
  private frame: (() => void) | undefined;
  private changed: (() => void) | undefined;

  readonly gamepads = (): readonly (DeskGamepad | null)[] => {
    this.reads += 1;
    return this.pads;
  };
  readonly isInUse = (): boolean => this.used;
  readonly nextFrame = (callback: () => void): () => void => {
    this.frame = callback;
    return () => {
      this.frame = undefined;
    };
  };
  readonly onChange = (listener: () => void): () => void => {
    this.changed = listener;
    return () => {
      this.changed = undefined;
    };
  };

  get polls(): boolean {
    return this.frame !== undefined;
  }

  draw(pads: (DeskGamepad | null)[] = this.pads): void {
    this.pads = pads;
    const frame = this.frame;
    this.frame = undefined;
    frame?.();
  }

  change(pads: (DeskGamepad | null)[] = this.pads): void {
    this.pads = pads;
    this.changed?.();
  }
}

interface Played {
  readonly session: FakeSession;
  readonly world: FakeWorld;
  /** Axes, or axes and buttons that are pressed, of the messages since the last call. */
  readonly heard: () => Promise<unknown[]>;
}

async function withDesk(use: (played: Played) => Promise<void>): Promise<void> {
  const session = new FakeSession({ nodes: [], interfaces });
  const world = new FakeWorld();
  const messages: unknown[] = [];
  const subscription = session.node().subscription('/_gamepad/joystick_0', JOY, { durability: 'transient_local', depth: 100 }, (bytes, _info) => {
    const decoded = codec.decode(JOY, bytes);
    assert.equal(decoded.kind, 'value');
    const { header, axes, buttons } = (decoded as { readonly value: Readonly<Record<string, never>>; }).value as unknown as {
      readonly header: { readonly frame_id: string; };
      readonly axes: Float32Array;
      readonly buttons: Int32Array;
    };
    messages.push([header.frame_id, [...axes].join(' '), [...buttons].flatMap((each, index) => (each === 0 ? [] : [index])).join(' ')]);
  });
  const desk = gamepadDesk(session, codec, world);
  try {
    await use({
      session,
      world,
      heard: async () => {
        await new Promise((done) => setTimeout(done));
        return messages.splice(0);
      },
    });
  } finally {
    desk.close();
    subscription.close();
  }
}

const REST = '0 0 -1 0 0 -1 0 0';
const wish = [topic('/_gamepad/joystick_0')];

test('a desk reads no gamepad before a node waits for it, and while there is none only on events', () =>
  withDesk(async ({ session, world, heard }) => {
    world.change([pad()]);
    assert.equal(world.reads, 0);
    world.pads = [];
    session.setTopics(wish);
    assert.equal(world.reads, 1);
    assert.equal(world.polls, false);
    assert.deepEqual(await heard(), []);
    world.change([null, pad({ index: 1 })]);
    assert.equal(world.polls, true);
    assert.deepEqual(await heard(), [['still Pad', REST, '']]);
  }));

test('a desk sends changes only, and stops when nobody subscribes', () =>
  withDesk(async ({ session, world, heard }) => {
    world.pads = [pad()];
    session.setTopics(wish);
    world.draw();
    world.draw([pad({ axes: [0, -1, 0, 0], buttons: { 2: 1 } })]);
    world.draw();
    assert.deepEqual(await heard(), [['still Pad', REST, ''], ['still Pad', '0 -1 -1 0 0 -1 0 0', '2']]);
    session.setTopics([]);
    world.draw([pad()]);
    assert.equal(world.polls, false);
    assert.deepEqual(await heard(), []);
  }));

test('a gamepad comes to rest when the page is left, and before it goes', () =>
  withDesk(async ({ session, world, heard }) => {
    world.pads = [pad({ axes: [1, 0, 0, 0] })];
    session.setTopics(wish);
    world.used = false;
    world.change();
    assert.equal(world.polls, false);
    assert.deepEqual(await heard(), [['still Pad', '1 0 -1 0 0 -1 0 0', ''], ['still Pad', REST, '']]);
    world.used = true;
    world.change();
    world.change([]);
    assert.deepEqual(await heard(), [['still Pad', '1 0 -1 0 0 -1 0 0', ''], ['still Pad', REST, ''], ['still Pad', '', '']]);
    world.change([pad({ id: 'Other' })]);
    world.draw([pad({ id: 'Third', index: 0 })]);
    assert.deepEqual(await heard(), [['still Other', REST, ''], ['still Other', '', ''], ['still Third', REST, '']]);
  }));

test('a page whose frame forbids gamepads has none', () =>
  withDesk(async ({ session, world, heard }) => {
    Object.assign(world, {
      gamepads: () => {
        throw new DOMException('forbidden', 'SecurityError');
      },
    });
    session.setTopics(wish);
    assert.equal(world.polls, false);
    assert.deepEqual(await heard(), []);
  }));

test('a gamepad rumbles for a second, the one that is meant', () =>
  withDesk(async ({ session, world, heard }) => {
    const effects: unknown[] = [];
    const vibrationActuator = {
      playEffect: (...effect: unknown[]) => {
        effects.push(effect);
        return Promise.reject(new Error('is not shown'));
      },
    };
    world.pads = [{ ...pad(), vibrationActuator }, { ...pad({ index: 1 }), vibrationActuator: null }];
    const motor = session.node().publisher(RUMBLE_TOPIC, FEEDBACK);
    session.setTopics([...wish, { ...topic(RUMBLE_TOPIC, 0, FEEDBACK), publishers: 1 }]);
    assert.deepEqual(await heard(), [['rumble Pad', REST, '']]);
    for (const [id, intensity] of [[0, 0.5], [1, 1], [7, 1]] as const) {
      const encoded = codec.encode(FEEDBACK, { type: 1, id, intensity });
      assert.equal(encoded.kind, 'bytes');
      if (encoded.kind === 'bytes') motor.publish(encoded.bytes);
    }
    await heard();
    assert.deepEqual(effects, [['dual-rumble', { duration: 1000, strongMagnitude: 0.5, weakMagnitude: 0.5 }]]);
    motor.close();
  }));
