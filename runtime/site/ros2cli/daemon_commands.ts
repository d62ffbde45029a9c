// ros2 daemon: a site has no daemon and needs none. The commands answer as the tool does, so that lab sheets work unchanged.

import type { Session } from '../contract/session.ts';
import type { Command } from './command.ts';

/** Sessions whose daemon was stopped by the command. */
const stopped = new WeakSet<Session>();

function command(verb: 'start' | 'status' | 'stop', help: string, answer: (session: Session) => string): Command {
  return {
    words: ['daemon', verb],
    help,
    positionals: [],
    options: [],
    run: (context) => {
      context.print(answer(context.session));
      return Promise.resolve(0);
    },
  };
}

export const daemonCommands: readonly Command[] = [
  command('start', "Start the daemon if it isn't running",
    (session) => stopped.delete(session) ? 'The daemon has been started' : 'The daemon is already running'),
  command('status', 'Output the status of the daemon', (session) => `The daemon is ${stopped.has(session) ? 'not ' : ''}running`),
  command('stop', 'Stop the daemon if it is running', (session) => {
    if (stopped.has(session)) return 'The daemon is not running';
    stopped.add(session);
    return 'The daemon has been stopped';
  }),
];
