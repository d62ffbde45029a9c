// A launch file in Python in a site with Pyodide: for launch arguments that nobody tried when it was packed, it is run
// again, headless and in Chromium.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const LAUNCH = `
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, OpaqueFunction
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory

from small.words import named


def spied():
    found = []
    for name in ('js', 'pyodide_js', 'pyodide.code'):
        try:
            __import__(name)
            found.append(name)
        except ImportError:
            pass
    try:
        open('/workspace/notes/words.txt', 'w')
        found.append('written')
    except OSError:
        pass
    return '_'.join(found) or 'nothing'


def names_of(size):
    if size == 'spy':
        return ['spy_found_' + spied()]
    with open('/workspace/notes/words.txt') as words:
        known = words.read().split()
    with open(get_package_share_directory('small') + '/config/more.txt') as more:
        known += more.read().split()
    return [named(known[int(size)])]


def nodes(context):
    size = LaunchConfiguration('size').perform(context)
    print('asked for size', size)
    return [Node(package='small', executable='speak', name=name) for name in names_of(size)]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('size', default_value='0', description='which word'),
        DeclareLaunchArgument('mode', default_value='quiet', choices=['quiet', 'loud']),
        DeclareLaunchArgument('part', default_value='one'),
        OpaqueFunction(function=nodes),
        IncludeLaunchDescription(PythonLaunchDescriptionSource(PathJoinSubstitution(
            [FindPackageShare('small'), 'launch', [LaunchConfiguration('part'), '.launch.py']]))),
    ])
`;
const part = (name: string): string =>
  `from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='small', executable='speak', name='${name}')])
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.write('src/small/package.xml', `<?xml version="1.0"?>
<package format="3"><name>small</name><version>0.1.0</version><description>Speaks</description>
<maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license>
<exec_depend>rclpy</exec_depend><export><build_type>ament_python</build_type></export></package>
`);
  workspace.write('src/small/setup.py', `from glob import glob
from setuptools import setup
setup(name='small', version='0.1.0', packages=['small'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/small']), ('share/small', ['package.xml']),
    ('share/small/launch', glob('launch/*.py')), ('share/small/config', glob('config/*'))],
    entry_points={'console_scripts': ['speak = small.speak:main']})
`);
  workspace.write('src/small/setup.cfg', '[develop]\nscript_dir=$base/lib/small\n[install]\ninstall_scripts=$base/lib/small\n');
  workspace.write('src/small/resource/small', '');
  workspace.write('src/small/small/__init__.py', '');
  workspace.write('src/small/small/words.py', "def named(word):\n    return 'node_' + word\n");
  workspace.write('src/small/small/speak.py', `import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('speak')
    node.get_logger().info('I am here')
    rclpy.spin(node)
`);
  for (const name of ['one', 'two']) workspace.write(`src/small/launch/${name}.launch.py`, part(`part_${name}`));
  workspace.write('src/small/config/more.txt', 'tiger');
  workspace.write('notes/words.txt', 'ant lion whale');
  workspace.write('start.launch.py', LAUNCH);
  workspace.write('workspace.yaml', 'schema: 1\nname: again\ndistro: jazzy\npackages: [src/*]\nlaunch: start.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

const run = (...given: string[]) => workspace.run(['run', 'site', '--for', '120s', ...given]);

test('values that were tried are answered without Python, others by it', async () => {
  const tried = await run('mode:=loud', '--until', 'node_ant.*I am here');
  assert.equal(tried.code, 0, tried.stderr);
  assert.doesNotMatch(tried.stderr, /Python/);
  // A file of the workspace, one of a package, a module of the workspace, a launch file that was never run.
  const other = await run('size:=3', 'part:=two', '--until', 'node_tiger.*I am here');
  assert.equal(other.code, 0, other.stdout + other.stderr);
  assert.match(other.stdout, /asked for size 3/);
  assert.match(other.stderr, /Python was run again for these launch arguments/);
  assert.doesNotMatch(other.stdout, /node_ant|part_one/);
});

test('R2W0416: a fault says its line and who called', async () => {
  const fails = await run('size:=seven');
  assert.equal(fails.code, 1);
  assert.match(fails.stderr, /error\[R2W0416\]: the launch file fails: ValueError: invalid literal for int.*'seven'/);
  assert.match(fails.stderr, /--> start\.launch\.py:36:/);
  assert.match(fails.stderr, /called from start\.launch\.py:42, in nodes/);
});

test('it has no JavaScript, and what it reads it cannot write', async () => {
  const spies = await run('size:=spy', '--until', 'spy_found_');
  assert.equal(spies.code, 0, spies.stderr);
  assert.match(spies.stdout, /spy_found_nothing/);
});

test('R2W0724: what it imports is what was packed', async () => {
  const file = join(workspace.root, 'site/python/launch.zip');
  const bytes = readFileSync(file);
  writeFileSync(file, Buffer.concat([bytes, Buffer.from('x')]));
  const refused = await run('size:=1');
  writeFileSync(file, bytes);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0724\]: python\/launch\.zip/);
});

test('the form says that Python is asked again, and so it is in the page', async () => {
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    const shows = (text: string) => page.waitForFunction((wanted) => document.body?.innerText.includes(wanted) === true, text);
    await page.goto(server.url);
    await page.getByText('Launch arguments').click();
    await shows('what only Python decides is asked of it again, in this page');
    await page.getByLabel('size', { exact: true }).fill('2');
    await page.getByRole('button', { name: 'Apply and restart' }).click();
    await shows('node_whale');
    await shows('Python was asked again for these values.');
    assert.equal(new URL(page.url()).search, '?size:=2');
    await page.goto(`${server.url}?size:=seven`);
    await shows('ValueError');
    await shows('start.launch.py:36');
  } finally {
    await browser.close();
    await server.close();
  }
});
