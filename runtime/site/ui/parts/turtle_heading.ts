// Turns a turtle to a heading by the keys around F, as turtle_teleop_key does: a goal of its action rotate_absolute.

import type { PageActionClient, PageGoal, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';

const TYPE = 'turtlesim/action/RotateAbsolute';
const READY_MS = 2000;

/** Radians, each where the key lies beside F. */
const HEADINGS: ReadonlyMap<string, number> = new Map([
  ['g', 0],
  ['t', 1],
  ['r', 2],
  ['e', 3],
  ['d', 4],
  ['c', -3],
  ['v', -2],
  ['b', -1],
].map(([key, eighths]) => [String(key), (Number(eighths) * Math.PI) / 4]));
const CANCEL = 'f';

export class TurtleHeading {
  private client: PageActionClient | null = null;
  private goal: PageGoal | null = null;
  private readonly session: Session;
  private readonly codec: Codec;
  private readonly action: string;

  constructor(session: Session, codec: Codec, action: string) {
    this.session = session;
    this.codec = codec;
    this.action = action;
  }

  static knows(key: string): boolean {
    return key === CANCEL || HEADINGS.has(key);
  }

  /** Rejects when the goal could not be sent, or the simulator refuses it. */
  async key(key: string): Promise<void> {
    const theta = HEADINGS.get(key);
    if (theta === undefined) {
      if (key === CANCEL) await this.goal?.cancel();
      return;
    }
    const made = this.codec.encode(`${TYPE}_Goal`, { theta });
    if (made.kind === 'failed') throw new Error(made.reason);
    this.client ??= this.session.node().actionClient(this.action, TYPE);
    const { client } = this;
    for (const end = performance.now() + READY_MS; !client.ready() && performance.now() < end;)
      await new Promise((go) => setTimeout(go, 20));
    const goal = client.sendGoal(made.bytes);
    this.goal = goal;
    // How it ends is seen: another goal or an arrow ends it, too.
    goal.result.catch(() => undefined);
    await goal.accepted;
  }

  close(): void {
    this.client?.close();
  }
}
