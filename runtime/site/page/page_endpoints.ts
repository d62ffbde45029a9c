// The page's publishers, subscriptions and clients. Calls always settle: with a reply, or with a SiteError.

import { EndpointKind } from '../../protocol/generated/constants.ts';
import { gidText } from '../bus/graph_view.ts';
import type { CallOptions, MessageListener, PageClient, PagePublisher, PageSubscription } from '../contract/page_node.ts';
import { closedError, guarded, type Made, type Participant } from './participant.ts';
import { SiteError } from '../contract/site_error.ts';

const defaultTimeoutMs = 10_000;

/** ms since 1970 of the ns in two words. */
export function wordsMs(words: Int32Array, at: number): number {
  return ((words[at]! >>> 0) + words[at + 1]! * 2 ** 32) / 1e6;
}

class Endpoint {
  protected readonly page: Participant;
  protected readonly handle: number;
  problem: SiteError | undefined;
  protected closed = false;

  constructor(page: Participant, made: Made) {
    this.page = page;
    this.handle = 'handle' in made ? made.handle : -1;
    this.problem = 'problem' in made ? made.problem : undefined;
  }

  protected get alive(): boolean {
    return this.problem === undefined && !this.closed;
  }

  matched(): number {
    return this.alive ? Math.max(0, this.page.broker.link.matched(this.handle)) : 0;
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    this.page.forget(this);
    if (this.handle < 0) return;
    this.page.unread(this.handle);
    this.page.broker.link.endpointDestroy(this.handle);
    this.page.broker.wrote();
  }
}

export class Publisher extends Endpoint implements PagePublisher {
  /** Under way while readers on the port link make room. */
  private waiting = false;
  /** Why the message before was not sent after all. */
  private lost: SiteError | undefined;

  publish(bytes: Uint8Array): SiteError | undefined {
    if (this.problem !== undefined) return this.problem;
    if (this.closed) return closedError('the publisher');
    if (this.waiting) {
      return new SiteError('R2W0718', 'the publisher cannot take more now', { why: 'a subscription that wants every message has not read the last ones' });
    }
    const { lost } = this;
    this.lost = undefined;
    if (lost !== undefined) return lost;
    const result = this.page.write(this.handle, bytes, 'the publisher');
    if (result instanceof SiteError) return result;
    if (typeof result === 'object') {
      this.waiting = true;
      void result.then((problem) => {
        this.waiting = false;
        this.lost = problem;
      }, (error: unknown) => {
        this.waiting = false;
        this.problem = new SiteError('R2W0718', `the publisher failed: ${error instanceof Error ? error.message : String(error)}`);
      });
    }
    return undefined;
  }
}

export class Subscription extends Endpoint implements PageSubscription {
  constructor(page: Participant, made: Made, listener: MessageListener) {
    super(page, made);
    if (this.handle < 0) return;
    page.read({
      handle: this.handle,
      takeOne: () => {
        const taken = page.take(this.handle);
        if (taken === undefined) return false;
        const { bytes, words } = taken;
        const info = { publishedAt: wordsMs(words, 4), receivedAt: page.broker.link.clock.systemNs() / 1e6, gid: gidText(words.subarray(12, 16)) };
        guarded(() => listener(bytes, info));
        return true;
      },
    });
  }
}

interface Call {
  readonly request: Uint8Array;
  readonly resolve: (reply: Uint8Array<ArrayBuffer>) => void;
  readonly reject: (error: SiteError) => void;
  /** Keys of the servers that got it; undefined: it waits for one. */
  servers?: readonly number[];
  sequence?: number;
}

export class Client extends Endpoint implements PageClient {
  readonly name: string;
  private readonly type: string;
  private readonly calls = new Set<Call>();
  private unwatch: (() => void) | undefined;

  constructor(page: Participant, made: Made, name: string, type: string) {
    super(page, made);
    this.name = name;
    this.type = type;
    if (this.handle >= 0) page.read({ handle: this.handle, takeOne: () => this.takeOne() });
  }

  ready(): boolean {
    return this.matched() > 0;
  }

  call(request: Uint8Array, { timeoutMs = defaultTimeoutMs, signal }: CallOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
    if (this.problem !== undefined) return Promise.reject(this.problem);
    if (this.closed || signal?.aborted === true) return Promise.reject(closedError(this.name));
    return new Promise((resolve, reject) => {
      const abort = (): void => call.reject(closedError(this.name));
      let takeBack = (): void => undefined;
      const settle = (): void => {
        takeBack();
        signal?.removeEventListener('abort', abort);
        this.calls.delete(call);
        if (this.calls.size > 0) return;
        this.unwatch?.();
        this.unwatch = undefined;
      };
      const call: Call = {
        request: request.slice(),
        resolve: (reply) => {
          settle();
          resolve(reply);
        },
        reject: (error) => {
          settle();
          reject(error);
        },
      };
      this.calls.add(call);
      signal?.addEventListener('abort', abort, { once: true });
      takeBack = this.page.timers.after(timeoutMs, () => call.reject(call.servers === undefined ? this.absent() : this.late(timeoutMs)));
      this.send(call);
      // When it could not be sent it is over.
      if (!this.calls.has(call)) return;
      this.unwatch ??= this.watchServers();
    });
  }

  private absent(): SiteError {
    return new SiteError('R2W0716', `no node offers the service \`${this.name}\``, { why: `its type would be ${this.type}` });
  }

  private late(timeoutMs: number): SiteError {
    return new SiteError('R2W0717', `the service \`${this.name}\` did not answer within ${timeoutMs / 1000} s`);
  }

  /** A reply that was written before the server's end is still taken: so who is gone is looked up before what came is. */
  private watchServers(): () => void {
    let gone: Call[] = [];
    let version: number | undefined;
    return this.page.watch({
      before: () => {
        const now = this.page.broker.link.graphVersion();
        if (now === version) return;
        version = now;
        const servers = new Set(this.servers());
        gone = [...this.calls].filter((call) => call.servers?.every((key) => !servers.has(key)) === true);
      },
      after: () => {
        for (const call of gone.splice(0)) {
          if (!this.calls.has(call)) continue;
          call.reject(new SiteError('R2W0716', `the node that was asked for \`${this.name}\` has gone without an answer`));
        }
        for (const call of this.calls) if (call.servers === undefined) this.send(call);
      },
    });
  }

  private servers(): readonly number[] {
    const { link } = this.page.broker;
    // Brings the replica up to date.
    link.matched(this.handle);
    return [...link.graphReplica.named(this.name)]
      .filter(({ kind, type }) => kind === EndpointKind.server && type === this.type)
      .map(({ key }) => key);
  }

  private send(call: Call): void {
    if (!this.ready()) return;
    const servers = this.servers();
    if (servers.length === 0) return;
    const result = this.page.write(this.handle, call.request, this.name);
    if (result instanceof SiteError) {
      call.reject(result);
    } else if (typeof result === 'object') {
      call.reject(closedError(this.name));
    } else {
      call.servers = servers;
      call.sequence = result;
    }
  }

  private takeOne(): boolean {
    const taken = this.page.take(this.handle);
    if (taken === undefined) return false;
    const sequence = taken.words[6];
    // One that nobody waits for any more falls through.
    for (const call of this.calls) if (call.sequence === sequence) call.resolve(taken.bytes);
    return true;
  }

  override close(): void {
    super.close();
    for (const call of [...this.calls]) call.reject(closedError(this.name));
  }
}
