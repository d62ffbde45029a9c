// Python that compiles modules to the same bytes every time.

import { createRequire } from 'node:module';
import { join } from 'node:path';

/** `folder`: of Pyodide. The function compiled() is among its globals. */
export async function compiler(folder) {
  const { loadPyodide } = createRequire(import.meta.url)(join(folder, 'pyodide.js'));
  // Else a path, the time zone and the language of this machine are seen.
  process.argv = [process.argv[0], '/usr/bin/python3'];
  process.env['TZ'] = 'UTC';
  const env = { HOME: '/home', LANG: 'C.UTF-8', PYTHONHASHSEED: '0' };
  const python = await loadPyodide({ indexURL: `${folder}/`, jsglobals: {}, env });
  python.runPython(`
import importlib.util, marshal
from importlib._bootstrap_external import _code_to_hash_pyc

def compiled(path, source, check_source):
    code = compile(source, path, 'exec', dont_inherit=True, optimize=0)
    # marshal's output depends on other references to the same constants; loaded code has none.
    code = marshal.loads(marshal.dumps(code))
    # By the hash of the source, not by times (PEP 552).
    return _code_to_hash_pyc(code, importlib.util.source_hash(source), check_source)
`);
  return python;
}
