// The libraries that nodes use beside rclcpp, and the programs that packages of the channel bring, through
// pack and run: one site with all programs of tests/packages/library_checks, side by side.

import assert from 'node:assert/strict';
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from './pack_workspace.ts';

const PACKAGES = resolve(import.meta.dirname, '../packages');
/** Each says that its checks hold, and ends. */
const CHECKS = ['camera', 'documents', 'geometry', 'viewer'];
const MANIFEST = `schema: 1
name: libraries
distro: jazzy
packages:
  - src/library_checks
launch:
${CHECKS.map((program) => `  - {package: library_checks, executable: ${program}}`).join('\n')}
  - package: image_transport
    executable: republish
    parameters: {in_transport: raw, out_transport: raw}
    remappings: {in: front/image_raw, out: again}
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace();
  cpSync(join(PACKAGES, 'library_checks'), join(workspace.root, 'src/library_checks'), { recursive: true });
  cpSync(join(PACKAGES, 'rclcpp_checks/src'), join(workspace.root, 'src/rclcpp_checks/src'), { recursive: true });
});
after(() => workspace.close());

/** Runs the site until each check has said that it holds: the channel's own programs go on for ever. */
async function checksThatHold(site: string, link: string): Promise<{ missing: string[]; said: string }> {
  const child = workspace.start(['run', site, '--link', link, '--for', '60s']);
  const missing = new Set(CHECKS);
  let said = '';
  const hear = (bytes: Buffer): void => {
    said += bytes.toString();
    for (const program of missing) {
      if (new RegExp(`^\\[${program}-\\d+\\] .*all \\d+ checks hold$`, 'm').test(said)) missing.delete(program);
    }
    if (missing.size === 0) child.kill('SIGINT');
  };
  child.stdout?.on('data', hear);
  child.stderr?.on('data', hear);
  await new Promise((ended) => { child.once('close', ended); });
  return { missing: [...missing], said };
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
