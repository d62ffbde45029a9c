// The console of one node: the newest lines, with the log level where the line has one.

import type { ConsoleLine, ConsoleLog, LogLevel, Unsubscribe } from '../contract/session.ts';
import type { SentLine } from '../bus/console_sender.ts';

export const mostConsoleLines = 100_000;
/** Dropped in steps, so that moving the rest costs little. */
const mostKept = 1.25 * mostConsoleLines;

const logLine = /^(?:\u001b\[[0-9;]*m)*\[(DEBUG|INFO|WARN|ERROR|FATAL)\] \[/;

export class NodeConsole implements ConsoleLog {
  private ring: ConsoleLine[] = [];
  private fresh: ConsoleLine[] = [];
  private lost = 0;
  private readonly listeners = new Set<(lines: readonly ConsoleLine[]) => void>();
  private readonly schedule: (task: () => void) => void;

  /** `schedule` runs a task at the next animation frame. */
  constructor(schedule: (task: () => void) => void) {
    this.schedule = schedule;
  }

  add(sent: readonly SentLine[], dropped: number): void {
    if (dropped > 0) {
      this.lost += dropped;
      this.push({ time: sent[0]?.[1] ?? 0, stream: 'stderr', text: `... ${dropped} lines were dropped: the node prints faster than the page can show` });
    }
    for (const [stream, time, text] of sent) {
      const level = logLine.exec(text)?.[1] as LogLevel | undefined;
      this.push({ time, stream: stream === 1 ? 'stdout' : 'stderr', text, ...(level === undefined ? {} : { level }) });
    }
    this.trim();
  }

  private push(line: ConsoleLine): void {
    this.ring.push(line);
    if (this.listeners.size === 0) return;
    if (this.fresh.length === 0) this.schedule(() => this.tell());
    this.fresh.push(line);
  }

  private trim(): void {
    if (this.ring.length > mostKept) {
      this.lost += this.ring.length - mostConsoleLines;
      this.ring = this.ring.slice(-mostConsoleLines);
    }
    if (this.fresh.length > mostKept) this.fresh = this.fresh.slice(-mostConsoleLines);
  }

  private tell(): void {
    const lines = this.fresh;
    this.fresh = [];
    if (lines.length === 0) return;
    for (const listener of [...this.listeners]) listener(lines);
  }

  lines(): readonly ConsoleLine[] {
    return this.ring.slice(-mostConsoleLines);
  }

  dropped(): number {
    return this.lost + Math.max(0, this.ring.length - mostConsoleLines);
  }

  onLines(listener: (lines: readonly ConsoleLine[]) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  clear(): void {
    this.ring = [];
    this.fresh = [];
    this.lost = 0;
  }
}
