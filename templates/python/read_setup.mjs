// Runs the setup.py of a package in Pyodide and prints as JSON what it would install. The package's own code runs here:
// it sees a copy of the package's folder and nothing else of this machine, and always the same clock.
// usage: node read_setup.mjs PYODIDE PACKAGE

import { constants, readFileSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const biggestCopied = 4_000_000; // bytes; what is bigger is data, of which the name is enough
const someDay = Date.UTC(2000, 0, 1);
const root = '/package';
const tools = '/tools';

/** Copies a folder into Pyodide's files, as the hash of a package sees it: nothing hidden, nothing compiled. */
function copy(fs, from, to) {
  fs.mkdirTree(to);
  for (const name of readdirSync(from).sort()) {
    if (name.startsWith('.') || name === '__pycache__' || name.endsWith('.pyc')) continue;
    const facts = statSync(join(from, name), { throwIfNoEntry: false });
    if (facts?.isDirectory()) copy(fs, join(from, name), `${to}/${name}`);
    else if (facts?.isFile()) {
      fs.writeFile(`${to}/${name}`, facts.size > biggestCopied ? '' : readFileSync(join(from, name)));
    }
  }
}

process.binding = () => constants; // the one use that Emscripten makes of it, which Node.js does not permit here
const [pyodide, source] = process.argv.slice(2);
const { default: { loadPyodide } } = await import(pathToFileURL(join(pyodide, 'pyodide.js')).href);
const say = (line) => process.stderr.write(`${line}\n`);
const python = await loadPyodide({
  indexURL: `${pyodide}/`, jsglobals: {}, env: { HOME: '/home', PYTHONHASHSEED: '0' }, stdout: say, stderr: say,
});
Date.now = () => someDay;
copy(python.FS, source, root);
copy(python.FS, fileURLToPath(new URL('stand_in', import.meta.url)), tools);
python.FS.writeFile('/read_setup.py', readFileSync(new URL('read_setup.py', import.meta.url)));
const read = python.runPython(`
import sys
sys.path[:0] = ['${tools}', '/']
from read_setup import read
read`);
process.stdout.write(`${read(root)}\n`);
