// Decides the checks of a site while it runs. Loaded for sites that have checks; sees the Session only, as the page does.

import { createCodec } from '../decode/codec.ts';
import { type Look, startLook } from './check_looks.ts';
import { checkTitle } from './check_words.ts';
import type { PageTimer } from '../contract/page_node.ts';
import type { Session, Unsubscribe } from '../contract/session.ts';
import type { CheckView, SiteCheck, SiteChecks } from '../contract/site_checks.ts';

/** Looked at so often, in ms of the site's time. */
const beatMs = 250;

interface Running {
  readonly check: SiteCheck;
  /** When time began to count, ms of the site's time: the first node's start. */
  begin: number | undefined;
  look: Look | undefined;
  /** Once it is decided. */
  verdict: { readonly passed: boolean; readonly seen: string; readonly afterMs: number; } | undefined;
}

/** To be awaited before the first node starts. */
export async function runChecks(session: Session): Promise<CheckRun> {
  return new CheckRun(session, createCodec(await session.interfaces()));
}

export class CheckRun implements SiteChecks {
  private readonly session: Session;
  private readonly codec: ReturnType<typeof createCodec>;
  private readonly listeners = new Set<(views: readonly CheckView[]) => void>();
  private readonly stopNodes: Unsubscribe;
  private running: Running[] = [];
  private timer: PageTimer | undefined;
  private telling = false;
  private news = false;

  constructor(session: Session, codec: ReturnType<typeof createCodec>) {
    this.session = session;
    this.codec = codec;
    // So that publishers are known that are gone when it is next looked at.
    session.topics();
    this.start();
    this.stopNodes = session.onNodes(() => this.watchBegin());
    this.watchBegin();
  }

  views(): readonly CheckView[] {
    // seen() looks once more, which may decide a check: so it is called for all before any view is made.
    const looked = this.running.map(({ look, verdict }) => verdict === undefined ? look?.seen() : undefined);
    return this.running.map(({ check, verdict }, at) => ({
      title: checkTitle(check),
      state: verdict === undefined ? 'waiting' : verdict.passed ? 'passed' : 'failed',
      seen: verdict?.seen ?? looked[at] ?? '',
      ...(verdict === undefined ? {} : { afterMs: verdict.afterMs }),
      withinMs: check.withinMs,
      ...(check.source === undefined ? {} : { source: check.source }),
    }));
  }

  onChange(listener: (views: readonly CheckView[]) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  again(at?: number): void {
    this.halt(at);
    this.start(at);
    this.watchBegin();
    this.tell();
  }

  /** Undecided checks fail, since the run ends. */
  end(): void {
    for (const running of this.running) if (running.verdict === undefined) this.decide(running, false, running.look?.seen() ?? '');
  }

  close(): void {
    this.halt();
    this.stopNodes();
    this.listeners.clear();
  }

  private now(): number {
    return this.session.time.view().now;
  }

  /** All, or the one at that place. */
  private start(at?: number): void {
    const { session, codec } = this;
    const from = this.now();
    const before = this.running;
    this.running = session.site.checks.map((check, index) =>
      at === undefined || at === index ? { check, begin: undefined, look: undefined, verdict: undefined } : before[index]!
    );
    for (const running of this.running) {
      if (running.look !== undefined) continue;
      const { check } = running;
      // Lines bear whole ms.
      const inTime = (time: number): boolean => time >= Math.floor(from) && time <= (running.begin ?? Infinity) + check.withinMs;
      running.look = startLook(check.aim, { session, codec, inTime, met: (seen) => this.decide(running, true, seen) });
      if (running.verdict !== undefined) running.look.close();
    }
  }

  /** Time counts from when a node starts. */
  private watchBegin(): void {
    const waiting = this.running.filter(({ begin }) => begin === undefined);
    if (waiting.length === 0 || this.session.nodes().every(({ state }) => state.kind === 'stopped')) return;
    for (const running of waiting) running.begin = this.now();
    this.stopTimer();
    const shortest = Math.min(beatMs, ...this.running.map(({ check }) => check.withinMs));
    if (this.running.some(({ verdict }) => verdict === undefined)) {
      this.timer = this.session.node().timer(shortest, () => this.beat());
    }
    this.beat();
  }

  private beat(): void {
    for (const running of this.running) {
      if (running.verdict === undefined) running.look?.look();
      if (running.verdict !== undefined || running.begin === undefined) continue;
      if (this.now() < running.begin + running.check.withinMs) continue;
      const seen = running.look?.seen() ?? '';
      // A last look may have found it.
      if (this.undecided(running)) this.decide(running, false, seen);
    }
  }

  private undecided({ verdict }: Running): boolean {
    return verdict === undefined;
  }

  private decide(running: Running, passed: boolean, seen: string): void {
    if (running.verdict !== undefined) return;
    running.verdict = { passed, seen, afterMs: Math.max(0, this.now() - (running.begin ?? this.now())) };
    running.look?.close();
    if (this.running.every(({ verdict }) => verdict !== undefined)) this.stopTimer();
    this.tell();
  }

  private stopTimer(): void {
    this.timer?.close();
    this.timer = undefined;
  }

  private halt(at?: number): void {
    if (at === undefined) this.stopTimer();
    for (const { look, verdict } of at === undefined ? this.running : this.running.slice(at, at + 1)) if (verdict === undefined) look?.close();
  }

  /** A check that is decided during the listeners' calls is reported after them, once. */
  private tell(): void {
    this.news = true;
    if (this.telling) return;
    this.telling = true;
    try {
      while (this.news) {
        // views() may decide checks, and its result contains those decisions.
        const views = this.views();
        this.news = false;
        for (const listener of [...this.listeners]) listener(views);
      }
    } finally {
      this.telling = false;
    }
  }
}
