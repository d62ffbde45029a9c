// A message that somebody is writing: values that may not fit yet, `now` where a time is, and how it becomes bytes. Pure.

import type { Codec, Encoded, MessageValue } from '../../decode/codec.ts';
import type { Field, Shape } from '../../decode/shape.ts';
import { isList, isMessage } from '../../decode/yaml.ts';

export interface SiteStamp {
  readonly sec: number;
  readonly nanosec: number;
}

export function stampOf(ms: number): SiteStamp {
  const sec = Math.floor(ms / 1000);
  return { sec, nanosec: Math.min(999_999_999, Math.round((ms - sec * 1000) * 1e6)) };
}

/** The value of a number's text for its field; the text itself when it is not a number, so that the encoder refuses it. */
export function readNumber(text: string, type: string): unknown {
  const trimmed = text.trim();
  if (type.startsWith('float')) {
    const special = /^([-+]?)\.?(inf|infinity|nan)$/i.exec(trimmed);
    if (special !== null) return special[2]?.toLowerCase() === 'nan' ? NaN : special[1] === '-' ? -Infinity : Infinity;
    return /^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(trimmed) ? Number(trimmed) : text;
  }
  return /^[-+]?\d{1,20}$/.test(trimmed) ? BigInt(trimmed) : text;
}

export function numberText(value: unknown): string {
  return value === undefined || value === null ? '' : String(value);
}

/** `now` in fields that are times becomes this time. */
export function withNow(value: MessageValue, shape: Shape, now: SiteStamp): MessageValue {
  const item = (given: unknown, field: Field): unknown => {
    if (field.type === 'time' && given === 'now') return now;
    return field.shape !== null && isMessage(given) ? withNow(given, field.shape, now) : given;
  };
  return Object.fromEntries(
    Object.entries(value).map(([name, given]) => {
      const field = shape.find((each) => each.name === name);
      if (field === undefined) return [name, given];
      return [name, field.isArray && Array.isArray(given) ? given.map((each) => item(each, field)) : item(given, field)];
    }),
  );
}

/** A message as its definition begins, with what is `given` in it. */
export function onto(begin: MessageValue, given: Readonly<Record<string, unknown>>): MessageValue {
  return Object.fromEntries([
    ...Object.entries(begin).map(([name, value]): [string, unknown] => {
      const own = Object.hasOwn(given, name) ? given[name] : undefined;
      if (own === undefined) return [name, value];
      if (isMessage(value) && isMessage(own)) return [name, onto(value, own)];
      return [name, isList(own) ? Array.from(own) : own];
    }),
    // Unknown fields stay in the message, and are refused when it is sent.
    ...Object.entries(given).filter(([name]) => !Object.hasOwn(begin, name)),
  ]);
}

export type DraftText =
  | { readonly view: 'form'; readonly value: MessageValue; }
  | { readonly view: 'yaml'; readonly text: string; };

/** The bytes of a draft at a time of the site. Reading YAML is loaded when it is needed. */
export async function draftBytes(codec: Codec, type: string, draft: DraftText, nowMs: number): Promise<Encoded> {
  const parsed = codec.types.get(type);
  if (typeof parsed === 'string') return { kind: 'failed', path: '', reason: parsed };
  const now = stampOf(nowMs);
  if (draft.view === 'form') return codec.encode(type, withNow(draft.value, parsed.shape, now));
  const { readMessage } = await import('../../decode/read_yaml.ts');
  const read = readMessage(draft.text, parsed.shape, { now });
  return read.kind === 'failed' ? { kind: 'failed', path: '', reason: read.reason } : codec.encode(type, read.value);
}

export function refusal(failed: Extract<Encoded, { kind: 'failed'; }>): string {
  return failed.path === '' ? failed.reason : `${failed.path}: ${failed.reason}`;
}
