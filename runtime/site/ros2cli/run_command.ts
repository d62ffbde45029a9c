// ros2 run: a program of the site once more, beside its nodes, with arguments of its own.

import type { KeyMode } from '../contract/session.ts';
import { type Command, CommandError } from './command.ts';
import { programsOf } from './programs.ts';

const killedCode = 137;

export const runCommand: Command = {
  words: ['run'],
  help: 'Run a package specific executable',
  positionals: [
    { name: 'package_name', meaning: 'program_package' },
    { name: 'executable_name', meaning: 'executable' },
    { name: 'argv', meaning: 'text', rest: true },
  ],
  options: [],
  run: (context, { positionals }) => {
    const { session } = context;
    const [from = '', executable = '', ...words] = positionals;
    if (!session.site.packages.includes(from)) throw new CommandError(`Package '${from}' not found`);
    const programs = programsOf(session.site);
    if (!programs.some((program) => program.package === from && program.executable === executable)) {
      const others = programs.filter((program) => program.package === from).map((program) => program.executable);
      throw new CommandError(`No executable found${others.length === 0 ? '' : `; of this package the site has: ${others.join(', ')}`}`);
    }
    if (session.stepped !== undefined) throw new CommandError('A run with a seed takes no further nodes');
    return new Promise((ended) => {
      const id = session.run({
        package: from,
        executable,
        arguments: words,
        onLines: (lines) => {
          for (const { stream, text } of lines) (stream === 'stdout' ? context.print : context.warn)(text);
        },
        onEnd: (state) => {
          off();
          context.takeInput(undefined);
          context.signal.removeEventListener('abort', stop);
          if (state.kind === 'crashed') context.warn(`[ros2run]: ${state.message} (${state.code})`);
          else if (state.code === killedCode) context.warn('[ros2run]: Killed');
          ended(state.kind === 'crashed' ? 1 : state.code);
        },
      });
      const stop = (): void => session.stop(id);
      const take = (text: string): void => session.sendInput(id, text);
      let keys: KeyMode | undefined;
      const off = session.onNodes((nodes) => {
        const now = nodes.find((node) => node.id === id)?.terminal;
        if (now === keys) return;
        keys = now;
        context.takeInput(take, keys);
      });
      context.takeInput(take);
      context.signal.addEventListener('abort', stop, { once: true });
      if (context.signal.aborted) stop();
    });
  },
};
