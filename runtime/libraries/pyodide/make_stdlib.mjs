// Writes Pyodide's standard library with the modules that nodes import at their start compiled beside their sources, which
// tracebacks and inspect show: to compile them would take as long as all the rest of a cold start. Pyodide compiles them
// itself. The same bytes every time. Each module more is a load for visitors: a site with Python has 7 MB at most.
// usage: node make_stdlib.mjs PYODIDE ZIP

import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

/** With all that these import. tests/unit/bundler/compiled_stdlib.test.ts proves that nothing is missing. */
const modules = [
  '__future__', '_threading_local', 'asyncio', 'contextlib', 'copy', 'dataclasses', 'encodings.cp437', 'enum', 'functools', 'hashlib', 'importlib.util', 'inspect', 'json',
  'locale', 'logging', 'pathlib', 'queue', 'random', 're', 'runpy', 'signal', 'struct', 'threading', 'traceback', 'typing', 'warnings',
  'weakref', 'zipfile',
];
/** Large ones among them that are compiled quickly, as they are documentation for the most part. */
const spared = [
  '_pyodide/_base', '_pyodide/_core_docs', 'asyncio/tasks', 'asyncio/transports', 'pyodide/webloop', 'shutil', 'socket', 'subprocess',
  'tempfile', 'textwrap', 'tokenize', 'traceback', 'zipfile/_path/__init__',
];

const [folder, zip] = process.argv.slice(2);
const { loadPyodide } = createRequire(import.meta.url)(join(folder, 'pyodide.js'));
// Else a path, the time zone and the language of this machine are seen.
process.argv = [process.argv[0], '/usr/bin/python3'];
process.env['TZ'] = 'UTC';
const env = { HOME: '/home', LANG: 'C.UTF-8', PYTHONHASHSEED: '0' };
const python = await loadPyodide({ indexURL: `${folder}/`, jsglobals: {}, env });
python.FS.writeFile('/given.zip', readFileSync(join(folder, 'python_stdlib.zip')));
python.runPython(`
import importlib, marshal, sys, zipfile
from importlib._bootstrap_external import _code_to_hash_pyc

for name in ${JSON.stringify(modules)}:
    importlib.import_module(name)
# Where Pyodide puts the archive.
place = next(one for one in sys.path if one.endswith('.zip')) + '/'
of_zip = [one for one in sys.modules.values() if type(getattr(one, '__loader__', None)).__name__ == 'zipimporter']
used = {one.__file__.removeprefix(place) for one in of_zip} - {f'{name}.py' for name in ${JSON.stringify(spared)}}

def compiled(path, source):
    code = compile(source, place + path, 'exec', dont_inherit=True, optimize=0)
    # What is written depends on who else holds the same constants: nobody does of what was read.
    code = marshal.loads(marshal.dumps(code))
    # Without a look at the source when it is read (PEP 552).
    return _code_to_hash_pyc(code, importlib.util.source_hash(source), False)

with zipfile.ZipFile('/given.zip') as given, zipfile.ZipFile('/made.zip', 'w') as made:
    def add(path, data):
        entry = zipfile.ZipInfo(path)
        entry.external_attr = 0o644 << 16
        made.writestr(entry, data, zipfile.ZIP_DEFLATED, 9)

    for path in sorted(given.namelist()):
        data = given.read(path)
        add(path, data)
        if path in used:
            add(path + 'c', compiled(path, data))
`);
writeFileSync(zip, python.FS.readFile('/made.zip'));
