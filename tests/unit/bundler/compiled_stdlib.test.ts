// The standard library in the channel's package of Pyodide: the same bytes every time, compiled where a start uses it, with
// the sources that people see.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { addPythonFiles } from '../../support/python_nodes.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-stdlib-'));
after(() => rmSync(folder, { recursive: true }));
addPythonFiles(folder, {});
const library = join(folder, 'pyodide/python_stdlib.zip');

/** The result of Python code (JSON) after rclpy was imported as at the start of a node. */
function told(code: string): unknown {
  const program = join(folder, 'look.mjs');
  writeFileSync(program, `
    import { readFileSync } from 'node:fs';
    import { createRequire } from 'node:module';
    const { loadPyodide } = createRequire(import.meta.url)(${JSON.stringify(join(folder, 'pyodide/pyodide.js'))});
    const python = await loadPyodide({ indexURL: ${JSON.stringify(join(folder, 'pyodide/'))}, env: { AMENT_PREFIX_PATH: '/ros' } });
    const kept = [];
    python.registerJsModule('ros2wasm_host', { address: (one) => kept.push(one.getBuffer('u8')) });
    python.unpackArchive(new Uint8Array(readFileSync(${JSON.stringify(join(folder, 'python/rclpy.zip'))})), 'zip', { extractDir: '/ros' });
    python.runPython('import sys; sys.path.insert(0, "/ros/lib/python3.12/site-packages"); import ros2wasm.start; ros2wasm.start.install(); import rclpy.node');
    process.stdout.write(python.runPython(${JSON.stringify(code)}));
  `);
  return JSON.parse(execFileSync(process.execPath, [program], { encoding: 'utf8' }));
}

test('the library has the same bytes every time, and no path of where it was made', () => {
  const again = join(folder, 'again.zip');
  execFileSync(process.execPath, [join(root, 'runtime/packages/vendor/pyodide/make_stdlib.mjs'), join(root, 'node_modules/pyodide'), again], {
    cwd: folder,
    env: { ...process.env, TZ: 'Asia/Tokyo', LC_ALL: 'de_DE.UTF-8', PYTHONHASHSEED: '7' },
  });
  const bytes = readFileSync(library);
  assert.ok(bytes.equals(readFileSync(again)));
  for (const path of [root, folder]) assert.equal(bytes.indexOf(path), -1, path);
});

test('what a start imports is compiled, but for what is spared to be small', () => {
  const code = [
    'import json, sys',
    'of_zip = [m for m in sys.modules.values() if type(getattr(m, "__loader__", None)).__name__ == "zipimporter"]',
    'json.dumps([[m.__name__ for m in of_zip if m.__file__.endswith(".pyc")], sorted(m.__name__ for m in of_zip if m.__file__.endswith(".py"))])',
  ].join('\n');
  const [compiled, others] = told(code) as [string[], string[]];
  assert.ok(compiled.length > 100, String(compiled.length));
  assert.deepEqual(others, ['_pyodide._core_docs']);
});

test('what a start imports of rclpy is compiled, and used as long as its source is the same', () => {
  const code = [
    'import importlib, json, marshal, pathlib, sys',
    'of_file = [m for m in sys.modules.values() if type(getattr(m, "__loader__", None)).__name__ == "SourceFileLoader"]',
    'without = [m.__name__ for m in of_file if not pathlib.Path(m.__cached__).exists()]',
    'qos = sys.modules["rclpy.qos"]',
    'source, made = pathlib.Path(qos.__file__), pathlib.Path(qos.__cached__)',
    // Behind the same hash of the source lies another program.
    'made.write_bytes(made.read_bytes()[:16] + marshal.dumps(compile("of = \'compiled\'", str(source), "exec")))',
    'found = [importlib.reload(qos).of]',
    'source.write_text("of = \'source\'")',
    'found.append(importlib.reload(qos).of)',
    'json.dumps([without, found])',
  ].join('\n');
  assert.deepEqual(told(code), [[], ['compiled', 'source']]);
});

test('tracebacks and inspect show sources of what is compiled', () => {
  const code = [
    'import inspect, json, traceback',
    'try:\n    json.loads("x")\nexcept ValueError:\n    shown = traceback.format_exc()',
    'json.dumps([shown, inspect.getsource(json.dumps).splitlines()[0], inspect.getdoc(json.loads).splitlines()[0]])',
  ].join('\n');
  const [shown, source, documentation] = told(code) as [string, string, string];
  assert.match(shown, /File "\/lib\/python312\.zip\/json\/decoder\.py", line 355, in raw_decode\n {4}raise JSONDecodeError\(/);
  assert.equal(source, 'def dumps(obj, *, skipkeys=False, ensure_ascii=True, check_circular=True,');
  assert.match(documentation, /^Deserialize/);
});

test('a traceback of a program begins with its own file', () => {
  const code = [
    'import json, pathlib, ros2wasm.start as start, sys',
    'pathlib.Path("/home/broken.py").write_text("1 / 0")',
    'sys.path.insert(0, "/home")',
    'try:\n    start.run_entry("broken:main", "")\nexcept ZeroDivisionError as error:\n    part = start.users_part(error.__traceback__.tb_next)',
    'json.dumps(part.tb_frame.f_code.co_filename)',
  ].join('\n');
  assert.equal(told(code), '/home/broken.py');
});

test('the library is nowhere larger than a site has room for', () => {
  assert.ok(readFileSync(library).length < 3_400_000, String(readFileSync(library).length));
});
