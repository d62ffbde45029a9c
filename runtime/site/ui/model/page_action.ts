// Links that act, in the text of a lab sheet: `ros2wasm:open?panel=plot&paths=/odom.pose.pose.position.x`,
// `ros2wasm:start?node=talker` and its like; docs/page.md lists them. Pure: what they mean.

import type { Json } from './json.ts';

export type PageAction =
  | { readonly kind: 'open'; readonly panel: string; readonly state: Json; }
  | { readonly kind: 'start' | 'stop' | 'restart'; readonly node: string; }
  | { readonly kind: 'set_param'; readonly node: string; readonly name: string; readonly value: string; }
  | { readonly kind: 'publish'; readonly topic: string; readonly type: string; readonly value: string; }
  /** Without a type: as the graph has it. */
  | { readonly kind: 'call' | 'goal'; readonly name: string; readonly type: string; readonly value: string; }
  /** The title of the checks; empty: all. */
  | { readonly kind: 'check'; readonly name: string; }
  /** A line to type in the terminal. */
  | { readonly kind: 'run'; readonly line: string; }
  | { readonly kind: 'pause' | 'resume'; }
  | { readonly kind: 'step'; readonly ms: number; };

const SCHEME = 'ros2wasm:';
const MOST_LENGTH = 8_192;
const STEP_MS = 100;
const MOST_STEP_MS = 3_600_000;

export function isPageAction(href: string): boolean {
  return href.toLowerCase().startsWith(SCHEME);
}

/** null for one that means nothing. */
export function readPageAction(href: string): PageAction | null {
  if (!isPageAction(href) || href.length > MOST_LENGTH) return null;
  const text = href.slice(SCHEME.length);
  const mark = text.indexOf('?');
  const name = mark === -1 ? text : text.slice(0, mark);
  const fields = new URLSearchParams(mark === -1 ? '' : text.slice(mark + 1));
  const field = (key: string): string => fields.get(key) ?? '';
  switch (name) {
    case 'open': {
      const panel = field('panel');
      fields.delete('panel');
      return panel === '' ? null : { kind: 'open', panel, state: stateOf(fields) };
    }
    case 'start':
    case 'stop':
    case 'restart':
      return field('node') === '' ? null : { kind: name, node: field('node') };
    case 'set_param': {
      const action = { node: field('node'), name: field('name'), value: field('value') };
      return action.node === '' || action.name === '' || !fields.has('value') ? null : { kind: 'set_param', ...action };
    }
    case 'publish': {
      const action = { topic: field('topic'), type: field('type'), value: field('value') };
      return action.topic === '' || action.type === '' ? null : { kind: 'publish', ...action };
    }
    case 'call':
    case 'goal':
      return field('name') === '' ? null : { kind: name, name: field('name'), type: field('type'), value: field('value') };
    case 'check':
      return { kind: 'check', name: field('name') };
    case 'run': {
      const line = field('line').trim();
      // One line: what stands behind the end of one would be run unseen.
      return line === '' || /\p{Cc}/u.test(line) ? null : { kind: 'run', line };
    }
    case 'pause':
    case 'resume':
      return { kind: name };
    case 'step': {
      const ms = fields.has('ms') ? Number(field('ms')) : STEP_MS;
      return ms > 0 && ms <= MOST_STEP_MS ? { kind: 'step', ms } : null;
    }
    default:
      return null;
  }
}

/** Fields as a panel's state: numbers and flags as such, what is named twice as a list; null without any. */
function stateOf(fields: URLSearchParams): Json {
  const state: Record<string, Json> = {};
  for (const key of new Set(fields.keys())) {
    if (key === '__proto__') continue;
    const values = fields.getAll(key).map(valueOf);
    state[key] = values.length === 1 ? (values[0] ?? null) : values;
  }
  return Object.keys(state).length === 0 ? null : state;
}

function valueOf(text: string): Json {
  if (text === 'true' || text === 'false') return text === 'true';
  return /^-?\d{1,15}(\.\d{1,15})?$/.test(text) ? Number(text) : text;
}
