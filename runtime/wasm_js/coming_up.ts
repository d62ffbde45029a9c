// Which programs have been started and not yet made what they make: who looks at the graph then sees it half made. A command
// of `ros2` natively takes about as long to start itself.

import type { SiteNode } from './session.ts';

/** One that computes for ever is not waited for. */
const longestMs = 20_000;

export class ComingUp {
  private readonly nodes = new Set<SiteNode>();
  private readonly waiting = new Set<() => void>();

  begins(node: SiteNode): void {
    this.nodes.add(node);
  }

  /** It waits for the first time, or is over. */
  settled(node: SiteNode): void {
    this.nodes.delete(node);
    if (this.nodes.size === 0) for (const go of [...this.waiting]) go();
  }

  /** Resolves when none is left, or the signal comes. */
  none(signal: AbortSignal): Promise<void> {
    return new Promise((resolve) => {
      const go = (): void => {
        clearTimeout(timer);
        this.waiting.delete(go);
        signal.removeEventListener('abort', go);
        resolve();
      };
      const timer = setTimeout(go, longestMs);
      this.waiting.add(go);
      signal.addEventListener('abort', go);
      if (this.nodes.size === 0 || signal.aborted) go();
    });
  }
}
