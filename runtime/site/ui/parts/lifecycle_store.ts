// The managed nodes of the graph: their states and the transitions that they take now, read over their services and
// followed over `transition_event`; and what came of a transition that was asked for. A node that has gone stays, as gone.

import type { GraphView, PageTimer, Session, Unsubscribe } from '../../contract/session.ts';
import type { Codec } from '../../decode/codec.ts';
import type { Caller } from '../../ros2cli/calls.ts';
import { changeState, managedNodes, stateOf, transitionsOf } from '../../ros2cli/lifecycle_calls.ts';
import type { State } from '../../ros2cli/lifecycle_calls.ts';
import { isHiddenName } from '../../decode/ros_names.ts';
import { member, textMember } from '../model/json.ts';
import { viewTexts } from '../texts_views.ts';

const EVENT_TYPE = 'lifecycle_msgs/msg/TransitionEvent';
const MOST_TRANSITIONS = 30;
/** After a read that failed: the node may only have been busy. By the site's time. */
const AGAIN_MS = 2000;

export interface ManagedNode {
  /** Fully qualified. */
  readonly name: string;
  /** Does it offer its services now? */
  readonly here: boolean;
  /** null: not read yet. */
  readonly state: State | null;
  /** Those it takes now. */
  readonly transitions: readonly State[];
  /** The one that is asked for, until it is answered. */
  readonly asked: State | null;
  /** The result of the last transition. */
  readonly answer: string;
  /** Why the last one was not made; empty: it was. */
  readonly problem: string;
  /** Why its state could not be read; empty: it was. */
  readonly unread: string;
}

interface Entry {
  view: ManagedNode;
  /** The gid of the service that reports its state; another gid means another node of that name. */
  gid: string;
  /** Reads that began later have a larger one. */
  turn: number;
  /** Ends what is asked of the node that has gone. */
  abort: AbortController;
  stop: Unsubscribe;
  /** Reads once more, after a read that failed. */
  again: PageTimer | undefined;
}

export class LifecycleStore {
  private readonly session: Session;
  private readonly codec: Codec;
  private readonly changed: () => void;
  private readonly entries = new Map<string, Entry>();
  private readonly stop: Unsubscribe;
  private closed = false;

  constructor(session: Session, codec: Codec, changed: () => void) {
    this.session = session;
    this.codec = codec;
    this.changed = changed;
    this.stop = session.onGraph((graph) => this.follow(graph));
    this.follow(session.graph());
  }

  /** Sorted by name; hidden ones are skipped. */
  nodes(): readonly ManagedNode[] {
    return [...this.entries.values()]
      .map(({ view }) => view)
      .filter(({ name }) => !isHiddenName(name))
      .sort((a, b) => (a.name < b.name ? -1 : 1));
  }

  /** Never rejects: what came of it stands in the node's view. Gives it as words, too; empty when nobody wants them. */
  async change(name: string, transition: State): Promise<string> {
    const entry = this.entries.get(name);
    if (entry === undefined || !entry.view.here || entry.view.asked !== null) return '';
    const { abort } = entry;
    // A read that is under way would give an old state: it is dropped.
    entry.turn += 1;
    entry.again?.close();
    this.show(entry, { asked: transition, answer: '', problem: '' });
    try {
      const done = await changeState(this.caller(abort), name, transition.id, Number.POSITIVE_INFINITY);
      if (abort.signal.aborted) return '';
      const words = done ? viewTexts.lifecycle.done(transition.label) : viewTexts.lifecycle.refused(transition.label);
      this.show(entry, { asked: null, ...(done ? { answer: words } : { problem: words }) });
      return words;
    } catch (error) {
      if (abort.signal.aborted) return '';
      const words = viewTexts.lifecycle.failed(transition.label, wordsOf(error));
      this.show(entry, { asked: null, problem: words });
      return words;
    } finally {
      this.read(entry);
    }
  }

  close(): void {
    this.closed = true;
    this.stop();
    for (const entry of this.entries.values()) this.leave(entry);
  }

  private caller({ signal }: AbortController): Caller {
    return { session: this.session, signal, codec: () => Promise.resolve(this.codec) };
  }

  private follow(graph: GraphView): void {
    const gids = new Map<string, string>();
    for (const { name, services } of managedNodes(graph)) {
      const gid = services.find((service) => service.name === `${name}/get_state`)?.gid;
      if (gid !== undefined) gids.set(name, gid);
    }
    for (const entry of this.entries.values()) {
      if (gids.has(entry.view.name) || !entry.view.here) continue;
      this.leave(entry);
      this.show(entry, { here: false, transitions: [], asked: null, unread: '' });
    }
    for (const [name, gid] of gids) {
      const known = this.entries.get(name);
      if (known?.gid === gid) continue;
      if (known !== undefined) this.leave(known);
      const entry: Entry = {
        view: { name, here: true, state: null, transitions: [], asked: null, answer: '', problem: '', unread: '' },
        gid,
        turn: 0,
        abort: new AbortController(),
        stop: () => undefined,
        again: undefined,
      };
      this.entries.set(name, entry);
      // Before it is read: what happens meanwhile is not missed.
      const heard = this.session.node().subscription(`${name}/transition_event`, EVENT_TYPE, { depth: 100 }, (bytes) => {
        const event = this.codec.decode(EVENT_TYPE, bytes);
        const goal = event.kind === 'value' ? (member(event.value, 'goal_state') as State | undefined) : undefined;
        if (goal !== undefined) this.show(entry, { state: { id: goal.id, label: textMember(goal, 'label') } });
        this.read(entry);
      });
      entry.stop = () => heard.close();
      this.read(entry);
    }
  }

  private leave(entry: Entry): void {
    entry.gid = '';
    entry.turn += 1;
    entry.abort.abort();
    entry.stop();
    entry.stop = () => undefined;
    entry.again?.close();
  }

  /** While a transition is made the node's callback works and nothing else is answered: what is true is read at its end. */
  private read(entry: Entry): void {
    if (entry.abort.signal.aborted || entry.view.asked !== null) return;
    entry.turn += 1;
    entry.again?.close();
    const { turn } = entry;
    const { name } = entry.view;
    const caller = this.caller(entry.abort);
    Promise.all([stateOf(caller, name), transitionsOf(caller, name)]).then(
      ([state, transitions]) => {
        if (entry.turn !== turn) return;
        this.show(entry, {
          state,
          transitions: transitions.slice(0, MOST_TRANSITIONS).map(({ transition }) => transition),
          unread: '',
        });
      },
      (error: unknown) => {
        if (entry.turn !== turn || entry.abort.signal.aborted) return;
        entry.again = this.session.node().timer(AGAIN_MS, () => this.read(entry));
        this.show(entry, { unread: wordsOf(error) });
      },
    );
    this.show(entry, {});
  }

  private show(entry: Entry, next: Partial<ManagedNode>): void {
    entry.view = { ...entry.view, ...next };
    if (!this.closed) this.changed();
  }
}

function wordsOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
