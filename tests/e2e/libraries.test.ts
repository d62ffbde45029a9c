// The libraries that nodes use beside rclcpp, and the programs that packages of the channel bring, through
// pack and run: one site with all programs of tests/packages/library_checks, side by side.

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from './pack_workspace.ts';

const PACKAGES = resolve(import.meta.dirname, '../packages');
const CHECKS = ['documents', 'geometry'];
const MANIFEST = `schema: 1
name: libraries
distro: jazzy
packages:
  - src/library_checks
launch:
${CHECKS.map((program) => `  - {package: library_checks, executable: ${program}}`).join('\n')}
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace();
  cpSync(join(PACKAGES, 'library_checks'), join(workspace.root, 'src/library_checks'), { recursive: true });
  cpSync(join(PACKAGES, 'rclcpp_checks/src'), join(workspace.root, 'src/rclcpp_checks/src'), { recursive: true });
});
after(() => workspace.close());

test('the libraries that nodes use hold their checks on both links', { timeout: 500_000 }, async () => {
  workspace.write('workspace.yaml', MANIFEST);
  const packed = await workspace.run(['pack', 'workspace.yaml', '--output', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  for (const link of ['shared', 'port']) {
    const ran = await workspace.run(['run', 'site', '--link', link, '--for', '60s']);
    const said = `${ran.stdout}${ran.stderr}`;
    for (const program of CHECKS) {
      assert.match(said, new RegExp(`^\\[${program}-\\d+\\] .*all \\d+ checks hold$`, 'm'), said);
    }
    assert.equal(ran.code, 0, said);
  }
});
