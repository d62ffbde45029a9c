// Packs packages of tests/bench/packages with a launch list into a site.
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { BenchContext } from './run.ts';

/** `launch`: entries of the manifest, as flow mappings. Returns the site's folder, below `folder`/`name`. */
export function packLaunch(
  context: BenchContext,
  folder: string,
  programs: readonly string[],
  name: string,
  launch: readonly string[],
): string {
  const workspace = join(folder, name);
  mkdirSync(workspace);
  for (const one of programs) cpSync(join(context.root, 'tests/bench/packages', one), join(workspace, one), { recursive: true });
  const manifest = ['schema: 1', `name: ${name}`, `packages: [${programs.join(', ')}]`, 'launch:', ...launch.map((node) => `  - ${node}`), ''];
  writeFileSync(join(workspace, 'workspace.yaml'), manifest.join('\n'));
  const site = join(workspace, 'site');
  const run = spawnSync(join(context.build, 'ros2wasm'), ['pack', join(workspace, 'workspace.yaml'), '-o', site], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(`pack failed: ${run.stderr}`);
  return site;
}
