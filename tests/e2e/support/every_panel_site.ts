// One site in which every panel has something to show: C++ and Python nodes of the examples and of the tests' packages.
import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Scratch, runCli } from './served_site.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

const PACKAGES = [
  'examples/05_mobile_robot/src/mobile_robot',
  'examples/06_notebook/src/relay',
  'tests/packages/board_companions_py',
  'tests/packages/countdown',
  'tests/packages/countdown_interfaces',
  'tests/packages/lifecycle_sensor',
];

const LAUNCH = `<launch>
  <include file="$(find-pkg-share mobile_robot)/launch/robot.launch.xml"/>
  <node pkg="turtlesim" exec="turtlesim_node" name="turtlesim"/>
  <node pkg="countdown" exec="server"/>
  <node pkg="lifecycle_sensor" exec="sensor" name="sensor" namespace="lab"/>
  <node pkg="board_companions_py" exec="pictures" args="/camera/image_raw"/>
  <node pkg="relay" exec="relay"/>
</launch>
`;

const MANIFEST = `schema: 1
name: every_panel
title: Every panel
version: 1.0.0
license: Apache-2.0
distro: jazzy
packages: [src/*]
dependencies: [turtlesim, diagnostic_msgs]
launch: all.launch.xml
checks:
  - {title: Odometry comes often enough, topic: /odom, above: 5 Hz}
  - {title: The turtle tells where it is, topic: /turtle1/pose}
tasks:
  - {title: Listen, hint: It comes by itself., checks: [{topic: /odom}]}
  - {title: Wait for ever, checks: [{topic: /nowhere}]}
ui:
  text: lab.md
  notebook: lab.ipynb
`;

/** Packs it, and gives the site's folder. */
export async function packEveryPanel(scratch: Scratch): Promise<string> {
  for (const folder of PACKAGES)
    cpSync(join(ROOT, folder), join(scratch.path, 'src', folder.slice(folder.lastIndexOf('/') + 1)), { recursive: true });
  cpSync(join(ROOT, 'examples/05_mobile_robot/lab.md'), join(scratch.path, 'lab.md'));
  cpSync(join(ROOT, 'examples/06_notebook/lab.ipynb'), join(scratch.path, 'lab.ipynb'));
  scratch.file('all.launch.xml', LAUNCH);
  const manifest = scratch.file('workspace.yaml', MANIFEST);
  const site = join(scratch.path, 'site');
  const packed = await runCli(['pack', manifest, '-o', site]);
  assert.equal(packed.code, 0, packed.errors);
  return site;
}
