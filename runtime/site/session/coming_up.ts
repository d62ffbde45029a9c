// The programs that were started and have not created their endpoints yet: a view of the graph is incomplete until then. A
// command of native `ros2` takes about as long to start itself.

import type { SiteNode } from '../contract/session.ts';

/** One that computes for ever is not waited for. */
const longestMs = 20_000;
const lookMs = 250;

/**
 * Resolves when `longestMs` have passed since the last look at which an interpreter was still loading (how long that takes is
 * a matter of the machine, and nothing of the node's own has run), or at the signal.
 */
export function longEnough(isLoading: () => boolean, signal: AbortSignal): Promise<void> {
  return new Promise((resolve) => {
    let quietMs = 0;
    const end = (): void => {
      clearInterval(timer);
      signal.removeEventListener('abort', end);
      resolve();
    };
    const timer = setInterval(() => {
      quietMs = isLoading() ? 0 : quietMs + lookMs;
      if (quietMs >= longestMs) end();
    }, lookMs);
    signal.addEventListener('abort', end);
    if (signal.aborted) end();
  });
}

export class ComingUp {
  private readonly nodes = new Set<SiteNode>();
  private readonly waiting = new Set<() => void>();
  private readonly isLoading: () => boolean;

  /** `isLoading`: is the interpreter of any node still being loaded? */
  constructor(isLoading: () => boolean) {
    this.isLoading = isLoading;
  }

  begins(node: SiteNode): void {
    this.nodes.add(node);
  }

  /** It waits for the first time, or is over. */
  settled(node: SiteNode): void {
    this.nodes.delete(node);
    if (this.nodes.size === 0) { for (const go of [...this.waiting]) go(); }
  }

  /** Resolves when none is left, or the signal comes. */
  none(signal: AbortSignal): Promise<void> {
    return new Promise((resolve) => {
      const over = new AbortController();
      const go = (): void => {
        this.waiting.delete(go);
        over.abort();
        resolve();
      };
      this.waiting.add(go);
      void longEnough(this.isLoading, AbortSignal.any([signal, over.signal])).then(go);
      if (this.nodes.size === 0) go();
    });
  }
}
