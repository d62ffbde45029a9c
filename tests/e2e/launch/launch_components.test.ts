// Components that a launch file loads into a container: they run in the container of their package, with their names,
// remappings, parameters and extra arguments; callbacks take turns there, or do not, as the container's name says.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const launchFile = `
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
from launch_ros.descriptions import ComposableNode


def component(plugin, **more):
    return ComposableNode(package='composed_talkers', plugin='composed_talkers::' + plugin, **more)


def generate_launch_description():
    box = ComposableNodeContainer(
        package='rclcpp_components', executable='my_container', name='box', namespace='/c',
        composable_node_descriptions=[
            component('Counter', name='source', remappings=[('TOPIC', '/numbers')],
                      extra_arguments=[{'use_intra_process_comms': True}]),
            component('Missing'),
        ])
    return LaunchDescription([
        box,
        LoadComposableNodes(target_container=box, composable_node_descriptions=[
            component('Echo', name='ear', namespace='in', remappings=[('TOPIC', '/numbers')],
                      parameters=[{'use_sim_time': False}, '/workspace/more.yaml']),
        ]),
    ])
`;

/** A visitor waits within a callback until the porter opens the gate, in each kind of container. */
const gates = `
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def container(name, executable, *words):
    return ComposableNodeContainer(
        package='rclcpp_components', executable=executable, name='box', namespace=name, arguments=list(words),
        composable_node_descriptions=[
            ComposableNode(package='composed_talkers', plugin='composed_talkers::Visitor', namespace=name, parameters=[{'patience': 1}]),
            ComposableNode(package='composed_talkers', plugin='composed_talkers::Porter', namespace=name)])


def generate_launch_description():
    return LaunchDescription([
        container('turns', 'component_container'),
        container('mt', 'component_container_mt', '--ros-args', '-p', 'thread_num:=2'),
        container('apart', 'component_container_isolated'),
        container('apart_mt', 'component_container_isolated', '--use_multi_threaded_executor')])
`;

let workspace: PackWorkspace;
/** Programs are linked in a folder with spaces in its name. */
const kept = (): Readonly<Record<string, string>> => ({ XDG_CACHE_HOME: join(workspace.root, 'a cache of its own') });

before(async () => {
  workspace = new PackWorkspace();
  workspace.copyPackages('composed_talkers', 'board_companions');
  workspace.write('workspace.yaml', 'schema: 1\nname: composed\npackages: [src/*]\nlaunch: all.launch.py\n');
  workspace.write('all.launch.py', launchFile.replaceAll('TOPIC', topic()));
  workspace.write('more.yaml', '/**:\n  ros__parameters: {gain: 2.5}\n');
  const packed = await workspace.run(['pack'], kept());
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

function topic(): string {
  const source = workspace.read('src/composed_talkers/src/talk.cpp').toString();
  return /"([^"]+)";/.exec(source)?.[1] ?? assert.fail(source);
}

test('the container of the package gets what the launch file says', () => {
  const { nodes } = JSON.parse(workspace.read('site/site.json').toString()) as { nodes: Record<string, unknown>[]; };
  assert.equal(nodes.length, 1);
  const [box] = nodes;
  assert.deepEqual([box?.['package'], box?.['executable'], box?.['label']], ['composed_talkers', 'component_container', '/c/box']);
  assert.deepEqual(box?.['arguments'], [
    '--component=composed_talkers::Counter',
    ...['--ros-args', '-r', '__node:=source', '-r', `${topic()}:=/numbers`].map((word) => `--component-arg=${word}`),
    '--component-flag=use_intra_process_comms',
    '--component=composed_talkers::Missing',
    '--component=composed_talkers::Echo',
    ...['--ros-args', '-r', '__node:=ear', '-r', '__ns:=/in', '-p', '/in/ear:use_sim_time:=false', '-p', '/**:gain:=2.5', '-r', `${topic()}:=/numbers`]
      .map((word) => `--component-arg=${word}`),
    '--ros-args',
    '-r',
    '__node:=box',
    '-r',
    '__ns:=/c',
  ]);
});

for (const link of played('shared', 'port')) {
  test(`${link}: they hear each other`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--until', 'heard 5', '--for', '60s']);
    assert.equal(run.code, 0, run.stderr);
    assert.match(run.stdout, /\[c\.box\]: Failed to find class with the requested plugin name 'composed_talkers::Missing'/);
    assert.match(run.stdout, /\[in\.ear\]: heard 5/);
  });
}

test('callbacks of a container take turns, or run at the same time', async () => {
  workspace.write('gates.launch.py', gates.replaceAll("{'patience': 1}", "{'patience': 600}").replace("container('turns', 'component_container'),", ''));
  workspace.write('gates.yaml', 'schema: 1\nname: gates\npackages: [src/*]\nlaunch: gates.launch.py\n');
  const packed = await workspace.run(['pack', 'gates.yaml', '--output', 'gates'], kept());
  assert.equal(packed.code, 0, packed.stderr);
  assert.doesNotMatch(packed.stderr, /R2W0417/);
  const { nodes } = JSON.parse(workspace.read('gates/site.json').toString()) as { nodes: { executable: string; }[]; };
  assert.deepEqual(nodes.map((node) => node.executable), ['component_container_mt', 'component_container_isolated', 'component_container_isolated']);
  for (const name of ['mt', 'apart', 'apart_mt']) {
    const run = await workspace.run(['run', 'gates', '--link', 'shared', '--until', `\\[${name}\\.visitor\\]: came in`, '--for', '60s']);
    assert.equal(run.code, 0, `${run.stdout}${run.stderr}`);
  }
  const refused = await workspace.run(['run', 'gates', '--link', 'port', '--for', '20s']);
  assert.notEqual(refused.code, 0);
  assert.match(`${refused.stdout}${refused.stderr}`, /R2W0704/);

  workspace.write('gates.launch.py', gates);
  const again = await workspace.run(['pack', 'gates.yaml', '--output', 'gates'], kept());
  assert.equal(again.code, 0, again.stderr);
  const turns = await workspace.run(['run', 'gates', '--link', 'shared', '--until', '\\[turns\\.visitor\\]: waited in vain', '--for', '60s']);
  assert.equal(turns.code, 0, `${turns.stdout}${turns.stderr}`);
});

test('containers with threads load, unload and list as the other one', async () => {
  for (const container of ['component_container_mt', 'component_container_isolated']) {
    workspace.write('asked.yaml', `schema: 1
name: asked
packages: [src/*]
launch:
  - {package: composed_talkers, executable: ${container}}
  - {package: board_companions, executable: load_components, arguments: [/ComponentManager, composed_talkers, 'composed_talkers::Counter:=clock', 'composed_talkers::Silent', '1', '7']}
`);
    const packed = await workspace.run(['pack', 'asked.yaml', '--output', container], kept());
    assert.equal(packed.code, 0, packed.stderr);
    const run = await workspace.run(['run', container, '--link', 'shared', '--until', '2 /silent', '--for', '60s']);
    const said = `${run.stdout}${run.stderr}`;
    assert.equal(run.code, 0, said);
    const told = said.split('\n').filter((line) => /^\[load_components-2\] (load|unload|\d)/.test(line)).map((line) =>
      line.slice('[load_components-2] '.length)
    );
    assert.deepEqual(told, ['load composed_talkers::Counter: /clock', 'load composed_talkers::Silent: /silent', 'unload 1: done',
      'unload 7: No node found with unique_id: 7', '2 /silent']);
  }
});

test('components of two packages are in one container, where their libraries define the same', async () => {
  const from = join(workspace.root, 'src/composed_talkers');
  for (const entry of readdirSync(from, { recursive: true, withFileTypes: true })) {
    if (!entry.isFile()) continue;
    const file = join(entry.parentPath, entry.name);
    const text = readFileSync(file, 'utf8').replaceAll('composed_talkers', 'other_talkers');
    workspace.write(join('src/other_talkers', relative(from, file)).replace('composed_talkers', 'other_talkers'), text);
  }
  workspace.write('two.launch.py', `
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([ComposableNodeContainer(
        package='rclcpp_components', executable='component_container', name='box', namespace='',
        composable_node_descriptions=[
            ComposableNode(package='composed_talkers', plugin='composed_talkers::Counter', name='source'),
            ComposableNode(package='other_talkers', plugin='other_talkers::Echo', name='ear')])])
`);
  workspace.write('two.yaml', 'schema: 1\nname: two\npackages: [src/*]\nlaunch: two.launch.py\n');
  const packed = await workspace.run(['pack', 'two.yaml', '--output', 'two'], kept());
  assert.equal(packed.code, 0, packed.stderr);
  const { nodes } = JSON.parse(workspace.read('two/site.json').toString()) as { nodes: { package: string; label: string; program: string; }[]; };
  assert.deepEqual(nodes.map((node) => [node.package, node.label, node.program]), [['composed_talkers', '/box',
    'programs/composed_talkers/component_container-other_talkers.wasm']]);
  const run = await workspace.run(['run', 'two', '--until', '\\[ear\\]: heard 5', '--for', '60s']);
  assert.equal(run.code, 0, run.stderr);
});
