// Runs a site from the sources, one whose launch file starts no commands of `ros2`: for what lies below these. Sites are run by
// ros2cli/headless_run_main.ts.

import { isMainThread } from 'node:worker_threads';
import { runMain } from './headless_run.ts';
import { serveHeadlessWorker } from './headless_session.ts';

if (!isMainThread) serveHeadlessWorker();
else if (import.meta.main) await runMain(new URL(import.meta.url));
