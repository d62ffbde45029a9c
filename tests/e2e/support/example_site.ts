// An example, packed by the program under test: the first one if no other is named.
import assert from 'node:assert/strict';
import { cpSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { type Scratch, runCli } from './served_site.ts';

const FIRST = '01_talker_listener';

function folderOf(example: string): string {
  return fileURLToPath(new URL(`../../../examples/${example}`, import.meta.url));
}

/** The lines that the example must print, as expressions; they come in this order. */
export function expectedLines(): RegExp[] {
  const lines = readFileSync(join(folderOf(FIRST), 'expected.txt'), 'utf8').trimEnd().split('\n');
  return lines.map((line) => new RegExp(`^${line}$`));
}

/** Packs a copy, so that nothing is written into the examples. Returns the site's folder. */
export async function packExample(scratch: Scratch, example = FIRST, manifest = 'workspace.yaml', folder = 'site'): Promise<string> {
  const workspace = join(scratch.path, 'workspace');
  const site = join(scratch.path, folder);
  cpSync(folderOf(example), workspace, { recursive: true });
  const packed = await runCli(['pack', join(workspace, manifest), '-o', site]);
  assert.equal(packed.code, 0, packed.errors);
  return site;
}
