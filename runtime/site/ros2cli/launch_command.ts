// ros2 launch: the nodes of the site's launch file once more, with launch arguments of their own, until Ctrl-C.

import { fileName } from '../contract/file_name.ts';
import { readGiven, shownArguments } from '../contract/launch_arguments.ts';
import type { LaunchFile, NodeState, SiteDescription } from '../contract/session.ts';
import { type Command, CommandError, type Context, has } from './command.ts';

/** As the command line names it: below a package, or by its path. */
function namesOf({ file, package: from }: LaunchFile): string {
  return from === undefined ? file : `${from} ${fileName(file)}`;
}

/** The words that are launch arguments. Throws for another launch file than the site's. */
function argumentsFor(site: SiteDescription, words: readonly string[]): readonly string[] {
  const { launchFile } = site;
  const [first = '', second] = words;
  const isPath = second === undefined || second.includes(':=');
  const named = isPath ? first : `${first} ${second}`;
  if (!isPath && !site.packages.includes(first)) throw new CommandError(`Package '${first}' not found`);
  if (launchFile === undefined) throw new CommandError(`'${named}': this site carries no launch file, its manifest lists its nodes`);
  const { file, package: from } = launchFile;
  const isMeant = isPath ? first === file || first === fileName(file) : first === from && fileName(second) === fileName(file);
  if (!isMeant) throw new CommandError(`'${named}': of launch files the site has: ros2 launch ${namesOf(launchFile)}`);
  return words.slice(isPath ? 1 : 2);
}

/** The line about the state of a process, in the words of ROS 2 but without the pid. */
function saidOf(id: string, state: NodeState): string | undefined {
  switch (state.kind) {
    case 'running':
      return `[INFO] [${id}]: process started`;
    case 'exited':
      return state.code === 0 ? `[INFO] [${id}]: process has finished cleanly` : `[ERROR] [${id}]: process has died [exit code ${state.code}]`;
    case 'crashed':
      return `[ERROR] [${id}]: process has died [${state.message} (${state.code})]`;
    case 'stopped':
    case 'starting':
    case 'waiting':
      return undefined;
  }
}

/** Natively they would run twice too. */
function tellOfTwins({ session, warn }: Context): void {
  const running = session.nodes().filter(({ state }) => state.kind === 'running').map(({ id }) => id);
  if (running.length > 0) warn(`[WARNING] [launch]: beside what is launched these run already: ${running.join(', ')}`);
}

export const launchCommand: Command = {
  words: ['launch'],
  help: 'Run a launch file',
  positionals: [
    { name: 'package_name', meaning: 'launch_package' },
    { name: 'launch_file_name', meaning: 'launch_file', optional: true },
    { name: 'launch_arguments', meaning: 'launch_argument', optional: true, many: true },
  ],
  options: [
    { names: ['--noninteractive', '-n'], help: 'Run the launch system non-interactively, with no terminal associated' },
    { names: ['--show-args', '--show-arguments', '-s'], help: 'Show arguments that may be given to the launch file.' },
    { names: ['--show-all-subprocesses-output', '-a'], help: "Show all launched subprocesses' output by overriding their output configuration" },
  ],
  startsNodes: true,
  run: async (context, given) => {
    const { session } = context;
    const words = argumentsFor(session.site, given.positionals);
    if (has(given, 'show-args')) {
      context.print(shownArguments(session.site.launch?.arguments ?? []));
      return 0;
    }
    if (session.stepped !== undefined) throw new CommandError('A run with a seed takes no further nodes');
    tellOfTwins(context);
    let code = 0;
    let ended = (): void => undefined;
    const end = new Promise<void>((resolve) => {
      ended = resolve;
    });
    const launched = await session.launch({
      arguments: readGiven(words),
      onSaid: (text) => context.print(text),
      onNode: ({ id }, state) => {
        const said = saidOf(id, state);
        if (said !== undefined) context.print(said);
        if (state.kind === 'crashed') code = 1;
      },
      onLines: ({ id, output }, lines) => {
        // With output 'log', stdout goes to the log only: errors are always on the screen.
        const shown = output === 'log' && !has(given, 'show-all-subprocesses-output') ? lines.filter(({ stream }) => stream === 'stderr') : lines;
        for (const { text } of shown) context.print(`[${id}] ${text}`);
      },
      onEnd: ended,
    });
    const stop = (): void => {
      context.print('[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)');
      launched.stop();
    };
    context.signal.addEventListener('abort', stop, { once: true });
    if (context.signal.aborted) stop();
    await end;
    context.signal.removeEventListener('abort', stop);
    return code;
  },
};
