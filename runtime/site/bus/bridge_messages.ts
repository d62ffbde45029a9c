// What the bridges of two tabs say to each other. Law: protocol/SPEC.md section 7.

import type { EndpointRecord } from './graph.ts';

export interface ExportedNode {
  readonly id: string;
  readonly namespace: string;
  readonly name: string;
}

export interface ExportedEndpoint extends Omit<EndpointRecord, 'participant' | 'nodeKey'> {
  /** ExportedNode.id. */
  readonly node: string;
}

export type BridgeMessage =
  /** I am here; sent again to whoever says it first. */
  | { readonly t: 'hello' }
  /** What came to the sender's graph and what left it since the last time. */
  | {
    readonly t: 'graph';
    readonly nodes: readonly ExportedNode[];
    readonly endpoints: readonly ExportedEndpoint[];
    readonly goneEndpoints: readonly number[];
    readonly goneNodes: readonly string[];
  }
  /** A frame (SPEC.md section 1, filled up to 4 bytes) of the sender's writer `writer`, that counts for the credit of `group`. */
  | { readonly t: 'frame'; readonly writer: number; readonly group: string; readonly frame: ArrayBuffer }
  /** So many frames and bytes of a group are delivered. */
  | { readonly t: 'ack'; readonly group: string; readonly frames: number; readonly bytes: number }
  /** Nobody at the sender's reads these writers any more: what their mirrors kept is out of date. */
  | { readonly t: 'forget'; readonly writers: readonly number[] }
  | { readonly t: 'bye' };
