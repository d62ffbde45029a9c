// Programs that rely on a 64-bit machine and on what g++'s library brings along, on both links; each says that its checks hold.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const PROGRAMS = ['formats', 'platform', 'brought_along', 'plain'];

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
  workspace.copyPackages('platform_checks');
  const nodes = PROGRAMS.map((name) => `  - {package: platform_checks, executable: ${name}}\n`).join('');
  workspace.write('workspace.yaml', `schema: 1\nname: platform\npackages: [src/*]\nlaunch:\n${nodes}`);
});
after(() => workspace.close());

test('formats, sizes and headers', { timeout: 500_000 }, async () => {
  const packed = await workspace.run(['pack', 'workspace.yaml', '--output', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.doesNotMatch(packed.stderr, /R2W0525/);
  for (const link of ['shared', 'port']) {
    const ran = await workspace.run(['run', 'site', '--link', link, '--for', '60s']);
    const said = `${ran.stdout}${ran.stderr}`;
    for (const program of PROGRAMS.filter((name) => name !== 'plain'))
      assert.match(said, new RegExp(`^\\[${program}-\\d+\\] .*all \\d+ checks hold$`, 'm'), said);
    assert.match(said, /^\[plain-\d+\] a: 41 b: 17, asked for: 38$/m, said);
    assert.equal(ran.code, 0, said);
  }
});
