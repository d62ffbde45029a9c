// A message out of what the user typed: YAML, filled up with the type's defaults; what does not fit is told.

import type { Codec } from '../decode/codec.ts';
import type { Shape } from '../decode/shape.ts';
import { CommandError, type Context } from './command.ts';
import { yamlReader } from './yaml_reader.ts';

export interface Filled {
  readonly type: string;
  readonly shape: Shape;
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** As it is sent. */
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
  return { type, shape, bytes: encoded.bytes, value: decoded.kind === 'value' ? decoded.value : {} };
}

export function stampOf(ms: number): { readonly sec: number; readonly nanosec: number } {
  const sec = Math.floor(ms / 1000);
  return { sec, nanosec: Math.min(999_999_999, Math.max(0, Math.round((ms - sec * 1000) * 1e6))) };
}

/** A message's value, or what is wrong with its bytes. */
export async function decoded(context: Pick<Context, 'codec'>, type: string, bytes: Uint8Array): Promise<{ readonly value: Readonly<Record<string, unknown>>; readonly shape: Shape }> {
  const result = (await context.codec()).decode(type, bytes);
  if (result.kind === 'failed') throw new CommandError(result.reason);
  return { value: result.value as Readonly<Record<string, unknown>>, shape: result.shape };
}
