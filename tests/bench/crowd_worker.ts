// One node of the crowd: publishes on its topics, each with a period and a phase of its own, and takes what its
// neighbour publishes. A JavaScript worker on the runtime's own link, so that the link alone is measured.

import { EndpointKind, ErrorCode } from '../../runtime/protocol/generated/constants.ts';
import type { Link } from '../../runtime/site/bus/link.ts';
import { type LinkTicket, openLink } from '../../runtime/site/bus/open_link.ts';
import { defaultQos } from '../../runtime/site/contract/qos.ts';

export interface CrowdOrder {
  readonly ticket: LinkTicket;
  readonly index: number;
  readonly nodes: number;
  readonly topicsEach: number;
  readonly bytes: number;
}

/** The task of a node: `hz` messages per second and topic, 0 to be idle; Infinity: as fast as it can. */
export interface CrowdTask {
  readonly hz: number;
  readonly durationMs: number;
}

export interface CrowdReport {
  readonly sent: number;
  readonly received: number;
  /** How often the worker was woken or woke by itself. */
  readonly wakeUps: number;
}

const payloadAt = 64;

class Crowd {
  private readonly link: Link;
  private readonly topics: number[] = [];
  private readonly subscriptions: number[] = [];
  private readonly order: CrowdOrder;
  private readonly heap: { u8: Uint8Array; i32: Int32Array; };

  constructor(order: CrowdOrder) {
    this.order = order;
    this.link = openLink(order.ticket, true);
    const buffer = new ArrayBuffer(payloadAt + order.bytes + 64 & -64);
    this.heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
    const node = this.link.nodeCreate(`n${order.index}`, '/crowd');
    const neighbour = (order.index + 1) % order.nodes;
    const endpoint = (kind: number, of: number, topic: number): number =>
      this.link.endpointCreate({
        kind,
        node,
        name: `/t${of}/n${topic}`,
        type: 'std_msgs/msg/UInt8MultiArray',
        hash: '',
        qos: defaultQos,
        flags: 0,
      });
    for (let topic = 0; topic < order.topicsEach; topic += 1) {
      this.topics.push(endpoint(EndpointKind.publisher, order.index, topic));
      this.subscriptions.push(endpoint(EndpointKind.subscription, neighbour, topic));
    }
  }

  /** Blocks until each publisher has its reader. */
  async matched(): Promise<void> {
    for (;;) {
      const token = this.link.wakeToken();
      if ([...this.topics, ...this.subscriptions].every((each) => this.link.matched(each) > 0)) return;
      await this.link.wait(token, -1);
    }
  }

  private async takeAll(): Promise<number> {
    let received = 0;
    for (const reader of this.link.ready()) {
      while (this.link.take(reader, this.heap, payloadAt, this.order.bytes, 0) !== ErrorCode.nothing) received += 1;
    }
    return received;
  }

  async run({ hz, durationMs }: CrowdTask): Promise<CrowdReport> {
    const { link, heap, order, topics } = this;
    const begin = performance.now();
    const end = begin + durationMs;
    const gap = 1000 / (hz * topics.length);
    let due = hz === 0 ? Infinity : begin + (gap * order.index) / order.nodes;
    let next = 0;
    let [sent, received, wakeUps] = [0, 0, 0];
    for (;;) {
      const token = link.wakeToken();
      received += await this.takeAll();
      const now = performance.now();
      if (now >= end) return { sent, received, wakeUps };
      if (now >= due) {
        heap.i32.fill(0, 0, 16);
        if (await link.write(topics[next]!, heap, payloadAt, order.bytes, 0) === 0) sent += 1;
        next = (next + 1) % topics.length;
        due += gap;
        continue;
      }
      await link.wait(token, Math.min(due, end) - now);
      wakeUps += 1;
    }
  }

  /** Takes the messages that are still under way when all have stopped. */
  drain(): Promise<number> {
    return this.takeAll();
  }
}

const scope = self as unknown as DedicatedWorkerGlobalScope;
let crowd: Crowd | undefined;
scope.onmessage = async ({ data }: MessageEvent<{ order?: CrowdOrder; task?: CrowdTask; drain?: true; matched?: true; }>) => {
  if (data.order !== undefined) crowd = new Crowd(data.order);
  if (data.matched === true) await crowd?.matched();
  const answer = data.task !== undefined ? await crowd?.run(data.task) : data.drain === true ? await crowd?.drain() : 'ready';
  scope.postMessage(answer);
};
