// Turns the bytes of a message (CDR) into plain values for showing. Loaded when a message is looked at
// for the first time, with the parser and reader of @foxglove. Malformed bytes give an error value.

// The package's index would bring its writer along, which nothing here uses.
import { MessageReader } from '@foxglove/rosmsg2-serialization/dist/MessageReader.js';
import type { Definitions } from './definitions.ts';
import type { Shape } from './shape.ts';
import { createTypes, messageOf, type Types } from './types.ts';

export type Decoded =
  | { readonly kind: 'value'; readonly value: unknown; readonly shape: Shape; }
  | { readonly kind: 'failed'; readonly reason: string; };

interface TypeReader {
  readonly read: (bytes: Uint8Array) => unknown;
  readonly shape: Shape;
}

export interface Decoder {
  decode(type: string, bytes: Uint8Array): Decoded;
}

export function createDecoder(interfaces: Definitions, types: Types = createTypes(interfaces)): Decoder {
  const readers = new Map<string, TypeReader>();
  const readerOf = (type: string): TypeReader | string => {
    const known = readers.get(type);
    if (known !== undefined) return known;
    const made = makeReader(type, types);
    if (typeof made !== 'string') readers.set(type, made);
    return made;
  };
  return {
    decode(type, bytes) {
      const found = readerOf(type);
      if (typeof found === 'string') {
        return { kind: 'failed', reason: found };
      }
      try {
        // Text decoders refuse shared memory, so shared bytes are copied first.
        const own = bytes.buffer instanceof ArrayBuffer ? bytes : Uint8Array.from(bytes);
        return { kind: 'value', value: found.read(own), shape: found.shape };
      } catch (error) {
        return {
          kind: 'failed',
          reason: `these ${bytes.byteLength} bytes are no ${type}: ${messageOf(error)}`,
        };
      }
    },
  };
}

function makeReader(type: string, types: Types): TypeReader | string {
  const known = types.get(type);
  if (typeof known === 'string') return known;
  const { shape, definitions } = known;
  // The reader takes a message without fields, but with constants, for no message at all.
  if (shape.length === 0) return { read: () => ({}), shape };
  const reader = new MessageReader([...definitions]);
  return { read: (bytes) => reader.readMessage(bytes), shape };
}
