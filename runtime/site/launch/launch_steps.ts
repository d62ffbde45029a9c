// The actions of the launcher besides starting nodes, and their times: lines, transitions of managed nodes and the shutdown,
// as in the launch file; and the nodes that start when others have started, ended or changed their state.

import type { DiagnosticCode } from '../contract/diagnostic_codes.ts';
import { changeStateRequest, changeStateSucceeded, changeStateType, readTransitionEvent, transitionEventType, type StateChange } from './lifecycle_messages.ts';
import type { PageNode } from '../contract/page_node.ts';
import { type LaunchMoment, type LineTest, type LaunchStep, type LogLevel, type NodeState, type SiteNode, unreachable } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';

/** How long a managed node may have no change_state service before that is told. */
const tellAfterMs = 10_000;

const transitionLabels: Readonly<Record<number, string>> = {
  0: 'create',
  1: 'configure',
  2: 'cleanup',
  3: 'activate',
  4: 'deactivate',
  5: 'unconfigured_shutdown',
  6: 'inactive_shutdown',
  7: 'active_shutdown',
  8: 'destroy',
};

const logLevels: Readonly<Record<string, LogLevel>> = {
  debug: 'DEBUG',
  info: 'INFO',
  warning: 'WARN',
  warn: 'WARN',
  error: 'ERROR',
  critical: 'FATAL',
  fatal: 'FATAL',
};

/** In a text that is said of a line: where the line stands. printed_text.py and launch_step.hpp know it too. */
const printedLine = '\u2039what it prints\u203a';

/** In a text that is said at the end of all: where its reason stands. events/__init__.py and launch_step.hpp know it too. */
const shutdownReason = '\u2039why all ends\u203a';
/** The reason of a shutdown that gives none, in the words of launch. */
export const noReason = 'reason not given';
/** The reason of a launch that is stopped from outside. */
export const interruptedReason = 'ctrl-c (SIGINT)';
/** The reason of a launch in which no node runs any more. */
export const idleReason = 'idle';

function fits(line: string, { how, text, anyCase, holds }: LineTest): boolean {
  const [whole, part] = anyCase ? [line.toLowerCase(), text.toLowerCase()] : [line, text];
  switch (how) {
    case 'contains':
      return whole.includes(part) === holds;
    case 'begins':
      return whole.startsWith(part) === holds;
    case 'ends':
      return whole.endsWith(part) === holds;
    case 'is':
      return (whole === part) === holds;
    default:
      return unreachable(how);
  }
}

/** The step as it is after that line. */
function ofLine(step: LaunchStep, line: string): LaunchStep {
  if (step.do === 'log') return { ...step, text: step.text.replaceAll(printedLine, () => line) };
  return step.do === 'shutdown' ? { ...step, reason: step.reason.replaceAll(printedLine, () => line) } : step;
}

export interface LaunchStepsHost {
  readonly nodes: readonly SiteNode[];
  readonly steps: readonly LaunchStep[];
  /** Runs a task later; gives back what calls it off. */
  readonly after: (ms: number, task: () => void) => () => void;
  readonly state: (id: string) => NodeState;
  readonly start: (id: string, afterSeconds: number) => void;
  readonly stop: (id: string) => void;
  readonly stopAll: (reason: string) => void;
  /** No process runs, and none is about to. */
  readonly idle: () => boolean;
  /** A line of the launch's own, by the logger of that name. */
  readonly say: (level: LogLevel, logger: string, text: string) => void;
  /** The page's node; made when the first managed node is spoken to. */
  readonly pageNode: () => PageNode;
}

/** A transition that is under way: of the node's id. */
interface Talk {
  readonly node: string;
  readonly abandoned: AbortController;
}

export class LaunchSteps {
  private readonly host: LaunchStepsHost;
  /** Ends what is heard of managed nodes. */
  private readonly hearing: (() => void)[] = [];
  private hears = false;
  /** The function that cancels a step that is still to come -> that step. */
  private readonly pending = new Map<() => void, LaunchStep>();
  private readonly talks = new Set<Talk>();
  /** Transitions that wait until their node runs. */
  private readonly waiting = new Map<Extract<LaunchStep, { do: 'transition'; }>, string>();
  private readonly done = new Set<LaunchStep>();
  /** Handlers that looked at several processes and are followed once, by number. */
  private readonly over = new Set<number>();
  /** Nodes that were told to end by the launch, which is an end like any other. */
  private readonly ending = new Set<string>();
  /** Ids of the nodes whose output lines are tested. */
  private readonly printing: ReadonlySet<string>;
  private begun = false;
  private ended = false;

  constructor(host: LaunchStepsHost) {
    this.host = host;
    const moments = [...host.steps.map(({ on }) => on), ...host.nodes.map(({ startOn }) => startOn)];
    this.printing = new Set(moments.flatMap((on) => (on?.event === 'output' ? [on.node] : [])));
  }

  /** Before nodes are started. */
  prepare(): void {
    if (!this.hears) this.hear();
  }

  /**
   * All nodes that start with the launch have been told to. `added`: those alone, while others of the launch still ran;
   * of the steps only the transitions of these nodes are done again then.
   */
  launched(added?: ReadonlySet<string>): void {
    if (added !== undefined && this.begun && !this.ended) {
      for (const step of this.host.steps) {
        if (step.on !== undefined || step.do !== 'transition' || !added.has(step.node)) continue;
        for (const [callOff, of] of this.pending) if (of === step) callOff();
        this.later(step);
      }
      return;
    }
    this.cancel();
    this.begun = true;
    this.ended = false;
    this.done.clear();
    this.over.clear();
    for (const step of this.host.steps) if (step.on === undefined) this.later(step);
  }

  /** Something is yet to come by itself. */
  busy(): boolean {
    return this.pending.size > 0;
  }

  /** `stop`: it has ended, but not by itself. */
  happened(node: string, event: 'start' | 'exit' | 'stop'): void {
    if (event !== 'start') {
      this.abandon(node);
      this.look();
    }
    const isTold = this.ending.delete(node);
    if (event === 'stop' && !isTold) return;
    const happens = event === 'start' ? event : 'exit';
    this.follow((on) => on.node === node && on.event === happens);
    if (isTold && this.host.nodes.some(({ id, shutdownOnExit }) => id === node && shutdownOnExit)) this.host.stopAll(noReason);
    if (event !== 'start') return;
    for (const [step, of] of [...this.waiting]) {
      if (of !== node) continue;
      this.waiting.delete(step);
      void this.change(step);
    }
  }

  /** `stream`: 1 is standard output, 2 standard error. */
  printed(node: string, lines: readonly (readonly [stream: number, time: number, text: string])[]): void {
    if (!this.printing.has(node)) return;
    for (const [stream, , line] of lines) {
      const name = stream === 2 ? 'stderr' : 'stdout';
      this.follow((on) =>
        on.event === 'output' && on.node === node && on.stream === name
        && on.tests.every((test) => fits(line, test)), line);
    }
  }

  private changed(node: string, change: StateChange): void {
    const isAsked = (wanted: string | undefined, found: string): boolean => wanted === undefined || wanted === found;
    this.follow((on) =>
      on.node === node && on.event === 'transition' && isAsked(on.transition, change.transition)
      && isAsked(on.startState, change.startState) && isAsked(on.goalState, change.goalState)
    );
  }

  /** Whether that was all. Once what happens now has had its say: an end may start another node. */
  private look(): void {
    queueMicrotask(() => {
      if (this.begun && !this.busy() && this.host.idle()) this.shutdown(idleReason);
    });
  }

  /** All nodes are about to be stopped, or have ended. */
  shutdown(reason: string): void {
    if (this.ended) return;
    for (const step of this.host.steps) {
      if (step.on?.event !== 'shutdown' || step.do === 'shutdown') continue;
      this.run(step.do === 'log' ? { ...step, text: step.text.replaceAll(shutdownReason, () => reason) } : step);
    }
    this.ended = true;
    this.cancel();
  }

  close(): void {
    this.ended = true;
    this.cancel();
    for (const end of this.hearing.splice(0)) end();
  }

  private cancel(): void {
    for (const callOff of this.pending.keys()) callOff();
    this.waiting.clear();
    for (const { abandoned } of this.talks) abandoned.abort();
  }

  private follow(happens: (on: LaunchMoment) => boolean, line?: string): void {
    // All that a handler says is done, and then the handler is gone.
    const over = new Set<number>();
    const isMeant = (on: LaunchMoment): boolean => {
      if (!happens(on) || (on.handler !== undefined && this.over.has(on.handler))) return false;
      if (on.handler !== undefined) over.add(on.handler);
      return true;
    };
    const nodes = this.host.nodes.filter(({ startOn }) => startOn !== undefined && isMeant(startOn));
    const steps = this.ended ? [] : this.host.steps.filter(({ on }) => on !== undefined && isMeant(on));
    for (const handler of over) this.over.add(handler);
    for (const { id, startAfter } of nodes) if (this.host.state(id).kind === 'waiting') this.host.start(id, startAfter);
    if (this.ended) return;
    for (const step of steps) this.later(step, line);
  }

  private later(of: LaunchStep, line?: string): void {
    if (of.on?.once === true) {
      if (this.done.has(of)) return;
      this.done.add(of);
    }
    const step = line === undefined ? of : ofLine(of, line);
    if (step.after === 0) {
      this.run(step);
      return;
    }
    const end = this.host.after(step.after * 1000, () => {
      this.pending.delete(callOff);
      this.run(step);
      this.look();
    });
    const callOff = (): void => {
      this.pending.delete(callOff);
      end();
    };
    this.pending.set(callOff, of);
  }

  private run(step: LaunchStep): void {
    if (this.ended) return;
    switch (step.do) {
      case 'log':
        this.host.say(logLevels[step.level] ?? 'INFO', 'launch.user', step.text);
        return;
      case 'shutdown':
        this.host.say('INFO', 'launch', `all nodes are stopped: ${step.reason}`);
        this.host.stopAll(step.reason);
        return;
      case 'end': {
        const { kind } = this.host.state(step.node);
        if (kind !== 'running' && kind !== 'starting') return;
        this.ending.add(step.node);
        this.host.stop(step.node);
        return;
      }
      case 'transition': {
        const { kind } = this.host.state(step.node);
        // Another tab has the node and its launcher, or it is over.
        if (kind === 'running') void this.change(step);
        else if (kind === 'starting' || kind === 'waiting') this.waiting.set(step, step.node);
        return;
      }
      default:
        unreachable(step);
    }
  }

  /** Each transition when the one before has succeeded. */
  private async change({ node, name, transitions }: Extract<LaunchStep, { do: 'transition'; }>): Promise<void> {
    const talk: Talk = { node, abandoned: new AbortController() };
    this.talks.add(talk);
    const client = this.host.pageNode().client(`${name}/change_state`, changeStateType);
    const tell = this.host.after(tellAfterMs, () => {
      if (client.problem === undefined && !client.ready()) {
        this.fail('R2W0725', `\`${name}\` offers no service \`${name}/change_state\` so far: is it a managed node?`);
      }
    });
    try {
      for (const id of transitions) {
        const reply = await client.call(changeStateRequest(id), { timeoutMs: Infinity, signal: talk.abandoned.signal });
        if (changeStateSucceeded(reply)) continue;
        this.fail('R2W0725', `Failed to make transition '${transitionLabels[id] ?? String(id)}' for LifecycleNode '${name}'`);
        return;
      }
    } catch (error) {
      if (talk.abandoned.signal.aborted) {
        this.tellUnmade(name);
      } else {
        this.fail(error instanceof SiteError ? error.code : 'R2W0725', error instanceof Error ? error.message : String(error));
      }
    } finally {
      tell();
      client.close();
      this.talks.delete(talk);
    }
  }

  private fail(code: DiagnosticCode, text: string): void {
    if (!this.ended) this.host.say('ERROR', 'launch', `error[${code}]: ${text}`);
  }

  private tellUnmade(name: string): void {
    if (!this.ended) this.host.say('WARN', 'launch', `\`${name}\` ended before its transitions were made`);
  }

  private abandon(node: string): void {
    for (const [step, of] of [...this.waiting]) {
      if (of !== node) continue;
      this.waiting.delete(step);
      this.tellUnmade(step.name);
    }
    for (const talk of this.talks) if (talk.node === node) talk.abandoned.abort();
  }

  /** Follows the transitions of managed nodes that others depend on, from before the nodes start. */
  private hear(): void {
    this.hears = true;
    const names = new Map<string, string>();
    for (const { on } of this.host.steps) if (on?.event === 'transition') names.set(on.node, on.name);
    for (const { startOn: on } of this.host.nodes) if (on?.event === 'transition') names.set(on.node, on.name);
    for (const [node, name] of names) {
      const heard = this.host.pageNode().subscription(`${name}/transition_event`, transitionEventType, {}, (bytes) => {
        const change = readTransitionEvent(bytes);
        if (change !== undefined) this.changed(node, change);
      });
      if (heard.problem !== undefined) this.fail(heard.problem.code, heard.problem.message);
      this.hearing.push(() => heard.close());
    }
  }
}
