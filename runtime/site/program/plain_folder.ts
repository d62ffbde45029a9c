// For Node.js: a site whose files lie in a store or in parts, as a folder in which each lies at its path. Pyodide's scripts
// find each other by their names only.

import { copyFileSync, linkSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import type { SiteFile } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';

function put(from: readonly string[], to: string): void {
  mkdirSync(dirname(to), { recursive: true });
  const [only] = from;
  if (only === undefined || from.length > 1) {
    writeFileSync(to, Buffer.concat(from.map((part) => readFileSync(part))));
    return;
  }
  try {
    linkSync(only, to);
  } catch {
    // Hard links do not work across file systems.
    copyFileSync(only, to);
  }
}

/** undefined: the site is one already. Throws SiteError R2W0706. */
export function plainFolder(folder: string, files: readonly SiteFile[]): { readonly place: string; close(): void; } | undefined {
  if (files.every(({ at }) => at === undefined)) return undefined;
  const place = mkdtempSync(join(tmpdir(), 'ros2wasm-run-'));
  const close = (): void => rmSync(place, { recursive: true, force: true });
  for (const { path, at } of files) {
    try {
      put((at ?? [path]).map((each) => join(folder, each)), join(place, path));
    } catch (error) {
      close();
      throw new SiteError('R2W0706', `the site's file ${path} cannot be read: ${error instanceof Error ? error.message : ''}`, {
        why: 'the site, or the store that it shares with others, is not complete',
        fix: 'put all folders that `ros2wasm pack` wrote in place, as they lay beside each other',
      });
    }
  }
  return { place, close };
}
