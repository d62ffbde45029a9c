// How a launch file in Python handles lines that nodes print, and nodes that it ends; headless on both links and in Chromium.

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
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import matches_action
from launch.events.process import ShutdownProcess
from launch_ros.actions import Node


def generate_launch_description():
    first = Node(package='plain', executable='counts', name='first')
    second = Node(package='plain', executable='counts', name='second')

    def ready(event):
        if b'counted to 3' in event.text:
            return [LogInfo(msg=f'first said: {event.text.decode().strip()}'), second]

    def logged(event):
        text = event.text.decode().strip()
        return LogInfo(msg=f'of second: {text}') if text.endswith('hello') else None

    return LaunchDescription([
        first,
        RegisterEventHandler(OnProcessIO(target_action=first, on_stdout=ready)),
        RegisterEventHandler(OnProcessIO(target_action=second, on_stderr=logged)),
        RegisterEventHandler(OnProcessStart(target_action=second, on_start=[
            EmitEvent(event=ShutdownProcess(process_matcher=matches_action(first)))])),
        RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[LogInfo(msg='first is over')])),
        RegisterEventHandler(OnProcessIO(target_action=second, on_stdout=lambda event: Shutdown(
            reason=f'second said: {event.text.decode()}') if 'counted to 9' in event.text.decode() else None)),
    ])
`;
const node = `#include <chrono>
#include <iostream>

#include "rclcpp/rclcpp.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  RCLCPP_INFO(node->get_logger(), "hello");
  int count = 0;
  auto timer = node->create_wall_timer(std::chrono::milliseconds(50), [&] {
    std::cout << "counted to " << ++count << std::endl;
  });
  rclcpp::spin(node);
}
`;
const expected = [
  /INFO\] \[launch\.user\]: first said: counted to 3\b/,
  /INFO\] \[launch\.user\]: first is over/,
  /INFO\] \[launch\.user\]: of second: .*\[second\]: hello/,
  /INFO\] \[launch\]: all nodes are stopped: second said: counted to 9\b/,
];

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.addPackage('plain', { counts: node }, {
    cmake: 'find_package(rclcpp REQUIRED)\nament_target_dependencies(counts rclcpp)',
    depends: ['rclcpp'],
  });
  workspace.write('events.launch.py', launchFile);
  workspace.write('workspace.yaml', 'schema: 1\nname: events\npackages: [src/*]\nlaunch: events.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

for (const link of played('shared', 'port')) {
  test(`${link}: lines of nodes start, say and end what the launch file asks for`, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '300s']);
    for (const line of expected) assert.match(run.stdout, line, run.stderr);
    assert.equal(run.stdout.split('first said').length, 2, 'the line came once');
  });
}

test('in Chromium the page shows the same', async () => {
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    await page.goto(server.url);
    const tile = page.getByRole('article', { name: 'Console of the launch file' });
    await tile.getByText('[launch.user]: first is over').waitFor();
    await tile.getByText('all nodes are stopped: second said: counted to 9').waitFor();
  } finally {
    await browser.close();
    await server.close();
  }
});
