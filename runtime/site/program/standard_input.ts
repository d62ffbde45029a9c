// A node's standard input travels over the link, since nothing else reaches a worker that blocks: a hidden topic per
// node, written by the page. An empty message is the end of input.

import { Durability, EndpointKind, ErrorCode, flagHidden, History, Reliability, WaitResult } from '../../protocol/generated/constants.ts';
import { hiddenNamespace } from '../bus/graph.ts';
import type { EndpointDescription, Heap, Link } from '../bus/link.ts';
import { defaultQos } from '../contract/qos.ts';
import type { Arrival, Input } from './wasi.ts';

function description(kind: EndpointDescription['kind'], node: number, id: string): EndpointDescription {
  return {
    kind,
    node,
    name: `${hiddenNamespace}/stdin/${id}`,
    type: 'ros2wasm/input',
    hash: '',
    flags: flagHidden,
    qos: {
      ...defaultQos,
      reliability: Reliability.reliable,
      durability: Durability.transientLocal,
      history: History.keepAll,
    },
  };
}

function scratch(bytes: number): Heap {
  const buffer = new ArrayBuffer((bytes + 3) & -4);
  return { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
}

/** The reading side, made at the first read. */
export function inputReader(link: Link, id: string): Input {
  let endpoint: number | undefined;
  let rest = new Uint8Array();
  let ended = false;
  let heap = scratch(64 + 4096);

  const next = (): boolean => {
    endpoint ??= link.endpointCreate(description(EndpointKind.subscription, link.nodeCreate('stdin', hiddenNamespace), id));
    let length = link.take(endpoint, heap, 64, heap.u8.length - 64, 0);
    if (length > heap.u8.length - 64) {
      heap = scratch(64 + length);
      length = link.take(endpoint, heap, 64, heap.u8.length - 64, 0);
    }
    if (length === ErrorCode.nothing) return false;
    if (length <= 0) ended = true;
    else rest = heap.u8.slice(64, 64 + length);
    return true;
  };
  const give = (capacity: number): Uint8Array => {
    const part = rest.slice(0, capacity);
    rest = rest.slice(part.length);
    return part;
  };
  const there = (): boolean => rest.length > 0 || ended;
  /** The site time left until `untilNs`, in ms; -1: no limit. */
  const left = (untilNs: number): number => untilNs === Infinity ? -1 : Math.max(0, (untilNs - link.clock.steadyNs()) / 1e6);
  const arrivesLater = async (untilNs: number): Promise<WaitResult | undefined> => {
    for (;;) {
      const token = link.wakeToken();
      if (next()) return undefined;
      const result = await link.wait(token, left(untilNs));
      if (result !== WaitResult.woken) return result;
    }
  };
  /** `undefined`: something is there. */
  const arrives = (untilNs: number): WaitResult | undefined | Promise<WaitResult | undefined> => {
    if (there()) return undefined;
    if (link.kind === 'port') return arrivesLater(untilNs);
    for (;;) {
      const token = link.wakeToken();
      if (next()) return undefined;
      const result = link.wait(token, left(untilNs)) as WaitResult;
      if (result !== WaitResult.woken) return result;
    }
  };
  return {
    read: (capacity) => {
      const result = arrives(Infinity);
      const answer = (ended: WaitResult | undefined): Uint8Array | undefined => ended === undefined ? give(capacity) : undefined;
      return result instanceof Promise ? result.then(answer) : answer(result);
    },
    arrives: (milliseconds) => {
      const result = arrives(milliseconds === Infinity ? Infinity : link.clock.steadyNs() + milliseconds * 1e6);
      const answer = (ended: WaitResult | undefined): Arrival => ended === undefined ? 'input' : ended === WaitResult.stop ? 'stop' : 'timeout';
      return result instanceof Promise ? result.then(answer) : answer(result);
    },
  };
}

/** The writing side, in the page. */
export class InputWriter {
  private readonly link: Link;
  private readonly node: number;
  private readonly endpoints = new Map<string, number>();

  constructor(link: Link) {
    this.link = link;
    this.node = link.nodeCreate('page', hiddenNamespace);
  }

  send(id: string, text: string): void {
    let endpoint = this.endpoints.get(id);
    if (endpoint === undefined) {
      endpoint = this.link.endpointCreate(description(EndpointKind.publisher, this.node, id));
      this.endpoints.set(id, endpoint);
    }
    const bytes = new TextEncoder().encode(text);
    const heap = scratch(64 + bytes.length);
    heap.u8.set(bytes, 64);
    void this.link.write(endpoint, heap, 64, bytes.length, 0);
  }

  /** Forgets what was typed for a run that is over. */
  reset(id: string): void {
    const endpoint = this.endpoints.get(id);
    if (endpoint !== undefined) this.link.endpointDestroy(endpoint);
    this.endpoints.delete(id);
  }
}
