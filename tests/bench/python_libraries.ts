// The cost of compiled Python libraries: from the start of a site to the first line of a node that imports one, beside a node
// that imports none (the peer), bytes of the site, and the import alone. numpy is the channel's; the others come from Pyodide's
// distribution, or from ROS2WASM_BENCH_PYTHON_INDEX, a mirror of it; without a network their rows say so.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { inBrowser } from './browser_site.ts';
import { machineLoad } from './machine_load.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const MODULES = ['rclpy', 'numpy', 'cv2', 'scipy.optimize', 'matplotlib.pyplot'] as const;
const RUNS = 3;
const WATCHDOG_MS = 120_000;
const MARK = 'the import took';

function nodeOf(module: string): string {
  return `import time
import rclpy
begin = time.perf_counter()
import ${module}
took = time.perf_counter() - begin


def main():
    rclpy.init()
    node = rclpy.create_node('imports')
    node.get_logger().info(f'${MARK} {took * 1000:.1f} ms')
    rclpy.spin(node)
`;
}

/** The site's folder; undefined: the library cannot be had. */
function packed(context: BenchContext, folder: string, module: string): string | undefined {
  const root = join(folder, module);
  const own = join(root, 'src/imports/imports');
  mkdirSync(own, { recursive: true });
  const write = (path: string, text: string): void => {
    writeFileSync(join(root, path), text);
  };
  write('src/imports/package.xml', `<package format="3"><name>imports</name><version>1.0.0</version><description>Imports</description>
<maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license>
<depend>rclpy</depend><export><build_type>ament_python</build_type></export></package>
`);
  write('src/imports/setup.py', `from setuptools import setup
setup(name='imports', version='1.0.0', packages=['imports'], entry_points={'console_scripts': ['imports = imports.imports:main']})
`);
  write('src/imports/setup.cfg', '[develop]\nscript_dir=$base/lib/imports\n[install]\ninstall_scripts=$base/lib/imports\n');
  write('src/imports/imports/__init__.py', '');
  write('src/imports/imports/imports.py', nodeOf(module));
  const index = process.env['ROS2WASM_BENCH_PYTHON_INDEX'];
  const python = index === undefined ? '' : `python: {index: "${index}"}\n`;
  write('workspace.yaml', `schema: 1\nname: imports\npackages: [src/*]\n${python}launch:\n  - {package: imports, executable: imports}\n`);
  const run = spawnSync(join(context.build, 'ros2wasm'), ['pack', join(root, 'workspace.yaml'), '-o', join(root, 'site')], { encoding: 'utf8' });
  if (run.status === 0) return join(root, 'site');
  if (run.stderr.includes('R2W0246')) return undefined;
  throw new Error(`pack failed: ${run.stderr}`);
}

function bytesOf(site: string): number {
  return readdirSync(join(site, 'python'), { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
    .reduce((sum, entry) => sum + statSync(join(entry.parentPath, entry.name)).size, 0);
}

interface Start {
  readonly ms: number;
  readonly line: string;
}

async function headless(context: BenchContext, site: string): Promise<Start> {
  const begin = performance.now();
  const run = spawn(process.execPath, [join(context.root, 'runtime/site/session/headless.ts'), site], { stdio: ['ignore', 'pipe', 'inherit'] });
  const over = once(run, 'close');
  const watchdog = setTimeout(() => run.kill('SIGKILL'), WATCHDOG_MS);
  try {
    for await (const line of createInterface({ input: run.stdout })) {
      if (line.includes(MARK)) return { ms: performance.now() - begin, line };
    }
  } finally {
    clearTimeout(watchdog);
    run.kill('SIGKILL');
    await over;
  }
  throw new Error(`${site} ends before its node says how long the import took`);
}

async function chromium(site: string): Promise<Start> {
  let found: Start | undefined;
  await inBrowser(site, async (page, _pid, url) => {
    const begin = performance.now();
    await page.goto(url);
    await page.waitForFunction((text) => (document.body?.textContent ?? '').includes(text), MARK, { timeout: WATCHDOG_MS });
    found = { ms: performance.now() - begin, line: await page.evaluate(() => document.body.textContent ?? '') };
  });
  if (found === undefined) throw new Error(`${site} has not started`);
  return found;
}

function importMs(line: string): number {
  return Number(new RegExp(`${MARK} ([0-9.]+) ms`).exec(line)?.[1]);
}

export async function benchPythonLibraries(context: BenchContext): Promise<void> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-bench-'));
  const peers = new Map<string, number>();
  try {
    for (const module of MODULES) {
      const site = packed(context, folder, module);
      const what = module === 'rclpy' ? 'start of a node without libraries' : `start of a node that imports ${module}`;
      if (site === undefined) {
        context.emit({ bench: 'python_libraries', what, not_measured: "Pyodide's distribution cannot be reached" });
        continue;
      }
      for (const [place, start] of [['Node.js', () => headless(context, site)], ['Chromium, nothing in the browser', () => chromium(site)]] as const) {
        const runs: Start[] = [];
        for (let run = 0; run < RUNS; run += 1) runs.push(await start());
        const ms = summary(runs.map((run) => run.ms));
        const peer = peers.get(place);
        if (peer === undefined) peers.set(place, ms.median);
        context.emit({
          bench: 'python_libraries',
          what,
          place,
          ms,
          import_ms: summary(runs.map((run) => importMs(run.line))),
          python_bytes: bytesOf(site),
          ...(peer === undefined ? {} : { peer: 'the node without libraries', peer_ms: peer }),
          machine_load: machineLoad(),
        });
      }
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
