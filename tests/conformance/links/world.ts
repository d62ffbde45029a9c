// A scene's world: a broker and workers, whatever the platform.

import { type Broker, PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import type { LinkKind } from '../../../runtime/site/contract/session.ts';
import type { Peer, PeerCall } from './peer.ts';

export interface RawWorker {
  post(message: unknown, transfer: readonly MessagePort[]): void;
  onMessage(listener: (message: unknown) => void): void;
  /** Resolves when the worker runs no more. */
  terminate(): Promise<void>;
  /** It has left its graph, and may serve another one; without: it is ended. */
  release?(): void;
}

type Answer = { value?: unknown; error?: string; begun?: string; };

/** A worker that carries out Peer's methods. Calls queue up. */
export class RemotePeer {
  readonly participant: number;
  private readonly raw: RawWorker;
  private readonly broker: Broker;
  private readonly pending: { resolve: (value: unknown) => void; reject: (error: Error) => void; begun: () => void; }[] = [];
  private burial: Promise<void> | undefined;

  constructor(raw: RawWorker, broker: Broker, participant: number) {
    this.raw = raw;
    this.broker = broker;
    this.participant = participant;
    raw.onMessage((message) => {
      const answer = message as Answer;
      if (answer.begun !== undefined) {
        this.pending[0]?.begun();
        return;
      }
      const next = this.pending.shift();
      if (answer.error !== undefined) next?.reject(new Error(answer.error));
      else next?.resolve(answer.value);
    });
  }

  request(message: unknown, transfer: readonly MessagePort[] = [], begun: () => void = () => undefined): Promise<unknown> {
    return new Promise((resolve, reject) => {
      this.pending.push({ resolve, reject, begun });
      this.raw.post(message, transfer);
    });
  }

  call<K extends PeerCall>(call: K, ...args: Parameters<Peer[K]>): Promise<Awaited<ReturnType<Peer[K]>>> {
    return this.request({ call, args }) as Promise<Awaited<ReturnType<Peer[K]>>>;
  }

  /** Resolves when the worker has begun the call; `result` when it has ended. */
  async begin<K extends PeerCall>(
    call: K,
    ...args: Parameters<Peer[K]>
  ): Promise<{ result: Promise<Awaited<ReturnType<Peer[K]>>>; }> {
    let begun: () => void = () => undefined;
    const started = new Promise<void>((resolve) => {
      begun = resolve;
    });
    const result = this.request({ call, args }, [], begun) as Promise<Awaited<ReturnType<Peer[K]>>>;
    await started;
    return { result };
  }

  stop(): void {
    this.broker.stop(this.participant);
  }

  /** Kills the worker wherever it is. It is out of the graph at once; resolves when it runs no more. */
  terminate(): Promise<void> {
    return this.bury(false);
  }

  /** Lets the worker take its leave. */
  async leave(): Promise<void> {
    await this.call('close');
    await this.bury(true);
  }

  /** At the end of a scene: whoever waits for nothing can be used again. */
  retire(): Promise<void> {
    const { release } = this.raw;
    if (release === undefined || this.pending.length > 0) return this.terminate();
    this.burial ??= (async () => {
      await this.call('close');
      this.broker.end(this.participant, true);
      this.broker.gone(this.participant);
      release();
    })();
    return this.burial;
  }

  /** As the page does it (node_runner.ts). */
  private bury(closed: boolean): Promise<void> {
    this.burial ??= (async () => {
      const gone = this.raw.terminate();
      this.broker.end(this.participant, closed);
      await gone;
      this.broker.gone(this.participant);
    })();
    return this.burial;
  }
}

export function newBroker(kind: LinkKind): Broker {
  return kind === 'shared' ? new SharedBroker({ ceiling: 256 << 20 }) : new PortBroker();
}

export class World {
  readonly broker: Broker;
  private readonly start: () => Promise<RawWorker>;
  protected readonly workers: RemotePeer[] = [];

  constructor(kind: LinkKind, start: () => Promise<RawWorker>) {
    this.broker = newBroker(kind);
    this.start = start;
  }

  get kind(): LinkKind {
    return this.broker.kind;
  }

  peer(): Promise<RemotePeer> {
    return this.peerOf(this.broker);
  }

  protected async peerOf(broker: Broker): Promise<RemotePeer> {
    const admission = broker.admit();
    if (admission === undefined) throw new Error('no place for a worker');
    const peer = new RemotePeer(await this.start(), broker, admission.participant);
    this.workers.push(peer);
    await peer.request({ ticket: admission.ticket }, admission.transfer);
    return peer;
  }

  async close(): Promise<void> {
    await Promise.all(this.workers.map((worker) => worker.retire()));
    this.broker.close();
  }
}
