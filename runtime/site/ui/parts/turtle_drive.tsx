// Drives a turtle with the moves of turtle_teleop_key: by arrow keys, by the letters around F, which turn it to a heading,
// and by a pad whose buttons may be held.

import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { PagePublisher, PageTimer, Session } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import { problemOf } from '../model/problem.ts';
import { panelTexts } from '../texts_panels.ts';
import { Icon } from './icon.tsx';
import { matched } from './matched.ts';
import { TurtleHeading } from './turtle_heading.ts';
import { useLetGo } from './use_let_go.ts';

const TWIST = 'geometry_msgs/msg/Twist';
/** Units per second and radians per second, as turtle_teleop_key. */
const LINEAR = 2;
const ANGULAR = 2;
/** A turtle goes on for a second after each command. */
const HOLD_MS = 250;

const MOVES = {
  forward: { key: 'ArrowUp', linear: LINEAR, angular: 0 },
  left: { key: 'ArrowLeft', linear: 0, angular: ANGULAR },
  back: { key: 'ArrowDown', linear: -LINEAR, angular: 0 },
  right: { key: 'ArrowRight', linear: 0, angular: -ANGULAR },
} as const;

export type TurtleMove = keyof typeof MOVES;
const MOVE_NAMES = ['forward', 'left', 'back', 'right'] as const satisfies readonly TurtleMove[];

export interface TurtleDrive {
  readonly move: (move: TurtleMove) => void;
  /** Takes the key if it is an arrow, or one of the letters, by itself. */
  readonly key: (event: KeyboardEvent) => void;
  /** Moves until release(), by the site's time. */
  readonly hold: (move: TurtleMove) => void;
  readonly release: () => void;
}

/** `topic` is empty while there is no turtle. The page becomes its publisher at the first move. */
export function useTurtleDrive(
  session: Session,
  codec: Codec | null,
  topic: string,
  tell: (problem: string) => void,
): TurtleDrive {
  const told = useRef(tell);
  told.current = tell;
  const drive = useMemo(() => new Driver(session, codec, topic, (problem) => told.current(problem)), [session, codec, topic]);
  useEffect(() => () => drive.close(), [drive]);
  return drive;
}

class Driver implements TurtleDrive {
  private outlet: { readonly publisher: PagePublisher; readonly ready: Promise<void>; } | null = null;
  private timer: PageTimer | null = null;
  private heading: TurtleHeading | null = null;
  private closed = false;
  private readonly session: Session;
  private readonly codec: Codec | null;
  private readonly topic: string;
  private readonly tell: (problem: string) => void;

  constructor(session: Session, codec: Codec | null, topic: string, tell: (problem: string) => void) {
    this.session = session;
    this.codec = codec;
    this.topic = topic;
    this.tell = tell;
  }

  readonly move = (move: TurtleMove): void => {
    this.send(move).catch((error: unknown) => this.tell(problemOf(error).what));
  };

  readonly key = (event: KeyboardEvent): void => {
    if (event.defaultPrevented || event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
    if (this.topic === '') return;
    if (TurtleHeading.knows(event.key) && this.codec !== null) {
      event.preventDefault();
      // The topic is the turtle's `cmd_vel`, and its action lies beside that.
      const action = `${this.topic.slice(0, this.topic.lastIndexOf('/'))}/rotate_absolute`;
      this.heading ??= new TurtleHeading(this.session, this.codec, action);
      this.heading.key(event.key).then(() => this.tell(''), (error: unknown) => this.tell(problemOf(error).what));
      return;
    }
    const move = MOVE_NAMES.find((name) => MOVES[name].key === event.key);
    if (move === undefined) return;
    event.preventDefault();
    this.move(move);
  };

  readonly hold = (move: TurtleMove): void => {
    this.release();
    this.move(move);
    this.timer = this.session.node().timer(HOLD_MS, () => this.move(move));
  };

  readonly release = (): void => {
    this.timer?.close();
    this.timer = null;
  };

  close(): void {
    this.closed = true;
    this.release();
    this.outlet?.publisher.close();
    this.heading?.close();
  }

  private async send(move: TurtleMove): Promise<void> {
    if (this.codec === null || this.topic === '' || this.closed) return;
    const { linear, angular } = MOVES[move];
    const made = this.codec.encode(TWIST, {
      linear: { x: linear, y: 0, z: 0 },
      angular: { x: 0, y: 0, z: angular },
    });
    if (made.kind === 'failed') throw new Error(made.reason);
    if (this.outlet === null) {
      const publisher = this.session.node().publisher(this.topic, TWIST, { depth: 1 });
      if (publisher.problem !== undefined) throw publisher.problem;
      this.outlet = { publisher, ready: matched(publisher) };
    }
    const { publisher, ready } = this.outlet;
    await ready;
    if (this.closed) return;
    const problem = publisher.publish(made.bytes);
    this.tell(problem === undefined ? '' : problem.message);
  }
}

export function TurtlePad({ drive, turtle }: { readonly drive: TurtleDrive; readonly turtle: string; }) {
  useLetGo(drive.release);
  return (
    <div class="turtle-pad" role="group" aria-label={panelTexts.turtlesim.pad}>
      {MOVE_NAMES.map((move) => (
        <button
          key={move}
          type="button"
          class={`turtle-key turtle-${move}`}
          aria-label={panelTexts.turtlesim.moves[move](turtle)}
          aria-disabled={turtle === '' ? 'true' : undefined}
          onPointerDown={(event) => {
            if (event.button !== 0) return;
            event.currentTarget.setPointerCapture(event.pointerId);
            drive.hold(move);
          }}
          onPointerUp={drive.release}
          onPointerCancel={drive.release}
          onLostPointerCapture={drive.release}
          onContextMenu={(event) => event.preventDefault()}
          onClick={(event) => {
            // A pointer has moved the turtle already: this is a key, or a click that a program makes.
            if (event.detail === 0) drive.move(move);
          }}
        >
          <Icon name="down" />
        </button>
      ))}
    </div>
  );
}
