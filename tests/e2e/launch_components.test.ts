// Components that a launch file loads into a container: they run in the container of their package, with their names,
// remappings, parameters and extra arguments.

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from './pack_workspace.ts';

const launchFile = `
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, LoadComposableNodes
from launch_ros.descriptions import ComposableNode


def component(plugin, **more):
    return ComposableNode(package='composed_talkers', plugin='composed_talkers::' + plugin, **more)


def generate_launch_description():
    box = ComposableNodeContainer(
        package='rclcpp_components', executable='component_container_mt', name='box', namespace='/c',
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

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace();
  cpSync(resolve(import.meta.dirname, '../packages/composed_talkers'), join(workspace.root, 'src/composed_talkers'), { recursive: true });
  workspace.write('workspace.yaml', 'schema: 1\nname: composed\npackages: [src/*]\nlaunch: all.launch.py\n');
  workspace.write('all.launch.py', launchFile.replaceAll('TOPIC', topic()));
  workspace.write('more.yaml', '/**:\n  ros__parameters: {gain: 2.5}\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, /warning\[R2W0417\].*`component_container_mt` runs as `component_container`/);
});
after(() => workspace.close());

function topic(): string {
  const source = workspace.read('src/composed_talkers/src/talk.cpp').toString();
  return /"([^"]+)";/.exec(source)?.[1] ?? assert.fail(source);
}

test('the container of the package gets what the launch file says', () => {
  const { nodes } = JSON.parse(workspace.read('site/site.json').toString()) as { nodes: Record<string, unknown>[] };
  assert.equal(nodes.length, 1);
  const [box] = nodes;
  assert.deepEqual([box?.['package'], box?.['executable'], box?.['label']], ['composed_talkers', 'component_container', '/c/box']);
  assert.deepEqual(box?.['arguments'], [
    '--component=composed_talkers::Counter',
    ...['--ros-args', '-r', '__node:=source', '-r', `${topic()}:=/numbers`].map((word) => `--component-arg=${word}`),
    '--component-flag=use_intra_process_comms',
    '--component=composed_talkers::Missing',
    '--component=composed_talkers::Echo',
    ...['--ros-args', '-r', '__node:=ear', '-r', '__ns:=/in', '-p', 'use_sim_time:=false', '-p', '/**:gain:=2.5', '-r', `${topic()}:=/numbers`]
      .map((word) => `--component-arg=${word}`),
    '--ros-args', '-r', '__node:=box', '-r', '__ns:=/c',
  ]);
});

for (const link of ['shared', 'port']) {
  test(`${link}: they hear each other`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--until', 'heard 5', '--for', '60s']);
    assert.equal(run.code, 0, run.stderr);
    assert.match(run.stdout, /\[c\.box\]: Failed to find class with the requested plugin name 'composed_talkers::Missing'/);
    assert.match(run.stdout, /\[in\.ear\]: heard 5/);
  });
}
