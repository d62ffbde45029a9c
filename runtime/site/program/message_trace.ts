// A record of the messages that were sent in a run, to compare runs.

import { SampleInfoLayout } from '../../protocol/generated/constants.ts';
import type { ProgramMemory } from './program_memory.ts';
import { RunningSha256 } from '../contract/running_sha256.ts';

export interface SentMessage {
  /** The name of the topic or service. */
  readonly name: string;
  /** The sequence number of the endpoint's message. */
  readonly sequence: string;
  /** ns since 1970. */
  readonly stamp: string;
  readonly bytes: number;
  readonly hash: string;
}

/** 64 bits that depend on every byte (FNV-1a, from two starts). */
function hashBytes(bytes: Uint8Array): string {
  let [a, b] = [0x811c9dc5, 0x1b873593];
  for (const byte of bytes) {
    a = Math.imul(a ^ byte, 0x01000193);
    b = Math.imul(b ^ byte, 0x01000193) ^ (b >>> 15);
  }
  return [a, b].map((half) => (half >>> 0).toString(16).padStart(8, '0')).join('');
}

/** The record of a message that a program has just written. `info`: address of its SampleInfo, filled in. */
export function sentMessage(
  name: string,
  memory: ProgramMemory,
  data: number,
  length: number,
  info: number,
): SentMessage {
  return {
    name,
    sequence: String(memory.i64(info + SampleInfoLayout.sequence)),
    stamp: String(memory.i64(info + SampleInfoLayout.sourceTimestampNs)),
    bytes: length,
    hash: hashBytes(memory.u8.subarray(data, data + length)),
  };
}

/** SHA-256 of what was added so far. */
export interface RunningHash {
  add(bytes: Uint8Array): void;
  hex(): string;
}

/** The messages of a run, one line each: how many, and the hash of the lines, which are not kept. */
export class MessageTrace {
  messages = 0;
  private readonly hash: RunningHash;
  private readonly encoder = new TextEncoder();

  constructor(hash: RunningHash = new RunningSha256()) {
    this.hash = hash;
  }

  /** Returns the line. */
  add(node: string, message: SentMessage): string {
    const line = `${JSON.stringify({ node, ...message })}\n`;
    this.messages += 1;
    this.hash.add(this.encoder.encode(line));
    return line;
  }

  /** The hash of all lines so far. */
  sha256(): string {
    return this.hash.hex();
  }
}
