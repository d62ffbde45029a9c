// Commands of `ros2` that a site's launch file starts: run as in a terminal, but that nothing is typed, and that paths below
// the site's prefix are its own files.

import type { BagSource } from '../bag/bag_file.ts';
import type { CommandLoader, RunningCommand, Session } from '../contract/session.ts';
import type { Terminal } from './command.ts';
import { codecOf, runCommand } from './run.ts';
import { yamlReader } from './yaml_reader.ts';

type Own = Pick<Terminal, 'bags' | 'readText'>;

/** The path in the site; undefined: it lies elsewhere. */
function pathInSite({ prefix, site }: Session, name: string, endings: readonly string[]): string | undefined {
  if (!name.startsWith(`${prefix}/`)) return undefined;
  const path = name.slice(prefix.length + 1).replace(/\/+$/, '');
  const isThere = (one: string): boolean => site.files.some((file) => file.path === one);
  return endings.map((ending) => path + ending).find(isThere);
}

/** A bag that is a folder: its recording, when it is one file. */
function recordingIn({ prefix, site }: Session, name: string): string | undefined {
  if (!name.startsWith(`${prefix}/`)) return undefined;
  const folder = `${name.slice(prefix.length + 1).replace(/\/+$/, '')}/`;
  const found = site.files.filter(({ path }) => path.startsWith(folder) && path.endsWith('.mcap'));
  return found.length === 1 ? found[0]?.path : undefined;
}

async function bagOf(path: string, file: RunningCommand['file']): Promise<BagSource> {
  const bytes = new Uint8Array(await file(path));
  return { name: path, size: bytes.length, read: (from, length) => Promise.resolve(bytes.slice(from, from + length)) };
}

/** `own`: where bags and texts are that are no files of the site. */
export function launchedCommands(own: Own): CommandLoader {
  return async (session) => {
    // Once they are there nothing else is waited for than what the command asks of the site.
    await Promise.all([codecOf(session), yamlReader()]);
    return ({ words, print, warn, file, signal }) =>
      runCommand(session, words, {
        signal,
        print,
        warn,
        takeInput: () => undefined,
        readText: async (name) => {
          const path = pathInSite(session, name, ['']);
          return path === undefined ? await own.readText(name) : new TextDecoder().decode(await file(path));
        },
        bags: {
          open: async (name) => {
            const path = pathInSite(session, name, ['', '.mcap']) ?? recordingIn(session, name);
            return path === undefined ? await own.bags.open(name) : await bagOf(path, file);
          },
          create: (name) => own.bags.create(name),
        },
      });
  };
}
