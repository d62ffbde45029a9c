// Module "ros2wasm": the link, as a program calls it. protocol/SPEC.md section 3.

import { abiVersion, EndpointDescLayout, EndpointStatusLayout, ErrorCode, type StatusKind, type TerminalMode } from '../../protocol/generated/constants.ts';
import { encodeGraph } from '../bus/graph_snapshot.ts';
import type { Link } from '../bus/link.ts';
import { type SentMessage, sentMessage } from './message_trace.ts';
import type { ProgramMemory } from './program_memory.ts';

/** Names of the functions that may suspend the program on the port link. */
export const suspendingHost: ReadonlySet<string> = new Set(['wait', 'sleep', 'write']);

/** ns in one i64, or in two halves, as ms. Negative stays negative. */
function milliseconds(low: number | bigint, high: number | undefined): number {
  if (typeof low === 'bigint') return Number(low) / 1e6;
  return ((low >>> 0) + (high ?? 0) * 2 ** 32) / 1e6;
}

export type HostFunction = (...args: never[]) => unknown;

export function hostImports(
  link: Link,
  memory: () => ProgramMemory,
  idle: () => void,
  terminal: (mode: TerminalMode) => void,
  sent?: (message: SentMessage) => void,
) {
  /** The names of the endpoints, by handle; filled only when the messages sent are traced. */
  const names = new Map<number, string>();
  const i64 = (address: number): bigint => memory().i64(address);

  const endpointCreate = (desc: number): number => {
    const heap = memory();
    const at = (offset: number): number => heap.u32(desc + offset);
    const text = (address: number, length: number): string => heap.text(at(address), at(length));
    const L = EndpointDescLayout;
    const name = text(L.name, L.nameLen);
    const endpoint = link.endpointCreate({
      kind: at(L.kind),
      node: at(L.node) | 0,
      name,
      type: text(L.type, L.typeLen),
      hash: text(L.hash, L.hashLen),
      qos: {
        reliability: at(L.reliability),
        durability: at(L.durability),
        history: at(L.history),
        depth: at(L.depth),
        liveliness: at(L.liveliness),
        deadline: i64(desc + L.deadlineNs),
        lifespan: i64(desc + L.lifespanNs),
        lease: i64(desc + L.leaseNs),
      },
      flags: at(L.flags),
    });
    if (sent !== undefined) names.set(endpoint, name);
    return endpoint;
  };

  const write = (endpoint: number, data: number, length: number, info: number): number | Promise<number> => {
    if (info % 4 !== 0) return ErrorCode.invalidArgument;
    const result = link.write(endpoint, memory(), data >>> 0, length >>> 0, info >>> 0);
    if (sent === undefined) return result;
    const tell = (code: number): number => {
      const name = names.get(endpoint);
      if (code >= 0 && name !== undefined) sent(sentMessage(name, memory(), data >>> 0, length >>> 0, info >>> 0));
      return code;
    };
    return typeof result === 'number' ? tell(result) : result.then(tell);
  };

  const status = (endpoint: number, kind: number, out: number): number => {
    const found = link.status(endpoint, kind as StatusKind);
    if (found === undefined) return ErrorCode.badHandle;
    const heap = memory();
    const L = EndpointStatusLayout;
    heap.u8.fill(0, out, out + L.size);
    heap.set(out + L.totalCount, found.totalCount);
    heap.set(out + L.totalChange, found.totalChange);
    heap.set(out + L.currentCount, found.currentCount);
    heap.set(out + L.currentChange, found.currentChange);
    heap.set(out + L.lastPolicy, found.lastPolicy);
    return 0;
  };

  return {
    abi_version: () => abiVersion,
    node_create: (name: number, nameLength: number, namespace: number, namespaceLength: number) =>
      link.nodeCreate(memory().text(name, nameLength), memory().text(namespace, namespaceLength)),
    node_destroy: (node: number) => link.nodeDestroy(node),
    endpoint_create: endpointCreate,
    endpoint_destroy: (endpoint: number) => {
      names.delete(endpoint);
      return link.endpointDestroy(endpoint);
    },
    endpoint_gid: (endpoint: number, out: number): number => {
      const gid = link.gid(endpoint);
      if (gid === undefined) return ErrorCode.badHandle;
      memory().u8.set(new Uint8Array(gid.slice().buffer), out);
      return 0;
    },
    write,
    take: (endpoint: number, buffer: number, capacity: number, info: number): number => {
      if (info % 4 !== 0) return ErrorCode.invalidArgument;
      return link.take(endpoint, memory(), buffer >>> 0, capacity >>> 0, info >>> 0);
    },
    ready: (out: number, capacity: number): number => {
      const ready = link.ready();
      const count = Math.min(ready.length, capacity);
      for (let i = 0; i < count; i += 1) memory().set(out + 4 * i, ready[i]!);
      return ready.length;
    },
    wake_token: () => link.wakeToken(),
    wait: (token: number, low: number | bigint, high?: number) => {
      idle();
      return link.wait(token, milliseconds(low, high));
    },
    wake: () => link.wake(),
    sleep: (low: number | bigint, high?: number) => {
      idle();
      return link.sleep(milliseconds(low, high));
    },
    real_timeout: (out: number, low: number | bigint, high?: number): number => {
      const { clock } = link;
      // Read before the time: an older one than the timeout's does no harm, a newer one would.
      const version = clock.lawVersion();
      const real = clock.realMsUntil(clock.steadyNs() + milliseconds(low, high) * 1e6);
      memory().setI64(out, real === Infinity ? -1n : BigInt(Math.ceil(real * 1e6)));
      return version;
    },
    stop_requested: () => (link.stopRequested() ? 1 : 0),
    terminal_mode: terminal,
    matched: (endpoint: number) => link.matched(endpoint),
    endpoint_status: status,
    status_version: () => link.statusVersion(),
    assert_liveliness: (endpoint: number) => link.assertLiveliness(endpoint),
    graph_version: () => link.graphVersion(),
    graph_snapshot: (buffer: number, capacity: number): number => {
      const bytes = encodeGraph(link.graph());
      if (bytes.length <= capacity) memory().u8.set(bytes, buffer >>> 0);
      return bytes.length;
    },
    thread_create_required: (): number => ErrorCode.unsupported,
  } satisfies Record<string, HostFunction>;
}
