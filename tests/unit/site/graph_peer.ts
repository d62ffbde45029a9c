// Another participant of the graph, in the test's own thread, on a real link: what a node would do, by hand.

import { EndpointKind, ErrorCode, frameHeaderSize } from '../../../runtime/protocol/generated/constants.ts';
import { type Broker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nextEvent } from '../../../runtime/site/bus/event_wait.ts';
import type { Heap } from '../../../runtime/site/bus/link.ts';
import { openLink } from '../../../runtime/site/bus/open_link.ts';
import type { QosRequest } from '../../../runtime/site/contract/page_node.ts';
import type { PortLink } from '../../../runtime/site/bus/port_link.ts';
import { endpointQos } from '../../../runtime/site/contract/qos_view.ts';
import type { SharedLink } from '../../../runtime/site/bus/shared_link.ts';

export interface Sample {
  readonly bytes: Uint8Array;
  /** SampleInfo. */
  readonly words: Int32Array;
}

function scratch(bytes: number): Heap {
  const buffer = new ArrayBuffer((frameHeaderSize + bytes + 3) & -4);
  return { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
}

export class GraphPeer {
  readonly link: SharedLink | PortLink;
  private readonly broker: Broker;
  private readonly participant: number;
  private readonly nodes = new Map<string, number>();

  constructor(broker: Broker) {
    const admission = broker.admit();
    if (admission === undefined) throw new Error('no place');
    this.broker = broker;
    this.participant = admission.participant;
    this.link = openLink(admission.ticket, false);
  }

  /** Handle of a new endpoint of `/<node>`. */
  make(kind: EndpointKind, node: string, name: string, type: string, qos: QosRequest = {}): number {
    const handle = this.nodes.get(node) ?? this.link.nodeCreate(node, '/');
    this.nodes.set(node, handle);
    return this.link.endpointCreate({ kind, node: handle, name, type, hash: '', qos: endpointQos(qos), flags: 0 });
  }

  write(endpoint: number, bytes: Uint8Array, asked?: Sample): void {
    const heap = scratch(bytes.length);
    heap.u8.set(bytes, frameHeaderSize);
    if (asked !== undefined) heap.i32.set(asked.words.subarray(6, 12), 6);
    const result = this.link.write(endpoint, heap, frameHeaderSize, bytes.length, 0);
    if (typeof result === 'number' && result < 0) throw new Error(`write: ${result}`);
  }

  take(endpoint: number): Sample | undefined {
    const heap = scratch(1 << 16);
    const length = this.link.take(endpoint, heap, frameHeaderSize, 1 << 16, 0);
    if (length === ErrorCode.nothing) return undefined;
    return { bytes: heap.u8.slice(frameHeaderSize, frameHeaderSize + length), words: heap.i32.slice(0, 16) };
  }

  async next(endpoint: number): Promise<Sample> {
    let sample: Sample | undefined;
    await this.until(() => (sample = this.take(endpoint)) !== undefined);
    return sample!;
  }

  async until(met: () => boolean): Promise<void> {
    for (;;) {
      const token = this.link.wakeToken();
      this.link.graphVersion();
      if (met()) return;
      await nextEvent(this.link, token, true);
    }
  }

  /** As a node that ends by itself. */
  leave(): void {
    this.link.close();
    this.broker.end(this.participant, true);
    this.broker.gone(this.participant);
  }

  /** As a worker that is terminated. */
  die(): void {
    this.broker.end(this.participant, false);
    this.broker.gone(this.participant);
    if (!(this.broker instanceof SharedBroker)) this.link.close();
  }
}
