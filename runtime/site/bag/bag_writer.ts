// Writes a bag: MCAP with the profile "ros2", in chunks with an index, not compressed. Calls are done in order; nothing
// is kept but the chunk that is being filled and the index.

import { McapWriter } from '@mcap/core';
import type { EndpointQosView } from '../contract/session.ts';
import { writeProfiles } from './qos_profiles.ts';

/** Where the bytes of a bag go, in order. They are the sink's own. */
export interface BagSink {
  write(bytes: Uint8Array<ArrayBuffer>): void;
}

export interface BagTopic {
  readonly name: string;
  readonly type: string;
  /** `RIHS01_...`; empty when nobody said. */
  readonly hash: string;
  /** As in decode's gatherSchema(); undefined: nobody knows. */
  readonly schema: string | undefined;
  readonly offered: readonly EndpointQosView[];
}

export interface WrittenMessage {
  /** ns since 1970. */
  readonly logTime: bigint;
  readonly publishTime: bigint;
  readonly data: Uint8Array;
}

export class BagWriter {
  private readonly writer: McapWriter;
  private written = 0;
  private waiting = 0;
  private count = 0;
  private readonly distro: string;
  private readonly channels = new Map<string, { readonly id: Promise<number>; messages: number; }>();
  private readonly schemas = new Map<string, Promise<number>>();
  private tail: Promise<unknown>;

  /** `library`: what made it. `distro`: as in ROS_DISTRO. */
  constructor(sink: BagSink, { library, distro }: { readonly library: string; readonly distro: string; }) {
    this.distro = distro;
    this.writer = new McapWriter({
      writable: {
        write: async (buffer) => {
          this.written += buffer.length;
          // A copy already: the writer goes on with its own buffer.
          sink.write(buffer as Uint8Array<ArrayBuffer>);
        },
        position: () => BigInt(this.written),
      },
    });
    this.tail = this.writer.start({ profile: 'ros2', library });
  }

  get messages(): number {
    return this.count;
  }

  /** About what the file would have now. */
  get bytes(): number {
    return this.written + this.waiting;
  }

  addTopic({ name, type, hash, schema, offered }: BagTopic): void {
    if (this.channels.has(name)) return;
    const id = this.queue(async () => {
      const known = this.schemas.get(type) ?? this.writer.registerSchema({
        name: type,
        encoding: schema === undefined ? '' : 'ros2msg',
        data: new TextEncoder().encode(schema ?? ''),
      });
      this.schemas.set(type, known);
      return await this.writer.registerChannel({
        topic: name,
        schemaId: await known,
        messageEncoding: 'cdr',
        metadata: new Map([['offered_qos_profiles', writeProfiles(offered)], ...(hash === '' ? [] : [['topic_type_hash', hash] as const])]),
      });
    });
    this.channels.set(name, { id, messages: 0 });
  }

  /** Adds a message of a topic that was added before. */
  addMessage(topic: string, { logTime, publishTime, data }: WrittenMessage): void {
    const channel = this.channels.get(topic);
    if (channel === undefined) return;
    channel.messages += 1;
    this.count += 1;
    this.waiting += data.length;
    const sequence = channel.messages;
    void this.queue(async () => {
      const before = this.written;
      await this.writer.addMessage({ channelId: await channel.id, sequence, logTime, publishTime, data });
      // A chunk has gone out.
      if (this.written !== before) this.waiting = 0;
    });
  }

  /** The rest, and the index. Rejects when the sink could not take something. */
  async end(): Promise<void> {
    await this.queue(async () => {
      await this.writer.addMetadata({
        name: 'rosbag2',
        metadata: new Map([['serialized_metadata', this.description()], ['ROS_DISTRO', this.distro]]),
      });
      await this.writer.end();
    });
  }

  /** The metadata that rosbag2 requires; it takes times, counts and topics from the index instead. */
  private description(): string {
    const { messageStartTime: start = 0n, messageEndTime: end = 0n, messageCount = 0n } = this.writer.statistics ?? {};
    return [
      'version: 9',
      'storage_identifier: mcap',
      `duration:\n  nanoseconds: ${end - start}`,
      `starting_time:\n  nanoseconds_since_epoch: ${start}`,
      `message_count: ${messageCount}`,
      'topics_with_message_count: []',
      'compression_format: ""',
      'compression_mode: ""',
      'relative_file_paths: []',
      'files: []',
      'custom_data: {}',
      `ros_distro: ${/^\w+$/.test(this.distro) ? this.distro : 'unknown'}`,
    ].join('\n');
  }

  /** Once some work has failed, all later work fails, too. */
  private queue<T>(work: () => Promise<T>): Promise<T> {
    const done = this.tail.then(work);
    this.tail = done;
    done.catch(() => undefined);
    return done;
  }
}
