// A replica of the graph: nodes and endpoints, and which of them match. Both links keep one; the rules are here only.

import { EndpointKind, flagHidden, flagIgnoreLocal, flagMirror, PolicyKind } from '../../protocol/generated/constants.ts';
import { incompatiblePolicy, type EndpointQos } from '../contract/qos.ts';
import type { GraphSnapshot } from './link.ts';

/** Nodes here are plumbing and not shown. */
export const hiddenNamespace = '/_ros2wasm';

export interface NodeRecord {
  /** Unique while the node lives. */
  readonly key: number;
  readonly participant: number;
  readonly namespace: string;
  readonly name: string;
}

export interface EndpointRecord {
  /** Unique while the endpoint lives. */
  readonly key: number;
  readonly participant: number;
  readonly nodeKey: number;
  readonly kind: number;
  readonly name: string;
  readonly type: string;
  readonly hash: string;
  readonly qos: EndpointQos;
  readonly flags: number;
  /** Four words. */
  readonly gid: Int32Array;
}

export type Relation =
  | { readonly kind: 'none'; }
  | { readonly kind: 'match'; }
  | { readonly kind: 'incompatible'; readonly policy: PolicyKind; }
  | { readonly kind: 'wrong_type'; };

const none: Relation = { kind: 'none' };
const match: Relation = { kind: 'match' };
const wrongType: Relation = { kind: 'wrong_type' };

const counterpart: Readonly<Record<number, number>> = {
  [EndpointKind.publisher]: EndpointKind.subscription,
  [EndpointKind.subscription]: EndpointKind.publisher,
  [EndpointKind.client]: EndpointKind.server,
  [EndpointKind.server]: EndpointKind.client,
};

export function writes(kind: number): boolean {
  return kind !== EndpointKind.subscription;
}

export function reads(kind: number): boolean {
  return kind !== EndpointKind.publisher;
}

/** The relation of two endpoints. Every participant computes the same answer. */
export function relate(a: EndpointRecord, b: EndpointRecord): Relation {
  if (counterpart[a.kind] !== b.kind || a.name !== b.name || (a.flags & b.flags & flagMirror) !== 0) return none;
  if (a.participant === b.participant && ((a.flags | b.flags) & flagIgnoreLocal) !== 0) return none;
  const anyType = a.type === '' || b.type === '';
  if (!anyType && (a.type !== b.type || (a.hash !== '' && b.hash !== '' && a.hash !== b.hash))) return wrongType;
  const aOffers = a.kind === EndpointKind.publisher || a.kind === EndpointKind.server;
  const policy = incompatiblePolicy(aOffers ? a.qos : b.qos, aOffers ? b.qos : a.qos);
  return policy === PolicyKind.none ? match : { kind: 'incompatible', policy };
}

/** Keep the order of arrival: snapshots are stable. */
export class Graph {
  readonly nodes = new Map<number, NodeRecord>();
  readonly endpoints = new Map<number, EndpointRecord>();
  private readonly byName = new Map<string, Set<EndpointRecord>>();

  add(record: EndpointRecord): void {
    this.endpoints.set(record.key, record);
    let set = this.byName.get(record.name);
    if (set === undefined) {
      set = new Set();
      this.byName.set(record.name, set);
    }
    set.add(record);
  }

  remove(key: number): EndpointRecord | undefined {
    const record = this.endpoints.get(key);
    if (record === undefined) return undefined;
    this.endpoints.delete(key);
    const set = this.byName.get(record.name);
    set?.delete(record);
    if (set?.size === 0) this.byName.delete(record.name);
    return record;
  }

  named(name: string): Iterable<EndpointRecord> {
    return this.byName.get(name) ?? [];
  }

  snapshot(): GraphSnapshot {
    const nodes = [...this.nodes.values()]
      .filter((node) => node.namespace !== hiddenNamespace)
      .sort((a, b) => a.key - b.key);
    const index = new Map(nodes.map((node, i) => [node.key, i]));
    return {
      nodes: nodes.map(({ participant, namespace, name }) => ({ participant, namespace, name })),
      endpoints: [...this.endpoints.values()].sort((a, b) => a.key - b.key).flatMap((record) => {
        const node = index.get(record.nodeKey);
        if (node === undefined || (record.flags & flagHidden) !== 0) return [];
        const { kind, name, type, hash, qos } = record;
        return [{ kind, node, name, type, hash, qos, gid: new Uint8Array(record.gid.slice().buffer) }];
      }),
    };
  }
}
