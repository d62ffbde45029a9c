// Launch arguments at the start of a site: a launch file in XML and the same in Python, headless on both links, and the form
// of the page in Chromium.

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
const WATCHDOG = '120s';

// One choice alone starts the program `station`; no default names heavy.yaml.
const inXml = `<launch>
  <arg name="robot" default="gamma" description="who drives"><choice value="gamma"/><choice value="delta"/></arg>
  <arg name="speed" default="1.0" description="metres per second"/>
  <arg name="load" default="light"/>
  <arg name="twice" default="false"/>
  <node pkg="two_robots" exec="robot" namespace="$(var robot)">
    <param from="$(find-pkg-share two_robots)/config/$(var load).yaml"/><param name="speed" value="$(var speed)"/>
  </node>
  <node pkg="two_robots" exec="robot" namespace="second" if="$(var twice)">
    <param from="$(find-pkg-share two_robots)/config/$(var load).yaml"/>
  </node>
  <node pkg="two_robots" exec="station" if="$(eval '\\'$(var robot)\\' == \\'delta\\'')">
    <remap from="first" to="/delta/position"/><remap from="second" to="/second/position"/>
  </node>
</launch>
`;
const inPython = `
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def others(context):
    if LaunchConfiguration('robot').perform(context) != 'delta':
        return []
    return [Node(package='two_robots', executable='station',
                 remappings=[('first', '/delta/position'), ('second', '/second/position')])]


def by_size(context):
    size = context.launch_configurations['size']
    return [Node(package='two_robots', executable='robot', namespace='size_' + size)]


def generate_launch_description():
    load = PathJoinSubstitution([FindPackageShare('two_robots'), 'config', [LaunchConfiguration('load'), '.yaml']])
    return LaunchDescription([
        DeclareLaunchArgument('robot', default_value='gamma', description='who drives', choices=['gamma', 'delta']),
        DeclareLaunchArgument('speed', default_value='1.0', description='metres per second'),
        DeclareLaunchArgument('load', default_value='light'),
        DeclareLaunchArgument('twice', default_value='false'),
        DeclareLaunchArgument('size', default_value='small'),
        Node(package='two_robots', executable='robot', namespace=LaunchConfiguration('robot'),
             parameters=[load, {'speed': LaunchConfiguration('speed')}]),
        Node(package='two_robots', executable='robot', namespace='second', parameters=[load],
             condition=IfCondition(LaunchConfiguration('twice'))),
        OpaqueFunction(function=others),
        OpaqueFunction(function=by_size),
    ])
`;

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  cpSync(EXAMPLE, workspace.root, { recursive: true });
  workspace.write('src/two_robots/config/light.yaml', '/**:\n  ros__parameters: {battery: 3}\n');
  workspace.write('src/two_robots/config/heavy.yaml', '/**:\n  ros__parameters: {speed: 5.5}\n');
  workspace.write('start.launch.xml', inXml);
  workspace.write('start.launch.py', inPython);
  const manifest = readFileSync(join(EXAMPLE, 'workspace.yaml'), 'utf8');
  for (const [file, site] of [['start.launch.xml', 'in_xml'], ['start.launch.py', 'in_python']] as const) {
    writeFileSync(join(workspace.root, 'workspace.yaml'), manifest.replace(/^launch: .*$/m, `launch: ${file}`));
    const packed = await workspace.run(['pack', '-o', site]);
    assert.equal(packed.code, 0, packed.stderr);
  }
});
after(() => workspace.close());

test('the arguments are listed as ros2 launch lists them, and other launch files have none', async () => {
  const shown = await workspace.run(['run', 'in_xml', '--show-args']);
  assert.equal(shown.stdout, `Arguments (pass arguments as '<name>:=<value>'):

    'robot':
        who drives. Valid choices are: ['gamma', 'delta']
        (default: 'gamma')

    'speed':
        metres per second
        (default: '1.0')

    'load':
        no description given
        (default: 'light')

    'twice':
        no description given
        (default: 'false')
`);
});

for (const link of played('port', 'shared')) {
  for (const site of ['in_xml', 'in_python']) {
    test(`${link}, ${site}: conditions, names, values and files follow the arguments`, async () => {
      const run = (...given: string[]) => workspace.run(['run', site, ...given, '--link', link, '--until', 'empty', '--for', WATCHDOG]);
      const usual = await run();
      assert.equal(usual.code, 0, usual.stderr);
      assert.match(usual.stdout, /gamma\.robot\]: starting at 1\.0 m\/s/);
      assert.doesNotMatch(usual.stdout, /second\.robot|station/);

      // The station, which no default starts, hears both.
      for (const heard of ['station.*delta is at 2.5', 'second.robot.: starting at 5.5']) {
        const other = await workspace.run([
          'run',
          site,
          'robot:=delta',
          'speed:=2.5',
          'load:=heavy',
          'twice:=true',
          '--link',
          link,
          '--until',
          heard,
          '--for',
          WATCHDOG,
        ]);
        assert.equal(other.code, 0, other.stdout + other.stderr);
        assert.doesNotMatch(other.stdout, /gamma/);
      }
    });
  }
}

test('R2W0730, R2W0412, R2W0403, R2W0411: what is wrong with arguments is said before anything runs', async () => {
  const refused = async (given: string, ...expected: RegExp[]): Promise<void> => {
    const run = await workspace.run(['run', 'in_xml', given]);
    assert.equal(run.code, 1, run.stdout);
    assert.equal(run.stdout, '');
    for (const one of expected) assert.match(run.stderr, one);
  };
  await refused('robt:=delta', /^error\[R2W0730\]: the launch file has no argument `robt`$/m, /fix: robot:=delta/);
  await refused('robot:=omega', /^error\[R2W0412\]: `omega` is not a value/m, /its values are: gamma, delta/, /--> start\.launch\.xml:2:3/);
  await refused('load:=absent', /^error\[R2W0403\]: .*absent\.yaml/m, /there is no such file/);
  await refused('twice:=perhaps', /^error\[R2W0411\]/m);
  const none = await workspace.run(['run', 'in_xml', 'robot']);
  assert.equal(none.code, 2);
  assert.match(none.stderr, /error\[R2W0902\]: `robot` is not a launch argument/);
});

test('arguments that the manifest gives are those of the site, until a visitor gives others', async () => {
  const manifest = readFileSync(join(EXAMPLE, 'workspace.yaml'), 'utf8');
  workspace.write('workspace.yaml', manifest.replace(/^launch: .*$/m, 'launch: {file: start.launch.py, arguments: {robot: delta, speed: 2.50}}'));
  const packed = await workspace.run(['pack', '-o', 'given']);
  assert.equal(packed.code, 0, packed.stderr);
  for (
    const [given, heard, never] of [
      [[], /delta\.robot\]: starting at 2\.5 m\/s/, /gamma/],
      [['robot:=gamma'], /gamma\.robot\]: starting at 2\.5 m\/s/, /delta|station/],
      [['speed:=1.0', 'size:=small'], /delta\.robot\]: starting at 1\.0 m\/s/, /gamma/],
    ] as const
  ) {
    const run = await workspace.run(['run', 'given', ...given, '--until', heard.source, '--for', WATCHDOG]);
    assert.equal(run.code, 0, run.stdout + run.stderr);
    assert.match(run.stdout, heard);
    assert.doesNotMatch(run.stdout, never);
  }
});

const wrong = `<launch>
  <arg name="mode" default="good"><choice value="good"/><choice value="bad"/></arg>
  <arg name="program" default="robot"/>
  <arg name="part" default="one"/>
  <node pkg="two_robots" exec="$(var program)"/>
  <node pkg="two_robots" exec="no_such_program" if="$(eval '\\'$(var mode)\\' == \\'bad\\'')"/>
  <include file="$(find-pkg-share two_robots)/launch/$(var part).launch.py"/>
</launch>
`;

test('variables that the manifest sets are there for the launch file and its nodes, also for other arguments', async () => {
  const ws = new PackWorkspace('shared');
  try {
    const program = '#include <cstdio>\n#include <cstdlib>\nint main(int, char** words) { std::printf("%s %s\\n", std::getenv("MODEL"), words[1]); }\n';
    ws.addPackage('arm', { hello: program }, { cmake: 'install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n' });
    ws.write('src/arm/launch/a.launch.xml', '<launch><arg name="who" default="one"/><node pkg="arm" exec="hello" args="$(var who)_$(env MODEL)"/></launch>\n');
    ws.write('workspace.yaml', 'schema: 1\nname: arm\npackages: [src/*]\nlaunch: {file: src/arm/launch/a.launch.xml, environment: {MODEL: burger}}\n');
    const packed = await ws.run(['pack', '--quick']);
    assert.equal(packed.code, 0, packed.stderr);
    assert.match((await ws.run(['run', 'site', '--for', '60s'])).stdout, /^\[hello-1\] burger one_burger$/m);
    assert.match((await ws.run(['run', 'site', 'who:=two', '--for', '60s'])).stdout, /^\[hello-1\] burger two_burger$/m);
  } finally {
    ws.close();
  }
});

test('R2W0440, R2W0731, R2W0732: values that a site cannot follow', async () => {
  workspace.write('wrong.launch.xml', wrong);
  const part = 'from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n';
  for (const name of ['one', 'two']) workspace.write(`src/two_robots/launch/${name}.launch.py`, part);
  const manifest = readFileSync(join(EXAMPLE, 'workspace.yaml'), 'utf8');
  workspace.write('workspace.yaml', manifest.replace(/^launch: .*$/m, 'launch: wrong.launch.xml'));
  const packed = await workspace.run(['pack', '-o', 'wrong']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, /warning\[R2W0440\]: the launch file fails with mode:=bad/);
  assert.match(packed.stderr, /has no executable `no_such_program`/);
  for (
    const [given, expected] of [
      ['mode:=bad', /error\[R2W0402\]/],
      ['program:=station', /error\[R2W0731\]: the program `station` of package `two_robots`/],
      ['part:=two', /error\[R2W0732\]/],
    ] as const
  ) {
    const run = await workspace.run(['run', 'wrong', given]);
    assert.equal(run.code, 1);
    assert.match(run.stderr, expected);
  }
});

test('what only Python decides for another value stays as it was packed, and that is said', async () => {
  const run = await workspace.run(['run', 'in_python', 'size:=large', '--until', 'size_small.robot', '--for', WATCHDOG]);
  assert.equal(run.code, 0, run.stderr);
  assert.match(run.stderr, /decided in Python when the site was packed/);
  assert.doesNotMatch(run.stdout, /size_large/);
  const exact = await workspace.run(['run', 'in_python', 'speed:=7.0', '--until', 'empty', '--for', WATCHDOG]);
  assert.equal(exact.code, 0, exact.stderr);
  assert.doesNotMatch(exact.stderr, /decided in Python/);
});

test('the form of the page starts the site anew with its values in the link', async () => {
  const server = await serveFolder(join(workspace.root, 'in_xml'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    const hears = (text: string) => page.waitForFunction((wanted) => document.body?.innerText.includes(wanted) === true, text);
    await page.goto(server.url);
    await hears('gamma.robot]: starting at 1.0 m/s');
    await page.getByText('Launch arguments').click();
    await page.getByLabel('robot', { exact: true }).selectOption('delta');
    await page.getByLabel('speed', { exact: true }).fill('2.5');
    await page.getByLabel('twice', { exact: true }).selectOption('true');
    await page.getByRole('button', { name: 'Apply and restart' }).click();
    await hears('delta.robot]: starting at 2.5 m/s');
    assert.equal(new URL(page.url()).search, '?robot:=delta&speed:=2.5&twice:=true');
    assert.doesNotMatch(await page.evaluate(() => document.body.innerText), /gamma\.robot/);
    assert.equal(await page.getByLabel('speed', { exact: true }).inputValue(), '2.5');

    await page.getByRole('button', { name: 'Back to defaults' }).click();
    await hears('gamma.robot]: starting at 1.0 m/s');
    assert.equal(new URL(page.url()).search, '');

    await page.goto(`${server.url}?robot:=omega`);
    await hears('R2W0412');
    await hears('its values are: gamma, delta');
  } finally {
    await browser.close();
    await server.close();
  }
});
