// How a program (or the page) reaches the graph: one interface, two kinds (shared_link.ts, port_link.ts).
// The calls mirror the imports of module "ros2wasm" (protocol/SPEC.md); handles are small integers.

import type { StatusKind, WaitResult } from '../../protocol/generated/constants.ts';
import type { SiteClock } from './clock.ts';
import type { EndpointQos } from '../contract/qos.ts';
import type { LinkKind } from '../contract/session.ts';

/** How many batches were sent and the page has not dealt with yet; shared by the threads of a program. */
export interface ConsoleCredit {
  posted(): void;
  ahead(): number;
}

/** A program's memory: both views cover the same buffer. SampleInfo addresses are multiples of 4. */
export interface Heap {
  readonly u8: Uint8Array;
  readonly i32: Int32Array;
}

export interface EndpointDescription {
  readonly kind: number;
  readonly node: number;
  /** Fully qualified. */
  readonly name: string;
  readonly type: string;
  readonly hash: string;
  readonly qos: EndpointQos;
  readonly flags: number;
  /** A subscription begins with what matched writers still hold, whatever their durability, where the link has it. */
  readonly past?: boolean;
}

export interface EndpointStatus {
  readonly totalCount: number;
  readonly totalChange: number;
  readonly currentCount: number;
  readonly currentChange: number;
  readonly lastPolicy: number;
}

/** A node in the snapshot of graph(), with its participant. */
export interface GraphNode {
  readonly participant: number;
  readonly namespace: string;
  readonly name: string;
}

export interface GraphEndpoint {
  readonly kind: number;
  /** Index in GraphSnapshot.nodes. */
  readonly node: number;
  readonly name: string;
  readonly type: string;
  readonly hash: string;
  readonly qos: EndpointQos;
  readonly gid: Uint8Array;
}

export interface GraphSnapshot {
  readonly nodes: readonly GraphNode[];
  readonly endpoints: readonly GraphEndpoint[];
}

export interface Link {
  readonly kind: LinkKind;
  /** The time as programs see it. All timeouts use this clock. */
  readonly clock: SiteClock;
  /** Handle, or a negative ErrorCode. */
  nodeCreate(name: string, namespace: string): number;
  nodeDestroy(node: number): void;
  /** Handle, or a negative ErrorCode. */
  endpointCreate(description: EndpointDescription): number;
  endpointDestroy(endpoint: number): void;
  /** Four words, or undefined for a bad handle. */
  gid(endpoint: number): Int32Array | undefined;
  /** 0, or a negative ErrorCode. Reads source_timestamp_ns and related_* of the SampleInfo, fills the rest in. */
  write(endpoint: number, heap: Heap, address: number, length: number, info: number): number | Promise<number>;
  /** Payload bytes (nothing was taken when more than capacity), or a negative ErrorCode. */
  take(endpoint: number, heap: Heap, address: number, capacity: number, info: number): number;
  /** Own readers with something to take; appends to the array that it returns. */
  ready(): readonly number[];
  /** Read before ready(); wait() returns at once when it has changed since. */
  wakeToken(): number;
  /** Blocks (shared) or suspends (port). A negative timeout means none. */
  wait(token: number, timeoutMs: number): WaitResult | Promise<WaitResult>;
  wake(): void;
  sleep(durationMs: number): WaitResult | Promise<WaitResult>;
  /** In a stepped run: waits for the first turn. */
  awaitTurn?(): void;
  stopRequested(): boolean;
  /** How often a stop was requested. */
  stops(): number;
  /** Matched peers, or a negative ErrorCode. */
  matched(endpoint: number): number;
  /** undefined for a bad handle or a status that this endpoint has not. */
  status(endpoint: number, kind: StatusKind): EndpointStatus | undefined;
  /** Changes when a status of an own endpoint does; the wait ends when one that was ever read does by time alone. */
  statusVersion(): number;
  /** A sign of life of a writer with manual liveliness. 0, or a negative ErrorCode. */
  assertLiveliness(endpoint: number): number;
  graphVersion(): number;
  graph(): GraphSnapshot;
  /** Counts the batches of console lines that the page has not dealt with. */
  readonly consoleCredit: ConsoleCredit;
  close(): void;
}
