// Bytes to values and back, and the values that a message begins with: what is loaded when the first message is
// looked at or made. One object per session, so that each type is parsed once.

import { createDecoder, type Decoder } from './decoder.ts';
import type { Definitions } from './definitions.ts';
import { draftOf, type MessageValue } from './draft.ts';
import { type Encoded, encodeMessage } from './encoder.ts';
import { createTypes, messageOf, type Types } from './types.ts';

export type { Decoded } from './decoder.ts';
export type { MessageValue } from './draft.ts';
export type { Encoded } from './encoder.ts';

export type Drafted =
  | { readonly kind: 'value'; readonly value: MessageValue; }
  | { readonly kind: 'failed'; readonly reason: string; };

export interface Codec extends Decoder {
  readonly types: Types;
  /** `value`: fields by name, as decode() gives them or plainer (numbers for bigints, lists for typed arrays). */
  encode(type: string, value: unknown): Encoded;
  draft(type: string): Drafted;
}

export function createCodec(interfaces: Definitions): Codec {
  const types = createTypes(interfaces);
  const { decode } = createDecoder(interfaces, types);
  return {
    types,
    decode,
    encode: (type, value) => encodeMessage(types, type, value),
    draft(type) {
      const parsed = types.get(type);
      if (typeof parsed === 'string') return { kind: 'failed', reason: parsed };
      try {
        return { kind: 'value', value: draftOf(parsed.shape) };
      } catch (error) {
        return { kind: 'failed', reason: messageOf(error) };
      }
    },
  };
}
