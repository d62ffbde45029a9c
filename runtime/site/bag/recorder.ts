// Records topics of a running site: subscribes to those that are wanted, and to those that come later, with what their
// publishers offer, and writes what comes in. All times are the site's.

import { gatherSchema } from '../decode/definitions.ts';
import type { GraphEndpointView, PageSubscription, Session } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { type BagSink, BagWriter } from './bag_writer.ts';
import { requestFor } from './qos_profiles.ts';

/** A recording ends by itself there. */
export const mostBagBytes = 2 ** 30;
const mostTopics = 2000;

export interface RecordOptions {
  /** Is a topic with that name and type recorded? */
  readonly wants: (name: string, type: string) => boolean;
  readonly onTopic?: (name: string) => void;
  /** Called once when it ends by itself. */
  readonly onEnd?: (problem: SiteError) => void;
  /** When other than mostBagBytes. */
  readonly mostBytes?: number;
}

interface Followed {
  readonly type: string;
  /** The reliability and durability that its subscription requests. */
  asked: string;
  subscription: PageSubscription;
}

export class Recorder {
  private readonly session: Session;
  private readonly options: RecordOptions;
  private readonly writer: BagWriter;
  private readonly definitions: ReadonlyMap<string, string>;
  private readonly followed = new Map<string, Followed>();
  /** Topics that the page could not subscribe to: not tried again at each change of the graph. */
  private readonly refused = new Set<string>();
  private readonly unwatch: () => void;
  private stopping: Promise<void> | undefined;
  /** ms since 1970. */
  readonly startedAt: number;

  /** Begins at once. Rejects when the definitions of types cannot be had. */
  static async begin(session: Session, sink: BagSink, options: RecordOptions): Promise<Recorder> {
    return new Recorder(session, sink, options, await session.interfaces());
  }

  private constructor(session: Session, sink: BagSink, options: RecordOptions, definitions: ReadonlyMap<string, string>) {
    this.session = session;
    this.options = options;
    this.definitions = definitions;
    this.startedAt = session.time.view().now;
    this.writer = new BagWriter(sink, { library: session.site.generator, distro: session.site.distro });
    this.unwatch = session.onGraph(() => this.look());
    this.look();
  }

  get messages(): number {
    return this.writer.messages;
  }

  get bytes(): number {
    return this.writer.bytes;
  }

  get topics(): number {
    return this.followed.size;
  }

  /** The length of the recording in ms of site time. */
  get durationMs(): number {
    return this.session.time.view().now - this.startedAt;
  }

  /** Resolves when all is written. */
  stop(): Promise<void> {
    this.stopping ??= this.end();
    return this.stopping;
  }

  private async end(): Promise<void> {
    this.unwatch();
    for (const { subscription } of this.followed.values()) subscription.close();
    await this.writer.end();
  }

  private look(): void {
    if (this.stopping !== undefined) return;
    const offers = new Map<string, GraphEndpointView[]>();
    for (const { publishers } of this.session.graph().nodes) {
      for (const publisher of publishers) {
        const before = offers.get(publisher.name);
        if (before === undefined) offers.set(publisher.name, [publisher]);
        else before.push(publisher);
      }
    }
    for (const [name, all] of offers) {
      const known = this.followed.get(name);
      const type = known?.type ?? all[0]!.type;
      if (!this.options.wants(name, type)) continue;
      this.follow(name, type, all.filter((one) => one.type === type), known);
    }
  }

  private follow(name: string, type: string, offers: readonly GraphEndpointView[], known: Followed | undefined): void {
    if (offers.length === 0 || (known === undefined && (this.followed.size >= mostTopics || this.refused.has(name)))) return;
    const request = requestFor(offers.map(({ qos }) => qos));
    const asked = `${request.reliability} ${request.durability}`;
    // The present subscription also matches a publisher that offers more.
    if (known !== undefined && (known.asked === asked || !weaker(asked, known.asked))) return;
    const subscribe = (): PageSubscription =>
      this.session.node().subscription(name, type, request, (data, info) => {
        if (this.stopping !== undefined) return;
        this.writer.addMessage(name, { data, logTime: nanoseconds(info.receivedAt), publishTime: nanoseconds(info.publishedAt) });
        if (this.writer.bytes >= (this.options.mostBytes ?? mostBagBytes)) this.full();
      });
    if (known !== undefined) {
      known.subscription.close();
      known.asked = asked;
      known.subscription = subscribe();
      if (known.subscription.problem !== undefined) known.subscription.close();
      return;
    }
    const subscription = subscribe();
    if (subscription.problem !== undefined) {
      this.refused.add(name);
      subscription.close();
      return;
    }
    // In the bag before anything that comes.
    this.writer.addTopic({
      name,
      type,
      hash: offers.find(({ hash }) => hash !== '')?.hash ?? '',
      schema: gatherSchema(type, this.definitions),
      offered: offers.map(({ qos }) => qos),
    });
    this.followed.set(name, { type, asked, subscription });
    this.options.onTopic?.(name);
  }

  private full(): void {
    void this.stop().catch(() => undefined);
    this.options.onEnd?.(new SiteError('R2W0742', 'the recording has ended: the bag is as large as one may become', {
      why: `a bag may have ${Math.round((this.options.mostBytes ?? mostBagBytes) / 2 ** 20)} MiB; what was recorded until then is whole`,
      fix: 'record fewer topics, or several bags',
    }));
  }
}

function weaker(asked: string, before: string): boolean {
  const rank = (text: string): number => (text.includes('best_effort') ? 1 : 0) + (text.includes('volatile') ? 1 : 0);
  return rank(asked) > rank(before);
}

/** Converts ms since 1970, which resolve some hundred ns. */
function nanoseconds(ms: number): bigint {
  return BigInt(Math.round(ms * 1e6));
}

/** Hidden topics begin with an underscore in one of their parts; those of actions are hidden so. */
export function recordsAll(hidden: boolean): (name: string) => boolean {
  return (name) => hidden || !/(?:^|\/)_/.test(name);
}
