// Runs the setup.py of a package in Pyodide and prints as JSON what it would install. The package's own code runs here:
// it sees the folder FOLDER, a copy without links that lead out, the MODULES of what the package depends on, for reading, and
// nothing else of this machine, and always the same clock.
// usage: node read_setup.mjs PYODIDE FOLDER PACKAGE [MODULES...]

import { readFileSync, readdirSync, readlinkSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { mountedFiles } from './mounted_files.mjs';
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

const [pyodide, source, name, ...modules] = process.argv.slice(2);
const python = await startPython(pyodide);
copy(python.FS, source, root);
copy(python.FS, fileURLToPath(new URL('stand_in', import.meta.url)), tools);
for (const file of ['manifest_in.py', 'read_setup.py']) {
  python.FS.writeFile(`/${file}`, readFileSync(new URL(file, import.meta.url)));
}
const files = mountedFiles(python.FS, new Map());
const places = modules.map((from, index) => {
  const at = `/modules/${index}`;
  python.FS.mkdirTree(at);
  python.FS.mount(files, { from, at }, at);
  return at;
});
const read = python.runPython(`
import sys
sys.path[:0] = ['${tools}', '/']
sys.path += ${JSON.stringify(places)}
sys.dont_write_bytecode = True
from read_setup import read
read`);
process.stdout.write(`${read(root, name)}\n`);
