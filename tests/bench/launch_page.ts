// From the opening of a page with other launch arguments to the moment in which its nodes are told to start, in Chromium:
// for values that were tried when the site was packed, and for one that only Python can follow, which Pyodide reads again.
// The launch file is in Python and has 200 nodes, of which one is started. Peer: the same page without arguments.
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { inBrowser } from './browser_site.ts';
import type { BenchContext } from './run.ts';
import { summary } from './statistics.ts';

const NODES = 200;
const RUNS = 5;
const WATCHDOG_MS = 120_000;

const LAUNCH = `from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch_ros.actions import Node


def nodes(context):
    prefix = context.launch_configurations['mode'] + context.launch_configurations['n']
    return [Node(package='python_bench', executable='waits', name='n', namespace=prefix + str(i), parameters=[{'p': [1, 2, 3]}])
            for i in range(${NODES})]


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('n', default_value='x'),
                              DeclareLaunchArgument('mode', default_value='a', choices=['a', 'b']), OpaqueFunction(function=nodes)])
`;

interface Start {
  /** Milliseconds for the launch file alone; 0: it was not evaluated. */
  readonly evaluated: number;
  readonly started: number;
}

export async function benchLaunchPage(context: BenchContext, folder: string): Promise<void> {
  const workspace = join(folder, 'in_page');
  mkdirSync(workspace);
  cpSync(join(context.root, 'tests/bench/packages/python_bench'), join(workspace, 'python_bench'), { recursive: true });
  writeFileSync(join(workspace, 'all.launch.py'), LAUNCH);
  writeFileSync(join(workspace, 'workspace.yaml'), 'schema: 1\nname: in_page\npackages: [python_bench]\nlaunch: all.launch.py\n');
  const site = join(workspace, 'site');
  const packed = spawnSync(join(context.build, 'ros2wasm'), ['pack', join(workspace, 'workspace.yaml'), '-o', site], { encoding: 'utf8' });
  if (packed.status !== 0) throw new Error(`pack failed: ${packed.stderr}`);
  await inBrowser(site, async (page, _pid, url) => {
    const start = async (given: string): Promise<Start> => {
      await page.goto('about:blank');
      await page.goto(`${url}?nodes=waits-1${given}`, { waitUntil: 'commit' });
      const found = await page.waitForFunction(() => {
        const [told] = performance.getEntriesByName('ros2wasm: nodes are told to start');
        if (told === undefined) return undefined;
        const [evaluated] = performance.getEntriesByName('ros2wasm: launch arguments');
        return { evaluated: evaluated?.duration ?? 0, started: told.startTime };
      }, undefined, { timeout: WATCHDOG_MS });
      const value = await found.jsonValue();
      if (value === undefined) throw new Error('the page tells no time');
      return value;
    };
    const cases = [['none', ''], ['tried', '&mode:=b'], ['python_again', '&n:=y']] as const;
    await start('');
    const times = new Map<string, Start[]>(cases.map(([name]) => [name, []]));
    for (let run = 0; run < RUNS; run += 1) for (const [name, given] of cases) times.get(name)?.push(await start(given));
    const all = (name: string, key: keyof Start): ReturnType<typeof summary> => summary((times.get(name) ?? []).map((one) => one[key]));
    for (const name of ['tried', 'python_again']) {
      context.emit({
        bench: 'launch_page',
        language: 'py',
        nodes: NODES,
        arguments: name,
        browser: 'chromium',
        evaluated_ms: all(name, 'evaluated'),
        started_ms: all(name, 'started'),
        peer: 'the page without launch arguments',
        peer_started_ms: all('none', 'started'),
      });
    }
  });
}
