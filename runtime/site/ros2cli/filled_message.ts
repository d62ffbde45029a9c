// A message out of what the user typed: YAML, filled up with the type's defaults; what does not fit is told.

import type { Codec } from '../decode/codec.ts';
import type { Shape } from '../decode/shape.ts';
import { CommandError, type Context } from './command.ts';
import { yamlReader } from './yaml_reader.ts';

export interface Filled {
  readonly type: string;
  readonly shape: Shape;
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** As it is sent, but for numbers, which are as they were typed: the tools of ROS 2 print them so. */
  readonly value: unknown;
}

/** `yaml` undefined or empty: the type's defaults. `nowMs`: what `now` and `auto` mean. */
export async function fillMessage(codec: Codec, type: string, yaml: string | undefined, nowMs?: number): Promise<Filled> {
  const parsed = codec.types.get(type);
  if (typeof parsed === 'string') throw new CommandError(parsed);
  const { shape } = parsed;
  let given: unknown = {};
  if (yaml !== undefined && yaml.trim() !== '') {
    const { readMessage } = await yamlReader();
    const read = readMessage(yaml, shape, nowMs === undefined ? {} : { now: stampOf(nowMs) });
    if (read.kind === 'failed') throw new CommandError(`The passed value needs to be a dictionary in YAML format: ${read.reason}`);
    given = read.value;
  }
  const encoded = codec.encode(type, given);
  if (encoded.kind === 'failed') throw new CommandError(`Failed to populate field: ${encoded.path === '' ? '' : `${encoded.path}: `}${encoded.reason}`);
  const decoded = codec.decode(type, encoded.bytes);
  return { type, shape, bytes: encoded.bytes, value: decoded.kind === 'value' ? asTyped(decoded.value, given) : {} };
}

/** Single precision is what the bytes have: 0.2 is 0.20000000298023224 there. Arrays of such are printed as they are sent. */
function asTyped(sent: unknown, given: unknown): unknown {
  if (typeof sent === 'number') return typeof given === 'number' && Math.fround(given) === sent ? given : sent;
  if (Array.isArray(sent) && Array.isArray(given) && isRecord(sent[0])) return sent.map((value, i) => asTyped(value, given[i]));
  if (!isRecord(sent) || !isRecord(given)) return sent;
  return Object.fromEntries(Object.entries(sent).map(([name, value]) => [name, asTyped(value, given[name])]));
}

function isRecord(value: unknown): value is Readonly<Record<string, unknown>> {
  return typeof value === 'object' && value !== null && Object.getPrototypeOf(value) === Object.prototype;
}

export function stampOf(ms: number): { readonly sec: number; readonly nanosec: number; } {
  const sec = Math.floor(ms / 1000);
  return { sec, nanosec: Math.min(999_999_999, Math.max(0, Math.round((ms - sec * 1000) * 1e6))) };
}

/** A message's value, or what is wrong with its bytes. */
export async function decoded(context: Pick<Context, 'codec'>, type: string,
  bytes: Uint8Array): Promise<{ readonly value: Readonly<Record<string, unknown>>; readonly shape: Shape; }>
{
  const result = (await context.codec()).decode(type, bytes);
  if (result.kind === 'failed') throw new CommandError(result.reason);
  return { value: result.value as Readonly<Record<string, unknown>>, shape: result.shape };
}
