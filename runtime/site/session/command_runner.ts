// A command of `ros2` that the launch file starts: a process of the launch that the page runs itself, over the session.

import type { CommandPlace, workOf } from './command_work.ts';
import type { NodeConsole } from '../program/console_log.ts';
import type { RunnerHost } from './node_runner.ts';
import { type ProcessHost, ProcessRunner } from '../program/process_runner.ts';
import type { CommandLoader, CommandNode, NodeView } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';

export interface CommandHost extends ProcessHost {
  readonly commands: CommandPlace | undefined;
  readonly lines: RunnerHost['lines'];
}

export class CommandRunner extends ProcessRunner<CommandNode> {
  private readonly host: CommandHost;
  private readonly commands: CommandPlace;
  private abort: AbortController | undefined;
  private startedAt: number | undefined;
  /** In a stepped run: the others wait for what it thinks. */
  private think: (() => void) | undefined;

  constructor(node: CommandNode, console: NodeConsole, host: CommandHost) {
    super(node, console, host);
    if (host.commands === undefined) throw new TypeError(`nobody was told how ${node.id} is run`);
    this.host = host;
    this.commands = host.commands;
  }

  override view(): NodeView {
    return { ...super.view(), command: true, ...(this.startedAt === undefined ? {} : { startedAt: this.startedAt }) };
  }

  protected override async launch(attempt: number): Promise<void> {
    const { broker } = this.host;
    const letGo = broker.conductor?.hold();
    try {
      const [{ workOf }, run] = await Promise.all([import('./command_work.ts'), this.commands.load(this.commands.session)]);
      // In a stepped run it begins when all others rest.
      if (broker.conductor === undefined) void this.go(workOf, run, attempt);
      else broker.after(0, () => void this.go(workOf, run, attempt));
    } catch (error) {
      if (this.attempt === attempt) this.fail(error instanceof SiteError ? error.code : 'R2W0708', reasonOf(error));
    } finally {
      letGo?.();
    }
  }

  private async go(work: typeof workOf, run: Awaited<ReturnType<CommandLoader>>, attempt: number): Promise<void> {
    if (this.attempt !== attempt) return;
    const { broker } = this.host;
    const abort = new AbortController();
    this.abort = abort;
    this.startedAt = Date.now();
    this.think = broker.conductor?.think();
    this.runs();
    this.host.settled(this.node);
    const state = await work({
      ...this.commands,
      run,
      words: this.node.arguments,
      broker,
      signal: abort.signal,
      say: (stream, text) => {
        if (this.attempt !== attempt) return;
        const time = broker.link.clock.systemNs() / 1e6;
        this.host.lines(this.node, { t: 'lines', lines: text.split('\n').map((line) => [stream, time, line]), dropped: 0 });
      },
    });
    if (this.attempt === attempt) this.finish(state);
  }

  protected override signal(): boolean {
    this.abort?.abort();
    return this.abort !== undefined;
  }

  protected override leave(): () => void {
    // One that is killed does not hear of it again; what it still does is nobody's.
    this.abort?.abort();
    this.abort = undefined;
    this.startedAt = undefined;
    const { think } = this;
    this.think = undefined;
    return () => think?.();
  }
}

function reasonOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
