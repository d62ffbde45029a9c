// Builds the page with the fake session into a folder.

import { copyFileSync, cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
/** The cache of a run of all tests, empty at first: the page is built there once for all of them. */
const SHARED_CACHE = process.env['ROS2WASM_TEST_CACHE'];

/** The built page: everything as in a site, but the session. Returns the folder. */
export async function buildFakePage(folder: string): Promise<string> {
  if (SHARED_CACHE === undefined) return build(folder);
  const shared = join(SHARED_CACHE, 'fake-page');
  if (!existsSync(shared)) {
    mkdirSync(SHARED_CACHE, { recursive: true });
    const made = await build(mkdtempSync(join(SHARED_CACHE, 'fake-page.')));
    // Another file of tests may have been first: its page is the same.
    try {
      renameSync(made, shared);
    } catch (error) {
      if (!existsSync(shared)) throw error;
      rmSync(made, { recursive: true });
    }
  }
  cpSync(shared, folder, { recursive: true });
  return folder;
}

async function build(folder: string): Promise<string> {
  const ui = join(ROOT, 'runtime/site/ui');
  mkdirSync(folder, { recursive: true });
  const shared = { bundle: true, minify: true, target: 'es2022', logLevel: 'warning' } as const;
  await esbuild.build({
    ...shared,
    entryPoints: { start: join(ROOT, 'tests/e2e/support/page_fake.tsx') },
    outdir: folder,
    format: 'esm',
    splitting: true,
    jsx: 'automatic',
    jsxImportSource: 'preact',
  });
  await esbuild.build({
    ...shared,
    entryPoints: { boot: join(ui, 'boot.ts') },
    outdir: folder,
    format: 'iife',
  });
  await esbuild.build({ ...shared, entryPoints: { styles: join(ui, 'styles/index.css'), panels: join(ui, 'styles/panels.css') }, outdir: folder });
  for (const file of ['icon.svg', 'app.webmanifest']) copyFileSync(join(ui, file), join(folder, file));
  // The files that a real session preloads are not there.
  const page = readFileSync(join(ui, 'index.html'), 'utf8').replace(
    /<link rel="(module)?preload".*\n/g,
    '',
  );
  writeFileSync(join(folder, 'index.html'), page);
  // A link to a view names the site by the sha256 of this file.
  writeFileSync(join(folder, 'site.json'), '{}\n');
  return folder;
}
