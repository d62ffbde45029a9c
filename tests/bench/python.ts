// The cost of Python nodes: from opening a page to the first node, when the browser has nothing, when it has cached the image
// of an interpreter, and by a plain boot of Pyodide (the peer); to the first message of a talker to a listener; memory of a further node;
// a message between entities of a node, and between nodes (Python's, and of C++ to Python); bytes of a site; serialised messages a second.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { setTimeout as setTimer } from 'node:timers/promises';
import { brotliCompressSync } from 'node:zlib';
import type { Page } from 'playwright-core';
import { makeSite } from '../e2e/support/runtime_site.ts';
import { eventually } from '../support/eventually.ts';
import { inBrowser } from './browser_site.ts';
import { peerIsThere, peerRoundTrip, peerThroughput, places } from './link.ts';
import { machineLoad, OthersLoad } from './machine_load.ts';
import { packLaunch } from './packed_launch.ts';
import { treePrivateKb } from './process_memory.ts';
import { benchCdr } from './python_cdr.ts';
import { benchPythonLibraries } from './python_libraries.ts';
import type { BenchContext } from './run.ts';
import { packedExample } from './site_bytes.ts';
import { summary } from './statistics.ts';

const WAITING = 5;
/** Pages whose memory is compared: the largest has all nodes of the site. */
const CROWDS = [3, 6, 9];
const RUNS = 5;
const TIMEOUT = { timeout: 120_000 };
const WATCHDOG_MS = 300_000;
const TRIP_AIM_US = 25;
const RATE_AIM = 200_000;
const BYTES_AIM = 7_000_000;
const COLD_AIM_MS = 2500;
const WARM_AIM_MS = 1000;
const MEMORY_AIM_KB = 60_000;
const FURTHER_AIM_MS = 250;
/** Serialised messages of some ten bytes, a second. */
const CDR_AIM = 100_000;
/** For an image of 921,600 bytes: a loop over them in Python would take a hundred times as long. */
const IMAGE_AIM_US = 500;
/** A page has come to rest. */
const REST_MS = 1000;

/** An aim that is missed is a failure, unless others took the machine meanwhile. */
function judge(context: BenchContext, others: OthersLoad, what: string, value: number, aim: number, least = false): void {
  if (least ? value >= aim : value <= aim) return;
  const share = others.share();
  const said = `python: ${what}: ${Math.round(value)}, the aim is ${aim}`;
  if (others.quiet()) context.fail(said);
  else console.error(`${said}; not judged: others had ${Math.round(100 * share)} % of the machine`);
}

/** Milliseconds from the navigation to so many of these lines. */
async function visitUntil(page: Page, address: string, line: string, lines: number): Promise<number> {
  const begin = performance.now();
  await page.goto(address);
  await page.waitForFunction(([text, count]) => (document.body?.textContent ?? '').split(text).length > count, [line, lines] as const, TIMEOUT);
  return performance.now() - begin;
}

/** Milliseconds from the navigation to the line of the last node. */
function visit(page: Page, url: string, nodes: number): Promise<number> {
  const names = Array.from({ length: nodes }, (_, i) => `waits-${i + 1}`).join(',');
  return visitUntil(page, `${url}?nodes=${names}`, 'node is made', nodes);
}

/** Milliseconds of what a program would do by itself: boot, unpack, import. */
function plainBoot(page: Page): Promise<number> {
  return page.evaluate(async (base) => {
    const script = `
      importScripts('${base}pyodide/pyodide.js');
      (async () => {
        const begin = performance.now();
        const python = await loadPyodide({ indexURL: '${base}pyodide/', env: { AMENT_PREFIX_PATH: '/ros' } });
        const archive = await (await fetch('${base}python/rclpy.zip')).arrayBuffer();
        python.unpackArchive(new Uint8Array(archive), 'zip', { extractDir: '/ros' });
        const bytes = [];
        python.registerJsModule('ros2wasm_host', { address: (one) => bytes.push(one.getBuffer('u8')) });
        python.runPython('import sys; sys.path.insert(0, "/ros/lib/python3.12/site-packages"); from ros2wasm import import_hook; import_hook.install(); import rclpy');
        postMessage(performance.now() - begin);
      })().catch((error) => postMessage(String(error)));`;
    const place = URL.createObjectURL(new Blob([script], { type: 'text/javascript' }));
    const worker = new Worker(place);
    const told = await new Promise<unknown>((resolve) => {
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = ({ message }) => resolve(message);
    });
    worker.terminate();
    URL.revokeObjectURL(place);
    if (typeof told !== 'number') throw new Error(String(told));
    return told;
  }, page.url().replace(/\?.*$/, ''));
}

/** Milliseconds from the button that starts the fifth node, beside four that run, to its line. */
async function fifthNode(page: Page, url: string): Promise<number> {
  await visit(page, url, WAITING - 1);
  await setTimer(REST_MS);
  return page.evaluate(async ([line, lines]) => {
    const button = [...document.querySelectorAll('button')].find((one) => one.getAttribute('aria-label')?.startsWith('Start /waits'));
    if (button === undefined) throw new Error('no node can be started');
    const begin = performance.now();
    button.click();
    while ((document.body.textContent ?? '').split(line).length <= lines) await new Promise((resolve) => setTimeout(resolve, 2));
    return performance.now() - begin;
  }, ['node is made', WAITING] as const);
}

async function isKept(page: Page): Promise<void> {
  await eventually('an image is kept', () => page.evaluate(async () => (await (await caches.open('ros2wasm-kept')).keys()).length > 0));
  // And the site: what is still on its way would take a core.
  await page.waitForSelector('html[data-offline]', { timeout: TIMEOUT.timeout });
}

async function benchStart(context: BenchContext, site: string): Promise<void> {
  const others = new OthersLoad();
  await inBrowser(site, async (page, _pid, url) => {
    const cold = await visit(page, url, 1);
    await isKept(page);
    const warm: number[] = [];
    const plain: number[] = [];
    const fifth: number[] = [];
    for (let run = 0; run < RUNS; run += 1) {
      warm.push(await visit(page, url, 1));
      plain.push(await plainBoot(page));
      fifth.push(await fifthNode(page, url));
    }
    const [warmMs, plainMs, fifthMs] = [warm, plain, fifth].map(summary);
    if (warmMs === undefined || plainMs === undefined || fifthMs === undefined) return;
    const ratio = (ours: number): number => Math.round((100 * plainMs.median) / ours) / 100;
    const shared = { bench: 'python', peer: 'boot of Pyodide with rclpy in a worker of the same page', peer_ms: plainMs, machine_load: machineLoad() };
    context.emit({ ...shared, what: 'page to first node, nothing in the browser', ms: Math.round(cold) });
    context.emit({ ...shared, what: 'page to first node, image kept', ms: warmMs, peer_to_ours: ratio(warmMs.median) });
    context.emit({ ...shared, what: 'start of the fifth node beside four that run', ms: fifthMs, peer_to_ours: ratio(fifthMs.median), aim_ms: FURTHER_AIM_MS });
    judge(context, others, 'ms of the start of the fifth node', fifthMs.median, FURTHER_AIM_MS);
  });
}

/** From the navigation to what a listener hears first of a talker, whose timer comes every 5 ms. Node.js: from the start of the process. */
async function benchFirstMessage(context: BenchContext, site: string): Promise<void> {
  const line = 'first message is hello';
  const others = new OthersLoad();
  const cold: number[] = [];
  const warm: number[] = [];
  for (let run = 0; run < RUNS; run += 1) {
    await inBrowser(site, async (page, _pid, url) => {
      cold.push(await visitUntil(page, url, line, 1));
      await isKept(page);
      warm.push(await visitUntil(page, url, line, 1));
    });
  }
  const headless: number[] = [];
  for (let run = 0; run < RUNS; run += 1) headless.push(await firstLine(context, site, line));
  const what = 'first message of a talker to a listener';
  const emit = (place: string, ms: readonly number[], aim?: number): void => {
    context.emit({ bench: 'python', what, place, ms: summary(ms), ...(aim === undefined ? {} : { aim_ms: aim }), machine_load: machineLoad() });
    if (aim !== undefined) judge(context, others, `ms to the ${what}, ${place}`, summary(ms).median, aim);
  };
  emit('Chromium, nothing in the browser', cold, COLD_AIM_MS);
  emit('Chromium, image kept', warm, WARM_AIM_MS);
  emit('Node.js', headless);
}

/** Milliseconds until a headless run prints it. */
async function firstLine(context: BenchContext, site: string, line: string): Promise<number> {
  const begin = performance.now();
  const run = spawn(process.execPath, [join(context.root, 'runtime/site/session/headless.ts'), site], { stdio: ['ignore', 'pipe', 'inherit'] });
  const over = once(run, 'close');
  const watchdog = setTimeout(() => run.kill('SIGKILL'), WATCHDOG_MS);
  try {
    for await (const one of createInterface({ input: run.stdout })) {
      if (one.includes(line)) return performance.now() - begin;
    }
  } finally {
    clearTimeout(watchdog);
    run.kill('SIGKILL');
    await over;
  }
  throw new Error(`the run ends before the line "${line}"`);
}

/** The memory that is written and shared with nobody, in kB, when it no longer changes. */
async function settledKb(pid: number): Promise<number> {
  let last = treePrivateKb(pid);
  for (let look = 0; look < 20; look += 1) {
    await setTimer(500);
    const now = treePrivateKb(pid);
    if (Math.abs(now - last) < now / 200) return now;
    last = now;
  }
  return last;
}

/**
 * The slope over pages of several sizes, each in a browser of its own, as what earlier pages left would be noise. All
 * of them have made an image: what that costs is in each.
 */
async function benchMemory(context: BenchContext, site: string): Promise<void> {
  const others = new OthersLoad();
  const seen: { nodes: number; kb: number; }[] = [];
  for (let run = 0; run < 3; run += 1) {
    for (const nodes of CROWDS) {
      await inBrowser(site, async (page, pid, url) => {
        await visit(page, url, nodes);
        seen.push({ nodes, kb: await settledKb(pid) });
      });
    }
  }
  const slopes = seen.flatMap((a) => seen.filter((b) => b.nodes > a.nodes).map((b) => (b.kb - a.kb) / (b.nodes - a.nodes)));
  context.emit({ bench: 'python', what: 'memory of a further node', nodes: CROWDS, kb: summary(slopes), aim_kb: MEMORY_AIM_KB, machine_load: machineLoad() });
  judge(context, others, 'kB of memory of a further node', summary(slopes).median, MEMORY_AIM_KB);
}

interface Rates {
  readonly what: string;
  readonly bytes?: number;
  readonly in_per_second?: number;
  readonly out_per_second?: number;
}

function judgeCdr(context: BenchContext, others: OthersLoad, link: string, { what, bytes, ...rates }: Rates): void {
  if (bytes === undefined) return;
  for (const [way, rate = 0] of [['in', rates.in_per_second], ['out', rates.out_per_second]] as const) {
    if (bytes < 100) judge(context, others, `messages a second, ${what}, ${way}, ${link}`, rate, CDR_AIM, true);
    else judge(context, others, `us of one, ${what}, ${way}, ${link}`, 1e6 / rate, IMAGE_AIM_US);
  }
}

function benchMessages(context: BenchContext, site: string): void {
  const others = new OthersLoad();
  for (const link of ['shared', 'port']) {
    const run = spawnSync(process.execPath, [join(context.root, 'runtime/site/session/headless.ts'), site, '--link', link], {
      encoding: 'utf8',
      timeout: WATCHDOG_MS,
    });
    if (run.status !== 0) context.fail(`python: the rates on the ${link} link end with ${run.status}: ${run.stderr}`);
    for (const [, json = ''] of run.stdout.matchAll(/rates (\{.*\})/g)) {
      const rates = JSON.parse(json) as Rates;
      const aim = rates.bytes === undefined ? {} : rates.bytes < 100 ? { aim_per_second: CDR_AIM } : { aim_us: IMAGE_AIM_US };
      context.emit({ bench: 'python', link, place: 'Node.js', ...rates, ...aim, machine_load: machineLoad() });
      judgeCdr(context, others, link, rates);
    }
  }
}

/** Round trips, and the way of many messages, between two nodes. Peer: ddsperf on loopback. */
async function benchPairs(context: BenchContext, folder: string): Promise<void> {
  const others = new OthersLoad();
  const bytes = 1000;
  const py = (executable: string, more = ''): string => `{package: python_bench, executable: ${executable}${more}}`;
  const cpp = (executable: string): string => `{package: link_bench, executable: ${executable}}`;
  const hasPeer = peerIsThere();
  const peerTrip = hasPeer ? await peerRoundTrip(bytes) : undefined;
  const trips = [['Python to Python and back', [py('ponger'), py('pinger')]], ['C++ to Python and back', [py('ponger'), cpp('pinger')]]] as const;
  for (const [i, [what, launch]] of trips.entries()) {
    const site = packLaunch(context, folder, ['link_bench', 'python_bench'], `trips_${i}`, launch);
    await places(context, site, 'pinger: done', (place, link, lines) => {
      for (const line of lines.filter((one) => one['bytes'] === bytes)) {
        context.emit({
          bench: 'python',
          what,
          place,
          link,
          bytes,
          p50_us: line['p50_us'],
          p99_us: line['p99_us'],
          aim_us: TRIP_AIM_US,
          ...(peerTrip === undefined ? {} : { peer: 'ddsperf ping, loopback', peer_p50_us: peerTrip }),
          machine_load: machineLoad(),
        });
        if (link === 'shared') judge(context, others, `us of a round trip, ${what}, ${place}`, line['p50_us'] ?? Infinity, TRIP_AIM_US);
      }
    });
  }
  const peerRate = hasPeer ? await peerThroughput(bytes) : undefined;
  const floods = [
    ['Python to Python', [py('flooder'), py('sink')]],
    ['C++ to Python', [cpp('flooder'), py('sink', ', parameters: {others: true}')]],
  ] as const;
  for (const [i, [what, launch]] of floods.entries()) {
    const site = packLaunch(context, folder, ['link_bench', 'python_bench'], `floods_${i}`, launch);
    await places(context, site, 'sink: done', (place, link, lines) => {
      for (const line of lines.filter((one) => one['bytes'] === bytes && one['per_second'] !== undefined)) {
        context.emit({
          bench: 'python',
          what: `${what}, reliable, keep_all`,
          place,
          link,
          bytes,
          per_second: line['per_second'],
          whole_per_second: line['whole'],
          aim_per_second: RATE_AIM,
          ...(peerRate === undefined ? {} : { peer: 'ddsperf pub/sub, loopback', peer_per_second: Math.round(peerRate) }),
          machine_load: machineLoad(),
        });
        if (link === 'shared') judge(context, others, `messages a second, ${what}, ${place}`, line['per_second'] ?? 0, RATE_AIM, true);
      }
    });
  }
}

/** All files of a packed site with two Python nodes, without numpy: more than a visit loads. */
function benchBytes(context: BenchContext, site: string): void {
  const total = { files: 0, raw: 0, brotli: 0 };
  for (const entry of readdirSync(site, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile()) continue;
    const bytes = readFileSync(join(entry.parentPath, entry.name));
    total.files += 1;
    total.raw += bytes.length;
    total.brotli += brotliCompressSync(bytes).length;
  }
  context.emit({ bench: 'python', what: 'bytes of a site with Python, without numpy', ...total, aim: BYTES_AIM });
  if (total.brotli > BYTES_AIM) context.fail(`python: a site has ${total.brotli} bytes compressed, ${BYTES_AIM} are the aim`);
}

export async function benchPython(context: BenchContext): Promise<void> {
  const packages = { [join(context.root, 'tests/bench/packages/python_bench/scripts')]: 'lib/python_bench' };
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  const script = (name: string): { entry: string; executable: string; } => ({ entry: `lib/python_bench/${name}`, executable: name });
  const waits = Array.from({ length: Math.max(...CROWDS) }, () => script('waits'));
  const sites = [waits, [script('rates')], [script('talks'), script('hears')]].map((nodes) => makeSite([], {}, {}, { nodes, packages }));
  try {
    const [start = '', messages = '', chatter = ''] = sites;
    benchBytes(context, packedExample(context, folder, '07_python'));
    await benchStart(context, start);
    await benchFirstMessage(context, chatter);
    await benchMemory(context, start);
    await benchCdr(context, messages);
    benchMessages(context, messages);
    await benchPythonLibraries(context);
    await benchPairs(context, folder);
  } finally {
    for (const one of [...sites, folder]) rmSync(one, { recursive: true, force: true });
  }
}
