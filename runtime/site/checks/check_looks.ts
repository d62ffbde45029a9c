// How each kind of check looks at a running site. A look calls `met` once it has seen what must be seen; what it saw
// later than the time allows does not count.

import type { Codec } from '../decode/codec.ts';
import { hertz, meets, plainLine, shown, valueAt } from './check_words.ts';
import type { ConsoleLine, NodeState, Session } from '../contract/session.ts';
import { unreachable } from '../contract/session.ts';
import type { CheckAim } from '../contract/site_checks.ts';

export interface Look {
  /** Called at each beat of the site's time, and when the time is over. */
  look(): void;
  /** The observations so far, in words. */
  seen(): string;
  close(): void;
}

export interface LookPlace {
  readonly session: Session;
  readonly codec: Codec;
  /** Is a time of the site, ms, from the begin on and not too late? */
  readonly inTime: (atMs: number) => boolean;
  /** Seen. */
  readonly met: (seen: string) => void;
}

type Aim<Kind extends CheckAim['kind']> = Extract<CheckAim, { readonly kind: Kind; }>;

/** A rate is that over at least so much. */
const leastMs = 1000;
const mostPoints = 1000;
/** Messages that wait until their type is known. */
const mostPending = 256;
/** As they come, from publishers of all kinds. */
const anyQos = { reliability: 'best_effort', depth: 1000 } as const;

export function startLook(aim: CheckAim, place: LookPlace): Look {
  switch (aim.kind) {
    case 'rate':
      return aim.above === undefined && aim.below === undefined ? anyMessageLook(aim, place) : rateLook(aim, place);
    case 'message':
      return messageLook(aim, place);
    case 'log':
      return logLook(aim, place);
    case 'parameter':
      return parameterLook(aim, place);
    case 'state':
    case 'exit_code':
      return stateLook(aim, place);
    default:
      return unreachable(aim);
  }
}

function anyMessageLook({ topic }: Aim<'rate'>, { session, inTime, met }: LookPlace): Look {
  const subscription = session.node().subscription(topic, '', anyQos, (bytes, { publishedAt }) => {
    if (inTime(publishedAt)) met(`a message of ${bytes.length} bytes`);
  });
  return { look: () => undefined, seen: () => subscription.problem?.message ?? 'no message', close: () => subscription.close() };
}

function rateLook({ topic, above, below }: Aim<'rate'>, { session, inTime, met }: LookPlace): Look {
  const points: { readonly count: number; readonly time: number; }[] = [];
  let rate: number | undefined;
  return {
    look: () => {
      session.topics();
      const last = session.lastMessage(topic);
      if (last === undefined || last.count === points.at(-1)?.count || !inTime(last.receivedAt)) return;
      points.push({ count: last.count, time: last.receivedAt });
      if (points.length > mostPoints) points.shift();
      const from = points.findLast(({ time }) => time <= last.receivedAt - leastMs);
      if (from === undefined) return;
      rate = (last.count - from.count) / (last.receivedAt - from.time) * 1000;
      if ((above === undefined || rate > above) && (below === undefined || rate < below)) met(hertz(rate));
    },
    seen: () => {
      if (rate !== undefined) return hertz(rate);
      const count = points.at(-1)?.count ?? 0;
      return count === 0 ? 'no message' : `${count} message${count === 1 ? '' : 's'}, none a second later`;
    },
    close: () => undefined,
  };
}

function messageLook({ topic, field, value: wanted }: Aim<'message'>, { session, codec, inTime, met }: LookPlace): Look {
  let type: string | undefined;
  let last = 'no message';
  let pending: Uint8Array[] = [];
  const typeOf = (): string | undefined => {
    for (const { publishers } of session.graph().nodes) {
      const found = publishers.find(({ name }) => name === topic);
      if (found !== undefined) return found.type;
    }
    return session.topics().find(({ name }) => name === topic)?.type;
  };
  const judge = (bytes: Uint8Array, of: string): void => {
    const decoded = codec.decode(of, bytes);
    if (decoded.kind === 'failed') {
      last = decoded.reason;
      return;
    }
    const value = valueAt(decoded.value, field);
    last = value === undefined
      ? `a message of type ${of} without ${field}`
      : typeof value === 'object'
      ? `${field} is not a single value`
      : shown(value);
    if (value !== undefined && typeof value !== 'object' && meets(value, wanted)) met(last);
  };
  const look = (): void => {
    if (pending.length === 0) return;
    type ??= typeOf();
    if (type === undefined || type === '') {
      type = undefined;
      return;
    }
    const waiting = pending;
    pending = [];
    for (const bytes of waiting) judge(bytes, type);
  };
  const subscription = session.node().subscription(topic, '', anyQos, (bytes, { publishedAt }) => {
    if (!inTime(publishedAt)) return;
    pending.push(bytes);
    if (pending.length > mostPending) pending.shift();
    look();
  });
  return { look, seen: () => subscription.problem?.message ?? last, close: () => subscription.close() };
}

function logLook({ node, log }: Aim<'log'>, { session, inTime, met }: LookPlace): Look {
  const pattern = new RegExp(log, 'u');
  const consoles = session.nodes().filter(({ id }) => node === undefined || id === node).map(({ id }) => session.console(id));
  let count = 0;
  let last = '';
  const judge = (lines: readonly ConsoleLine[]): void => {
    for (const { time, text } of lines) {
      if (!inTime(time)) continue;
      count += 1;
      last = plainLine(text);
      if (pattern.test(last)) {
        met(shown(last));
        return;
      }
    }
  };
  const stops = consoles.map((console) => console.onLines(judge));
  // Counts all lines again: those printed before this look but within its time, and those of this frame, not reported yet.
  const look = (): void => {
    count = 0;
    for (const console of consoles) judge(console.lines());
  };
  return {
    look: () => undefined,
    seen: () => {
      look();
      return count === 0 ? 'no line' : `${count} line${count === 1 ? '' : 's'}, the last ${shown(last)}`;
    },
    close: () => {
      for (const stop of stops) stop();
    },
  };
}

/** By the constants of rcl_interfaces/msg/ParameterType; 0 is not set. */
const parameterFields = [
  undefined,
  'bool_value',
  'integer_value',
  'double_value',
  'string_value',
  'byte_array_value',
  'bool_array_value',
  'integer_array_value',
  'double_array_value',
  'string_array_value',
] as const;

/** A list is compared as a text: `[1, 2]`, `[1.0, 0.5]`, `[left, right]`. */
function parameterValue(field: string, value: unknown): unknown {
  if (!field.endsWith('_array_value')) return value;
  const item = (one: unknown): string => field === 'double_array_value' && Number.isInteger(one) ? `${String(one)}.0` : String(one);
  return `[${Array.from(value as ArrayLike<unknown>, item).join(', ')}]`;
}

function parameterLook({ node, parameter, value: wanted }: Aim<'parameter'>, { session, codec, inTime, met }: LookPlace): Look {
  const service = 'rcl_interfaces/srv/GetParameters';
  const client = session.node().client(`${node}/get_parameters`, service);
  const request = codec.encode(`${service}_Request`, { names: [parameter] });
  let asking = false;
  let closed = false;
  let last = 'no such node';
  const judge = (bytes: Uint8Array): void => {
    const reply = codec.decode(`${service}_Response`, bytes);
    const given = reply.kind === 'value' ? valueAt(reply.value, 'values[0]') : undefined;
    const kind = valueAt(given, 'type');
    const field = typeof kind === 'number' ? parameterFields[kind] : undefined;
    if (reply.kind === 'failed') last = reply.reason;
    else if (field === undefined) last = 'the node has no such parameter';
    else {
      const value = parameterValue(field, valueAt(given, field));
      last = shown(value);
      if (meets(value, wanted) && inTime(session.time.view().now)) met(last);
    }
  };
  return {
    look: () => {
      if (asking || closed || !client.ready()) return;
      if (request.kind === 'failed') {
        last = request.reason;
        return;
      }
      asking = true;
      client.call(request.bytes, { timeoutMs: 1000 }).then(
        (bytes) => {
          if (!closed) judge(bytes);
        },
        (error: unknown) => {
          last = error instanceof Error ? error.message : String(error);
        },
      ).finally(() => {
        asking = false;
      });
    },
    seen: () => client.problem?.message ?? last,
    close: () => {
      closed = true;
      client.close();
    },
  };
}

function stateLook(aim: Aim<'state'> | Aim<'exit_code'>, { session, inTime, met }: LookPlace): Look {
  let state: NodeState = { kind: 'stopped' };
  const look = (): void => {
    state = session.nodes().find(({ id }) => id === aim.node)?.state ?? state;
    if (inTime(session.time.view().now) && isThere(state)) met(stateWords(state));
  };
  const isThere = (now: NodeState): boolean => {
    if (aim.kind === 'exit_code') return now.kind === 'exited' && now.code === aim.exitCode;
    // A node that has ended was running before.
    return now.kind === aim.state || (aim.state === 'running' && now.kind === 'exited');
  };
  const stop = session.onNodes(look);
  return { look, seen: () => stateWords(state), close: stop };
}

function stateWords(state: NodeState): string {
  switch (state.kind) {
    case 'exited':
      return `it ended with code ${state.code}`;
    case 'crashed':
      return `it crashed: ${shown(state.message.split('\n', 1)[0] ?? '')}`;
    case 'running':
      return 'it runs';
    case 'starting':
      return 'it starts';
    case 'waiting':
      return `it waits for ${state.on.node}`;
    case 'stopped':
      return 'it does not run';
    default:
      return unreachable(state);
  }
}
