// robot_state_publisher with the path of a description on its command line, as older launch files start it.

// Compatibility, works: `robot_state_publisher` with the path of a description as its argument, in place of the parameter

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const launchFile = `
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    urdf = os.path.join(get_package_share_directory('arm'), 'urdf', 'arm.urdf')
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', name='described', arguments=[urdf]),
        Node(package='robot_state_publisher', executable='robot_state_publisher', name='astray', arguments=['/nowhere.urdf']),
        Node(package='robot_state_publisher', executable='robot_state_publisher', name='bare'),
    ])
`;
const wanted = [
  /\[WARN\] .*\[described\]: No robot_description parameter, but command-line argument available\./,
  /\[INFO\] .*\[described\]: Robot initialized/,
  /\[FATAL\] .*\[astray\]: Failed to open URDF file: \/nowhere\.urdf: No such file or directory/,
  /\[FATAL\] .*\[bare\]: robot_description parameter must not be empty/,
];

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('arm', {}, { cmake: 'install(DIRECTORY launch urdf DESTINATION share/arm)\n', depends: ['robot_state_publisher'] });
  workspace.write('src/arm/urdf/arm.urdf', '<robot name="arm"><link name="base"/></robot>\n');
  workspace.write('src/arm/launch/arm.launch.py', launchFile);
  workspace.write('all.launch.xml', '<launch><include file="$(find-pkg-share arm)/launch/arm.launch.py"/></launch>\n');
  workspace.write('workspace.yaml', 'schema: 1\nname: robots\npackages: [src/*]\nlaunch: all.launch.xml\n');
});
after(() => workspace.close());

test('the description is read from the file that the argument names', async () => {
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  const run = await workspace.run(['run', 'site', '--for', '20s']);
  for (const line of wanted) assert.match(run.stdout + run.stderr, line);
});
