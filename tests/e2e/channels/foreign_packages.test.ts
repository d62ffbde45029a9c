// Packages that others have made for emscripten-wasm32: what fits is used, what does not is refused by name before anything is
// built. The packages are made here, by the compilers of this machine, in the shapes that public channels have.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { dirname, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { type Finished, PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 240_000 };
const LIBRARIES = resolve(import.meta.dirname, '../../support/make_python_libraries.py');

let ws: PackWorkspace;

function run(program: string, ...words: readonly string[]): void {
  execFileSync(program, words, { cwd: ws.root, stdio: ['ignore', 'ignore', 'inherit'], env: { NODE_PATH: '/usr/share/nodejs', ...process.env } });
}

/** Compiles a library into a package of the channel `forge`. */
async function addLibrary(name: string, text: string, compiler: readonly string[], depends: readonly string[] = []): Promise<void> {
  const cpp = name === 'thrower';
  ws.write(`made/${name}.${cpp ? 'cpp' : 'c'}`, text);
  const [program = '', ...flags] = compiler;
  run(program, ...flags, '-c', `made/${name}.${cpp ? 'cpp' : 'c'}`, '-o', `made/${name}.o`);
  ws.write(`${name}/include/${name}.h`, `#ifdef __cplusplus\nextern "C"\n#endif\nint ${name}_of(int);\n`);
  run(program === 'gcc' ? 'ar' : 'emar', 'rcs', `${name}/lib${name}.a`, `made/${name}.o`);
  ws.write(`${name}/lib/lib${name}.a`, ws.read(`${name}/lib${name}.a`));
  run('rm', `${name}/lib${name}.a`);
  await addPackage(name, name, depends);
}

async function addPackage(name: string, folder: string, depends: readonly string[] = [], subdir = 'emscripten-wasm32'): Promise<void> {
  ws.write(`made/${name}.json`, JSON.stringify({ name, version: '2.0', build: 'h1_0', subdir, depends, license: 'MIT' }));
  const { code, stderr } = await ws.run(['channel', 'add', 'forge', '--prefix', folder, '--metadata', `made/${name}.json`]);
  assert.equal(code, 0, stderr);
}

/** Packs a workspace with one program, which needs `packages` of the channel. */
async function pack(packages: readonly string[], site = 'site', starts = 'user'): Promise<Finished> {
  const { code, stderr } = await ws.run(['channel', 'index', 'forge']);
  assert.equal(code, 0, stderr);
  ws.write('workspace.yaml', `schema: 1
name: lab
packages: [src/*]
channels: [./forge, embedded]
dependencies: [${packages.join(', ')}]
launch:
  - {package: ${starts}, executable: ${starts}}
`);
  return ws.run(['pack', 'workspace.yaml', '-o', site]);
}

before(() => {
  ws = new PackWorkspace();
  ws.addPackage('user', { user: '#include <cstdio>\nint main() { std::puts("nothing is used"); }\n' });
});
after(() => ws.close());

test('a static library that fits is linked', watchdog, async () => {
  await addLibrary('doubler', 'int doubler_of(int x) { return 2 * x; }\n', ['emcc', '-O2']);
  ws.addPackage('twice', { twice: '#include <cstdio>\n#include <doubler.h>\nint main() { std::printf("twice 21 is %d\\n", doubler_of(21)); }\n' }, {
    cmake:
      'find_library(DOUBLER doubler REQUIRED)\nfind_path(DOUBLER_HEADERS doubler.h REQUIRED)\ntarget_link_libraries(twice ${DOUBLER})\ntarget_include_directories(twice PRIVATE ${DOUBLER_HEADERS})',
  });
  const { code, stderr } = await pack(['doubler'], 'fits', 'twice');
  assert.equal(code, 0, stderr);
  const ran = await ws.run(['run', 'fits', '--for', '20s', '--until', 'twice 21 is']);
  assert.match(ran.stdout + ran.stderr, /twice 21 is 42/);
});

test('threads, exceptions and other machines are refused, with package, file and reason', watchdog, async () => {
  await addLibrary('counter', 'static _Thread_local int n;\nint counter_of(int x) { n += x; return n; }\n', ['emcc', '-O2']);
  await addLibrary('thrower', 'extern "C" int inner(int);\nextern "C" int thrower_of(int x) { try { return inner(x); } catch (...) { return 0; } }\n', ['em++',
    '-O2', '-fexceptions']);
  await addLibrary('native', 'int native_of(int x) { return x; }\n', ['gcc', '-O2']);
  const { code, stderr } = await pack(['counter', 'thrower', 'native']);
  assert.equal(code, 1);
  assert.match(stderr,
    /error\[R2W0534\]: `counter-2\.0-h1_0` of the channel `\.\/forge` cannot be a part of this site\n.*`lib\/libcounter\.a`: it was compiled without threads/);
  assert.match(stderr, /error\[R2W0534\]: `thrower-2\.0-h1_0`[^\n]*\n.*`lib\/libthrower\.a`: it throws exceptions through JavaScript \(-fexceptions\)/);
  assert.match(stderr, /error\[R2W0534\]: `native-2\.0-h1_0`[^\n]*\n.*`lib\/libnative\.a`: it is not compiled for WebAssembly/);
  assert.doesNotMatch(stderr, /built|R2W0504/);
});

test('a compiler of another version is refused by the record', watchdog, async () => {
  await addLibrary('newer', 'int newer_of(int x) { return x; }\n', ['emcc', '-O2'], ['emscripten-abi >=3.1.73,<3.1.74.0a0']);
  const { code, stderr } = await pack(['newer']);
  assert.equal(code, 1);
  assert.match(stderr, /R2W0301[\s\S]*newer[\s\S]*emscripten-abi >=3\.1\.73/);
});

test('modules for another Python are refused, in its folder or by their name', watchdog, async () => {
  ws.write('later/lib/python3.13/site-packages/later/__init__.py', 'x = 1\n');
  await addPackage('later', 'later');
  ws.write('earlier/lib/python3.12/site-packages/earlier.cpython-311-wasm32-emscripten.so', '\0asm');
  await addPackage('earlier', 'earlier');
  await addPackage('by_record', 'made', ['python_abi 3.13.* *_cp313']);
  const { code, stderr } = await pack(['later', 'earlier']);
  assert.equal(code, 1);
  assert.match(stderr,
    /`later-2\.0-h1_0`[^\n]*\n.*`lib\/python3\.13\/site-packages\/later\/__init__\.py`: it is for Python 3\.13, and a site has Python 3\.12/);
  assert.match(stderr, /`earlier-2\.0-h1_0`[^\n]*\n.*it is for Python 3\.11, and a site has Python 3\.12/);
  const record = await pack(['by_record']);
  assert.equal(record.code, 1);
  assert.match(record.stderr, /python_abi/);
});

test('a compiled module for the Python of sites is loaded; a damaged one, and one that needs a library, are refused', watchdog, async () => {
  // The module in C of that script, which needs no other library, and the wheel of another one, which does.
  run('python3', '-c', `import sys
from pathlib import Path
sys.path.insert(0, '${dirname(LIBRARIES)}')
from make_python_libraries import API, side_module
folder = Path('springs/lib/python3.12/site-packages')
folder.mkdir(parents=True)
text = API + """static PyObject* stiffness(PyObject* self, PyObject* number) { return PyLong_FromLong(40 * PyLong_AsLong(number)); }
ONE_FUNCTION(springs, stiffness, 1013)
"""
side_module(Path('made'), 'springs.so', text, '_PyInit_springs').rename(folder / 'springs.cpython-312-wasm32-emscripten.so')`);
  await addPackage('springs', 'springs');
  ws.addPythonPackage('scales', {
    scales: `import springs

def main():
    print(f'stiffness {springs.stiffness(2)}', flush=True)
`,
  }, ['rclpy']);
  const { code, stderr } = await pack(['springs', 'doubler'], 'modules', 'scales');
  assert.equal(code, 0, stderr);
  const ran = await ws.run(['run', 'modules', '--for', '30s', '--until', 'stiffness']);
  assert.match(ran.stdout + ran.stderr, /stiffness 80/);
  run('python3', LIBRARIES, 'libraries');
  run('python3', '-c', `import glob, zipfile
[wheel] = glob.glob('libraries/springs-*.whl')
zipfile.ZipFile(wheel).extractall('coiled/lib/python3.12/site-packages')`);
  await addPackage('coiled', 'coiled');
  ws.write('broken/lib/python3.12/site-packages/broken.cpython-312-wasm32-emscripten.so', '\0asm\x01\0\0\0');
  await addPackage('broken', 'broken');
  const refused = await pack(['broken', 'coiled', 'doubler']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /`broken-2\.0-h1_0`[^\n]*\n.*broken\.cpython-312-wasm32-emscripten\.so`: it does not begin with the section `dylink\.0`/);
  assert.match(refused.stderr, /`coiled-2\.0-h1_0`[^\n]*\n.*`: it needs `lib\w+\.so`, and libraries of modules are loaded for wheels only/);
});
