// `ros2` commands for a site without a browser: node ros2.js [--link shared|port] SITE WORDS... starts the site's
// nodes, runs the command and ends with its exit code. The nodes' own output is not shown.

import { isMainThread } from 'node:worker_threads';
import { longEnough } from '../session/coming_up.ts';
import { endWhenNobodyReads, exitWhenPrinted, openHeadless, serveHeadlessWorker, siteErrorText } from '../session/headless_session.ts';
import type { NodeView } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import type { SiteSession } from '../session/site_session.ts';
import { parseCommand } from './parse.ts';
import { shellCommands } from './shell_commands.ts';
import { bagFiles, textOfFile } from './shell_files.ts';
import { runCommand } from './run.ts';
import { commands } from './table.ts';

const usage = 'usage: node ros2.js [--link shared|port] SITE COMMAND...';
const interrupted = 130;
/** On message ports the graph comes in bit by bit. */
const discoveryMs = 200;

interface Asked {
  readonly site: string;
  readonly link: 'shared' | 'port';
  readonly words: readonly string[];
}

function parseArguments(argv: readonly string[]): Asked | undefined {
  let link: Asked['link'] = 'shared';
  let rest = argv;
  if (rest[0] === '--link') {
    if (rest[1] !== 'shared' && rest[1] !== 'port') return undefined;
    link = rest[1];
    rest = rest.slice(2);
  }
  const [site, ...words] = rest;
  return site === undefined || site.startsWith('-') ? undefined : { site, link, words };
}

function pause(ms: number): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, ms);
  });
}

/** All nodes have come to rest, or do not, or the command's own time is over, or Ctrl-C. */
async function allUp(session: SiteSession, words: readonly string[], signal: AbortSignal): Promise<void> {
  const up = new AbortController();
  const parsed = parseCommand(commands, words);
  const seconds = parsed.kind === 'run' ? parsed.given.options.get('timeout') : undefined;
  const timer = seconds === undefined ? undefined : setTimeout(() => up.abort(), Number(seconds) * 1000);
  const isLoading = (): boolean => session.nodes().some(({ loading }) => loading === true);
  await Promise.race([session.settled, longEnough(isLoading, AbortSignal.any([signal, up.signal]))]);
  clearTimeout(timer);
  up.abort();
}

async function main({ site, link, words }: Asked): Promise<number> {
  const abort = new AbortController();
  process.on('SIGINT', () => {
    if (abort.signal.aborted) process.exit(interrupted);
    abort.abort();
  });
  process.on('SIGTERM', () => abort.abort());
  endWhenNobodyReads(() => process.exit(0));
  const { session, close } = await openHeadless(site, link, new URL(import.meta.url), shellCommands(false));
  const told = new Set<string>();
  const tell = (nodes: readonly NodeView[]): void => {
    for (const { id, state } of nodes) {
      if (state.kind !== 'crashed' || told.has(id)) continue;
      told.add(id);
      process.stderr.write(`[${id}] error[${state.code}]: ${state.message}\n`);
    }
  };
  session.onNodes(tell);
  if (!commands.some((command) => command.words[0] === words[0] && command.startsNodes === true)) {
    session.startAll();
    await allUp(session, words, abort.signal);
  }
  if (session.link === 'port') await pause(discoveryMs);
  const code = await runCommand(session, words, {
    signal: abort.signal,
    bags: bagFiles,
    readText: textOfFile,
    takeInput: (taker, keys) => {
      process.stdin.removeAllListeners();
      if (process.stdin.isTTY) process.stdin.setRawMode(keys !== undefined);
      if (taker === undefined) {
        process.stdin.pause();
        return;
      }
      const take = (text: string): void => {
        // A terminal without lines gives no signal for Ctrl-C, and a carriage return for Enter.
        if (keys === 'cbreak' && process.stdin.isTTY && text.includes('\u0003')) abort.abort();
        else taker(keys === undefined ? text : text.replaceAll('\r', '\n'));
      };
      // An empty text is the end.
      process.stdin.setEncoding('utf8').on('data', take).on('end', () => taker('')).on('error', () => undefined);
    },
    print: (text) => void process.stdout.write(`${text}\n`),
    warn: (text) => void process.stderr.write(`${text}\n`),
  });
  close();
  return code;
}

if (isMainThread) {
  const asked = parseArguments(process.argv.slice(2));
  if (asked === undefined) process.stderr.write(`${usage}\n`);
  try {
    await exitWhenPrinted(asked === undefined ? 2 : await main(asked));
  } catch (error) {
    if (!(error instanceof SiteError)) throw error;
    process.stderr.write(siteErrorText(error));
    await exitWhenPrinted(1);
  }
} else {
  serveHeadlessWorker();
}
