// Compiles the modules of Python packages that every start imports, as Python itself does when it may write: __pycache__ beside
// the sources. Python looks whether the source is still the same. The same bytes every time.
// usage: node compile_modules.mjs PYODIDE PLACE OUT PACKAGE...   PLACE: where the packages are when they run

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { compiler } from './compiler.mjs';

const [pyodide, place, out, ...packages] = process.argv.slice(2);
const python = await compiler(pyodide);
for (const folder of packages) {
  for (const name of readdirSync(folder, { recursive: true }).filter((one) => one.endsWith('.py')).sort()) {
    const path = join(basename(folder), name);
    python.FS.writeFile('/source.py', readFileSync(join(folder, name)));
    python.runPython(`
with open('/source.py', 'rb') as source, open('/made.pyc', 'wb') as made:
    made.write(compiled(${JSON.stringify(join(place, path))}, source.read(), check_source=True))
`);
    const cache = join(out, dirname(path), '__pycache__');
    mkdirSync(cache, { recursive: true });
    writeFileSync(join(cache, `${basename(name, '.py')}.cpython-312.pyc`), python.FS.readFile('/made.pyc'));
  }
}
