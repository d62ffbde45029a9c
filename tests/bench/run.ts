// Runs the benchmarks and prints one JSON object a line. Figures are medians of several runs; each line
// names its peer, measured in the same run on the same machine. A bench that misses an aim it states
// ends with exit code 1.
//   node tests/bench/run.ts --build BUILD_DIR [--minutes N] [--source DIR] [NAME ...]
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { benchBusy } from './busy.ts';
import { benchChannelBuild } from './channel_build.ts';
import { benchControl } from './control.ts';
import { benchCrowd } from './crowd.ts';
import { benchFetch } from './fetch.ts';
import { benchLaunch } from './launch.ts';
import { benchLines } from './lines.ts';
import { benchLink } from './link.ts';
import { benchPack } from './pack.ts';
import { benchPython } from './python.ts';
import { benchSim } from './sim.ts';
import { benchSolve } from './solve.ts';
import { benchBytes } from './site_bytes.ts';
import { benchSoak } from './soak.ts';
import { benchStacks } from './stacks.ts';
import { benchStart } from './site_start.ts';
import { benchVision } from './vision.ts';
import { benchWaits } from './waits.ts';
import { benchWorkspace } from './workspace.ts';

export interface BenchContext {
  /** Absolute path of the build directory (ros2wasm, runtime/, channel/). */
  readonly build: string;
  /** Absolute path of the checkout. */
  readonly root: string;
  /** How long what runs only when named lasts, when that was said. */
  readonly minutes: number | undefined;
  /** Folder of ROS 2 packages of others, when it was said. */
  readonly source: string | undefined;
  /** The title of the landing whose ratios are to be recorded, when one was given. */
  readonly record: string | undefined;
  /** Prints one result line. */
  emit(line: Readonly<Record<string, unknown>>): void;
  /** Says that an aim was missed. */
  fail(why: string): void;
}

const BENCHES: Readonly<Record<string, (context: BenchContext) => Promise<void> | void>> = {
  busy: benchBusy,
  bytes: benchBytes,
  channel_build: benchChannelBuild,
  control: benchControl,
  crowd: benchCrowd,
  fetch: benchFetch,
  launch: benchLaunch,
  lines: benchLines,
  link: benchLink,
  pack: benchPack,
  python: benchPython,
  sim: benchSim,
  soak: benchSoak,
  solve: benchSolve,
  stacks: benchStacks,
  start: benchStart,
  vision: benchVision,
  waits: benchWaits,
  workspace: benchWorkspace,
};
/** Run only when named: an hour, twice ten minutes, forty times six runs, and sources of others. */
const WHEN_NAMED: readonly string[] = ['soak', 'busy', 'waits', 'workspace'];

const USAGE = `./dev bench [--minutes N] [--source DIR] [--record TITLE] [NAME ...]: one JSON object a line on standard output.
NAME is one of ${Object.keys(BENCHES).join(', ')}; all but ${WHEN_NAMED.join(', ')} when none is named. --minutes says how long soak and busy last,
--source where the packages of workspace are, --record under which title waits adds its ratios to tests/bench/ratios.json.`;

const { values, positionals: names } = parseArgs({
  allowPositionals: true,
  options: {
    build: { type: 'string', default: 'build' },
    help: { type: 'boolean', short: 'h', default: false },
    minutes: { type: 'string' },
    record: { type: 'string' },
    source: { type: 'string' },
  },
});
if (values.help) {
  console.log(USAGE);
  process.exit(0);
}
const unknown = names.filter((name) => !(name in BENCHES));
if (unknown.length > 0) {
  console.error(`no such benchmark: ${unknown.join(', ')}; there are ${Object.keys(BENCHES).join(', ')}`);
  process.exit(2);
}
const context: BenchContext = {
  build: resolve(values.build),
  minutes: values.minutes === undefined ? undefined : Number(values.minutes),
  source: values.source,
  record: values.record,
  root: resolve(import.meta.dirname, '../..'),
  emit: (line) => console.log(JSON.stringify(line)),
  fail: (why) => {
    console.error(why);
    process.exitCode = 1;
  },
};
for (const [name, bench] of Object.entries(BENCHES)) {
  if (names.length === 0 ? !WHEN_NAMED.includes(name) : names.includes(name)) await bench(context);
}
