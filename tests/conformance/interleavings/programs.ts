// The code of the processes of a scene, written as in programs: calls of a link, one after another. This file is stepped too,
// so that each function here becomes one that pauses wherever the runtime reaches shared memory.

import { ErrorCode, SampleInfoLayout } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { Bus, createBus } from '../../../runtime/site/bus/bus.ts';
import type { EndpointDescription, Heap } from '../../../runtime/site/bus/link.ts';
import { Sampler } from '../../../runtime/site/bus/sampler.ts';
import { SharedLink } from '../../../runtime/site/bus/shared_link.ts';

export { Bus, createBus, Sampler, SharedBroker, SharedLink };

/** The link and the memory of a program. */
export interface Hands {
  readonly link: SharedLink;
  readonly heap: Heap;
}

export interface Message {
  /** The payload is this byte over and over; 0 is not used. */
  readonly mark: number;
  readonly length: number;
}

export interface Received extends Message {
  /** Third word of the gid. */
  readonly writer: number;
  readonly sequence: number;
}

const payloadAt = 64;

/** The broker clears up after a participant that runs no more. */
export function bury(broker: SharedBroker, participant: number): void {
  broker.end(participant);
  broker.gone(participant);
}

/** Takes its leave when all is written. */
export function publishAndLeave(hands: Hands, endpoint: number, messages: readonly Message[], done: number[]): void {
  publish(hands, endpoint, messages, done);
  hands.link.close();
}

/** Result of each write: the sequence, or an ErrorCode. */
export function publish(hands: Hands, endpoint: number, messages: readonly Message[], done: number[]): void {
  const { link, heap } = hands;
  for (const { mark, length } of messages) {
    for (let i = 0; i < 16; i += 1) heap.i32[i] = 0;
    heap.u8.fill(mark, payloadAt, payloadAt + length);
    const result = link.write(endpoint, heap, payloadAt, length, 0) as number;
    done.push(result < 0 ? result : heap.i32[SampleInfoLayout.sequence >> 2]!);
  }
}

/** Answers a request: the sequence and the client come from it. */
export function reply(hands: Hands, endpoint: number, length: number): number {
  return hands.link.write(endpoint, hands.heap, payloadAt, length, 0) as number;
}

/** The broker ends a participant, and another one begins to publish at once. */
export function succeed(
  broker: SharedBroker,
  ended: number,
  hands: Hands,
  description: EndpointDescription,
  messages: readonly Message[],
): void {
  broker.end(ended);
  joinAndPublish(hands, description, messages);
}

/** The next sample, checked to be whole; undefined when there is none. */
export function takeOne(hands: Hands, endpoint: number): Received | undefined {
  const { link, heap } = hands;
  const length = link.take(endpoint, heap, payloadAt, heap.u8.length - payloadAt, 0);
  if (length === ErrorCode.nothing) return undefined;
  if (length < 0) throw new Error(`take: ${length}`);
  const mark = heap.u8[payloadAt]!;
  const info = heap.i32.slice(0, 16);
  const bytes = heap.u8.slice(payloadAt, payloadAt + length);
  if (info[0] !== length) throw new Error(`torn: a length of ${info[0]} in the header, ${length} in the slot`);
  if (bytes.some((byte) => byte !== mark)) throw new Error(`torn: ${mark} and ${bytes.find((byte) => byte !== mark)} in one payload`);
  return { mark, length, sequence: info[2]!, writer: info[14]! };
}

/** Takes and sleeps by turns until `enough` says so, or nobody is matched any more and nothing is left. */
export function listen(hands: Hands, endpoint: number, received: Received[], enough: (received: readonly Received[]) => boolean): void {
  const { link } = hands;
  for (;;) {
    const token = link.wakeToken();
    const matched = link.matched(endpoint);
    if (link.ready().includes(endpoint)) {
      for (let sample = takeOne(hands, endpoint); sample !== undefined; sample = takeOne(hands, endpoint)) {
        received.push(sample);
        if (enough(received)) return;
      }
    }
    if (matched === 0) return;
    link.wait(token, -1);
  }
}

/** Writes, and then one message more with another endpoint. */
export function publishThen(hands: Hands, endpoint: number, messages: readonly Message[], written: number[], next: number): void {
  publish(hands, endpoint, messages, written);
  publish(hands, next, [{ mark: 1, length: 8 }], []);
}

/** Listens to one endpoint, and then, without another look at it, to the next. */
export function listenThen(
  hands: Hands,
  endpoint: number,
  received: Received[],
  enough: (received: readonly Received[]) => boolean,
  next: number,
  after: Received[],
): void {
  listen(hands, endpoint, received, enough);
  takeAsItComes(hands, next, after);
}

/** Takes without looking first, and sleeps when there is nothing. */
export function takeAsItComes(hands: Hands, endpoint: number, received: Received[]): void {
  for (;;) {
    const token = hands.link.wakeToken();
    const sample = takeOne(hands, endpoint);
    if (sample !== undefined) {
      received.push(sample);
      return;
    }
    hands.link.wait(token, -1);
  }
}

/** Looks whether there is something, `times` over, and leaves it to others. */
export function glance(hands: Hands, times: number): void {
  for (let i = 0; i < times; i += 1) hands.link.ready();
}

/** A writer that comes and writes. */
export function joinAndPublish(hands: Hands, description: EndpointDescription, messages: readonly Message[]): void {
  const endpoint = hands.link.endpointCreate(description);
  if (endpoint < 0) throw new Error(`endpointCreate: ${endpoint}`);
  publish(hands, endpoint, messages, []);
}

/** Waits for as many peers. */
export function awaitMatched(hands: Hands, endpoint: number, count: number): void {
  for (;;) {
    const token = hands.link.wakeToken();
    if (hands.link.matched(endpoint) === count) return;
    hands.link.wait(token, -1);
  }
}

/** Becomes visible, notes how much the writer had done by then, and listens until it is alone. */
export function joinAndListen(
  hands: Hands,
  description: EndpointDescription,
  received: Received[],
  written: readonly number[],
  promised: number[],
): void {
  const endpoint = hands.link.endpointCreate(description);
  if (endpoint < 0) throw new Error(`endpointCreate: ${endpoint}`);
  promised.push(written.length);
  listen(hands, endpoint, received, () => false);
}

/** An endpoint comes and goes, then the node, as when a program ends. */
export function comeAndGo(hands: Hands, node: number, description: EndpointDescription): void {
  const endpoint = hands.link.endpointCreate(description);
  if (endpoint < 0) throw new Error(`endpointCreate: ${endpoint}`);
  hands.link.endpointDestroy(endpoint);
  hands.link.nodeDestroy(node);
}

/** Waits until there is no other node. */
export function awaitAlone(hands: Hands, endpoint: number): void {
  for (;;) {
    const token = hands.link.wakeToken();
    hands.link.graphVersion();
    if (hands.link.graph().nodes.length === 1 && hands.link.matched(endpoint) === 0) return;
    hands.link.wait(token, -1);
  }
}

/** Looks at the newest message, as the page does, twice. */
export function look(sampler: Sampler, topic: string, seen: unknown[]): void {
  seen.push(sampler.lastMessage(topic, 0));
  seen.push(sampler.lastMessage(topic, 0));
}

/** Asks, and waits for the answer. */
export function ask(hands: Hands, client: number, answers: Received[]): void {
  publish(hands, client, [{ mark: 1, length: 8 }], []);
  listen(hands, client, answers, (received) => received.length === 1);
}

/** Answers the first request. */
export function serveOnce(hands: Hands, server: number): void {
  const requests: Received[] = [];
  listen(hands, server, requests, (received) => received.length === 1);
  if (reply(hands, server, 8) !== 0) throw new Error('no reply');
}
