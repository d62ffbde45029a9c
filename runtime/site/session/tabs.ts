// Joins the graphs of several tabs of one site: finds the others, starts a bridge to each, knows which nodes they run.
// A tab is there as long as it holds its lock, which the browser takes from it however it ends.

import type { Broker } from '../bus/broker.ts';
import type { Platform, WorkerHandle } from '../workers/platform.ts';
import { SiteError } from '../contract/site_error.ts';

export interface TabsOptions {
  /** Tabs with the same name join. */
  readonly graph: string;
  /** Where the site lies; other sites of the host have graphs of their own. */
  readonly site: string;
  readonly broker: Broker;
  readonly platform: Platform;
  /** Another tab came, went, or started or stopped a node. */
  readonly changed: () => void;
}

/** The message by which the tabs of a graph inform each other, besides data. */
interface TabNews {
  readonly id: string;
  readonly number: number;
  /** Ids of the nodes that run there. */
  readonly nodes: readonly string[];
}

interface OtherTab {
  news: TabNews;
  readonly worker: WorkerHandle | undefined;
  readonly participant: number | undefined;
}

type Release = () => void;

export class Tabs {
  readonly graph: string;
  /** The smallest that no tab of the graph has. */
  readonly number: number;
  private readonly options: TabsOptions;
  private readonly prefix: string;
  private readonly id: string;
  private readonly meeting: BroadcastChannel;
  private readonly others = new Map<string, OtherTab>();
  private readonly held = new Map<string, Release>();
  private readonly ends = new AbortController();
  private nodes: readonly string[] = [];
  private closed = false;

  /** Throws SiteError R2W0712 where a browser lacks what it takes. */
  static async join(options: TabsOptions): Promise<Tabs> {
    if (typeof navigator === 'undefined' || navigator.locks === undefined || typeof BroadcastChannel === 'undefined') {
      throw new SiteError('R2W0712', `this page cannot join the graph \`${options.graph}\` of other tabs`, {
        why: 'the browser has no locks between tabs here: it is too old, or the address is neither https:// nor localhost',
        fix: 'open the site over https:// or from localhost, in a current browser',
      });
    }
    const prefix = `ros2wasm ${options.site} ${options.graph}`;
    const id = crypto.randomUUID();
    const present = await hold(`${prefix} tab ${id}`);
    for (let number = 1;; number += 1) {
      const release = await hold(`${prefix} number ${number}`);
      if (release === undefined) continue;
      return new Tabs(options, prefix, id, number, [present, release]);
    }
  }

  private constructor(options: TabsOptions, prefix: string, id: string, number: number, held: readonly (Release | undefined)[]) {
    this.options = options;
    this.graph = options.graph;
    this.prefix = prefix;
    this.id = id;
    this.number = number;
    for (const [i, release] of held.entries()) if (release !== undefined) this.held.set(`${i}`, release);
    this.meeting = new BroadcastChannel(prefix);
    this.meeting.onmessage = ({ data }: MessageEvent<TabNews>) => this.hear(data);
    this.tell();
  }

  /** Numbers of the other tabs in which a node runs, in order. */
  elsewhere(node: string): readonly number[] {
    return [...this.others.values()].filter(({ news }) => news.nodes.includes(node)).map(({ news }) => news.number).sort((a, b) => a - b);
  }

  /** How many other tabs there are. */
  get size(): number {
    return this.others.size;
  }

  /** True when no other tab has claimed the node; it is this tab's until it is given back, or the tab ends. */
  async claim(node: string): Promise<boolean> {
    const name = `node ${node}`;
    if (this.held.has(name)) return true;
    const release = await hold(`${this.prefix} ${name}`);
    if (release === undefined) return false;
    if (this.closed) release();
    else this.held.set(name, release);
    return true;
  }

  /** Which nodes run here now; the claims of others are given back. */
  run(nodes: readonly string[]): void {
    if (nodes.join() === this.nodes.join()) return;
    for (const node of this.nodes) if (!nodes.includes(node)) this.giveBack(node);
    this.nodes = nodes;
    this.tell();
  }

  private giveBack(node: string): void {
    this.held.get(`node ${node}`)?.();
    this.held.delete(`node ${node}`);
  }

  private tell(): void {
    const news: TabNews = { id: this.id, number: this.number, nodes: this.nodes };
    if (!this.closed) this.meeting.postMessage(news);
  }

  private hear(news: TabNews): void {
    if (this.closed || news.id === this.id) return;
    const known = this.others.get(news.id);
    if (known === undefined) {
      this.others.set(news.id, { news, ...this.openBridge(news.id) });
      this.watch(news.id);
      this.tell();
    } else {
      known.news = news;
    }
    this.options.changed();
  }

  /** A bridge to one tab is a participant of its own, so that all of that tab goes at once when it dies. */
  private openBridge(other: string): Pick<OtherTab, 'worker' | 'participant'> {
    const { broker, platform } = this.options;
    const admission = broker.admit();
    if (admission === undefined) return { worker: undefined, participant: undefined };
    const { participant, ticket, transfer } = admission;
    const worker = platform.startWorker('bridge', { report: () => undefined, failed: () => this.drop(other) });
    const channel = `${this.prefix} ${[this.id, other].sort().join(' ')}`;
    worker.post({ t: 'bridge', ticket, channel }, transfer);
    return { worker, participant };
  }

  /** Another tab's lock is granted here only when that tab is gone. */
  private watch(other: string): void {
    navigator.locks.request(`${this.prefix} tab ${other}`, { signal: this.ends.signal }, () => this.drop(other))
      .catch(() => undefined);
  }

  private drop(other: string): void {
    const tab = this.others.get(other);
    if (tab === undefined) return;
    this.others.delete(other);
    const { worker, participant } = tab;
    if (worker !== undefined && participant !== undefined) {
      const { broker } = this.options;
      const gone = worker.terminate();
      broker.end(participant, false);
      // Its place is free when the worker runs no more.
      void gone.then(() => broker.gone(participant));
    }
    if (!this.closed) this.options.changed();
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    this.ends.abort();
    for (const other of [...this.others.keys()]) this.drop(other);
    this.meeting.close();
    for (const release of this.held.values()) release();
    this.held.clear();
  }
}

/** Takes a lock if nobody has it. The returned function releases it. */
function hold(name: string): Promise<Release | undefined> {
  return new Promise((resolve, reject) => {
    navigator.locks.request(name, { ifAvailable: true }, (lock) => {
      if (lock === null) {
        resolve(undefined);
        return undefined;
      }
      return new Promise<void>((release) => resolve(release));
    }).catch(reject);
  });
}
