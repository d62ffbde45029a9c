// Runs a site without a browser: node headless.js SITE [NAME:=VALUE ...] [--show-args] [--for 5s] [--until REGEX] [--json]
// [--link shared|port] [--stepped [--seed N]] [--trace FILE] [--bags DIR] [--checks [--junit FILE]]
// stdout is what the nodes print, as `ros2 launch` shows it. Exit code: 0 met, 1 not met, 2 command line, 130 Ctrl-C.
// When the reader of stdout closes it, the run ends: met, unless it has a condition.

import { parseArgs } from 'node:util';
import { writeFileSync } from 'node:fs';
import { type Broker, PortBroker, SharedBroker, steppedBus } from '../bus/broker.ts';
import { checkLine, junitXml } from '../checks/check_report.ts';
import { type CheckRun, runChecks } from '../checks/check_run.ts';
import { endWhenNobodyReads, exitWhenPrinted, siteErrorText } from './headless_session.ts';
import { checkBagsFolder, KeptBags } from '../program/stored_bags.ts';
import { readGiven, shownArguments } from '../contract/launch_arguments.ts';
import { siteWithArguments } from '../launch/launch_evaluation.ts';
import { nodePlatform } from './node_platform.ts';
import type { CommandLoader, NodeView } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import { readSite } from '../contract/site_reader.ts';
import { SiteSession } from './site_session.ts';
import { TraceFile } from '../program/trace_file.ts';

const usage = 'usage: node headless.js SITE [NAME:=VALUE ...] [--show-args] [--for TIME] [--until REGEX] [--json] [--link shared|port] '
  + '[--stepped [--seed N]] [--trace FILE] [--bags DIR] [--checks [--junit FILE]]';
const interrupted = 130;
/** Until a program's own code runs: an interpreter is loaded on a busy machine, too. */
const longestStartMs = 120_000;

interface Options {
  readonly site: string;
  readonly forMs: number | undefined;
  readonly until: RegExp | undefined;
  readonly json: boolean;
  readonly link: 'shared' | 'port';
  /** One node runs at a time, and time jumps to what is waited for. */
  readonly stepped: { readonly seed: number; } | undefined;
  /** Where the messages that were sent are written to. */
  readonly trace: string | undefined;
  /** The folder that bags of nodes are written to. */
  readonly bags: string | undefined;
  /** Ends when the site's checks are decided. */
  readonly checks: { readonly junit: string | undefined; } | undefined;
  /** Launch arguments. */
  readonly given: ReadonlyMap<string, string>;
  /** Print what launch arguments there are, and start nothing. */
  readonly showArguments: boolean;
}

/** "5s", "500ms", "2m" in ms. */
function parseTime(text: string): number {
  const match = /^(\d+(?:\.\d+)?)(ms|s|m|h)?$/.exec(text);
  if (match === null) throw new TypeError(`not a time: ${text}`);
  const scale = { ms: 1, s: 1000, m: 60_000, h: 3_600_000 }[match[2] ?? 's'] ?? 1000;
  return Number(match[1]) * scale;
}

export function parseOptions(argv: readonly string[]): Options {
  const { values, positionals } = parseArgs({
    args: [...argv],
    allowPositionals: true,
    options: {
      for: { type: 'string' },
      until: { type: 'string' },
      json: { type: 'boolean', default: false },
      link: { type: 'string', default: 'shared' },
      stepped: { type: 'boolean', default: false },
      seed: { type: 'string' },
      trace: { type: 'string' },
      bags: { type: 'string' },
      checks: { type: 'boolean', default: false },
      junit: { type: 'string' },
      'show-args': { type: 'boolean', default: false },
    },
  });
  const [site, ...given] = positionals;
  if (site === undefined) throw new TypeError('a SITE is wanted');
  if (values.link !== 'shared' && values.link !== 'port') throw new TypeError(`no such link: ${values.link}`);
  if (values.stepped && values.link === 'port') throw new TypeError('--stepped needs the shared link');
  if (values.seed !== undefined && !values.stepped) throw new TypeError('--seed is for --stepped');
  if (!/^\d{1,9}$/.test(values.seed ?? '0')) throw new TypeError(`not a seed: ${values.seed}`);
  if (values.junit !== undefined && !values.checks) throw new TypeError('--junit is for --checks');
  if (values.until !== undefined && values.checks) throw new TypeError('--until and --checks both say when a run ends');
  return {
    site,
    forMs: values.for === undefined ? undefined : parseTime(values.for),
    until: values.until === undefined ? undefined : new RegExp(values.until),
    json: values.json,
    link: values.link,
    stepped: values.stepped ? { seed: Number(values.seed ?? 0) } : undefined,
    trace: values.trace,
    bags: values.bags,
    checks: values.checks ? { junit: values.junit } : undefined,
    given: readGiven(given),
    showArguments: values['show-args'],
  };
}

/**
 * Whether all nodes ended well; undefined while one has not ended. Nodes that wait then wait for ever. `launched`: all nodes that
 * start were started, so a node that is stopped waited when the launch ended, and has nothing to end.
 */
function allEnded(all: readonly NodeView[], launched: boolean): boolean | undefined {
  const nodes = all.filter(({ state }) => state.kind !== 'waiting' && !(launched && state.kind === 'stopped'));
  if (nodes.some(({ state }) => state.kind === 'starting' || state.kind === 'running' || state.kind === 'stopped')) {
    return undefined;
  }
  return (nodes.length > 0 || all.length === 0) && nodes.every(({ state }) => state.kind === 'exited' && state.code === 0);
}

function brokerFor({ link, stepped }: Options): Broker {
  if (link === 'port') return new PortBroker();
  return new SharedBroker(stepped === undefined ? {} : steppedBus(stepped.seed));
}

async function checksOf(session: SiteSession): Promise<CheckRun> {
  if (session.site.checks.length === 0) {
    throw new SiteError('R2W0720', 'the site has no checks', {
      why: 'its manifest says nothing of what must be seen',
      fix: 'list it under `checks:` in workspace.yaml and pack the workspace again',
    });
  }
  const checks = await runChecks(session);
  session.useChecks(checks);
  return checks;
}

interface CheckTeller {
  readonly json: boolean;
  readonly event: (value: Record<string, unknown>) => void;
  readonly finish: (code: number) => void;
}

/** Tells what is decided, and finishes when all is. */
function watchChecks(checks: CheckRun, { json, event, finish }: CheckTeller): void {
  const told = new Set<number>();
  const stop = checks.onChange((views) => {
    for (const [index, view] of views.entries()) {
      if (view.state === 'waiting' || told.has(index)) continue;
      told.add(index);
      if (json) event({ event: 'check', index, ...view });
      else process.stderr.write(`${checkLine(view)}\n`);
    }
    if (told.size < views.length) return;
    stop();
    const passed = views.filter(({ state }) => state === 'passed').length;
    if (!json) process.stderr.write(`${passed} of ${views.length} checks passed\n`);
    finish(passed === views.length ? 0 : 1);
  });
}

/** Runs to the end and returns the exit code. `commands`: for launch files that start some of `ros2`. */
export async function runHeadless(options: Options, entry: URL, commands?: CommandLoader): Promise<number> {
  let finish: (code: number) => void = () => undefined;
  const finished = new Promise<number>((resolve) => {
    finish = resolve;
  });
  endWhenNobodyReads(() => finish(options.until === undefined && options.checks === undefined ? 0 : 1));
  const platform = nodePlatform(options.site, entry);
  const print = (text: string): void => void process.stdout.write(`${text}\n`);
  const packed = readSite(await platform.json('site.json'));
  if (options.showArguments) {
    print(shownArguments(packed.launch?.arguments ?? []));
    return 0;
  }
  if (options.bags !== undefined) await checkBagsFolder(options.bags);
  platform.expect(packed.files);
  const site = await siteWithArguments(packed, options.given, platform);
  for (const note of site.launch?.notes ?? []) process.stderr.write(`${note}\n`);
  if (site.launch?.reran === true) process.stderr.write("the launch file's Python was run again for these launch arguments\n");
  if (site.launch?.decided === true) process.stderr.write('some of what runs was decided in Python when the site was packed\n');
  const broker = brokerFor(options);
  const event = (value: Record<string, unknown>): void => print(JSON.stringify(value));
  let met = false;
  const trace = options.trace === undefined ? undefined : new TraceFile(options.trace);

  const tell = (node: string, line: string, stream: number, time: number, text: string): void => {
    if (met) return;
    if (options.json) event({ event: 'line', node, stream: stream === 1 ? 'stdout' : 'stderr', time, text });
    else print(line);
    if (options.until?.test(line) !== true) return;
    met = true;
    finish(0);
  };

  const session = new SiteSession({
    site,
    platform,
    broker,
    ...(commands === undefined ? {} : { commands }),
    ...(options.stepped === undefined ? {} : { stepped: options.stepped }),
    ...(trace === undefined ? {} : { onSent: (node, message) => trace.add(node.id, message) }),
    onLines: (node, lines, dropped) => {
      if (dropped > 0 && !met) process.stderr.write(`[${node.id}] ... ${dropped} lines were dropped\n`);
      for (const [stream, time, text] of lines) tell(node.id, `[${node.id}] ${text}`, stream, time, text);
    },
    onLaunchLine: (time, text) => tell('launch', text, 1, time, text),
  });

  const checks = options.checks === undefined ? undefined : await checksOf(session);
  const bags = new KeptBags(session, options.bags, ({ node }, path) => {
    if (options.json) event({ event: 'bag', node, path });
    else process.stderr.write(`[${node}] wrote ${path}\n`);
  });
  const told = new Map<string, NodeView['state']>();
  let stopping = false;
  let launched = false;
  session.onNodes((nodes) => {
    for (const { id, state, source } of nodes) {
      if (told.get(id) === state) continue;
      told.set(id, state);
      if (options.json) event({ event: 'node', node: id, ...state });
      if (state.kind === 'crashed') {
        const place = source === undefined ? '' : `\n  --> ${source.file}:${source.line}:${source.column}`;
        process.stderr.write(`[${id}] error[${state.code}]: ${state.message}${place}\n`);
      } else if (state.kind === 'exited' && !options.json) {
        const how = state.code === 0 ? 'process has finished cleanly' : `process has died [exit code ${state.code}]`;
        process.stderr.write(`[${id}] ${how}\n`);
      }
    }
    const well = allEnded(nodes, launched);
    if (stopping && well !== undefined) finish(interrupted);
    // Messages may still be on their way: the time limits of the checks decide.
    else if (checks !== undefined) return;
    // Nobody will start them again.
    else if (well !== undefined && !session.respawns()) {
      finish(options.until === undefined && well ? 0 : 1);
    }
  });

  const stop = (): void => {
    if (stopping) finish(interrupted);
    stopping = true;
    session.stopAll();
  };
  process.on('SIGINT', stop);
  process.on('SIGTERM', stop);
  const timeIsOver = (): void => {
    if (checks !== undefined) {
      checks.end();
      return;
    }
    const well = session.nodes().every(({ state }) => state.kind !== 'crashed' && !(state.kind === 'exited' && state.code !== 0));
    finish(options.until === undefined && well ? 0 : 1);
  };
  const { forMs } = options;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let begun = false;
  /** `--for` counts from the first node whose own code runs: what is loaded before that is not part of the run. */
  const watchStart = (nodes: readonly NodeView[]): void => {
    const runs = ({ state, loading }: NodeView): boolean =>
      state.kind === 'exited' || state.kind === 'crashed' || (state.kind === 'running' && loading !== true);
    if (begun || forMs === undefined || !(nodes.length === 0 || nodes.some(runs))) return;
    begun = true;
    clearTimeout(timer);
    timer = setTimeout(timeIsOver, forMs);
  };
  if (forMs !== undefined && options.stepped === undefined) {
    timer = setTimeout(() => {
      process.stderr.write(`no node has begun to run within ${longestStartMs / 1000} s\n`);
      finish(1);
    }, longestStartMs);
    session.onNodes(watchStart);
  }

  if (checks !== undefined) watchChecks(checks, { json: options.json, event, finish });
  session.startAll();
  launched = true;
  if (options.stepped === undefined) watchStart(session.nodes());
  if (forMs !== undefined && broker instanceof SharedBroker) broker.conductor?.runUntil(forMs * 1e6, timeIsOver);
  let code = await finished;
  clearTimeout(timer);
  const lost = await bags.finish();
  if (lost !== undefined) {
    process.stderr.write(`--bags: ${lost}\n`);
    code = code === 0 ? 1 : code;
  }
  process.off('SIGINT', stop);
  process.off('SIGTERM', stop);
  if (trace !== undefined) {
    const { messages, sha256 } = trace.close();
    if (options.json) event({ event: 'trace', messages, sha256 });
    else process.stderr.write(`trace: ${messages} messages, sha256 ${sha256}\n`);
  }
  if (checks !== undefined && options.checks?.junit !== undefined) {
    checks.end();
    try {
      writeFileSync(options.checks.junit, junitXml(site.name, checks.views()));
    } catch (error) {
      process.stderr.write(`--junit: ${error instanceof Error ? error.message : String(error)}\n`);
      code = code === 0 ? 1 : code;
    }
  }
  if (options.json) event({ event: 'end', met: code === 0 });
  session.close();
  platform.close();
  return code;
}

/** `entry`: the program's own file, which its workers run too. */
export async function runMain(entry: URL, commands?: CommandLoader): Promise<void> {
  let options: Options;
  try {
    options = parseOptions(process.argv.slice(2));
  } catch (error) {
    process.stderr.write(`${error instanceof Error ? error.message : String(error)}\n${usage}\n`);
    return await exitWhenPrinted(2);
  }
  try {
    await exitWhenPrinted(await runHeadless(options, entry, commands));
  } catch (error) {
    if (!(error instanceof SiteError)) throw error;
    process.stderr.write(siteErrorText(error));
    await exitWhenPrinted(1);
  }
}
