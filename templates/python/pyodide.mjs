// Pyodide for code of a workspace: it sees what its caller copies or mounts and nothing else of this machine, has the
// same clock every time, and prints to standard error. Python finds no way into JavaScript by its modules; what code that
// finds another way is kept from stands in bundler/launch/python_sandbox.hpp.

import { constants } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const someDay = Date.UTC(2000, 0, 1);
const someSeed = 2000;
const doors = ['js', 'pyodide_js'];

/** Bytes that look random and are the same every time: of random, uuid, secrets, os.urandom(). */
function seededBytes() {
  let state = someSeed;
  const next = () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return (mixed ^ (mixed >>> 14)) & 0xff;
  };
  return (view) => {
    const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
    for (let i = 0; i < bytes.length; i += 1) bytes[i] = next();
    return view;
  };
}

/** `folder`: Pyodide's files. `environment`: variables beside HOME. */
export async function startPython(folder, environment = {}) {
  process.binding = () => constants; // the one use that Emscripten makes of it, which Node.js does not permit here
  Object.defineProperty(globalThis.crypto, 'getRandomValues', { value: seededBytes() });
  const { default: { loadPyodide } } = await import(pathToFileURL(join(folder, 'pyodide.js')).href);
  const say = (line) => process.stderr.write(`${line}\n`);
  const python = await loadPyodide({
    indexURL: `${folder}/`, jsglobals: {}, env: { HOME: '/home', ...environment, PYTHONHASHSEED: '0' },
    stdout: say, stderr: say,
  });
  Date.now = () => someDay;
  let looks = 0; // a time that is waited for comes: each look at it is a millisecond
  performance.now = () => { looks += 1; return looks; };
  for (const name of doors) python.unregisterJsModule(name);
  python.runPython(`import sys\nfor name in ${JSON.stringify(doors)}:\n    sys.modules.pop(name, None)`);
  return python;
}
