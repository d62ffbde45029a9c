// The simulator: how much faster than real time a robot with a lidar runs among boxes, with all its topics published to a node, in
// Node.js and in Chromium; what a scan and a picture cost; bytes; and the time from an address to a robot that moves. The peer
// steps the same scene with npm's build of MuJoCo, without ROS, and casts the same rays.
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import loadMujoco from '@mujoco/mujoco';
import { inBrowser } from './browser_site.ts';
import { machineLoad } from './machine_load.ts';
import type { BenchContext } from './run.ts';
import { mjcfWorld, sdfWorld, type Sensors } from './sim_world.ts';
import { summary } from './statistics.ts';

const RUNS = 3;
const PAGE_RUNS = 3;
const FACTOR_AIM = 5;
const SCAN_AIM_MS = 0.5;
const BYTES_AIM = 1_500_000;
const MOVES_AIM_MS = 4000;
/** Scans of a run that costs enough to be measured. */
const MANY_SCANS_HZ = 500;
const PEER_STEPS = 20_000;
const STEPS_A_SCAN = 100;

const VARIANTS = {
  lidar: { scansHz: 10 },
  scans: { scansHz: MANY_SCANS_HZ },
  small: { scansHz: 10, camera: { width: 320, height: 240, hz: 10 } },
  large: { scansHz: 10, camera: { width: 640, height: 480, hz: 15 } },
} satisfies Readonly<Record<string, Sensors>>;
type Variant = keyof typeof VARIANTS;

interface Measured {
  /** Seconds of simulation a second. */
  readonly factor: number;
  readonly scans: number;
  readonly images: number;
  readonly simulated: number;
}

function pack(context: BenchContext, folder: string, name: string, sensors: Sensors, realTime: boolean): string {
  const workspace = join(folder, name);
  mkdirSync(workspace);
  cpSync(join(context.root, 'tests/bench/packages/sim_bench'), join(workspace, 'sim_bench'), { recursive: true });
  writeFileSync(join(workspace, 'sim_bench/launch/bench.world'), sdfWorld(sensors, realTime));
  writeFileSync(join(workspace, 'workspace.yaml'), `schema: 1\nname: ${name}\npackages: [sim_bench]\nlaunch: sim_bench/launch/sim.launch.py\n`);
  const site = join(workspace, 'site');
  const run = spawnSync(join(context.build, 'ros2wasm'), ['pack', join(workspace, 'workspace.yaml'), '-o', site], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(`pack failed: ${run.stderr}`);
  return site;
}

function read(text: string): Measured {
  const found = /([\d.]+) s of simulation in ([\d.]+) s: scans (\d+), images (\d+), joint states (\d+), frames (\d+)/.exec(text);
  if (found === null) throw new Error(`the meter said nothing: ${text.slice(-2000)}`);
  const [simulated, wall, scans, images, joints, frames] = found.slice(1).map(Number) as [number, number, number, number, number, number];
  if (scans === 0 || joints === 0 || frames === 0) throw new Error(`a topic is silent: ${found[0]}`);
  return { factor: simulated / wall, scans, images, simulated };
}

function inNode(context: BenchContext, site: string): Measured {
  const run = spawnSync(join(context.build, 'ros2wasm'), ['run', site, '--for', '60s', '--until', 's of simulation in'], { encoding: 'utf8' });
  return read(run.stdout + run.stderr);
}

/** Milliseconds from the address until the page has a line. */
async function shown(site: string, line: RegExp): Promise<{ ms: number; text: string; }> {
  let result = { ms: 0, text: '' };
  await inBrowser(site, async (page, _pid, url) => {
    const begin = performance.now();
    await page.goto(url);
    await page.getByText(line).first().waitFor({ timeout: 60_000 });
    result = { ms: performance.now() - begin, text: await page.locator('body').innerText() };
  });
  return result;
}

/** Seconds of simulation a second of npm's MuJoCo; with the rays of a lidar at 10 Hz. */
async function peerFactor(): Promise<number> {
  const mujoco = await loadMujoco();
  const model = mujoco.MjModel.from_xml_string(mjcfWorld());
  const data = new mujoco.MjData(model);
  data.ctrl.set([4, 4]);
  const rays = 360;
  const directions = Array.from({ length: rays }, (_, i) => [Math.cos((2 * Math.PI * i) / rays), Math.sin((2 * Math.PI * i) / rays), 0]).flat();
  const geoms = new mujoco.IntBuffer(rays);
  const distances = new mujoco.DoubleBuffer(rays);
  const normals = new mujoco.DoubleBuffer(3 * rays);
  const step = (): void => {
    for (let i = 0; i < PEER_STEPS; ++i) {
      mujoco.mj_step(model, data);
      if (i % STEPS_A_SCAN === 0)
        mujoco.mj_multiRay(model, data, [0, 0, 0.25], directions, [1, 1, 1, 1, 1, 1], true, -1, geoms, distances, normals, rays, 10);
    }
  };
  step();
  const begin = performance.now();
  step();
  return (PEER_STEPS * 0.001) / ((performance.now() - begin) / 1000);
}

export async function benchSim(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    const sites = new Map<Variant, string>();
    for (const [name, sensors] of Object.entries(VARIANTS) as [Variant, Sensors][])
      sites.set(name, pack(context, folder, name, sensors, false));
    const site = (name: Variant): string => sites.get(name) ?? '';
    const runs: Record<Variant, Measured[]> = { lidar: [], scans: [], small: [], large: [] };
    const peers: number[] = [];
    // In turn, so that each meets the same machine.
    for (let i = 0; i < RUNS; ++i) {
      for (const name of sites.keys()) runs[name].push(inNode(context, site(name)));
      peers.push(await peerFactor());
    }
    const pages: Measured[] = [];
    const pictures: Measured[] = [];
    for (let i = 0; i < PAGE_RUNS; ++i) {
      pages.push(read((await shown(site('lidar'), /s of simulation in/)).text));
      pictures.push(read((await shown(site('large'), /s of simulation in/)).text));
    }
    const peer = summary(peers);
    const factor = (measured: readonly Measured[]): ReturnType<typeof summary> => summary(measured.map((one) => one.factor));
    // Milliseconds of a second of simulation: what another run has more, by how many more it made.
    const cost = (name: Variant, count: (one: Measured) => number): number => {
      const ms = 1000 / factor(runs[name]).median - 1000 / factor(runs.lidar).median;
      const more = summary(runs[name].map((one) => count(one) / one.simulated)).median - summary(runs.lidar.map((one) => count(one) / one.simulated)).median;
      return Math.round((1000 * ms) / more) / 1000;
    };
    const lines = { node: factor(runs.lidar), chromium: factor(pages), node_camera: factor(runs.large), chromium_camera: factor(pictures) };
    for (const [place, value] of Object.entries(lines)) {
      context.emit({
        bench: 'sim',
        what: `seconds of simulation a second, ${place}`,
        ...value,
        aim: FACTOR_AIM,
        peer: 'npm MuJoCo 3.14, the same scene and rays, without ROS',
        peer_factor: peer.median,
        ratio: Math.round((100 * value.median) / peer.median) / 100,
        load: machineLoad(),
      });
      if (value.median < FACTOR_AIM) context.fail(`sim: ${place}: ${String(value.median)} times real time, the aim is ${String(FACTOR_AIM)}`);
    }
    const scan = cost('scans', (one) => one.scans);
    context.emit({ bench: 'sim', what: 'a scan of 360 rays, received', ms: scan, aim_ms: SCAN_AIM_MS });
    if (scan > SCAN_AIM_MS) context.fail(`sim: a scan takes ${String(scan)} ms, the aim is ${String(SCAN_AIM_MS)}`);
    context.emit({ bench: 'sim', what: 'a picture of 320 x 240, received', ms: cost('small', (one) => one.images) });
    context.emit({ bench: 'sim', what: 'a picture of 640 x 480, received', ms: cost('large', (one) => one.images) });
    const program = readFileSync(join(site('lidar'), 'programs/ros2wasm_sim/gzserver.wasm'));
    const brotli = brotliCompressSync(program).length;
    context.emit({ bench: 'sim', what: 'gzserver.wasm', raw: program.length, brotli, aim: BYTES_AIM });
    if (brotli > BYTES_AIM) context.fail(`sim: the simulator has ${String(brotli)} bytes, ${String(BYTES_AIM)} are the aim`);
    const real = pack(context, folder, 'real', VARIANTS.lidar, true);
    const moves: number[] = [];
    for (let i = 0; i < PAGE_RUNS; ++i) moves.push((await shown(real, /the robot moves/)).ms);
    context.emit({ bench: 'sim', what: 'ms from the address to a robot that moves, nothing cached', ...summary(moves), aim_ms: MOVES_AIM_MS });
    if (summary(moves).median > MOVES_AIM_MS) context.fail(`sim: a robot moves after ${String(summary(moves).median)} ms`);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
