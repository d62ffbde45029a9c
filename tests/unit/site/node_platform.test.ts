// The files of a site under Node.js: whatever stands in the place of one, a read ends.
//
// Guarantee, hostile input: a pipe, a device or a list of 200 MB in the place of a site's file ends `ros2wasm run` with R2W0706

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, symlinkSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { nodeFiles, nodePlatform, readFileNow } from '../../../runtime/site/session/node_platform.ts';

const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-platform-'));
const platform = nodePlatform(folder, new URL(import.meta.url));
after(() => {
  platform.close();
  rmSync(folder, { recursive: true });
});

test('pipes and devices are refused, whoever reads', { timeout: 20_000 }, async () => {
  execFileSync('mkfifo', [join(folder, 'pipe.json')]);
  symlinkSync('/dev/zero', join(folder, 'zero.json'));
  for (const name of ['pipe.json', 'zero.json']) {
    await assert.rejects(platform.json(name), { code: 'R2W0706', message: /it is not a regular file/ });
    await assert.rejects(platform.compile(name), { code: 'R2W0706' });
    await assert.rejects(platform.bytes(name), { code: 'R2W0706' });
    await assert.rejects(nodeFiles.bytes(join(folder, name)), /it is not a regular file/);
    assert.equal(readFileNow(folder, name), undefined);
  }
});

test('a list has a limit', async () => {
  writeFileSync(join(folder, 'large.json'), '');
  truncateSync(join(folder, 'large.json'), 200e6);
  await assert.rejects(platform.json('large.json'), { code: 'R2W0706', message: /larger than/ });
});
