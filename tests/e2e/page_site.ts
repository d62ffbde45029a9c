// Builds the page with the fake session into a folder and serves it on localhost with the headers of a
// plain static host. Opens Chromium for tests of the page.

import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const kRoot = fileURLToPath(new URL('../..', import.meta.url));
const kTypes: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
};

export interface Served {
  readonly url: string;
  close(): Promise<void>;
}

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
  await build({ ...shared, entryPoints: { styles: join(ui, 'styles/index.css') }, outdir: folder });
  copyFileSync(join(ui, 'icon.svg'), join(folder, 'icon.svg'));
  // What a real session fetches first is not there.
  const page = readFileSync(join(ui, 'index.html'), 'utf8').replace(
    /<link rel="(module)?preload".*\n/g,
    '',
  );
  writeFileSync(join(folder, 'index.html'), page);
  return folder;
}

export async function serveFolder(folder: string): Promise<Served> {
  const server = createServer((request, response) => {
    const path = normalize(
      decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname),
    );
    const file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
    try {
      const body = readFileSync(file);
      response
        .writeHead(200, { 'content-type': kTypes[extname(file)] ?? 'application/octet-stream' })
        .end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}/`,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
