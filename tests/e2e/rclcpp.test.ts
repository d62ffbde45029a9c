// The C++ client library through pack and run: each program of tests/packages/rclcpp_checks logs one line
// when all its checks hold.
import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from './pack_workspace.ts';

const PACKAGE = resolve(import.meta.dirname, '../packages/rclcpp_checks');
const SINGLE = ['topics', 'services', 'parameters', 'actions', 'waiting', 'component'];
const THREADED = ['threads'];

const workspaces: PackWorkspace[] = [];
after(() => { for (const one of workspaces) one.close(); });

function manifest(name: string, programs: readonly string[]): string {
  const nodes = programs.map((program) => `  - package: rclcpp_checks
    executable: ${program}
${program === 'parameters' ? '    parameters:\n      - from_arguments: 2.5\n        names: [a, b]\n' : ''}`);
  return `schema: 1
name: ${name}
title: ${name}
version: 1.0.0
license: Apache-2.0
distro: jazzy
packages:
  - src/*
launch:
${nodes.join('')}`;
}

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace();
  workspaces.push(workspace);
  cpSync(PACKAGE, join(workspace.root, 'src/rclcpp_checks'), { recursive: true });
});

for (const program of [...SINGLE, ...THREADED]) {
  const links = THREADED.includes(program) ? ['shared'] : ['shared', 'port'];
  test(`${program} on ${links.join(' and ')}`, { timeout: 300_000 }, async () => {
    const file = `${program}.yaml`;
    workspace.write(file, manifest(program, [program]));
    const packed = await workspace.run(['pack', file, '--output', `site_${program}`]);
    assert.equal(packed.code, 0, packed.stderr);
    for (const link of links) {
      const ran = await workspace.run(
        ['run', `site_${program}`, '--link', link, '--until', 'all \\d+ checks hold', '--for', '30s']);
      assert.equal(ran.code, 0, `${link}: ${ran.stdout}${ran.stderr}`);
    }
  });
}
