// Pyodide for code of a workspace: it sees what its caller copies or mounts and nothing else of this machine, has the
// same clock every time, and prints to standard error. Python finds no way into JavaScript by its modules; what code that
// finds another way is kept from stands in bundler/io/python_sandbox.hpp.

import { constants, existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const someDay = Date.UTC(2000, 0, 1);
const someSeed = 2000;
const doors = ['js', 'pyodide_js'];
/** The path that Python sees as its program, in place of a path of this machine. */
const program = '/usr/bin/python3';
/** The memory of a started interpreter, from the Pyodide package of ros2wasm: with it, Python need not start again. */
const image = 'started.image';

/** Bytes that look random and are the same every time: of random, uuid, secrets, os.urandom(). */
function seededBytes() {
  let state;
  const next = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return (mixed ^ (mixed >>> 14)) & 0xff;
  };
  const restart = () => {
    state = someSeed;
  };
  restart();
  const fill = (view) => {
    const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
    for (let i = 0; i < bytes.length; i += 1) bytes[i] = next();
    return view;
  };
  return { fill, restart };
}

/** `folder`: Pyodide's files. `environment`: variables beside HOME. */
export async function startPython(folder, environment = {}) {
  process.binding = () => constants; // the one use that Emscripten makes of it, which Node.js does not permit here
  process.argv = [process.argv[0], program];
  process.env['TZ'] = 'UTC';
  const random = seededBytes();
  Object.defineProperty(globalThis.crypto, 'getRandomValues', { value: random.fill });
  const { default: { loadPyodide } } = await import(pathToFileURL(join(folder, 'pyodide.js')).href);
  const say = (line) => process.stderr.write(`${line}\n`);
  const started = existsSync(join(folder, image)) ? { _loadSnapshot: readFileSync(join(folder, image)) } : {};
  const env = { HOME: '/home', LANG: 'C.UTF-8', ...environment, PYTHONHASHSEED: '0' };
  const python = await loadPyodide({ indexURL: `${folder}/`, jsglobals: {}, env, stdout: say, stderr: say, ...started });
  // Replace the random state and the variables that an image has from the machine that made it.
  random.restart();
  python.runPython(`import os, random\nos.environ.update(${JSON.stringify(env)})\nrandom.seed()\ndel os, random`);
  Date.now = () => someDay;
  let looks = 0; // a time that is waited for comes: each look at it is a millisecond
  performance.now = () => {
    looks += 1;
    return looks;
  };
  for (const name of doors) python.unregisterJsModule(name);
  // Their submodules too, such as pyodide_js._api.
  python.runPython(`import sys
for name in [name for name in sys.modules if name.split('.')[0] in ${JSON.stringify(doors)}]:
    del sys.modules[name]`);
  return python;
}
