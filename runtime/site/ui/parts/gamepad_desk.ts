// Publishes the state of the visitor's gamepads while nodes wait for it: on change only, read once per frame, and at rest
// while the page is not in use. Rumbles on request.

import type { PagePublisher, Session, TopicView } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { atRest, frameOf, gamepadNumbers, JOY, joyReading, RUMBLE_TOPIC, wantedGamepads } from '../model/gamepads.ts';
import type { GamepadReading, GamepadWish, JoyReading } from '../model/gamepads.ts';
import { numberMember } from '../model/json.ts';
import { feed } from './message_feed.ts';

/** As upstream has it. */
const RUMBLE_MS = 1000;

/** A Gamepad, as far as it is used here. */
export interface DeskGamepad extends GamepadReading {
  readonly index: number;
  readonly connected: boolean;
  readonly vibrationActuator?: RumbleActuator | null;
}

interface RumbleActuator {
  playEffect?(type: 'dual-rumble', effect: Readonly<Record<string, number>>): Promise<unknown>;
}

/** The browser, as far as it is used here. */
export interface GamepadWorld {
  /** Throws where a frame around the page forbids gamepads. */
  readonly gamepads: () => readonly (DeskGamepad | null)[];
  /** The visitor uses this page. */
  readonly isInUse: () => boolean;
  readonly nextFrame: (callback: () => void) => () => void;
  /** Calls when a gamepad comes or goes, and when the page comes into use or leaves it. */
  readonly onChange: (listener: () => void) => () => void;
}

export function browserWorld(): GamepadWorld {
  return {
    gamepads: () => navigator.getGamepads(),
    isInUse: () => document.hasFocus() && document.visibilityState === 'visible',
    nextFrame: (callback) => {
      const frame = requestAnimationFrame(callback);
      return () => cancelAnimationFrame(frame);
    },
    onChange: (listener) => {
      const ends = [...['gamepadconnected', 'gamepaddisconnected', 'focus', 'blur'].map((name) => heard(window, name, listener)),
        heard(document, 'visibilitychange', listener)];
      return () => ends.forEach((end) => end());
    },
  };
}

function heard(target: EventTarget, name: string, listener: () => void): () => void {
  target.addEventListener(name, listener);
  return () => target.removeEventListener(name, listener);
}

interface Connected {
  readonly pad: DeskGamepad;
  readonly number: number;
}

/** The publisher for one wish. It stays open while no gamepad is there: its last message must arrive. */
interface Sender {
  readonly wish: GamepadWish;
  readonly publisher: PagePublisher;
  /** undefined: nothing was published, or that the gamepad is gone. */
  shown: Shown | undefined;
}

interface Shown {
  readonly frame: string;
  readonly pad: GamepadReading;
  /** The axes and buttons, as text. */
  readonly sent: string;
}

export interface GamepadDesk {
  readonly close: () => void;
}

export function gamepadDesk(session: Session, codec: Codec, world: GamepadWorld = browserWorld()): GamepadDesk {
  const senders = new Map<string, Sender>();
  let numbers: ReadonlyMap<number, number> = new Map();
  let cancel: (() => void) | undefined;

  const connected = (): readonly Connected[] => {
    let pads: readonly DeskGamepad[];
    try {
      pads = world.gamepads().flatMap((pad) => (pad?.connected === true ? [pad] : []));
    } catch {
      pads = [];
    }
    numbers = gamepadNumbers(numbers, pads.map(({ index }) => index));
    return pads.map((pad) => ({ pad, number: numbers.get(pad.index) ?? 0 }));
  };
  const publish = ({ publisher }: Sender, frame: string, reading: JoyReading): void => {
    const encoded = codec.encode(JOY, { header: { frame_id: frame }, ...reading });
    if (encoded.kind === 'bytes') publisher.publish(encoded.bytes);
  };
  const show = (sender: Sender, frame: string, pad: GamepadReading): void => {
    const reading = joyReading(pad, sender.wish.layout);
    if (reading === undefined) return;
    const sent = JSON.stringify(reading);
    if (sent !== sender.shown?.sent) publish(sender, frame, reading);
    sender.shown = { frame, pad, sent };
  };
  const hide = (sender: Sender): void => {
    if (sender.shown === undefined) return;
    const { frame, pad } = sender.shown;
    // Robots stand still before the gamepad goes.
    show(sender, frame, atRest(pad));
    publish(sender, frame, { axes: [], buttons: [] });
    sender.shown = undefined;
  };
  const fulfill = (sender: Sender, pad: DeskGamepad, isInUse: boolean): void => {
    const frame = frameOf(pad.id, typeof pad.vibrationActuator?.playEffect === 'function');
    // Another one has its number.
    if (sender.shown?.frame !== frame) hide(sender);
    show(sender, frame, isInUse ? pad : atRest(pad));
  };
  const close = (topic: string): void => {
    senders.get(topic)?.publisher.close();
    senders.delete(topic);
  };
  const look = (): void => {
    cancel?.();
    cancel = undefined;
    if (senders.size === 0) return;
    const pads = connected();
    const isInUse = world.isInUse();
    for (const sender of senders.values()) {
      const found = pads.find(({ number }) => number === sender.wish.number);
      if (found === undefined) hide(sender);
      else fulfill(sender, found.pad, isInUse);
    }
    if (pads.length > 0 && isInUse) cancel = world.nextFrame(look);
  };
  const follow = (topics: readonly TopicView[]): void => {
    const wishes = wantedGamepads(topics);
    for (const topic of [...senders.keys()]) if (!wishes.some((wish) => wish.topic === topic)) close(topic);
    const fresh = wishes.filter(({ topic }) => !senders.has(topic));
    for (const wish of fresh) {
      const publisher = session.node().publisher(wish.topic, JOY, { durability: 'transient_local', depth: 1 });
      senders.set(wish.topic, { wish, publisher, shown: undefined });
    }
    if (fresh.length > 0) look();
  };
  follow(session.topics());
  const stopTopics = session.onTopics(follow);
  const stopEvents = world.onChange(look);
  const stopRumble = feed(session, codec, RUMBLE_TOPIC, ({ decoded }) => {
    if (decoded.kind === 'failed') return;
    const number = numberMember(decoded.value, 'id', 0, 255, 0);
    const strength = numberMember(decoded.value, 'intensity', 0, 1, 0);
    const actuator = connected().find((each) => each.number === number)?.pad.vibrationActuator;
    const effect = { duration: RUMBLE_MS, strongMagnitude: strength, weakMagnitude: strength };
    actuator?.playEffect?.('dual-rumble', effect).catch(() => undefined);
  });
  return {
    close: () => {
      cancel?.();
      stopTopics();
      stopEvents();
      stopRumble();
      for (const topic of [...senders.keys()]) close(topic);
    },
  };
}
