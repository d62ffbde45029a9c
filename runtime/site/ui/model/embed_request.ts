// The requests that a page that shows this one in a frame may send by postMessage (docs/page.md), and their limits. They are
// hostile: each is either one object of a known shape, bounded in size and depth, or it is refused. Pure.

import type { DiagnosticCode } from '../../contract/diagnostic_codes.ts';
import { embedTexts } from '../texts_embed.ts';
import { isRecord, member, numberMember, readJson } from './json.ts';
import type { Json } from './json.ts';

const words = embedTexts.refusals;

export const EMBED_VERSION = 1;

const MOST_SIZE = 65_536;
const MOST_NAME = 256;
const MOST_WAIT_MS = 600_000;
/** Messages of a topic in a second. */
const USUAL_RATE = 30;
const MOST_RATE = 60;
const COMMANDS = 'hello, state, height, watch, checks, run_checks, tasks, start, stop, restart, publish, set_parameter, subscribe, unsubscribe, call';

/** Why a request is not followed, in the form of every failure (model/problem.ts). */
export class Refusal extends Error {
  readonly code: DiagnosticCode;
  readonly fix: string;
  readonly why: string;

  constructor(code: DiagnosticCode, message: string, fix: string, why = '') {
    super(message);
    this.code = code;
    this.fix = fix;
    this.why = why;
  }
}

export type EmbedId = string | number;

export type EmbedOrder =
  | { readonly do: 'hello' | 'state' | 'height' | 'checks' | 'tasks'; }
  | { readonly do: 'watch'; readonly on: boolean; }
  /** null: all nodes. */
  | { readonly do: 'start' | 'stop' | 'restart'; readonly node: string | null; }
  | { readonly do: 'publish'; readonly topic: string; readonly type: string; readonly message: Json; }
  | { readonly do: 'set_parameter'; readonly node: string; readonly name: string; readonly value: Json; }
  | { readonly do: 'subscribe'; readonly topic: string; readonly rate: number; }
  | { readonly do: 'unsubscribe'; readonly subscription: number; }
  | { readonly do: 'call'; readonly service: string; readonly type: string; readonly request: Json; readonly timeoutMs: number; }
  | { readonly do: 'run_checks'; };

export interface EmbedRequest {
  readonly id: EmbedId;
  /** Or why it is none. */
  readonly order: EmbedOrder | Refusal;
}

/** Those that any page may give: they tell no more than the site's files do, but which of its nodes run here. */
const READING: ReadonlySet<EmbedOrder['do']> = new Set(['hello', 'state', 'height', 'watch']);

export function isReading(order: EmbedOrder): boolean {
  return READING.has(order.do);
}

/** null for what is not for us: other scripts send messages too. */
export function readRequest(data: unknown): EmbedRequest | null {
  const id = member(data, 'id');
  if (!isRecord(data) || !Object.hasOwn(data, 'ros2wasm')) return null;
  const named = (typeof id === 'string' && id.length <= 64) || Number.isSafeInteger(id);
  if (!named) return null;
  return { id: id as EmbedId, order: readOrder(data) };
}

function readOrder(data: Readonly<Record<string, unknown>>): EmbedOrder | Refusal {
  if (data['ros2wasm'] !== EMBED_VERSION)
    return refused(words.version(EMBED_VERSION));
  // Before anything is looked at: what is too large or too deep is not read.
  const request = readJson(data, MOST_SIZE);
  if (request === undefined) return refused(words.form(MOST_SIZE));
  const what = member(request, 'do');
  const name = (key: string): string => nameOf(request, key);
  try {
    switch (what) {
      case 'hello':
      case 'state':
      case 'height':
      case 'checks':
      case 'run_checks':
      case 'tasks':
        return { do: what };
      case 'watch':
        return { do: what, on: member(request, 'on') !== false };
      case 'start':
      case 'stop':
      case 'restart':
        return { do: what, node: Object.hasOwn(request as object, 'node') ? name('node') : null };
      case 'publish':
        return { do: what, topic: name('topic'), type: name('type'), message: fields(request, 'message') };
      case 'set_parameter':
        return { do: what, node: name('node'), name: name('name'), value: given(request, 'value') };
      case 'subscribe':
        return { do: what, topic: name('topic'), rate: numberMember(request, 'rate', 0.01, MOST_RATE, USUAL_RATE) };
      case 'unsubscribe':
        return { do: what, subscription: numberMember(request, 'subscription', 0, Number.MAX_SAFE_INTEGER, -1) };
      case 'call':
        return {
          do: what,
          service: name('service'),
          type: name('type'),
          request: fields(request, 'request'),
          timeoutMs: numberMember(request, 'timeout_ms', 1, MOST_WAIT_MS, 10_000),
        };
      default:
        return refused(words.command(typeof what === 'string' ? what.slice(0, 40) : undefined, COMMANDS));
    }
  } catch (error) {
    if (error instanceof Refusal) return error;
    throw error;
  }
}

function refused([message, fix]: readonly [string, string]): Refusal {
  return new Refusal('R2W0750', message, fix);
}

function nameOf(request: Json, key: string): string {
  const found = member(request, key);
  if (typeof found === 'string' && found !== '' && found.length <= MOST_NAME) return found;
  throw refused(words.name(key, MOST_NAME));
}

function given(request: Json, key: string): Json {
  const found = member(request, key);
  if (found !== undefined) return found as Json;
  throw refused(words.missing(key));
}

function fields(request: Json, key: string): Json {
  const found = member(request, key) ?? {};
  if (isRecord(found)) return found as Json;
  throw refused(words.fields(key));
}

export function mayAct(origin: string, own: string, listed: readonly string[]): boolean {
  if (listed.includes('*')) return true;
  // All pages without an origin share the word `null`.
  return origin !== 'null' && (origin === own || listed.includes(origin));
}

/** So many at once, and so many a second in the long run. */
export class Allowance {
  private readonly most: number;
  private readonly perSecond: number;
  private left: number;
  private at: number;

  constructor(most: number, perSecond: number, nowMs: number) {
    this.most = most;
    this.perSecond = perSecond;
    this.left = most;
    this.at = nowMs;
  }

  take(nowMs: number): boolean {
    this.left = Math.min(this.most, this.left + (Math.max(0, nowMs - this.at) / 1000) * this.perSecond);
    this.at = nowMs;
    if (this.left < 1) return false;
    this.left -= 1;
    return true;
  }
}
