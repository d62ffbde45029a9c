// The behaviour that a graph must have, in the fewest words: endpoints, which match, and a queue per reader (SPEC.md
// section 2). Has neither memory nor threads.

import { Durability, EndpointKind, flagIgnoreLocal, History } from '../../../runtime/protocol/generated/constants.ts';
import { incompatiblePolicy, type EndpointQos } from '../../../runtime/site/contract/qos.ts';

export interface ModelSample {
  readonly writer: ModelEndpoint;
  readonly sequence: number;
  readonly bytes: Uint8Array;
  /** Place in the order of publication. */
  readonly order: number;
  /** The client that asked, for requests and replies. */
  readonly client: ModelEndpoint | undefined;
  readonly relatedSequence: number;
}

export interface ModelEndpoint {
  readonly participant: number;
  readonly kind: number;
  readonly name: string;
  readonly qos: EndpointQos;
  readonly flags: number;
  /** The samples that it has not yet taken, oldest first. */
  queue: ModelSample[];
  /** The samples that it has written. */
  readonly written: ModelSample[];
}

const fits: Readonly<Record<number, number>> = {
  [EndpointKind.publisher]: EndpointKind.subscription,
  [EndpointKind.subscription]: EndpointKind.publisher,
  [EndpointKind.client]: EndpointKind.server,
  [EndpointKind.server]: EndpointKind.client,
};

export class Model {
  readonly endpoints = new Set<ModelEndpoint>();
  private order = 0;

  matches(a: ModelEndpoint, b: ModelEndpoint): boolean {
    if (fits[a.kind] !== b.kind || a.name !== b.name) return false;
    if (a.participant === b.participant && ((a.flags | b.flags) & flagIgnoreLocal) !== 0) return false;
    const offers = a.kind === EndpointKind.publisher || a.kind === EndpointKind.server;
    return incompatiblePolicy(offers ? a.qos : b.qos, offers ? b.qos : a.qos) === 0;
  }

  matched(endpoint: ModelEndpoint): ModelEndpoint[] {
    return [...this.endpoints].filter((other) => this.matches(endpoint, other));
  }

  create(parts: Omit<ModelEndpoint, 'queue' | 'written'>): ModelEndpoint {
    const endpoint: ModelEndpoint = { ...parts, queue: [], written: [] };
    this.endpoints.add(endpoint);
    const late = (qos: EndpointQos): boolean => qos.durability === Durability.transientLocal;
    if (endpoint.kind === EndpointKind.subscription && late(endpoint.qos)) {
      for (const writer of this.matched(endpoint)) {
        if (!late(writer.qos)) continue;
        endpoint.queue.push(...writer.written.slice(-Math.min(depthOf(writer.qos), depthOf(endpoint.qos))));
      }
      endpoint.queue.sort((a, b) => a.order - b.order);
      this.trim(endpoint);
    }
    return endpoint;
  }

  destroy(endpoint: ModelEndpoint): void {
    this.endpoints.delete(endpoint);
  }

  write(writer: ModelEndpoint, bytes: Uint8Array, answered?: ModelSample): ModelSample {
    const sequence = writer.written.length + 1;
    const asks = writer.kind === EndpointKind.client;
    const sample: ModelSample = {
      writer,
      sequence,
      bytes,
      order: this.order,
      client: asks ? writer : answered?.client,
      relatedSequence: asks ? sequence : (answered?.relatedSequence ?? 0),
    };
    this.order += 1;
    writer.written.push(sample);
    for (const reader of this.matched(writer)) {
      if (answered !== undefined && reader !== answered.client) continue;
      reader.queue.push(sample);
      this.trim(reader);
    }
    return sample;
  }

  take(reader: ModelEndpoint): ModelSample | undefined {
    return reader.queue.shift();
  }

  private trim(reader: ModelEndpoint): void {
    if (reader.kind !== EndpointKind.subscription) return;
    const depth = depthOf(reader.qos);
    if (reader.queue.length > depth) reader.queue = reader.queue.slice(-depth);
  }
}

export function depthOf(qos: EndpointQos): number {
  return qos.history === History.keepAll ? Infinity : Math.max(1, qos.depth);
}
