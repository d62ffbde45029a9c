// The C++ client library through pack and run: each program of tests/packages/rclcpp_checks logs one line
// when all its checks hold. They run side by side, as the nodes of one site.

// Compatibility, works: topics, services, parameters, actions, wait sets, callback groups and
// executors, components of rclcpp; its exceptions with the texts of ROS 2

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from './pack_workspace.ts';

const PACKAGES = resolve(import.meta.dirname, '../packages');
const SINGLE = ['topics', 'services', 'parameters', 'actions', 'waiting', 'quality', 'sim_clock', 'sim_time', 'every_node', 'exceptions', 'component', 'lifecycle', 'introspection', 'content_filter', 'statistics', 'newer_cpp'];
const THREADED = ['threads', 'plain_threads', 'newer_threads'];
/** The port link has no memory for threads. */
const PROGRAMS = { shared: [...SINGLE, ...THREADED], port: SINGLE };
/** Values that the program `parameters` checks. */
const PARAMETERS = '    parameters:\n      - from_arguments: 2.5\n        names: [a, b]\n';

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace();
  for (const name of ['rclcpp_checks', 'lifecycle_sensor', 'tf2_checks', 'filter_checks', 'file_checks']) {
    cpSync(join(PACKAGES, name), join(workspace.root, 'src', name), { recursive: true });
  }
});
after(() => workspace.close());

function manifest(name: string, programs: readonly string[]): string {
  const nodes = programs.map((program) => `  - package: ${name}
    executable: ${program}
${program === 'parameters' ? PARAMETERS : ''}`);
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
    const ran = await workspace.run(['run', 'site_lifecycle', '--link', link,
      '--until', 'led the sensor through its whole life', '--for', '60s']);
    assert.equal(ran.code, 0, `${ran.stdout}${ran.stderr}`);
  }
});

for (const { title, name, programs } of [
  { title: 'transforms are told, kept and found', name: 'tf2_checks', programs: ['buffer', 'broadcaster', 'listener'] },
  { title: 'share files are read and own files written', name: 'file_checks', programs: ['share', 'own_files'] },
  { title: 'messages pass filters and are put together', name: 'filter_checks', programs: ['filters', 'subscribers'] },
]) {
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
