// Managed nodes that a launch file leads through their lives: transitions, what follows from them, and the end of all; headless on
// both links and in Chromium.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const launchFile = `
from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, LogWarning, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessStart, OnShutdown
from launch.events import matches_action
from launch.substitutions import LocalSubstitution
from launch_ros.actions import LifecycleNode, LifecycleTransition
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from lifecycle_msgs.msg import Transition


def sensor(name, namespace='', **more):
    return LifecycleNode(package='lifecycle_sensor', executable='sensor', name=name, namespace=namespace, **more)


def change(node, transition):
    return EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_action(node), transition_id=transition))


def generate_launch_description():
    first, late = sensor('first', 'robot'), sensor('late', autostart=True)
    return LaunchDescription([
        RegisterEventHandler(OnProcessStart(target_action=first, on_start=[change(first, Transition.TRANSITION_CONFIGURE)])),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=first, start_state='configuring', goal_state='inactive',
            entities=[LogInfo(msg='first is inactive'), change(first, Transition.TRANSITION_ACTIVATE)])),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=first, goal_state='active', handle_once=True, entities=[late])),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=late, goal_state='active',
            entities=[LifecycleTransition(lifecycle_node_names=['robot/first'], transition_ids=[
                Transition.TRANSITION_DEACTIVATE, Transition.TRANSITION_INACTIVE_SHUTDOWN])])),
        RegisterEventHandler(OnStateTransition(
            target_lifecycle_node=first, goal_state='finalized',
            entities=[LogWarning(msg='first is over'), Shutdown(reason='all was seen')])),
        RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg=['good bye, ', LocalSubstitution('event.reason')])])),
        first,
    ])
`;
const expected = [
  /INFO\] \[launch\.user\]: first is inactive[^]*WARN\] \[launch\.user\]: first is over[^]*INFO\] \[launch\]: all nodes are stopped: all was seen[^]*INFO\] \[launch\.user\]: good bye, all was seen/,
  /robot\.first\]: goes off, was inactive/,
];

const faults = `
launch:
- lifecycle_node:
    {pkg: lifecycle_sensor, exec: sensor, name: broken, namespace: "", autostart: true, param: [{name: period_ms, value: -1}]}
- lifecycle_node: {pkg: plain, exec: spins, name: plain, namespace: "", autostart: true}
`;

const plainNode = `#include "rclcpp/rclcpp.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<rclcpp::Node>("node"));
}
`;

let workspace: PackWorkspace;
const pack = async (file: string, text: string): Promise<void> => {
  workspace.write(file, text);
  workspace.write('workspace.yaml', `schema: 1\nname: lives\npackages: [src/*]\nlaunch: ${file}\n`);
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
};
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.copyPackages('lifecycle_sensor');
  workspace.addPackage('plain', { spins: plainNode }, {
    cmake: 'find_package(rclcpp REQUIRED)\nament_target_dependencies(spins rclcpp)',
    depends: ['rclcpp'],
  });
  await pack('lives.launch.py', launchFile);
});
after(() => workspace.close());

for (const link of played('port', 'shared')) {
  test(`${link}: a launch file changes states, follows changes, and ends all`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '300s']);
    for (const lines of expected) assert.match(run.stdout, lines, run.stderr);
    assert.doesNotMatch(run.stdout, /R2W07/);
  });
}

test('in Chromium the page shows what the launch says', async () => {
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    await page.goto(server.url);
    const tile = page.getByRole('article', { name: 'Console of the launch file' });
    await tile.getByText('[launch.user]: good bye').waitFor();
    await tile.getByText('all nodes are stopped: all was seen').waitFor();
  } finally {
    await browser.close();
    await server.close();
  }
});

test('a node that refuses a transition, and one that is not a managed node, are told of', async () => {
  await pack('faults.launch.yaml', faults);
  for (const fault of ["Failed to make transition 'configure' for LifecycleNode '/broken'", '`/plain/change_state` so far']) {
    const run = await workspace.run(['run', 'site', '--until', `ERROR\\] \\[launch\\]: error\\[R2W0725\\]: .*${fault}`]);
    assert.equal(run.code, 0, run.stdout + run.stderr);
  }
});
