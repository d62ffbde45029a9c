// Pyodide for code of a workspace: it sees what its caller copies or mounts and nothing else of this machine, has the
// same clock every time, and prints to standard error. Python finds no way into JavaScript by its modules; what code that
// finds another way is kept from stands in bundler/launch/python_sandbox.hpp.

import { constants } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const someDay = Date.UTC(2000, 0, 1);
const doors = ['js', 'pyodide_js'];

/** `folder`: Pyodide's files. `environment`: variables beside HOME. */
export async function startPython(folder, environment = {}) {
  process.binding = () => constants; // the one use that Emscripten makes of it, which Node.js does not permit here
  const { default: { loadPyodide } } = await import(pathToFileURL(join(folder, 'pyodide.js')).href);
  const say = (line) => process.stderr.write(`${line}\n`);
  const python = await loadPyodide({
    indexURL: `${folder}/`, jsglobals: {}, env: { HOME: '/home', ...environment, PYTHONHASHSEED: '0' },
    stdout: say, stderr: say,
  });
  Date.now = () => someDay;
  for (const name of doors) python.unregisterJsModule(name);
  python.runPython(`import sys\nfor name in ${JSON.stringify(doors)}:\n    sys.modules.pop(name, None)`);
  return python;
}
