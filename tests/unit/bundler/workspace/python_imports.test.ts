// The modules that an import is held to at pack time are those of the Python that sites run.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { test } from 'node:test';
import { loadPyodide } from 'pyodide';

const source = readFileSync(resolve(import.meta.dirname, '../../../../bundler/workspace/python_imports.cpp'), 'utf8');

function table(name: string): string[] {
  const begin = source.indexOf(name);
  return [...source.slice(begin, source.indexOf('});', begin)).matchAll(/"(\w+)"/g)].map(([, module = '']) => module);
}

test('the table of modules is what Pyodide has of the standard library', async () => {
  const pyodide = await loadPyodide();
  const names = JSON.parse(pyodide.runPython(`
import importlib.util, json, sys

def found(name):
    try:
        return name in sys.modules or importlib.util.find_spec(name) is not None
    except ImportError:
        return False

public = [name for name in sys.stdlib_module_names if not name.startswith('_') or name == '__future__']
json.dumps([sorted(filter(found, public)), sorted(name for name in public if not found(name))])
`) as string) as [string[], string[]];
  // Not of Pyodide, but of every site: runtime/packages/client/rclpy/ros2wasm/terminal.py.
  const ours = ['__main__', 'termios'];
  assert.deepEqual(table('kModules').filter((name) => !ours.includes(name)), names[0]);
  const lacking = table('kLacking');
  assert.deepEqual(lacking.filter((name) => !names[1].includes(name)), []);
});
