// One process of a site's launch: its state and its rules (start, stop, respawn). The classes that derive from it
// run the program.

import type { Broker } from '../bus/broker.ts';
import type { DiagnosticCode } from '../contract/diagnostic_codes.ts';
import type { NodeConsole } from './console_log.ts';
import type { NodeMoment, NodeState, NodeView, SiteNode } from '../contract/session.ts';

/** After a stop is requested; `ros2 launch` waits as long before it sends SIGTERM. */
export const stopGraceMs = 5000;
/** Exit code of a process that did not stop in time, as a shell tells of SIGKILL. */
const killedCode = 137;
/** A process that ends at once is not started again without pause. */
const leastRespawnMs = 100;

export interface ProcessHost {
  readonly broker: Broker;
  readonly changed: () => void;
  /** It is about to run. */
  readonly begins: (node: SiteNode) => void;
  /** It waits for the first time, or is over. */
  readonly settled: (node: SiteNode) => void;
  /** It ended, with which all shall end. */
  readonly shutdown: () => void;
  /** It has started, has ended by itself, or otherwise (`stop`): it was stopped, or could not start. */
  readonly happened: (node: SiteNode, event: 'start' | 'exit' | 'stop') => void;
}

export abstract class ProcessRunner<Node extends SiteNode = SiteNode> {
  readonly node: Node;
  readonly console: NodeConsole;
  /** Counts starts, so that what belongs to an older one is dropped. */
  protected attempt = 0;
  protected stopping = false;
  private readonly rules: ProcessHost;
  private state: NodeState = { kind: 'stopped' };
  private again = false;
  /** Its end is told: who ends all for that does not end it once more. */
  private ending = false;
  /** The timer that kills the process when the grace period after a stop is over. */
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Calls off a start that is yet to come. */
  private keepFromStart: (() => void) | undefined;
  /** Respawns since somebody started it. */
  private retries = 0;

  constructor(node: Node, console: NodeConsole, rules: ProcessHost) {
    this.node = node;
    this.console = console;
    this.rules = rules;
  }

  /** Runs it; the state is "starting". */
  protected abstract launch(attempt: number): Promise<void>;
  /** As SIGINT; false: it does not run yet. */
  protected abstract signal(): boolean;
  /** It runs no more; gives back what is done when its new state is told. */
  protected abstract leave(closed: boolean): () => void;

  /** Its place in the graph while it runs. */
  participant(): number | undefined {
    return undefined;
  }

  /** Its program has sent others what no program sends. */
  strange(): void {}

  /** Time of the site follows another law. */
  timeChanged(): void {}

  view(): NodeView {
    const { id, label, package: from, executable, source } = this.node;
    return { id, label, package: from, executable, state: this.state, ...(source === undefined ? {} : { source }) };
  }

  active(): boolean {
    return this.state.kind === 'starting' || this.state.kind === 'running';
  }

  /** Until start(), of another node's start or end. */
  wait(on: NodeMoment): void {
    if (this.active()) return;
    this.clearTimer();
    this.set({ kind: 'waiting', on });
  }

  /** Ended, and about to start by itself. */
  respawns(): boolean {
    return this.keepFromStart !== undefined && !this.active();
  }

  /** `afterMs`: it is starting until then. */
  start(afterMs = 0): void {
    if (this.active()) return;
    this.retries = 0;
    this.begin(afterMs);
  }

  protected begin(afterMs: number): void {
    if (this.active()) return;
    this.clearTimer();
    this.stopping = false;
    this.again = false;
    this.attempt += 1;
    this.set({ kind: 'starting' });
    const { attempt } = this;
    if (afterMs === 0) this.goes(attempt);
    else this.keepFromStart = this.rules.broker.after(afterMs, () => this.goes(attempt));
  }

  private goes(attempt: number): void {
    this.rules.begins(this.node);
    void this.launch(attempt);
  }

  /** As Ctrl-C; a second time, or after the grace, it is killed. */
  stop(): void {
    const respawned = this.respawns();
    this.clearTimer();
    if (respawned) this.rules.changed();
    if (this.state.kind === 'waiting') {
      this.rules.happened(this.node, 'stop');
      this.set({ kind: 'stopped' });
    }
    if (!this.active() || this.ending) return;
    const isSecond = this.stopping;
    this.stopping = true;
    if (isSecond || !this.signal()) {
      // It does not end by itself: no rule is followed.
      this.kill();
      return;
    }
    // It may have ended at once.
    if (this.active()) this.timer = setTimeout(() => this.kill(), stopGraceMs);
  }

  restart(): void {
    if (!this.active()) {
      this.start();
      return;
    }
    this.again = true;
    if (!this.stopping) this.stop();
  }

  /** Ends it wherever it is. */
  kill(): void {
    if (!this.active() || this.ending) return;
    this.attempt += 1;
    this.finish({ kind: 'exited', code: killedCode });
  }

  close(): void {
    this.again = false;
    this.stopping = true;
    this.kill();
    this.clearTimer();
  }

  protected runs(): void {
    this.set({ kind: 'running' });
    this.rules.happened(this.node, 'start');
  }

  /** It could not start. */
  protected fail(code: DiagnosticCode, message: string): void {
    this.rules.happened(this.node, 'stop');
    this.set({ kind: 'crashed', code, message });
  }

  protected finish(state: NodeState, closed = false): void {
    const byItself = !this.stopping && !this.again;
    const { respawnMaxRetries } = this.node;
    const respawns = this.node.respawn && byItself && (respawnMaxRetries === undefined || this.retries < respawnMaxRetries);
    const left = this.leave(closed);
    this.clearTimer();
    // Before the others of a stepped run go on.
    if (respawns) {
      const delay = Math.max(leastRespawnMs, this.node.respawnDelay * 1000);
      this.retries += 1;
      this.keepFromStart = this.rules.broker.after(delay, () => this.begin(0));
    }
    this.ending = true;
    this.rules.happened(this.node, byItself ? 'exit' : 'stop');
    this.ending = false;
    const { again } = this;
    this.stopping = false;
    this.again = false;
    this.attempt += 1;
    // Before time goes on: in a stepped run it may, as soon as the program is out of the graph.
    this.set(state);
    left();
    if (byItself && this.node.shutdownOnExit && !respawns) this.rules.shutdown();
    if (again) this.start();
  }

  private clearTimer(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.keepFromStart?.();
    this.keepFromStart = undefined;
  }

  private set(state: NodeState): void {
    this.state = state;
    this.rules.changed();
    if (!this.active()) this.rules.settled(this.node);
  }
}
