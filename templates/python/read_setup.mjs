// Runs the setup.py of a package in Pyodide and prints as JSON what it would install. The package's own code runs here:
// it sees the folder PACKAGE, a copy without links that lead out, and nothing else of this machine, and always the same clock.
// usage: node read_setup.mjs PYODIDE PACKAGE

import { readFileSync, readdirSync, readlinkSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { startPython } from './pyodide.mjs';

const root = '/package';
const tools = '/tools';

/** Copies a folder into Pyodide's files. */
function copy(fs, from, to) {
  fs.mkdirTree(to);
  for (const entry of readdirSync(from, { withFileTypes: true })) {
    const [source, target] = [join(from, entry.name), `${to}/${entry.name}`];
    if (entry.isSymbolicLink()) fs.symlink(readlinkSync(source), target);
    else if (entry.isDirectory()) copy(fs, source, target);
    else fs.writeFile(target, readFileSync(source));
  }
}

const [pyodide, source] = process.argv.slice(2);
const python = await startPython(pyodide);
copy(python.FS, source, root);
copy(python.FS, fileURLToPath(new URL('stand_in', import.meta.url)), tools);
for (const name of ['manifest_in.py', 'read_setup.py']) {
  python.FS.writeFile(`/${name}`, readFileSync(new URL(name, import.meta.url)));
}
const read = python.runPython(`
import sys
sys.path[:0] = ['${tools}', '/']
from read_setup import read
read`);
process.stdout.write(`${read(root)}\n`);
