// Messages from a port of the port link come from another program, so they are validated before use. A program may only report
// endpoints of its own; a participant that reports others' endpoints, or sends an unknown form, is ignored from then on.

import { EndpointKind, frameHeaderSize } from '../../protocol/generated/constants.ts';
import { checkDescription, checkNode } from './description_check.ts';
import type { PeerMessage } from './port_messages.ts';

type Members = Readonly<Record<string, unknown>>;

/** The word of a frame's header that has the writer's key. */
const writerWord = 14;
/** Upper bound of the topics in one `sample` request of the page. */
const mostNames = 100_000;

function isMembers(value: unknown): value is Members {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function isInt32(...values: readonly unknown[]): boolean {
  return values.every((value) => Number.isInteger(value) && Math.abs(value as number) <= 0xffffffff);
}

function isBytes(value: unknown): boolean {
  return value === undefined || (value instanceof Uint8Array && value.buffer instanceof ArrayBuffer);
}

function isQos(value: unknown): boolean {
  if (!isMembers(value)) return false;
  const { reliability, durability, history, depth, liveliness, deadline, lifespan, lease } = value;
  return isInt32(reliability, durability, history, depth, liveliness) && [deadline, lifespan, lease].every((ns) => typeof ns === 'bigint');
}

/** A key of something that the participant has made. */
function isOf(participant: number, key: unknown): key is number {
  return Number.isInteger(key) && (key as number) >>> 20 === participant;
}

function isNode(participant: number, node: unknown): boolean {
  if (!isMembers(node)) return false;
  const { key, participant: of, namespace, name } = node;
  return isOf(participant, key) && of === participant && typeof name === 'string' && typeof namespace === 'string' && checkNode(name, namespace) === 0;
}

function isEndpoint(participant: number, record: unknown): boolean {
  if (!isMembers(record)) return false;
  const { key, participant: of, nodeKey, kind, name, type, hash, qos, flags, gid } = record;
  if (!isOf(participant, key) || !isOf(participant, nodeKey) || of !== participant) return false;
  if (!Object.values<unknown>(EndpointKind).includes(kind) || !isInt32(flags) || !isQos(qos)) return false;
  if (!(gid instanceof Int32Array) || gid.length !== 4 || !(gid.buffer instanceof ArrayBuffer)) return false;
  if (typeof name !== 'string' || typeof type !== 'string' || typeof hash !== 'string') return false;
  return checkDescription({ kind, name, type, hash } as Parameters<typeof checkDescription>[0]) === 0;
}

function isSample(participant: number, sample: unknown): boolean {
  if (!isMembers(sample)) return false;
  const { key, count, bytes, time, payload } = sample;
  return isOf(participant, key) && [count, bytes, time].every(Number.isFinite) && isBytes(payload);
}

function isFrame(participant: number, frame: unknown): frame is ArrayBuffer {
  return frame instanceof ArrayBuffer && frame.byteLength >= frameHeaderSize
    && isOf(participant, new Int32Array(frame, 0, writerWord + 1)[writerWord]);
}

const forms: Readonly<Record<PeerMessage['t'], (message: Members, participant: number) => boolean>> = {
  'node+': ({ node }, from) => isNode(from, node),
  'node-': ({ key }, from) => isOf(from, key),
  'ep+': ({ record }, from) => isEndpoint(from, record),
  'ep-': ({ key, last }, from) => isOf(from, key) && (last === undefined || isSample(from, last)),
  match: ({ mine, yours, after }, from) => isOf(from, mine) && isInt32(yours, after),
  late: ({ reader, frames }, from) => isInt32(reader) && Array.isArray(frames) && frames.every((frame) => isFrame(from, frame)),
  ack: ({ writer, sequence }) => isInt32(writer, sequence),
  alive: ({ writer }, from) => isOf(from, writer),
  sample: ({ topics }) => Array.isArray(topics) && topics.length <= mostNames && topics.every((topic) => typeof topic === 'string'),
  samples: ({ writers }, from) => Array.isArray(writers) && writers.every((sample) => isSample(from, sample)),
  bye: () => true,
};

/** The message of that participant; undefined: it is not valid, so it does not come from a program built by ros2wasm. */
export function readPeer(participant: number, data: unknown): ArrayBuffer | PeerMessage | undefined {
  if (data instanceof ArrayBuffer) return isFrame(participant, data) ? data : undefined;
  if (!isMembers(data)) return undefined;
  const kind = data['t'];
  if (typeof kind !== 'string' || !Object.hasOwn(forms, kind)) return undefined;
  return forms[kind as PeerMessage['t']](data, participant) ? data as unknown as PeerMessage : undefined;
}
