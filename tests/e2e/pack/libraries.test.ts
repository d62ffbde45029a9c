// The libraries that nodes use beside rclcpp, and the programs that packages of the channel bring, through
// pack and run: one site with all programs of tests/packages/library_checks, side by side,
// and one that loads plugins.

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const PACKAGES = resolve(import.meta.dirname, '../../packages');
/** Each says that its checks hold, and ends well. Program -> its package. */
const PROGRAMS = new Map([
  ...['calibration', 'camera', 'control', 'documents', 'geometry', 'kinematics', 'monitor', 'robot', 'scan', 'viewer'].map((
    one,
  ): [string, string] => [one, 'library_checks']),
  ...['compiled', 'headers'].map((one): [string, string] => [one, 'header_checks']),
  ['loader', 'plugin_checks'],
  ...['trees', 'trees_v3'].map((one): [string, string] => [one, 'tree_checks']),
]);
const CHECKS = [...PROGRAMS.keys()];
/** The last lines of `documents`, printed when objects end with their thread and with the program. */
const FAREWELLS = ['the first', 'the last', ...['one', 'two', 'three', 'kept'].map((one) => `the thread's ${one}`)].map((one) => `${one} is gone`);
const ROBOT = `<?xml version="1.0"?>
<!-- a column, two arms, a hand that slides, and a wheel that follows the elbow -->
<robot name="arm">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base">
    <inertial><mass value="2.5"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <visual><geometry><box size="1 2 3"/></geometry><material name="grey"/></visual>
  </link>
  <link name="column"/> <link name="upper"/> <link name="fore"/> <link name="hand"/> <link name="rim"/>
  <joint name="mount" type="fixed"><parent link="base"/><child link="column"/><origin xyz="0 0 0.5"/></joint>
  <joint name="shoulder" type="revolute"><parent link="column"/><child link="upper"/><origin xyz="0 0 0.1"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="fore"/><origin xyz="1 0 0"/>
    <axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
  <joint name="slide" type="prismatic"><parent link="fore"/><child link="hand"/>
    <limit lower="0.2" upper="0.4" effort="1" velocity="1"/></joint>
  <joint name="wheel" type="continuous"><parent link="column"/><child link="rim"/>
    <axis xyz="0 0 1"/><mimic joint="elbow" multiplier="2" offset="0.1"/></joint>
</robot>`;
const MANIFEST = `schema: 1
name: libraries
distro: jazzy
packages:
  - src/header_checks
  - src/library_checks
  - src/plugin_checks
  - src/plugin_shapes
  - src/tree_checks
  - src/tree_nodes
launch:
${[...PROGRAMS].map(([program, of]) => `  - {package: ${of}, executable: ${program}}`).join('\n')}
  - package: image_transport
    executable: republish
    parameters: {in_transport: raw, out_transport: raw}
    remappings: {in: front/image_raw, out: again}
  - package: robot_state_publisher
    executable: robot_state_publisher
    parameters:
      robot_description: ${JSON.stringify(ROBOT)}
  - package: tf2_ros
    executable: static_transform_publisher
    arguments: [--x, 2, --yaw, 1.5707963267948966, --frame-id, map, --child-frame-id, base]
  - package: joint_state_publisher
    executable: joint_state_publisher
    parameters: {rate: 50, publish_default_velocities: true, source_list: [told], zeros.elbow: 0.5}
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  for (const name of ['header_checks', 'library_checks', 'plugin_checks', 'plugin_shapes', 'tree_checks', 'tree_nodes']) {
    cpSync(join(PACKAGES, name), join(workspace.root, 'src', name), { recursive: true });
  }
  cpSync(join(PACKAGES, 'rclcpp_checks/src'), join(workspace.root, 'src/rclcpp_checks/src'), { recursive: true });
});
after(() => workspace.close());

/** Runs the site until each check has said that it holds and has ended well: the channel's own programs go on for ever. */
async function checksThatHold(site: string, link: string): Promise<{ missing: string[]; said: string; }> {
  const child = workspace.start(['run', site, '--link', link, '--for', '60s']);
  const missing = new Set(CHECKS);
  const heard = { stdout: '', stderr: '' }; // apart, as either may stop within a line
  const said = (line: RegExp): boolean => line.test(heard.stdout) || line.test(heard.stderr);
  const hear = (stream: keyof typeof heard) => (bytes: Buffer): void => {
    heard[stream] += bytes.toString();
    for (const program of missing) {
      const lines = ['.*all \\d+ checks hold', 'process has finished cleanly'];
      if (program === 'documents') lines.push(...FAREWELLS);
      if (lines.every((line) => said(new RegExp(`^\\[${program}-\\d+\\] ${line}$`, 'm')))) missing.delete(program);
    }
    if (missing.size === 0 && !child.killed) child.kill('SIGINT');
  };
  child.stdout?.on('data', hear('stdout'));
  child.stderr?.on('data', hear('stderr'));
  await new Promise((ended) => {
    child.once('close', ended);
  });
  return { missing: [...missing], said: heard.stdout + heard.stderr };
}

test('the libraries that nodes use hold their checks on both links', { timeout: 500_000 }, async () => {
  workspace.write('workspace.yaml', MANIFEST);
  const packed = await workspace.run(['pack', 'workspace.yaml', '--output', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  for (const link of ['shared', 'port']) {
    const { missing, said } = await checksThatHold('site', link);
    assert.deepEqual(missing, [], said);
  }
});

test('a component of Boost that is compiled is named as missing', async () => {
  workspace.addPackage('planner', { plan: 'int main() {}' }, {
    depends: ['libboost-all-dev'],
    cmake: 'find_package(Boost REQUIRED COMPONENTS system thread filesystem)',
  });
  workspace.write('planning/workspace.yaml',
    'schema: 1\nname: planning\ndistro: jazzy\npackages: [../src/planner]\nlaunch:\n  - {package: planner, executable: plan}\n');
  const packed = await workspace.run(['pack', 'planning/workspace.yaml', '--output', 'planning/site']);
  assert.equal(packed.code, 1, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0503\]: .*Could NOT find Boost \(missing: thread filesystem\)/);
  assert.match(packed.stderr, /a site has Boost's headers, not its compiled\s+libraries:\s+thread,\s+filesystem/);
});
