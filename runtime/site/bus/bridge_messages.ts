// The messages between the bridges of two tabs. protocol/SPEC.md section 7 defines them.

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
  /** The sender is here; sent again in reply to the first one from the other tab. */
  | { readonly t: 'hello'; }
  /** The changes of the sender's graph since the last message: new and removed nodes and endpoints. */
  | {
    readonly t: 'graph';
    readonly nodes: readonly ExportedNode[];
    readonly endpoints: readonly ExportedEndpoint[];
    readonly goneEndpoints: readonly number[];
    readonly goneNodes: readonly string[];
  }
  /** A frame (SPEC.md section 1, filled up to 4 bytes) of the sender's writer `writer`, that counts for the credit of `group`. */
  | { readonly t: 'frame'; readonly writer: number; readonly group: string; readonly frame: ArrayBuffer; }
  /** So many frames and bytes of a group are delivered. */
  | { readonly t: 'ack'; readonly group: string; readonly frames: number; readonly bytes: number; }
  /** Nobody at the sender's reads these writers any more: what their mirrors kept is out of date. */
  | { readonly t: 'forget'; readonly writers: readonly number[]; }
  | { readonly t: 'bye'; };
