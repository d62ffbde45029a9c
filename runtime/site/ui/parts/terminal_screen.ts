// The lines of one terminal, drawn once per animation frame.

import type { ConsoleLine, Session } from '../../contract/session.ts';
import { LineList } from '../model/line_list.ts';
import { expandTabs } from '../model/terminal_input.ts';

const MOST_LINES = 20_000;
/** Upper bound of the lines that wait to be drawn; the oldest of them are dropped. */
const MOST_WAITING = 5000;

export class TerminalScreen {
  readonly list = new LineList(MOST_LINES);
  private waiting: ConsoleLine[] = [];
  private frame = 0;
  private readonly session: Session;
  private readonly drawn: () => void;

  constructor(session: Session, drawn: () => void) {
    this.session = session;
    this.drawn = drawn;
  }

  write(text: string, stream: ConsoleLine['stream']): void {
    const time = this.session.time.view().now;
    // One item, so that a flood of long outputs is bounded too.
    for (const line of text.split('\n')) this.waiting.push({ time, stream, text: expandTabs(line) });
    if (this.waiting.length > 2 * MOST_WAITING) this.waiting = this.waiting.slice(-MOST_WAITING);
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.flush());
  }

  clear(): void {
    this.waiting = [];
    this.list.clear();
    this.drawn();
  }

  private flush(): void {
    this.frame = 0;
    this.list.append(this.waiting.splice(0), '');
    this.drawn();
  }

  close(): void {
    cancelAnimationFrame(this.frame);
  }
}
