// The compiled modules of the channel's numpy import only functions that there are: of the interpreter, of the libraries around
// it, or of ours. One that is missing ends a program when it is first called, which may be in a rare case.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { test } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { notOfPyodide } from '../../../runtime/site/python/pyodide_loader.ts';

const MODULES = resolve(import.meta.dirname, '../../../node_modules');
const BLOCK = 512;

/** The files of a tar archive with that ending. */
function* filesIn(archive: Buffer, ending: string): Iterable<{ readonly name: string; readonly bytes: Uint8Array<ArrayBuffer>; }> {
  const text = (at: number, length: number): string => archive.toString('utf8', at, at + length).replace(/\0.*$/s, '');
  for (let at = 0; at + BLOCK <= archive.length && archive[at] !== 0;) {
    const size = Number.parseInt(text(at + 124, 12), 8) || 0;
    const name = text(at, 100);
    if (name.endsWith(ending)) yield { name, bytes: new Uint8Array(archive.subarray(at + BLOCK, at + BLOCK + size)) };
    at += BLOCK + Math.ceil(size / BLOCK) * BLOCK;
  }
}

test('every function that compiled modules of numpy import is there', () => {
  const interpreter = new WebAssembly.Module(readFileSync(join(MODULES, 'pyodide/pyodide.asm.wasm')));
  const known = new Set([...WebAssembly.Module.exports(interpreter), ...WebAssembly.Module.imports(interpreter)].map(({ name }) => name));
  const folder = join(MODULES, '@emscripten-forge/numpy/pkg');
  const archive = readdirSync(folder).find((name) => /^numpy-.*\.tar\.gz$/.test(name)) ?? assert.fail();
  const missing = new Set<string>();
  let modules = 0;
  for (const { bytes } of filesIn(gunzipSync(readFileSync(join(folder, archive))), '.so')) {
    modules += 1;
    const module = new WebAssembly.Module(bytes);
    const own = new Set(WebAssembly.Module.exports(module).map(({ name }) => name));
    for (const { kind, name } of WebAssembly.Module.imports(module)) {
      if (kind === 'function' && !known.has(name) && !own.has(name)) missing.add(name);
    }
  }
  assert.ok(modules > 10, `${modules} modules`);
  assert.deepEqual([...missing].toSorted(), Object.keys(notOfPyodide).toSorted());
});
