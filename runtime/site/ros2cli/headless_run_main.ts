// Runs a site without a browser: node headless.js SITE ...; its words and exit codes: session/headless_run.ts.

import { isMainThread } from 'node:worker_threads';
import { runMain } from '../session/headless_run.ts';
import { serveHeadlessWorker } from '../session/headless_session.ts';
import { shellCommands } from './shell_commands.ts';

if (isMainThread) await runMain(new URL(import.meta.url), shellCommands(true));
else serveHeadlessWorker();
