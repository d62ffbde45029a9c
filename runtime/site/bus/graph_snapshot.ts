// The graph as bytes, for programs. Form: protocol/SPEC.md section 3.3.

import type { GraphSnapshot } from './link.ts';

export function encodeGraph(graph: GraphSnapshot): Uint8Array {
  const encoder = new TextEncoder();
  let buffer = new Uint8Array(4096);
  let view = new DataView(buffer.buffer);
  let at = 0;
  const room = (bytes: number): void => {
    if (at + bytes <= buffer.length) return;
    const larger = new Uint8Array(Math.max(2 * buffer.length, at + bytes));
    larger.set(buffer);
    buffer = larger;
    view = new DataView(buffer.buffer);
  };
  const u32 = (value: number): void => {
    room(4);
    view.setUint32(at, value, true);
    at += 4;
  };
  const i64 = (value: bigint): void => {
    room(8);
    view.setBigInt64(at, value, true);
    at += 8;
  };
  const bytes = (value: Uint8Array): void => {
    room(value.length);
    buffer.set(value, at);
    at += value.length;
  };
  const text = (value: string): void => {
    const encoded = encoder.encode(value);
    u32(encoded.length);
    bytes(encoded);
  };
  u32(graph.nodes.length);
  for (const node of graph.nodes) {
    u32(node.participant);
    text(node.namespace);
    text(node.name);
  }
  u32(graph.endpoints.length);
  for (const { kind, node, name, type, hash, qos, gid } of graph.endpoints) {
    u32(kind);
    u32(node);
    text(name);
    text(type);
    text(hash);
    for (const value of [qos.reliability, qos.durability, qos.history, qos.depth, qos.liveliness]) u32(value);
    for (const value of [qos.deadline, qos.lifespan, qos.lease]) i64(value);
    bytes(gid);
  }
  return buffer.subarray(0, at);
}
