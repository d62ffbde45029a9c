// The score board: builds each package of a folder, plays each executable and launch file, says which do what is expected.
//   node tests/scoreboard/run.ts --build BUILD_DIR DIR [--chromium] [--json FILE] [--only PACKAGE...] [--expect FILE...]
// Exit code: 0 every row is green, 1 one is not, 2 command line.
import { mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { isGreen, keptLines, ownEndpoints, type Row, rowText, summary } from './board.ts';
import { BadExpectation, type Expectation, keyOf, readExpectations } from './expectation.ts';
import { findPackages, type Package } from './packages.ts';
import { chromiumPlayer, nodePlayer, type Player } from './players.ts';
import { type Failure, launchFiles, type Packed, Workshop } from './site.ts';

const USAGE = 'usage: ./dev scoreboard DIR [--chromium] [--json FILE] [--only PACKAGE[/NAME]]... [--expect FILE]...';
/** Programs mostly wait, so some are played at a time. */
const PLAYED_AT_ONCE = 3;
/** The build adds these to every package with components: rows of their own only where something is expected of them. */
const CONTAINERS = ['component_container', 'component_container_mt', 'component_container_isolated'];
const root = resolve(import.meta.dirname, '../..');

/** An error in the command line; the usage is printed after it. */
class Misused extends Error {}

interface Board {
  readonly workshop: Workshop;
  readonly player: Player;
  readonly expectations: ReadonlyMap<string, Expectation>;
  readonly wanted: (key: string) => boolean;
}

async function rowsOf(board: Board, of: Package): Promise<Row[]> {
  const { workshop, expectations } = board;
  const built = await workshop.build(of.name);
  const ours = [...expectations.values()].filter((one) => one.package === of.name);
  const stated = ours.filter(({ kind }) => kind === 'executable').map((one) => one.executable);
  const statedLaunches = ours.filter(({ kind }) => kind === 'launch').map((one) => one.executable);
  const made = 'executables' in built ? built.executables.filter((name) => !CONTAINERS.includes(name)) : [];
  const leftOut: ReadonlyMap<string, Failure> = 'leftOut' in built ? built.leftOut : new Map();
  const names = [...new Set([...stated, ...made, ...leftOut.keys()])].sort();
  const blank = {
    package: of.name,
    language: of.language,
    kind: 'executable',
    built: false,
    started: false,
    endpoints: [],
    log_lines: [],
    expected: null,
    error: null,
  } as const;
  if ('failure' in built) {
    const launches = [...new Set([...statedLaunches, ...launchFiles(of.folder)])].sort();
    if (names.length + launches.length === 0) return [{ ...blank, executable: '', kind: 'package', error: built.failure }];
    return [
      ...names.map((executable): Row => ({ ...blank, executable, error: built.failure })),
      ...launches.map((executable): Row => ({ ...blank, executable, kind: 'launch', error: built.failure })),
    ];
  }
  const launches = [...new Set([...statedLaunches, ...built.launches])].sort();
  const ofPrograms = await inParallel(names.filter((name) => board.wanted(`${of.name}/${name}`)), PLAYED_AT_ONCE, async (executable) => {
    const row: Row = { ...blank, executable };
    const expected = expectations.get(keyOf({ package: of.name, executable }));
    const failure = leftOut.get(expected?.program ?? executable);
    if (failure !== undefined) return { ...row, error: failure };
    if (!built.executables.includes(expected?.program ?? executable))
      return { ...row, error: { code: 'absent', reason: 'the package installs no such executable' } };
    return playedRow(board, row, await workshop.pack({ package: of.name, executable }, expected), expected);
  });
  const ofLaunches = await inParallel(launches.filter((name) => board.wanted(`${of.name}/${name}`)), PLAYED_AT_ONCE, async (executable) => {
    const row: Row = { ...blank, executable, kind: 'launch' };
    const expected = expectations.get(keyOf({ package: of.name, executable }));
    if (!built.launches.includes(executable)) return { ...row, error: { code: 'absent', reason: 'the package installs no such launch file' } };
    return playedRow(board, row, await workshop.packLaunch(of.name, executable, expected?.given ?? {}), expected);
  });
  return [...ofPrograms, ...ofLaunches];
}

async function playedRow(board: Board, row: Row, packed: Packed, expected: Expectation | undefined): Promise<Row> {
  if ('failure' in packed) return { ...row, built: true, error: packed.failure };
  const { node, endpoints, verdict } = await board.player.play(packed.site, { kind: row.kind === 'launch' ? 'launch' : 'executable', expected });
  const missing = verdict?.missing[0];
  return {
    ...row,
    built: true,
    started: node.started,
    endpoints: ownEndpoints(endpoints),
    log_lines: keptLines(node.lines),
    expected: verdict === undefined ? null : missing === undefined,
    error: node.crash !== undefined
      ? { code: node.crash.code, reason: node.crash.message }
      : missing === undefined
      ? null
      : { code: 'unmet', reason: missing },
  };
}

/** In the order of `items`. */
async function inParallel<T, R>(items: readonly T[], atOnce: number, work: (item: T) => Promise<R>): Promise<R[]> {
  const results: R[] = [];
  let next = 0;
  const worker = async (): Promise<void> => {
    while (next < items.length) {
      const index = next++;
      results[index] = await work(items[index] as T);
    }
  };
  await Promise.all(Array.from({ length: Math.min(atOnce, items.length) }, worker));
  return results;
}

interface Options {
  readonly folder: string;
  readonly build: string;
  readonly chromium: boolean;
  readonly json: string | undefined;
  readonly only: readonly string[] | undefined;
  readonly expect: readonly string[];
}

function readOptions(): Options {
  try {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: {
        build: { type: 'string', default: 'build' },
        chromium: { type: 'boolean', default: false },
        json: { type: 'string' },
        only: { type: 'string', multiple: true },
        expect: { type: 'string', multiple: true, default: [] },
      },
    });
    const [folder] = positionals;
    if (folder === undefined || positionals.length !== 1) throw new Misused('one DIR is wanted');
    return { ...values, folder, json: values.json, only: values.only };
  } catch (error) {
    throw error instanceof TypeError ? new Misused(error.message) : error;
  }
}

async function main(): Promise<number> {
  const options = readOptions();
  const build = resolve(options.build);
  const shipped = join(import.meta.dirname, 'expectations');
  const files = [...readdirSync(shipped).filter((name) => name.endsWith('.yaml')).sort().map((name) => join(shipped, name)), ...options.expect];
  const chosen = findPackages([resolve(options.folder)]);
  if (chosen.size === 0) throw new Misused(`there is no package.xml below ${options.folder}`);
  // The programs that run beside an executable may be from tests/packages.
  const packages = findPackages([resolve(options.folder), join(root, 'tests/packages')]);
  const wanted = (key: string): boolean =>
    options.only === undefined || options.only.some((one) => one === key || key.startsWith(`${one}/`) || one.startsWith(`${key}/`));
  const work = mkdtempSync(join(tmpdir(), 'ros2wasm-scoreboard-'));
  const expectations = readExpectations(files);
  const player = options.chromium ? await chromiumPlayer() : nodePlayer(join(build, 'runtime/headless.js'));
  const board: Board = {
    workshop: new Workshop(join(build, 'ros2wasm'), work, packages, expectations.values()),
    player,
    expectations,
    wanted,
  };
  const rows: Row[] = [];
  try {
    for (const one of chosen.values()) {
      if (!wanted(one.name)) continue;
      for (const row of await rowsOf(board, one)) {
        rows.push(row);
        console.log(rowText(row));
      }
    }
  } finally {
    await player.close();
    rmSync(work, { recursive: true, force: true });
  }
  console.log(summary(rows));
  if (options.json !== undefined) writeFileSync(options.json, `${JSON.stringify(rows, undefined, 2)}\n`);
  return rows.length > 0 && rows.every(isGreen) ? 0 : 1;
}

try {
  process.exit(await main());
} catch (error) {
  if (!(error instanceof Misused || error instanceof BadExpectation)) throw error;
  console.error(`${error.message}\n${USAGE}`);
  process.exit(2);
}
