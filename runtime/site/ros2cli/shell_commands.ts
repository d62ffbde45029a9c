// The commands of `ros2` that a site's launch file starts, when the site runs from a shell. A site is of others, perhaps: of
// the shell's files they read none, and all that they write are new recordings, in the folder where it is.

import { fileName } from '../contract/file_name.ts';
import type { CommandLoader } from '../contract/session.ts';
import type { BagOutput } from './command.ts';
import { launchedCommands } from './launched_command.ts';
import { bagFiles } from './shell_files.ts';

const nowhere: BagOutput = { write: () => undefined, end: () => undefined };

/** `keepsBags`: else what is recorded is lost. */
export function shellCommands(keepsBags: boolean): CommandLoader {
  return launchedCommands({
    readText: () => Promise.resolve(undefined),
    bags: {
      open: () => Promise.resolve(undefined),
      create: (name) => (keepsBags ? bagFiles.create(fileName(name)) : Promise.resolve(nowhere)),
    },
  });
}
