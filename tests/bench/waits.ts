// The short exchanges of two nodes, many times over: round trips and throughput at 8 and 1,000 bytes, on a machine that
// does nothing else and beside one process that takes a core. Whether two threads run on one core or on two is the
// scheduler's choice, and it makes two speeds; so each line has the median and the worst of its runs, as ratios to ddsperf
// of the same moment. Runs only when named. `--record TITLE` adds the ratios to ratios.json.
import { type ChildProcess, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { type Line, type Link, peerIsThere, peerRoundTrip, peerThroughput, type Place, inChromium, inNode } from './link.ts';
import { OthersLoad } from './machine_load.ts';
import { packLaunch } from './packed_launch.ts';
import type { Ratio, RatioEntry } from './ratios.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const RUNS = 10;
const SIZES = [8, 1000];
const LARGEST = 'parameters: {largest: 1000}';
const WAYS: readonly (readonly [Place, Link])[] = [['Node.js', 'shared'], ['Node.js', 'port'], ['Chromium', 'shared'], ['Chromium', 'port']];
/** Aims, as ratios of ours to the peer's: round trips of the shared link in the worst run, messages a second in the middle one. */
export const MOST_ROUND_TRIP = 1.5;
export const LEAST_THROUGHPUT = 1.5;

type State = 'nothing else' | 'a busy process';

/** Takes one core until it is ended; ends by itself when this process does. */
function busyProcess(): ChildProcess {
  return spawn(process.execPath, ['-e', 'for (;;) if (process.ppid === 1) process.exit();'], { stdio: 'ignore' });
}

async function beside<T>(state: State, act: () => Promise<T>): Promise<T> {
  const busy = state === 'a busy process' ? busyProcess() : undefined;
  try {
    return await act();
  } finally {
    busy?.kill('SIGKILL');
  }
}

/** How one kind of figure is measured. */
interface Figure {
  readonly what: 'round trip' | 'throughput';
  readonly unit: 'us' | 'messages/s';
  readonly site: string;
  readonly until: string;
  peer(bytes: number): Promise<number>;
  ours(line: Line, place: Place): number;
}

/** A page's clock goes in steps of 5 or 100 us, which are longer than a round trip: there the mean is exact, and no median. */
function middleTrip(line: Line, place: Place): number {
  return line[place === 'Node.js' ? 'p50_us' : 'mean_us'] ?? Number.NaN;
}

class Series {
  /** Ratios of ours to the peer's, by place, link and size. */
  private readonly values = new Map<string, { ours: number[]; peer: number[]; ratios: number[]; }>();

  add(key: string, ours: number, peer: number): void {
    const series = this.values.get(key) ?? { ours: [], peer: [], ratios: [] };
    series.ours.push(ours);
    series.peer.push(peer);
    series.ratios.push(ours / peer);
    this.values.set(key, series);
  }

  ours(key: string): readonly number[] {
    return this.values.get(key)?.ours ?? [];
  }

  entries(): IterableIterator<[string, { ours: number[]; peer: number[]; ratios: number[]; }]> {
    return this.values.entries();
  }
}

async function run(context: BenchContext, figure: Figure, state: State, recorded: Ratio[]): Promise<void> {
  const series = new Series();
  const others = new OthersLoad();
  for (let i = 0; i < RUNS; i += 1) {
    await beside(state, async () => {
      const peers = new Map<number, number>();
      for (const bytes of SIZES) peers.set(bytes, await figure.peer(bytes));
      for (const [place, link] of WAYS) {
        const lines = place === 'Node.js'
          ? inNode(context, figure.site, link, figure.until)
          : await inChromium(figure.site, link, figure.until);
        for (const line of lines) {
          const bytes = line['bytes'] ?? 0;
          const peer = peers.get(bytes);
          if (peer !== undefined) series.add(`${place}, ${link} link, ${bytes} B`, figure.ours(line, place), peer);
        }
      }
    });
  }
  const share = others.share();
  for (const [where, { peer, ratios }] of series.entries()) {
    const ratio = summary(ratios);
    const ours = summary(series.ours(where));
    const worst = figure.what === 'round trip' ? ratio.max : ratio.min;
    context.emit({
      bench: 'waits',
      what: figure.what,
      where,
      beside: state,
      runs: ratio.runs,
      unit: figure.unit,
      median: ours.median,
      peer: 'ddsperf, loopback, in the same state',
      peer_median: summary(peer).median,
      median_ratio: ratio.median,
      worst_ratio: worst,
      taken_by_others: Math.round(share * 100) / 100,
    });
    recorded.push({ line: `${figure.what}, ${where}, beside ${state}`, median: ratio.median, worst });
    if (!where.includes('shared')) continue;
    const port = summary(series.ours(where.replace('shared', 'port'))).median;
    if (figure.what === 'round trip' && ours.max > port)
      context.fail(`waits: ${where} beside ${state}: ${ours.max} us in the worst run, ${port} us on the port link`);
    if (figure.what === 'throughput' && ours.median < port)
      context.fail(`waits: ${where} beside ${state}: ${ours.median} messages/s, ${port} on the port link`);
    if (figure.what === 'round trip' && worst > MOST_ROUND_TRIP)
      context.fail(`waits: ${where} beside ${state}: a round trip takes ${worst} times ddsperf's in the worst run`);
    if (figure.what === 'throughput' && ratio.median < LEAST_THROUGHPUT)
      context.fail(`waits: ${where} beside ${state}: ${ratio.median} times ddsperf's messages`);
  }
}

export async function benchWaits(context: BenchContext): Promise<void> {
  if (!peerIsThere()) {
    context.fail('waits: not measured');
    return;
  }
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  const recorded: Ratio[] = [];
  try {
    const trips = packLaunch(context, folder, ['link_bench'], 'trips', [
      '{package: link_bench, executable: ponger}',
      `{package: link_bench, executable: pinger, ${LARGEST}}`,
    ]);
    const flood = packLaunch(context, folder, ['link_bench'], 'flood', [
      '{package: link_bench, executable: flooder, parameters: {sinks: 1, largest: 1000}}',
      `{package: link_bench, executable: sink, ${LARGEST}}`,
    ]);
    const figures: readonly Figure[] = [
      { what: 'round trip', unit: 'us', site: trips, until: 'pinger: done', peer: peerRoundTrip, ours: middleTrip },
      { what: 'throughput', unit: 'messages/s', site: flood, until: 'flooder: done', peer: peerThroughput, ours: (line) => line['per_second'] ?? Number.NaN },
    ];
    for (const figure of figures) {
      for (const state of ['nothing else', 'a busy process'] as const) await run(context, figure, state, recorded);
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  if (context.record !== undefined) record(context, recorded);
}

/** Adds a landing's ratios to the file that tests/unit/bench/ratios.test.ts compares. */
function record(context: BenchContext, ratios: readonly Ratio[]): void {
  const file = join(context.root, 'tests/bench/ratios.json');
  const entries = JSON.parse(readFileSync(file, 'utf8')) as RatioEntry[];
  const date = new Date().toISOString().slice(0, 10);
  entries.push({ date, title: context.record ?? '', ratios: [...ratios].sort((a, b) => (a.line < b.line ? -1 : 1)) });
  writeFileSync(file, `${JSON.stringify(entries, undefined, 1)}\n`);
}
