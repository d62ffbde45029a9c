// The compiled libraries that modules of Python wheels need: loaded into a real interpreter, or refused with their names.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadPyodide, type PyodideInterface } from 'pyodide';
import { loadLibraries } from '../../../runtime/site/python/python_libraries.ts';

const text = (words: string): number[] => [words.length, ...new TextEncoder().encode(words)];
const section = (id: number, contents: readonly number[]): number[] => [id, contents.length, ...contents];
const header = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];

/** A library without a function, which may need others. */
function library(...needed: readonly string[]): Uint8Array {
  const names = needed.flatMap(text);
  const needs = needed.length === 0 ? [] : [2, names.length + 1, needed.length, ...names];
  return new Uint8Array([...header, ...section(0, [...text('dylink.0'), 1, 4, 0, 0, 0, 0, ...needs])]);
}

async function interpreter(files: Readonly<Record<string, Uint8Array>>): Promise<PyodideInterface> {
  const python = await loadPyodide();
  const system = python['FS'] as { mkdirTree(path: string): void; writeFile(path: string, bytes: Uint8Array): void; };
  system.mkdirTree('/ros/lib');
  for (const [name, bytes] of Object.entries(files)) system.writeFile(`/ros/lib/${name}`, bytes);
  return python;
}

test('each is known by its name to those that need it', async () => {
  const python = await interpreter({ 'libteeth.so': library(), 'libgear.so': library('libteeth.so') });
  await loadLibraries(python, ['lib/libteeth.so', 'lib/libgear.so'], '/ros');
});

test('one that is cut, or needs what is not there, is told with its name', async () => {
  const python = await interpreter({ 'libcut.so': library('libteeth.so').subarray(0, 14), 'libgear.so': library('libteeth.so') });
  for (const name of ['libcut.so', 'libgear.so']) {
    await assert.rejects(loadLibraries(python, [`lib/${name}`], '/ros'), (error: { readonly code: string; readonly message: string; }) => {
      assert.equal(error.code, 'R2W0728');
      assert.ok(error.message.startsWith(`the library lib/${name} cannot be loaded: `), error.message);
      return true;
    });
  }
});
