// Example 01, packed by the program under test.
import assert from 'node:assert/strict';
import { cpSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Scratch, runCli } from './served_site.ts';

const EXAMPLE = fileURLToPath(new URL('../../examples/01_talker_listener', import.meta.url));

/** What one must see when it runs: an expression for each of some lines, found in this order. */
export function expectedLines(): RegExp[] {
  const lines = readFileSync(join(EXAMPLE, 'expected.txt'), 'utf8').trimEnd().split('\n');
  return lines.map((line) => new RegExp(`^${line}$`));
}

/** Packs a copy, so that nothing is written into the examples. Returns the site's folder. */
export async function packExample(scratch: Scratch): Promise<string> {
  const workspace = join(scratch.path, 'workspace');
  const site = join(scratch.path, 'site');
  cpSync(EXAMPLE, workspace, { recursive: true });
  const packed = await runCli(['pack', join(workspace, 'workspace.yaml'), '-o', site]);
  assert.equal(packed.code, 0, packed.errors);
  return site;
}
