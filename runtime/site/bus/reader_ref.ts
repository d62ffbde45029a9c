// A reader on the shared bus as one of its writers knows it.

import { History, Reliability } from '../../protocol/generated/constants.ts';
import type { Bus } from './bus.ts';
import { BusCells } from './bus_cells.ts';
import type { EndpointRecord } from './graph.ts';
import { keyIndex } from './shared_ring.ts';
import { deadlineOf } from './timing.ts';

export interface ReaderRef {
  readonly key: number;
  readonly word: number;
  readonly generation: number;
  readonly participant: number;
  readonly local: boolean;
  /** Newest samples the reader may still want; Infinity when it wants all. */
  readonly depth: number;
  readonly reliable: boolean;
  /** Set when the reader asks for a deadline; only a writer that offers one can match it. */
  readonly deadline: { readonly ns: number; readonly cells: BusCells; } | undefined;
  pair: number;
  /** It has read as far as this, or further; undefined: not asked yet. */
  known: number | undefined;
}

/** `all`: it wants every sample whatever its history, as readers of services do. `participant`: that of the writer. */
export function readerRef(bus: Bus, reader: EndpointRecord, all: boolean, participant: number): ReaderRef {
  const word = bus.endpointWord(keyIndex(reader.key));
  const ns = deadlineOf(reader);
  return {
    key: reader.key,
    word,
    generation: reader.key >>> 13,
    participant: reader.participant,
    local: reader.participant === participant,
    depth: all || reader.qos.history === History.keepAll ? Infinity : Math.max(1, reader.qos.depth),
    reliable: reader.qos.reliability === Reliability.reliable,
    deadline: ns === 0 ? undefined : { ns, cells: new BusCells(bus, word) },
    pair: -1,
    known: undefined,
  };
}
