// Builds the page with the fake session into a folder.

import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const kRoot = fileURLToPath(new URL('../..', import.meta.url));
/** The built page: everything as in a site, but the session. Returns the folder. */
export async function buildFakePage(folder: string): Promise<string> {
  const ui = join(kRoot, 'runtime/ui');
  mkdirSync(folder, { recursive: true });
  const shared = { bundle: true, minify: true, target: 'es2022', logLevel: 'warning' } as const;
  await build({
    ...shared,
    entryPoints: { start: join(kRoot, 'tests/e2e/page_fake.tsx') },
    outdir: folder,
    format: 'esm',
    splitting: true,
    jsx: 'automatic',
    jsxImportSource: 'preact',
  });
  await build({
    ...shared,
    entryPoints: { boot: join(ui, 'boot.ts') },
    outdir: folder,
    format: 'iife',
  });
  await build({ ...shared, entryPoints: { styles: join(ui, 'styles/index.css'), panels: join(ui, 'styles/panels.css') }, outdir: folder });
  for (const file of ['icon.svg', 'app.webmanifest']) copyFileSync(join(ui, file), join(folder, file));
  // What a real session fetches first is not there.
  const page = readFileSync(join(ui, 'index.html'), 'utf8').replace(
    /<link rel="(module)?preload".*\n/g,
    '',
  );
  writeFileSync(join(folder, 'index.html'), page);
  // A link to a view names the site by the sha256 of this file.
  writeFileSync(join(folder, 'site.json'), '{}\n');
  return folder;
}
