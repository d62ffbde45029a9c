// The C++ client library through pack and run: each program of tests/packages/rclcpp_checks logs one line
// when all its checks hold. They run side by side, as the nodes of one site.

// Compatibility, works: topics, services, parameters, actions, wait sets, callback groups and
// executors, components of rclcpp; its exceptions with the texts of ROS 2

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const PACKAGES = resolve(import.meta.dirname, '../../packages');
const SINGLE = ['topics', 'services', 'parameters', 'actions', 'waiting', 'quality', 'sim_clock', 'sim_time', 'every_node', 'exceptions', 'component',
  'lifecycle', 'introspection', 'content_filter', 'statistics', 'newer_cpp'];
const THREADED = ['threads', 'plain_threads', 'newer_threads'];
/** The port link has no memory for threads. */
const PROGRAMS = { shared: [...SINGLE, ...THREADED], port: SINGLE };
/** Values that the program `parameters` checks. */
const PARAMETERS = '    parameters:\n      - from_arguments: 2.5\n        names: [a, b]\n';

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  for (const name of ['rclcpp_checks', 'lifecycle_sensor', 'rclcpp_events_checks', 'rclcpp_forms_checks', 'tf2_checks', 'filter_checks', 'file_checks']) {
    cpSync(join(PACKAGES, name), join(workspace.root, 'src', name), { recursive: true });
  }
});
after(() => workspace.close());

function manifest(name: string, programs: readonly string[]): string {
  const nodes = programs.map((program) =>
    `  - package: ${name}
    executable: ${program}
${program === 'parameters' ? PARAMETERS : ''}`
  );
  return `schema: 1
name: checks
title: Checks
version: 1.0.0
license: Apache-2.0
distro: jazzy
packages:
  - src/${name}
launch:
${nodes.join('')}`;
}

for (const [link, programs] of Object.entries(PROGRAMS)) {
  test(`every program's checks hold on the ${link} link`, { timeout: 500_000 }, async () => {
    workspace.write(`${link}.yaml`, manifest('rclcpp_checks', programs));
    const packed = await workspace.run(['pack', `${link}.yaml`, '--output', `site_${link}`]);
    assert.equal(packed.code, 0, packed.stderr);
    const ran = await workspace.run(['run', `site_${link}`, '--link', link, '--for', '60s']);
    const said = `${ran.stdout}${ran.stderr}`;
    for (const program of programs) {
      assert.match(said, new RegExp(`^\\[${program}-\\d+\\] .*all \\d+ checks hold$`, 'm'), said);
    }
    assert.equal(ran.code, 0, said);
  });
}

test('a managed node is led through its life on both links', { timeout: 500_000 }, async () => {
  workspace.write('lifecycle.yaml', manifest('lifecycle_sensor', ['sensor', 'manager']));
  const packed = await workspace.run(['pack', 'lifecycle.yaml', '--output', 'site_lifecycle']);
  assert.equal(packed.code, 0, packed.stderr);
  for (const link of Object.keys(PROGRAMS)) {
    const ran = await workspace.run(['run', 'site_lifecycle', '--link', link, '--until', 'led the sensor through its whole life', '--for', '60s']);
    assert.equal(ran.code, 0, `${ran.stdout}${ran.stderr}`);
  }
});

for (
  const { title, name, programs } of [
    { title: 'transforms are published, stored and found', name: 'tf2_checks', programs: ['buffer', 'broadcaster', 'listener'] },
    { title: 'share files are read and own files written', name: 'file_checks', programs: ['share', 'own_files'] },
    {
      title: 'waits end with messages, requests and events; waitables, wait sets and executors of events run',
      name: 'rclcpp_events_checks',
      programs: ['told', 'waitables', 'wait_sets', 'events_executor'],
    },
    { title: 'seldom used forms and the small libraries do what they say', name: 'rclcpp_forms_checks', programs: ['forms', 'log_macros', 'small_libraries'] },
    { title: 'messages pass filters and are put together', name: 'filter_checks', programs: ['filters', 'subscribers'] },
  ]
) {
  test(`${title} on both links`, { timeout: 500_000 }, async () => {
    workspace.write(`${name}.yaml`, manifest(name, programs));
    const packed = await workspace.run(['pack', `${name}.yaml`, '--output', `site_${name}`]);
    assert.equal(packed.code, 0, packed.stderr);
    for (const link of Object.keys(PROGRAMS)) {
      const ran = await workspace.run(['run', `site_${name}`, '--link', link, '--for', '60s']);
      const said = `${ran.stdout}${ran.stderr}`;
      for (const program of programs) {
        assert.match(said, new RegExp(`^\\[${program}-\\d+\\] .*all \\d+ checks hold$`, 'm'), said);
      }
      assert.equal(ran.code, 0, said);
    }
  });
}

/** The output of tf2_echo for base in map, and of tf2_monitor for the same frames: two metres ahead, turned by a quarter. */
const ECHO = [
  /At time \d+\.\d+$/,
  /- Translation: \[2\.000, 0\.000, 0\.000\]$/,
  /- Rotation: in Quaternion \[0\.000, 0\.000, 0\.707, 0\.707\]$/,
  /- Rotation: in RPY \(radian\) \[0\.000, -?0\.000, 1\.571\]$/,
  /- Rotation: in RPY \(degree\) \[0\.000, -?0\.000, 90\.000\]$/,
  /- Matrix:$/,
  / {2}-?0\.000 -1\.000 {2}0\.000 {2}2\.000$/,
  / {2}1\.000 {2}-?0\.000 {2}0\.000 {2}0\.000$/,
  / {2}0\.000 {2}0\.000 {2}1\.000 {2}0\.000$/,
  / {2}0\.000 {2}0\.000 {2}0\.000 {2}1\.000$/,
];
const MONITOR = [
  /Waiting for transform chain to become available between map and base \.*$/,
  /Gathering data on map -> base for 10 seconds\.\.\.$/,
  /RESULTS: for map to base$/,
  /Chain is: map -> base$/,
  /Net delay {5}avg = [-\d.e+]+: max = [-\d.e+]+$/,
  /Frames:$/,
  /Frame: base, published by <no authority available>, Average Delay: [-\d.e+]+, Max Delay: [-\d.e+]+$/,
  /All Broadcasters:$/,
  /Node: <no authority available> [\d.e+]+ Hz, Average Delay: [-\d.e+]+ Max Delay: [-\d.e+]+$/,
];

test('the programs of tf2_ros say where frames are, and answer who asks', { timeout: 500_000 }, async () => {
  const frames =
    '  - {package: tf2_ros, executable: static_transform_publisher, arguments: [--x, 2, --yaw, 1.5707963267948966, --frame-id, map, --child-frame-id, base]}\n';
  const tools =
    '  - {package: tf2_ros, executable: tf2_echo, arguments: [map, base, 2]}\n  - {package: tf2_ros, executable: tf2_monitor, arguments: [map, base]}\n';
  workspace.write('tools.yaml', manifest('tf2_checks', []) + frames + tools);
  workspace.write('remote.yaml', `${manifest('tf2_checks', ['remote'])}  - {package: tf2_ros, executable: buffer_server}\n${frames}`);
  for (const name of ['tools', 'remote']) {
    const packed = await workspace.run(['pack', `${name}.yaml`, '--output', `site_${name}`]);
    assert.equal(packed.code, 0, packed.stderr);
  }
  // Ten seconds of the monitor take none in a stepped run.
  const said = await workspace.run(['run', 'site_tools', '--stepped', '--seed', '1', '--until', 'Node: <no authority available>', '--for', '60s']);
  assert.equal(said.code, 0, `${said.stdout}${said.stderr}`);
  for (const [program, lines] of [['tf2_echo', ECHO], ['tf2_monitor', MONITOR]] as const) {
    const own = said.stdout.split('\n').filter((line) => line.startsWith(`[${program}-`));
    let at = -1;
    for (const line of lines) {
      at = own.findIndex((text, i) => i > at && line.test(text));
      assert.notEqual(at, -1, `${String(line)}\n${own.join('\n')}`);
    }
  }
  const asked = await workspace.run(['run', 'site_remote', '--link', 'shared', '--until', '\\[remote\\]: all \\d+ checks hold', '--for', '60s']);
  assert.equal(asked.code, 0, `${asked.stdout}${asked.stderr}`);
});
