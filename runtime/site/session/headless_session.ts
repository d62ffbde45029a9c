// Code shared by the Node.js programs that run a site: their workers, a session, the text for a site that cannot run.

import type { Writable } from 'node:stream';
import { parentPort, workerData } from 'node:worker_threads';
import { PortBroker, SharedBroker } from '../bus/broker.ts';
import { nodeFiles, nodePlatform, readFileNow, workerMark } from './node_platform.ts';
import { serveWorker } from '../workers/node_worker.ts';
import type { WorkerOrder } from '../workers/worker_messages.ts';
import type { CommandLoader } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { readSite } from '../contract/site_reader.ts';
import { SiteSession } from './site_session.ts';

/** To be called where the program is not the main thread: its workers run the same file. */
export function serveHeadlessWorker(): void {
  if (workerData !== workerMark || parentPort === null) return;
  const port = parentPort;
  const handle = serveWorker((report) => port.postMessage(report), readFileNow, {
    files: nodeFiles,
    python: async () => ({
      run: (await import('../python/python_program.ts')).runPython,
      makeImage: (await import('../python/python_image.ts')).makeImage,
      runLaunch: (await import('../launch/launch_python.ts')).runLaunch,
    }),
    openChannel: (name) => new BroadcastChannel(name),
  });
  port.on('message', (order: WorkerOrder) => handle(order));
}

export interface HeadlessSite {
  readonly session: SiteSession;
  close(): void;
}

/** `entry`: the program's own file. Rejects with a SiteError. */
export async function openHeadless(folder: string, link: 'shared' | 'port', entry: URL, commands?: CommandLoader): Promise<HeadlessSite> {
  const platform = nodePlatform(folder, entry);
  const site = readSite(await platform.json('site.json'));
  platform.expect(site.files);
  const broker = link === 'port' ? new PortBroker() : new SharedBroker();
  const session = new SiteSession({ site, platform, broker, ...(commands === undefined ? {} : { commands }) });
  return {
    session,
    close: () => {
      session.close();
      platform.close();
    },
  };
}

export function siteErrorText({ code, message, place, why, fix }: SiteError): string {
  const where = place === undefined ? [] : [`  --> ${place}`];
  return [`error[${code}]: ${message}`, ...where, ...why.map((line) => `   = why: ${line}`), ...fix.map((line) => `   = fix: ${line}`), ''].join('\n');
}

/** Once all that was printed has gone out: a pipe takes only so much at a time, and exit() drops the rest. */
export async function exitWhenPrinted(
  code: number,
  streams: readonly Writable[] = [process.stdout, process.stderr],
  exit: (code: number) => void = (given) => process.exit(given),
): Promise<void> {
  const gone = (stream: Writable): Promise<void> => new Promise((done) => void stream.write('', () => done()));
  await Promise.all(streams.map(gone));
  exit(code);
}

/** Calls `end` when the reader closes the output, as `| head -1` does: later output is lost, which is not the program's fault. */
export function endWhenNobodyReads(end: () => void): void {
  for (const stream of [process.stdout, process.stderr]) {
    stream.on('error', (error: NodeJS.ErrnoException) => {
      if (error.code !== 'EPIPE') throw error;
      end();
    });
  }
}
