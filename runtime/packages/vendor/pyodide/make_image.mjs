// Writes the memory of a started interpreter that has imported what the readers of launch files and of setup.py need of the
// standard library: templates/python/pyodide.mjs begins with it. The same bytes every time.
// usage: node make_image.mjs PYODIDE STDLIB IMAGE, where STDLIB is the library that starts with the image have (make_stdlib.mjs)

import { writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const modules = [
  'argparse',
  'ast',
  'collections',
  'configparser',
  'contextlib',
  'dataclasses',
  'enum',
  'fnmatch',
  'functools',
  'glob',
  'importlib.util',
  'json',
  'os',
  'pathlib',
  'posixpath',
  're',
  'runpy',
  'sys',
  'traceback',
  'types',
  'typing',
];
const someDay = Date.UTC(2000, 0, 1);

const [folder, library, image] = process.argv.slice(2);
const { loadPyodide } = createRequire(import.meta.url)(join(folder, 'pyodide.js'));
// Else a path, the time zone and the language of this machine are in the image.
process.argv = [process.argv[0], '/usr/bin/python3'];
process.env['TZ'] = 'UTC';
const env = { HOME: '/home', LANG: 'C.UTF-8', PYTHONHASHSEED: '0' };
let looks = 0;
Date.now = () => someDay;
performance.now = () => {
  looks += 1;
  return looks;
};
Object.defineProperty(globalThis.crypto, 'getRandomValues', {
  value: (view) => {
    new Uint8Array(view.buffer, view.byteOffset, view.byteLength).fill(1);
    return view;
  },
});
const python = await loadPyodide({
  indexURL: `${folder}/`,
  stdLibURL: library,
  jsglobals: {},
  env,
  _makeSnapshot: true,
});
// Each start puts the present folder on the path.
python.runPython(`import gc, ${modules.join(', ')}\nsys.path.remove('')\ngc.collect()`);
writeFileSync(image, python.makeMemorySnapshot());
