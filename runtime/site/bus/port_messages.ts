// The messages between the workers on the port link, besides data. A data message is one ArrayBuffer: the 64-byte
// frame header and the payload. Everything else is one of these objects.

import type { TimeLaw } from './time_law.ts';
import type { EndpointRecord, NodeRecord } from './graph.ts';

export interface PeerPort {
  readonly participant: number;
  readonly port: MessagePort;
}

/** The nodes and endpoints that a participant has created. */
export interface PeerRecords {
  readonly nodes: readonly NodeRecord[];
  readonly endpoints: readonly EndpointRecord[];
}

/** The data that a participant needs to join. */
export interface PortTicket {
  readonly participant: number;
  readonly session: readonly [number, number];
  readonly time: TimeLaw;
  readonly control: MessagePort;
  readonly peers: readonly PeerPort[];
  /** The page's records: known from the first instruction on, so that the page also hears of a program that ends at once. */
  readonly known: PeerRecords;
}

export interface WriterSample {
  readonly key: number;
  readonly count: number;
  readonly bytes: number;
  /** The time of the last sample, ms since 1970. */
  readonly time: number;
  /** The last payload, when it was asked for or is small. */
  readonly payload: Uint8Array | undefined;
}

export type PeerMessage =
  | { readonly t: 'node+'; readonly node: NodeRecord; }
  | { readonly t: 'node-'; readonly key: number; }
  | { readonly t: 'ep+'; readonly record: EndpointRecord; }
  /** To the page: with what a publisher did, its last payload when it is small. */
  | { readonly t: 'ep-'; readonly key: number; readonly last?: WriterSample | undefined; }
  /** The sender's endpoint `mine` knows the receiver's `yours`; of its frames those with a sequence above `after` are for it. */
  | { readonly t: 'match'; readonly mine: number; readonly yours: number; readonly after: number; }
  /** The samples that a transient_local writer has stored, for one reader. */
  | { readonly t: 'late'; readonly reader: number; readonly frames: readonly ArrayBuffer[]; }
  /** All readers here are done with the samples of this writer up to `sequence` (low word). */
  | { readonly t: 'ack'; readonly writer: number; readonly sequence: number; }
  /** A writer with manual liveliness gives a sign of life. */
  | { readonly t: 'alive'; readonly writer: number; }
  | { readonly t: 'sample'; readonly topics: readonly string[]; }
  | { readonly t: 'samples'; readonly writers: readonly WriterSample[]; }
  | { readonly t: 'bye'; };

export type ControlMessage =
  | { readonly t: 'peer'; readonly peer: PeerPort; }
  | { readonly t: 'gone'; readonly participant: number; }
  | { readonly t: 'stop'; }
  /** The page has dealt with a batch of console lines. */
  | { readonly t: 'seen'; }
  | { readonly t: 'time'; readonly law: TimeLaw; };
