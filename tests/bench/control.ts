// ros2_control: a manager at 100 Hz with six joints, three controllers and one that measures when it is updated. The processor
// time of the node is that of the site with it less that of the site without it.
import { spawn, spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { brotliCompressSync } from 'node:zlib';
import { inBrowser } from './browser_site.ts';
import { machineLoad } from './machine_load.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const RUNS = 3;
const WARM_UP_MS = 6000;
const WINDOW_MS = 8000;
const SHARE_AIM = 3;
const JITTER_AIM_MS = 2;
const TICKS_A_SECOND = 100;

/** Seconds of processor time of a process and those that it has started. */
function processorTime(pid: number): number {
  const stat = readFileSync(`/proc/${String(pid)}/stat`, 'utf8');
  const [user = 0, system = 0] = stat.slice(stat.lastIndexOf(')') + 2).split(' ').slice(11, 13).map(Number);
  const children = readdirSync(`/proc/${String(pid)}/task`)
    .flatMap((task) => readFileSync(`/proc/${String(pid)}/task/${task}/children`, 'utf8').trim().split(' '))
    .filter((one) => one !== '');
  return (user + system) / TICKS_A_SECOND + children.reduce((sum, one) => sum + processorTime(Number(one)), 0);
}

/** How much of one core a running site takes, in percent; and what it printed. */
async function share(context: BenchContext, site: string, control: boolean): Promise<{ percent: number; text: string; }> {
  const run = spawn(join(context.build, 'ros2wasm'), ['run', site, `control:=${String(control)}`, '--for', `${String((WARM_UP_MS + WINDOW_MS) / 1000 + 4)}s`]);
  let text = '';
  run.stdout.on('data', (bytes: Buffer) => (text += bytes.toString()));
  run.stderr.on('data', (bytes: Buffer) => (text += bytes.toString()));
  const ended = new Promise((resolve) => run.on('close', resolve));
  await sleep(WARM_UP_MS);
  const [before, begin] = [processorTime(run.pid ?? 0), performance.now()];
  await sleep(WINDOW_MS);
  const percent = (100 * (processorTime(run.pid ?? 0) - before)) / ((performance.now() - begin) / 1000);
  await ended;
  return { percent, text };
}

interface Jitter {
  readonly p99: number;
  readonly worst: number;
}

function read(text: string): Jitter {
  const [, p99, worst] = /jitter of \d+ updates: median [\d.]+, p99 ([\d.]+), worst ([\d.]+) ms/.exec(text) ?? [];
  if (p99 === undefined || worst === undefined) throw new Error(`the meter said nothing: ${text.slice(-3000)}`);
  return { p99: Number(p99), worst: Number(worst) };
}

export async function benchControl(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  try {
    cpSync(join(context.root, 'tests/bench/packages/control_bench'), join(folder, 'control_bench'), { recursive: true });
    writeFileSync(join(folder, 'workspace.yaml'), 'schema: 1\nname: control\npackages: [control_bench]\nlaunch: control_bench/launch/control.launch.py\n');
    const site = join(folder, 'site');
    const packed = spawnSync(join(context.build, 'ros2wasm'), ['pack', join(folder, 'workspace.yaml'), '-o', site], { encoding: 'utf8' });
    if (packed.status !== 0) throw new Error(`pack failed: ${packed.stderr}`);
    const shares: number[] = [];
    const inNode: Jitter[] = [];
    const inPage: Jitter[] = [];
    for (let i = 0; i < RUNS; ++i) {
      const [without, with_] = [await share(context, site, false), await share(context, site, true)];
      shares.push(with_.percent - without.percent);
      inNode.push(read(with_.text));
      await inBrowser(site, async (page, _pid, url) => {
        await page.goto(url);
        await page.getByText(/jitter of 1000 updates/).first().waitFor({ timeout: 60_000 });
        inPage.push(read(await page.locator('body').innerText()));
      });
    }
    const cpu = summary(shares);
    context.emit({ bench: 'control', what: 'percent of a core, 100 Hz, 6 joints, 4 controllers, Node.js', ...cpu, aim: SHARE_AIM, load: machineLoad() });
    if (cpu.median > SHARE_AIM) context.fail(`control: the manager takes ${String(cpu.median)} % of a core, the aim is ${String(SHARE_AIM)}`);
    for (const [place, all] of Object.entries({ 'Node.js': inNode, Chromium: inPage })) {
      const p99 = summary(all.map((one) => one.p99));
      context.emit({
        bench: 'control',
        what: `ms from the time of an update, p99, ${place}`,
        ...p99,
        worst: Math.max(...all.map((one) => one.worst)),
        aim: JITTER_AIM_MS,
        load: machineLoad(),
      });
      if (p99.median > JITTER_AIM_MS)
        context.fail(`control: ${place}: an update is ${String(p99.median)} ms late or early, the aim is ${String(JITTER_AIM_MS)}`);
    }
    for (const name of ['ros2_control_node', 'spawner']) {
      const program = readFileSync(join(site, `programs/controller_manager/${name}.wasm`));
      context.emit({ bench: 'control', what: `${name}.wasm`, raw: program.length, brotli: brotliCompressSync(program).length });
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
