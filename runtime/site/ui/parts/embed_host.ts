// Answers the page that shows this one in a frame (docs/page.md): reads what it asks for by postMessage, does it with the
// session, and tells what happens. It acts only for origins that the manifest lists, and runs no text as code.

import type { DiagnosticCode } from '../../contract/diagnostic_codes.ts';
import type { PagePublisher, Session, Unsubscribe } from '../../contract/session.ts';
import { onto, refusal, stampOf, withNow } from '../model/draft_value.ts';
import { Allowance, isReading, EMBED_VERSION, mayAct, readRequest, Refusal } from '../model/embed_request.ts';
import type { EmbedOrder } from '../model/embed_request.ts';
import type { Json } from '../model/json.ts';
import { siteHash } from '../model/link.ts';
import type { Store } from '../model/preferences.ts';
import { problemOf } from '../model/problem.ts';
import { embedTexts } from '../texts_embed.ts';
import { matched } from './matched.ts';
import { codecOf, feedBytes } from './message_feed.ts';
import { taskDesk } from './task_desk.ts';

const words = embedTexts.refusals;

const MOST_SUBSCRIPTIONS = 16;
const MOST_PUBLISHERS = 16;
const MOST_WAITING = 16;
const MOST_MESSAGE_BYTES = 1 << 20;
const STATE_MS = 100;
const MOST_HEIGHT = 10_000;
/** At once, and in a second. */
const ORDERS = [200, 100] as const;
const REFUSALS = [20, 2] as const;

type Order<Kind extends EmbedOrder['do']> = Extract<EmbedOrder, { readonly do: Kind; }>;

/** Listens until the returned function is called. */
export function hostEmbedding(session: Session, store: Store | null): Unsubscribe {
  const host = new EmbedHost(session, store);
  const listen = (event: MessageEvent<unknown>): void => host.hear(event);
  addEventListener('message', listen);
  tellParent({ event: 'ready', versions: [EMBED_VERSION] }, '*');
  return () => {
    removeEventListener('message', listen);
    host.close();
  };
}

/** The session could not begin: there is nobody to ask. */
export function tellFailure(code: DiagnosticCode, message: string): void {
  tellParent({ event: 'failed', error: { code, message } }, '*');
}

function tellParent(what: Readonly<Record<string, unknown>>, origin: string): void {
  window.parent.postMessage({ ros2wasm: EMBED_VERSION, ...what }, origin);
}

class EmbedHost {
  private readonly session: Session;
  private readonly store: Store | null;
  private readonly orders = new Allowance(...ORDERS, performance.now());
  private readonly refusals = new Allowance(...REFUSALS, performance.now());
  private readonly subscriptions = new Map<number, Unsubscribe>();
  private readonly publishers = new Map<string, PagePublisher>();
  private readonly leaving = new AbortController();
  private numbered = 0;
  private waiting = 0;
  private unwatch: Unsubscribe | undefined;

  constructor(session: Session, store: Store | null) {
    this.session = session;
    this.store = store;
  }

  hear({ source, origin, data }: MessageEvent<unknown>): void {
    if (source !== window.parent || source === window) return;
    const now = performance.now();
    const request = readRequest(data);
    if (request === null) return;
    const { id, order } = request;
    // A page that may not act could have a null origin, which no address names; the answer goes to this window only.
    const to = origin === 'null' ? '*' : origin;
    const fail = (error: unknown): void => {
      const { code, what, why, fix } = problemOf(error);
      tellParent({ id, ok: false, error: { code, message: what, why, fix } }, to);
    };
    if (!this.orders.take(now)) {
      // Rate-limit the "too many requests" replies as well.
      if (this.refusals.take(now)) fail(tooMany(words.tooOften(ORDERS[1])));
      return;
    }
    if (order instanceof Refusal) return fail(order);
    const acts = mayAct(origin, location.origin, this.session.site.embed);
    if (!acts && !isReading(order)) return fail(notListed(origin));
    if (this.waiting >= MOST_WAITING) return fail(tooMany(words.busy()));
    this.waiting += 1;
    this.follow(order, to, acts)
      .then((result) => tellParent({ id, ok: true, result: result ?? null }, to))
      .catch(fail)
      .finally(() => {
        this.waiting -= 1;
      });
  }

  close(): void {
    this.leaving.abort();
    this.unwatch?.();
    for (const end of this.subscriptions.values()) end();
    for (const publisher of this.publishers.values()) publisher.close();
  }

  private async follow(order: EmbedOrder, to: string, acts: boolean): Promise<unknown> {
    const { session } = this;
    switch (order.do) {
      case 'hello': {
        const { name, title, version } = session.site;
        return { version: EMBED_VERSION, may: acts ? 'act' : 'read', link: session.link, site: { name, title, version, hash: await siteHash() } };
      }
      case 'state':
        return this.state();
      case 'height':
        return { height: wantedHeight() };
      case 'watch':
        return this.watch(order.on, to);
      case 'start':
      case 'stop':
      case 'restart':
        return this.run(order);
      case 'publish':
        return this.publish(order);
      case 'set_parameter':
        return this.setParameter(order);
      case 'subscribe':
        return this.subscribe(order, to);
      case 'unsubscribe':
        this.end(order.subscription);
        return null;
      case 'call':
        return this.call(order);
      case 'checks':
        return this.checks();
      case 'run_checks':
        return this.runChecks();
      case 'tasks':
        return this.tasks();
    }
  }

  private state(): unknown {
    const { state, rate, now } = this.session.time.view();
    return {
      nodes: this.session.nodes().map(({ id, label, state: node }) => ({
        id,
        label,
        state: node.kind,
        ...('code' in node ? { code: node.code } : {}),
      })),
      time: { state, rate, now },
      checks: (this.session.checks?.views() ?? []).map((check) => ({ title: check.title, state: check.state })),
      // This visit only: not every page may see the progress that the browser stores from earlier visits.
      tasks: (this.session.tasks?.views() ?? []).map(({ title, done, checks }) => ({
        title,
        done,
        checks: checks.map((check) => ({ title: check.title, state: check.state })),
      })),
    };
  }

  private watch(on: boolean, to: string): null {
    this.unwatch?.();
    this.unwatch = undefined;
    if (!on) return null;
    let timer: ReturnType<typeof setTimeout> | undefined;
    const soon = (): void => {
      timer ??= setTimeout(() => {
        timer = undefined;
        tellParent({ event: 'state', state: this.state() }, to);
      }, STATE_MS);
    };
    const ends = [this.session.onNodes(soon), this.session.time.onChange(soon), this.session.checks?.onChange(soon), this.session.tasks?.onChange(soon)];
    soon();
    this.unwatch = () => {
      clearTimeout(timer);
      for (const end of ends) end?.();
    };
    return null;
  }

  private run(order: Order<'start' | 'stop' | 'restart'>): null {
    const { session } = this;
    const named = session.nodes().filter(
      ({ id, label }) => order.node === null || [id, label, label.replace(/^\//, '')].includes(order.node),
    );
    if (named.length === 0) throw failed(words.node(order.node ?? ''));
    for (const { id } of named) session[order.do](id);
    return null;
  }

  /** Times may be `now`; what is skipped is as the definition has it. */
  private async encoded(type: string, value: Json): Promise<Uint8Array> {
    const codec = await codecOf(this.session);
    const parsed = codec.types.get(type);
    if (typeof parsed === 'string') throw failed(words.type(parsed));
    const drafted = codec.draft(type);
    if (drafted.kind === 'failed') throw failed([drafted.reason, '']);
    const whole = onto(drafted.value, value as Readonly<Record<string, unknown>>);
    const made = codec.encode(type, withNow(whole, parsed.shape, stampOf(this.session.time.view().now)));
    if (made.kind === 'failed') throw failed([refusal(made), '']);
    return made.bytes;
  }

  private async publish({ topic, type, message }: Order<'publish'>): Promise<null> {
    const bytes = await this.encoded(type, message);
    const key = `${topic} ${type}`;
    let publisher = this.publishers.get(key);
    if (publisher === undefined) {
      if (this.publishers.size >= MOST_PUBLISHERS) throw tooMany(words.publishers(MOST_PUBLISHERS));
      publisher = this.session.node().publisher(topic, type);
      if (publisher.problem !== undefined) {
        publisher.close();
        throw publisher.problem;
      }
      this.publishers.set(key, publisher);
      await matched(publisher);
    }
    const problem = publisher.publish(bytes);
    if (problem !== undefined) throw problem;
    return null;
  }

  private async setParameter({ node, name, value }: Order<'set_parameter'>): Promise<null> {
    const { setText, valuesOf } = await import('../../ros2cli/parameter_calls.ts');
    const caller = { session: this.session, codec: () => codecOf(this.session), signal: this.leaving.signal };
    const full = node.startsWith('/') ? node : `/${node}`;
    let text = JSON.stringify(value);
    try {
      // JavaScript writes 1.0 as 1, which would be a whole number.
      const [before] = Number.isInteger(value) ? await valuesOf(caller, full, [name]) : [];
      if (before?.['type'] === DOUBLE) text += '.0';
      const { successful, reason } = await setText(caller, full, name, text);
      if (successful) return null;
      throw failed(words.parameter(full, reason));
    } catch (error) {
      throw error instanceof Refusal ? error : failed([error instanceof Error ? error.message : String(error), '']);
    }
  }

  private async subscribe({ topic, rate }: Order<'subscribe'>, to: string): Promise<unknown> {
    if (this.subscriptions.size >= MOST_SUBSCRIPTIONS)
      throw tooMany(words.subscriptions(MOST_SUBSCRIPTIONS));
    const number = (this.numbered += 1);
    let newest: { bytes: Uint8Array; type: string; time: number; } | undefined;
    let missed = 0;
    let timer: ReturnType<typeof setTimeout> | undefined;
    this.subscriptions.set(number, () => clearTimeout(timer));
    const codec = await codecOf(this.session).catch((error: unknown) => {
      // The requester has not received a number with which to end it.
      this.subscriptions.delete(number);
      throw error;
    });
    const tell = (): void => {
      timer = undefined;
      if (newest === undefined) return;
      const { bytes, type, time } = newest;
      newest = undefined;
      const read = bytes.length > MOST_MESSAGE_BYTES
        ? { error: embedTexts.tooLarge(bytes.length, MOST_MESSAGE_BYTES) }
        : messageOf(codec.decode(type, bytes));
      tellParent({ event: 'message', subscription: number, topic, type, time, missed, ...read }, to);
      missed = 0;
      timer = setTimeout(tell, 1000 / rate);
    };
    const end = feedBytes(this.session, topic, (bytes, type, info) => {
      if (newest !== undefined) missed += 1;
      newest = { bytes, type, time: info.publishedAt };
      if (timer === undefined) tell();
    });
    const stop = (): void => {
      clearTimeout(timer);
      end();
    };
    if (this.subscriptions.has(number) && !this.leaving.signal.aborted) this.subscriptions.set(number, stop);
    else stop();
    return { subscription: number };
  }

  private end(number: number): void {
    const stop = this.subscriptions.get(number);
    if (stop === undefined) throw failed(words.subscription());
    this.subscriptions.delete(number);
    stop();
  }

  private async call({ service, type, request, timeoutMs }: Order<'call'>): Promise<unknown> {
    const bytes = await this.encoded(`${type}_Request`, request);
    const client = this.session.node().client(service, type);
    try {
      const reply = await client.call(bytes, { timeoutMs, signal: this.leaving.signal });
      const codec = await codecOf(this.session);
      const read = codec.decode(`${type}_Response`, reply);
      if (read.kind === 'failed') throw failed([read.reason, '']);
      return read.value;
    } finally {
      client.close();
    }
  }

  private checks(): unknown {
    const checks = this.session.checks?.views() ?? [];
    return checks.map(({ title, state, seen, afterMs }) => ({ title, state, seen, ...(afterMs === undefined ? {} : { after_ms: afterMs }) }));
  }

  /** With what the browser keeps of earlier visits. */
  private tasks(): unknown {
    return taskDesk(this.session, this.store).tasks().map(({ title, checks, kept }) => ({
      title,
      done: kept.doneAt !== undefined,
      ...(kept.doneAt === undefined ? {} : { done_at: kept.doneAt }),
      ...(kept.hintAt === undefined ? {} : { hint_at: kept.hintAt }),
      ...(kept.solutionAt === undefined ? {} : { solution_at: kept.solutionAt }),
      checks: checks.map((check) => ({ title: check.title, state: check.state, seen: check.seen })),
    }));
  }

  /** Answers when all are decided. */
  private async runChecks(): Promise<unknown> {
    const { checks } = this.session;
    if (checks === undefined) throw failed(words.checks());
    checks.again();
    await new Promise<void>((resolve) => {
      const look = (): void => {
        if (!this.leaving.signal.aborted && checks.views().some(({ state }) => state === 'waiting')) return;
        end();
        resolve();
      };
      const end = checks.onChange(look);
      this.leaving.signal.addEventListener('abort', look, { once: true });
      look();
    });
    return this.checks();
  }
}

/** rcl_interfaces/msg/ParameterType.PARAMETER_DOUBLE */
const DOUBLE = 3;

/** The height of the frame, in px, with which no panel scrolls. Parts inside of a panel, such as a console, may still scroll. */
function wantedHeight(): number {
  const hidden = Array.from(document.querySelectorAll('.panel-body, .panel-body > *'), (body) => body.scrollHeight - body.clientHeight);
  return Math.min(MOST_HEIGHT, innerHeight + Math.max(0, ...hidden));
}

function messageOf(read: { readonly kind: 'value'; readonly value: unknown; } | { readonly kind: 'failed'; readonly reason: string; }): object {
  return read.kind === 'value' ? { message: read.value } : { error: read.reason };
}

function failed([message, fix]: readonly [string, string]): Refusal {
  return new Refusal('R2W0753', message, fix);
}

function tooMany([message, fix]: readonly [string, string]): Refusal {
  return new Refusal('R2W0752', message, fix);
}

function notListed(origin: string): Refusal {
  return new Refusal('R2W0751', ...words.origin(origin), embedTexts.originWhy);
}
