// Sends what a stick says: at once and then at a rate of the site's time while it is held, one zero when it is let go,
// then nothing.

import type { PagePublisher, PageTimer, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { refusal } from '../model/draft_value.ts';
import { isRest, REST, TWIST, TWIST_STAMPED, twistOf } from '../model/twist.ts';
import type { Limits, Stick } from '../model/twist.ts';

export interface TwistTarget {
  readonly topic: string;
  readonly stamped: boolean;
  readonly frame: string;
}

export class TwistSender {
  limits: Limits = { linear: 0, angular: 0 };
  rateHz = 10;
  private readonly session: Session;
  private readonly codec: Codec;
  private readonly target: TwistTarget;
  private readonly told: (problem: string) => void;
  private publisher: PagePublisher | undefined;
  private timer: PageTimer | undefined;
  private stick = REST;
  /** The last message was no zero, so one is owed. */
  private moving = false;

  constructor(session: Session, codec: Codec, target: TwistTarget, told: (problem: string) => void) {
    this.session = session;
    this.codec = codec;
    this.target = target;
    this.told = told;
  }

  /** So that subscriptions have found it when the first message is sent. */
  open(): void {
    if (this.publisher !== undefined) return;
    const { topic, stamped } = this.target;
    const publisher = this.session.node().publisher(topic, stamped ? TWIST_STAMPED : TWIST);
    if (publisher.problem === undefined) this.publisher = publisher;
    this.told(publisher.problem?.message ?? '');
  }

  /** Sets the stick that is held now. */
  hold(stick: Stick): void {
    if (stick.ahead === this.stick.ahead && stick.turn === this.stick.turn) return;
    const started = isRest(this.stick);
    this.stick = stick;
    // Between two sticks the rate decides: a finger that moves tells more often than a robot wants to know.
    if (!started && !isRest(stick)) return;
    this.open();
    this.send();
    this.pace();
  }

  /** The rate is another one. */
  pace(): void {
    this.timer?.close();
    this.timer = isRest(this.stick) && !this.moving ? undefined : this.session.node().timer(1000 / this.rateHz, () => this.beat());
  }

  private beat(): void {
    this.send();
    if (isRest(this.stick) && !this.moving) this.pace();
  }

  private send(): void {
    const rest = isRest(this.stick);
    if (this.publisher === undefined || (rest && !this.moving)) {
      this.moving = false;
      return;
    }
    const { stamped, frame } = this.target;
    const value = twistOf(this.stick, this.limits, stamped ? { nowMs: this.session.time.view().now, frame } : undefined);
    const made = this.codec.encode(stamped ? TWIST_STAMPED : TWIST, value);
    const problem = made.kind === 'failed' ? refusal(made) : this.publisher.publish(made.bytes)?.message;
    this.told(problem ?? '');
    // A zero that did not go out is sent again at the next beat, unless it can never be.
    if (problem === undefined) this.moving = !rest;
    else if (made.kind === 'failed') this.moving = false;
  }

  /** Stands still first. */
  close(): void {
    this.hold(REST);
    this.timer?.close();
    this.timer = undefined;
    this.publisher?.close();
    this.publisher = undefined;
  }
}
