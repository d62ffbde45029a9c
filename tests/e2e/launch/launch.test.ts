// A workspace whose launch file says what runs: example 02, headless on both links and in Chromium; and in Python.

import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../../examples/02_launch');
const expected = readFileSync(join(EXAMPLE, 'expected.txt'), 'utf8').trimEnd().split('\n').map((line) => new RegExp(line));

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  cpSync(EXAMPLE, workspace.root, { recursive: true });
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, /R2W0415.*rviz2\/rviz2/);
});
after(() => workspace.close());

test('what no site can start is refused with --strict', async () => {
  const packed = await workspace.run(['pack', '--strict']);
  assert.equal(packed.code, 1);
  assert.match(packed.stderr, /error\[R2W0415\]: `rviz2\/rviz2` is not started/);
});

function seenInOrder(text: string): void {
  let from = 0;
  for (const line of expected) {
    const found = line.exec(text.slice(from));
    assert.ok(found, `${line.source} is not in\n${text.slice(from)}`);
    from += found.index + found[0].length;
  }
}

test('nodes get what the launch file decides', () => {
  const { nodes } = JSON.parse(workspace.read('site/site.json').toString()) as { nodes: unknown[]; };
  const robot = (n: number, name: string, speed: string): unknown => ({
    id: `robot-${n}`,
    package: 'two_robots',
    executable: 'robot',
    label: `robot (/${name})`,
    kind: 'cpp',
    program: 'programs/two_robots/robot.wasm',
    names: 'programs/two_robots/robot.names',
    threads: false,
    arguments: ['--ros-args', '-r', `__ns:=/${name}`, '-p', '/**:battery:=4', '-p', `speed:=${speed}`],
    environment: {},
    output: 'screen',
    respawn: true,
    respawn_delay: 1,
    source: { file: 'share/two_robots/launch/robot.launch.yaml', line: 7, column: 11 },
  });
  assert.deepEqual(nodes.slice(0, 2), [robot(1, 'alpha', '2.0'), robot(2, 'beta', '1.0')]);
  assert.equal((nodes[2] as { start_after: number; }).start_after, 1);
  assert.equal(nodes.length, 3);
});

for (const link of played('port', 'shared')) {
  test(`${link}: namespaces, parameters, a late start and respawn`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '8s']);
    seenInOrder(run.stdout);
  });
}

test('in Chromium', async () => {
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    await page.goto(server.url);
    await page.waitForFunction(() => /beta\.robot\]: the battery is empty[^]*beta\.robot\]: starting at 1\.0 m\/s/.test(document.body?.innerText ?? ''));
  } finally {
    await browser.close();
    await server.close();
  }
});

const inPython = `
from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    first, second, third = (Node(package='two_robots', executable='robot', namespace=name,
                                 parameters=[{'battery': 1, 'speed': 3.0}]) for name in ('first', 'second', 'third'))
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=first, on_start=[second])),
        RegisterEventHandler(OnProcessExit(target_action=second, on_exit=[LogInfo(msg='and then'), third])),
        first,
    ])
`;

test('the launch file in Python comes to the same, and nodes start when others have started or ended', async () => {
  const nodes = (): { source: unknown; start_on?: unknown; }[] =>
    (JSON.parse(workspace.read('site/site.json').toString()) as { nodes: { source: unknown; }[]; }).nodes;
  const withoutPlaces = (): unknown[] => nodes().map((node) => ({ ...node, source: undefined }));
  const written = withoutPlaces();
  const manifest = workspace.read('workspace.yaml').toString();
  const pack = async (file: string): Promise<void> => {
    writeFileSync(join(workspace.root, 'workspace.yaml'), manifest.replace(/^launch: .*$/m, `launch: ${file}`));
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
  };
  await pack('src/two_robots/launch/bringup.launch.py');
  assert.deepEqual(withoutPlaces(), written);
  assert.deepEqual(nodes()[2]?.source, { file: 'src/two_robots/launch/bringup.launch.py', line: 19, column: 5 });

  writeFileSync(join(workspace.root, 'events.launch.py'), inPython);
  await pack('events.launch.py');
  assert.deepEqual(nodes().map(({ start_on: on }) => on), [
    undefined,
    { node: 'robot-1', event: 'start' },
    { node: 'robot-2', event: 'exit' },
  ]);
  for (const link of ['shared', 'port']) {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '30s']);
    assert.equal(run.code, 0, run.stderr);
    assert.match(run.stdout, /second\.robot\]: the battery is empty[^]*third\.robot\]: starting at 3\.0 m\/s[^]*third\.robot\]: the battery is empty/);
  }
});
