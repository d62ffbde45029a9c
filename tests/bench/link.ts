// How messages travel between rclcpp nodes: round trips, the way from `publish` in one worker to the callback in another,
// and throughput, over both links, under Node.js and in Chromium. Peers, in the same run: ddsperf of Eclipse Cyclone DDS on
// loopback, and the design of the ROS2WASM paper, which must be beaten by far. Our payload is made, serialised (one CDR
// copy), written to the bus (one), read out of it (one) and deserialised (one); ddsperf's stays in its stack.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { texts } from '../../runtime/site/ui/texts.ts';
import { wholeChromium } from '../e2e/support/chromium.ts';
import { machineLoad } from './machine_load.ts';
import { packLaunch } from './packed_launch.ts';
import { paperDesign } from './paper_design.ts';
import type { BenchContext } from './run.ts';
import { serveFolder } from '../support/static_server.ts';

const WATCHDOG_MS = 600_000;
const PEER_SECONDS = 4;
/** ddsperf's sequence number and length are part of its size; 12 is the least. */
const PEER_SIZES: Readonly<Record<number, number>> = { 8: 12, 1000: 1000, 64000: 64000, 1000000: 1000000, 6000000: 6000000 };
/** Sizes that the paper's design carries at all: a text of its 64 kB is one of 300 kB, made and read number by number. */
const PAPER_SIZES = [8, 1000];
/**
 * At least: how many round trips of the shared link go into one of the paper's design, and how many messages of the shared
 * link into one of it. That design mostly sleeps: a busy machine holds it up less than us.
 */
const PAPER_ROUND_TRIPS = 100;
const PAPER_RATES = 1000;
/** As COPIES says: by the writer of each message once, and by each reader. Workers copy side by side; the plain copy is one thread's. */
const COPIES_OF_WRITER = 2;
const COPIES_OF_READER = 2;
const COPIES = 'CDR made by the writer; copies: serialise, to the bus, from the bus, deserialise';

export type Line = Readonly<Record<string, number>>;
export type Place = 'Node.js' | 'Chromium';
export type Link = 'shared' | 'port';

/** The JSON lines that the nodes printed. */
function jsonLines(text: string): Line[] {
  return [...text.matchAll(/\{"bytes".*?\}/g)].map(([json]) => JSON.parse(json) as Line);
}

export function inNode(context: BenchContext, site: string, link: Link, until: string): Line[] {
  const command = ['run', site, '--link', link, '--until', until, '--for', `${WATCHDOG_MS / 1000}s`];
  const run = spawnSync(join(context.build, 'ros2wasm'), command, { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(`run failed: ${run.stdout}${run.stderr}`);
  return jsonLines(run.stdout);
}

export async function inChromium(site: string, link: Link, until: string): Promise<Line[]> {
  const server = await serveFolder(site, { isolated: link === 'shared' });
  // Without service workers the page cannot become isolated, and takes the port link.
  const browser = await chromium.launch(wholeChromium());
  try {
    const context = await browser.newContext({ serviceWorkers: link === 'shared' ? 'allow' : 'block' });
    const page = await context.newPage();
    // A first visit copies the site for later ones, which takes a core: the nodes begin after that.
    await page.goto(`${server.url}#autorun=0`);
    await page.waitForSelector('html[data-offline]', { timeout: WATCHDOG_MS });
    await page.getByRole('button', { name: texts.startAll, exact: true }).click();
    await page.waitForFunction((text) => (document.body?.innerText ?? '').includes(text), until, { timeout: WATCHDOG_MS });
    return jsonLines(await page.evaluate(() => document.body.innerText));
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Whether ddsperf is installed; says so when it is not. */
export function peerIsThere(): boolean {
  const is = spawnSync('ddsperf', ['help']).error === undefined;
  if (!is) console.error('ddsperf is missing, without which there is no peer: install cyclonedds-tools');
  return is;
}

/** The output of one ddsperf while another, the `other`, runs too. */
async function ddsperf(other: readonly string[], own: readonly string[]): Promise<string> {
  const partner = spawn('ddsperf', ['-D', String(PEER_SECONDS + 4), ...other], { stdio: ['ignore', 'pipe', 'inherit'] });
  let printed = '';
  partner.stdout.on('data', (chunk: Buffer) => {
    printed += chunk.toString();
  });
  const ended = new Promise((resolve) => partner.on('exit', resolve));
  const run = spawnSync('ddsperf', ['-D', String(PEER_SECONDS), ...own], { encoding: 'utf8' });
  partner.kill();
  await ended;
  return `${run.stdout}\n${printed}`;
}

function middle(values: readonly number[]): number {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? Number.NaN;
}

/** Median round trip in microseconds. ddsperf prints half of it: its count times its mean makes half of the time. */
export async function peerRoundTrip(bytes: number): Promise<number> {
  const text = await ddsperf(['pong'], ['ping', 'size', String(PEER_SIZES[bytes] ?? bytes)]);
  return 2 * middle([...text.matchAll(/size \d+ mean .* 50% ([0-9.]+)us/g)].map(([, half]) => Number(half)));
}

/** Samples per second that arrive at one subscriber, reliable and keep_all. */
export async function peerThroughput(bytes: number): Promise<number> {
  const text = await ddsperf(['-k', 'all', 'sub'], ['-k', 'all', 'pub', 'size', String(PEER_SIZES[bytes] ?? bytes)]);
  return 1000 * middle([...text.matchAll(/ rate ([0-9.]+) kS\/s/g)].map(([, rate]) => Number(rate)));
}

/** Bytes per second of a plain copy of as many bytes from one buffer to another. */
function copyRate(bytes: number): number {
  const from = new Uint8Array(bytes).fill(1);
  const to = new Uint8Array(bytes);
  const rounds = Math.max(5, Math.floor(2e9 / bytes / 10));
  const begin = performance.now();
  for (let i = 0; i < rounds; i += 1) to.set(from);
  return (rounds * bytes * 1000) / (performance.now() - begin);
}

/** The steps in which a page's clock goes: finer when it is isolated. Of little say in Node.js. */
function clockStep(place: Place, link: Link): { readonly clock_step_us?: number; } {
  return place === 'Node.js' ? {} : { clock_step_us: link === 'shared' ? 5 : 100 };
}

const rounded = (value: number): number => Math.round(value * 100) / 100;

export async function places(
  context: BenchContext,
  site: string,
  until: string,
  use: (place: Place, link: Link, lines: readonly Line[]) => void,
): Promise<void> {
  for (const link of ['shared', 'port'] as const) {
    use('Node.js', link, inNode(context, site, link, until));
    use('Chromium', link, await inChromium(site, link, until));
  }
}

export async function benchLink(context: BenchContext): Promise<void> {
  if (!peerIsThere()) {
    context.fail('link: not measured');
    return;
  }
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const ping = packLaunch(context, folder, ['link_bench'], 'ping', ['{package: link_bench, executable: ponger}',
      '{package: link_bench, executable: pinger}']);
    const peerTrips = new Map<number, number>();
    for (const bytes of [8, 1000, 64000, 1000000]) peerTrips.set(bytes, await peerRoundTrip(bytes));
    const paper = await paperDesign(PAPER_SIZES);
    await places(context, ping, 'pinger: done', (place, link, lines) => {
      for (const { bytes = 0, round_trips, p50_us = 0, p99_us, way_p50_us, way_p99_us } of lines) {
        const peer = peerTrips.get(bytes) ?? Number.NaN;
        const papers = paper.get(bytes)?.roundTripUs;
        context.emit({
          bench: 'link',
          what: 'round trip',
          place,
          link,
          bytes,
          round_trips,
          p50_us,
          p99_us,
          copies: COPIES,
          peer: 'ddsperf ping, loopback',
          peer_p50_us: rounded(peer),
          ...clockStep(place, link),
          ...(papers === undefined ? {} : { paper_p50_us: rounded(papers) }),
          machine_load: machineLoad(),
        });
        context.emit({
          bench: 'link',
          what: 'rclcpp publish in one worker to callback in another',
          place,
          link,
          bytes,
          messages: round_trips,
          p50_us: way_p50_us,
          p99_us: way_p99_us,
          copies: COPIES,
          peer: 'ddsperf ping, loopback, half of a round trip',
          peer_p50_us: rounded(peer / 2),
          ...clockStep(place, link),
        });
        if (link === 'shared' && papers !== undefined && papers < p50_us * PAPER_ROUND_TRIPS) {
          context.fail(`link: a round trip of ${bytes} B takes ${p50_us} us, in the paper's design ${rounded(papers)} us`);
        }
      }
    });
    const sinks = (count: number): string[] => [
      `{package: link_bench, executable: flooder, parameters: {sinks: ${count}}}`,
      ...Array.from({ length: count }, (_, i) => `{package: link_bench, executable: sink, name: sink_${i}}`),
    ];
    const peerRates = new Map<number, number>();
    for (const bytes of [8, 1000, 64000, 6000000]) peerRates.set(bytes, await peerThroughput(bytes));
    const emitRate = (to: number) => (place: Place, link: Link, lines: readonly Line[]): void => {
      for (const bytes of [8, 1000, 64000, 6000000]) {
        const of = lines.filter((line) => line['bytes'] === bytes);
        if (of.length === 0) continue;
        const each = middle(of.map((line) => line['per_second'] ?? 0));
        const papers = paper.get(bytes)?.perSecond;
        const carried = (each * bytes * of.length) / 1e6;
        const copied = (each * bytes * (COPIES_OF_WRITER + COPIES_OF_READER * of.length)) / 1e6;
        const plain = copyRate(bytes) / 1e6;
        context.emit({
          bench: 'link',
          what: `throughput, 1 to ${to}`,
          place,
          link,
          bytes,
          qos: 'reliable, keep_all',
          lost: of.reduce((sum, line) => sum + (line['lost'] ?? 0), 0),
          per_second_each: each,
          sinks_counted: of.length,
          mb_per_second: rounded(carried),
          plain_copy_mb_per_second: rounded(plain),
          copies: COPIES,
          copied_share_of_plain: rounded(copied / plain),
          ...(to === 1 ? { peer: 'ddsperf pub/sub, loopback', peer_per_second: rounded(peerRates.get(bytes) ?? Number.NaN) } : {}),
          ...(to === 1 && papers !== undefined ? { paper_per_second: rounded(papers) } : {}),
          machine_load: machineLoad(),
        });
        if (link === 'shared' && to === 1 && papers !== undefined && each < papers * PAPER_RATES) {
          context.fail(`link: ${each} messages of ${bytes} B come in a second, in the paper's design ${rounded(papers)}`);
        }
      }
    };
    for (const count of [1, 10]) {
      await places(context, packLaunch(context, folder, ['link_bench'], `flood_${count}`, sinks(count)), 'flooder: done', emitRate(count));
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
