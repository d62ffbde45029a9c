// The launch file's nodes once more, as `ros2 launch` starts them: with names of their own, and with the launch file's steps.

import { idleReason, interruptedReason, LaunchSteps, noReason } from './launch_steps.ts';
import type { PageNode } from '../contract/page_node.ts';
import type { ProcessRunner } from '../program/process_runner.ts';
import type { LaunchedNodes, LaunchMoment, LaunchRequest, LaunchStep, SiteNode } from '../contract/session.ts';

export interface LaunchGroupHost {
  /** An id for one more process of that executable. `but`: what it cannot be either. */
  readonly idFor: (executable: string, but: ReadonlySet<string>) => string;
  /** Runs nothing yet. */
  readonly runnerOf: (node: SiteNode, told: RunnerTold) => ProcessRunner;
  /** They are over: their ids are free. */
  readonly free: (ids: readonly string[]) => void;
  readonly after: (ms: number, task: () => void) => () => void;
  readonly pageNode: () => PageNode;
}

/** The callbacks of a runner for one of the group's nodes. */
export interface RunnerTold {
  readonly changed: () => void;
  readonly happened: (event: 'start' | 'exit' | 'stop') => void;
  readonly shutdown: () => void;
  readonly lines: (lines: readonly (readonly [stream: number, time: number, text: string])[]) => void;
}

type Ids = ReadonlyMap<string, string>;

function renamedMoment<Moment extends LaunchMoment>(on: Moment, ids: Ids): Moment {
  return on.node === undefined ? on : { ...on, node: ids.get(on.node) ?? on.node };
}

function renamedStep(step: LaunchStep, ids: Ids): LaunchStep {
  const own = 'node' in step ? { ...step, node: ids.get(step.node) ?? step.node } : step;
  return own.on === undefined ? own : { ...own, on: renamedMoment(own.on, ids) };
}

export class LaunchGroup implements LaunchedNodes {
  private readonly host: LaunchGroupHost;
  private readonly asked: LaunchRequest;
  private readonly runners = new Map<string, ProcessRunner>();
  private readonly steps: LaunchSteps;
  private looked = true;
  private over = false;

  constructor(nodes: readonly SiteNode[], steps: readonly LaunchStep[], asked: LaunchRequest, host: LaunchGroupHost) {
    this.host = host;
    this.asked = asked;
    const ids = new Map<string, string>();
    for (const { id, executable } of nodes) ids.set(id, host.idFor(executable, new Set(ids.values())));
    const renamed = nodes.map((node): SiteNode => ({
      ...node,
      id: ids.get(node.id) ?? node.id,
      ...(node.startOn === undefined ? {} : { startOn: renamedMoment(node.startOn, ids) }),
    }));
    this.steps = new LaunchSteps({
      nodes: renamed,
      steps: steps.map((step) => renamedStep(step, ids)),
      after: (ms, task) =>
        host.after(ms, () => {
          task();
          this.look();
        }),
      state: (id) => this.runner(id).view().state,
      start: (id, afterSeconds) => this.runner(id).start(afterSeconds * 1000),
      stop: (id) => this.runner(id).stop(),
      stopAll: (reason) => this.end(reason),
      idle: () => this.idle(),
      say: (level, logger, text) => asked.onSaid(`[${level}] [${logger}]: ${text}`),
      pageNode: host.pageNode,
    });
    for (const node of renamed) this.runners.set(node.id, host.runnerOf(node, this.toldOf(node)));
    this.steps.prepare();
    for (const { id, startOn, startAfter } of renamed) {
      if (startOn === undefined) this.runner(id).start(startAfter * 1000);
      else this.runner(id).wait(startOn);
    }
    this.steps.launched();
    this.look();
  }

  stop(): void {
    this.end(interruptedReason);
  }

  private end(reason: string): void {
    if (this.over) return;
    this.steps.shutdown(reason);
    for (const runner of this.runners.values()) runner.stop();
    this.look();
  }

  private toldOf(node: SiteNode): RunnerTold {
    let before = '';
    return {
      changed: () => {
        const { state } = this.runner(node.id).view();
        if (state.kind !== before) this.asked.onNode(node, state);
        before = state.kind;
        this.look();
      },
      happened: (event) => this.steps.happened(node.id, event),
      shutdown: () => this.end(noReason),
      lines: (lines) => {
        this.asked.onLines(node, lines.map(([stream, , text]) => ({ stream: stream === 1 ? 'stdout' : 'stderr', text })));
        this.steps.printed(node.id, lines);
      },
    };
  }

  private runner(id: string): ProcessRunner {
    const runner = this.runners.get(id);
    if (runner === undefined) throw new RangeError(`the launch has no node ${id}`);
    return runner;
  }

  private idle(): boolean {
    return ![...this.runners.values()].some((runner) => runner.active() || runner.respawns());
  }

  /** Whether that was all. Once what happens now has had its say: an end may start another node. */
  private look(): void {
    if (!this.looked || this.over) return;
    this.looked = false;
    queueMicrotask(() => {
      this.looked = true;
      if (this.over || this.steps.busy() || !this.idle()) return;
      this.over = true;
      this.steps.shutdown(idleReason);
      this.steps.close();
      for (const runner of this.runners.values()) runner.stop();
      this.host.free([...this.runners.keys()]);
      this.asked.onEnd();
    });
  }
}
