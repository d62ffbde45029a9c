// The commands of `ros2` that the site's launch file starts, in the page: the same code as the terminal's, with its files.

import { launchedCommands } from '../../ros2cli/launched_command.ts';
import type { CommandLoader } from '../../contract/session.ts';
import { HOME } from '../shell/paths.ts';
import { readText } from '../shell/session_files.ts';
import { bagsOf } from './terminal_files.ts';

export const pageCommands: CommandLoader = (session) => launchedCommands({ bags: bagsOf(session), readText: (name) => readText(session, HOME, name) })(session);
