// The OnShutdown handlers of a launch file run when its launch is interrupted from outside.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const launchFile = `
from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnShutdown
from launch.substitutions import LocalSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg=['asked to end: ', LocalSubstitution('event.reason')])])),
        RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: LogInfo(msg='because of ' + event.reason))),
    ])
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  workspace.write('all.launch.py', launchFile);
  workspace.write('workspace.yaml', 'schema: 1\nname: turtles\ndependencies: [turtlesim]\nlaunch: all.launch.py\n');
});
after(() => workspace.close());

test('Ctrl-C is the reason that handlers of the end are told', async () => {
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  const child = workspace.start(['run', 'site', '--for', '120s']);
  let said = '';
  child.stdout?.on('data', (bytes: Buffer) => {
    const before = said;
    said += bytes.toString();
    if (said.includes('Spawning turtle') && !before.includes('Spawning turtle')) child.kill('SIGINT');
  });
  await new Promise((ended) => {
    child.once('close', ended);
  });
  assert.match(said, /\[INFO\] \[launch\.user\]: asked to end: ctrl-c \(SIGINT\)\n/);
  assert.match(said, /\[INFO\] \[launch\.user\]: because of ctrl-c \(SIGINT\)\n/);
});
