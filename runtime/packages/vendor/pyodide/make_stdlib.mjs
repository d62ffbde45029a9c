// Writes Pyodide's standard library with the modules that nodes import at their start compiled beside their sources, which
// tracebacks and inspect show: to compile them would take as long as all the rest of a cold start. Pyodide compiles them
// itself. The same bytes every time. Each module more is a load for visitors: a site with Python has 7 MB at most.
// usage: node make_stdlib.mjs PYODIDE ZIP

import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { compiler } from './compiler.mjs';

/** With all that these import. tests/unit/bundler/compiled_stdlib.test.ts proves that nothing is missing. */
const modules = [
  '__future__',
  '_threading_local',
  'asyncio',
  'contextlib',
  'copy',
  'dataclasses',
  'encodings.cp437',
  'enum',
  'functools',
  'hashlib',
  'importlib.util',
  'inspect',
  'json',
  'locale',
  'logging',
  'pathlib',
  'queue',
  'random',
  're',
  'runpy',
  'signal',
  'struct',
  'threading',
  'traceback',
  'typing',
  'warnings',
  'weakref',
  'zipfile',
];
/** A large one among them that is compiled quickly, as it is documentation. */
const spared = '_pyodide/_core_docs';

const [folder, zip] = process.argv.slice(2);
const python = await compiler(folder);
python.FS.writeFile('/given.zip', readFileSync(join(folder, 'python_stdlib.zip')));
python.runPython(`
import importlib, sys, zipfile

for name in ${JSON.stringify(modules)}:
    importlib.import_module(name)
# Where Pyodide puts the archive.
place = next(one for one in sys.path if one.endswith('.zip')) + '/'
of_zip = [one for one in sys.modules.values() if type(getattr(one, '__loader__', None)).__name__ == 'zipimporter']
used = {one.__file__.removeprefix(place) for one in of_zip} - {'${spared}.py'}

with zipfile.ZipFile('/given.zip') as given, zipfile.ZipFile('/made.zip', 'w') as made:
    def add(path, data):
        entry = zipfile.ZipInfo(path)
        entry.external_attr = 0o644 << 16
        made.writestr(entry, data, zipfile.ZIP_DEFLATED, 9)

    for path in sorted(given.namelist()):
        data = given.read(path)
        add(path, data)
        if path in used:
            add(path + 'c', compiled(place + path, data, check_source=False))
`);
writeFileSync(zip, python.FS.readFile('/made.zip'));
// By libdeflate, which finds 3 % more than zlib.
execFileSync('advzip', ['-z', '-2', '-q', zip]);
