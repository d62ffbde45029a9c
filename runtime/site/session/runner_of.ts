// Chooses the runner for a node of a site: a worker, or the page itself for a command of `ros2`.

import type { ComingUp } from './coming_up.ts';
import { CommandRunner } from './command_runner.ts';
import type { CommandPlace } from './command_work.ts';
import type { NodeConsole } from '../program/console_log.ts';
import { NodeRunner, type RunnerHost } from './node_runner.ts';
import type { ProcessRunner } from '../program/process_runner.ts';
import type { SiteNode } from '../contract/session.ts';

/** The members of the host that all runners of a session share. */
export type CommonHost = Omit<RunnerHost, 'changed' | 'settled' | 'shutdown' | 'happened' | 'lines' | 'event'> & {
  readonly comingUp: ComingUp;
  /** undefined: the session's maker has none. */
  readonly commands: CommandPlace | undefined;
};

export function runnerOf(node: SiteNode, console: NodeConsole, asked: RunnerHost & CommonHost): ProcessRunner {
  const host = {
    ...asked,
    settled: (of: SiteNode): void => {
      asked.comingUp.settled(of);
      asked.settled(of);
    },
  };
  return node.kind === 'command' ? new CommandRunner(node, console, host) : new NodeRunner(node, console, host);
}
