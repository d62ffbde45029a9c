// setup.py files that want more than they may have: what they try is refused, each by the message that tells so, and
// nothing of the machine that packs comes out.

import assert from 'node:assert/strict';
import { symlinkSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

const SECRET = 'hush-4711';
let workspace: PackWorkspace;
let server: Server;
let callers = 0;
let port = 0;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.write('id_rsa', SECRET);
  server = createServer((_request, response) => {
    callers += 1;
    response.end(SECRET);
  });
  await new Promise<void>((done) => {
    server.listen(0, '127.0.0.1', done);
  });
  const address = server.address();
  assert.ok(address !== null && typeof address === 'object');
  port = address.port;
});
after(() => {
  server.close();
  workspace.close();
});

function addPackage(name: string, setup: string): void {
  workspace.write(`src/work/${name}/package.xml`, `<package format="3">
  <name>${name}</name>
  <version>1.2.3</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <export><build_type>ament_python</build_type></export>
</package>
`);
  workspace.write(`src/work/${name}/setup.py`, setup);
}

/** Name of a door -> an expression of Python that would open it. */
const DOORS = new Map([
  ['file', () => `open(${JSON.stringify(join(workspace.root, 'id_rsa'))}).read()`],
  ['folder', () => `os.listdir(${JSON.stringify(workspace.root)})[0]`],
  ['variable', () => 'os.environ["TOKEN_OF_TEST"]'],
  ['child', () => 'subprocess.check_output(["env"])'],
  ['js', () => '__import__("js").process.env.TOKEN_OF_TEST'],
  ['pyodide', () => '__import__("pyodide_js")._module'],
  ['inner', () => 'sys.modules["pyodide_js._api"].public_api._module'],
  ['evaluation', () => '__import__("pyodide.code").code.run_js("globalThis.process.env.TOKEN_OF_TEST")'],
  ['constructor', () => 'any_object().constructor.constructor("return process")().env.TOKEN_OF_TEST'],
  ['loader', () => `mounted(${JSON.stringify(workspace.root)})`],
  ['socket', () => `socket.create_connection(("127.0.0.1", ${port}), 5)`],
  ['url', () => `urllib.request.urlopen("http://127.0.0.1:${port}/", timeout=5)`],
  ['page', () => `__import__("pyodide.http").http.open_url("http://127.0.0.1:${port}/")`],
]);

// Guarantee, hostile input: a setup.py reaches no network, environment, process or file outside the
// workspace when it is read
test('a setup.py that tries all doors gets nothing', async () => {
  addPackage('doors', `import gc, os, socket, subprocess, sys, urllib.request

def any_object():
    from pyodide.ffi import to_js
    return to_js([1])

def mounted(folder):
    modules = [one.jsproxy for one in gc.get_objects() if type(one).__name__ == 'JsLoader']
    api = next(one for one in modules if hasattr(one, 'mountNodeFS'))
    api.mountNodeFS('/out', folder)
    return open('/out/id_rsa').read()

said = []
for name, door in {
${[...DOORS].map(([name, door]) => `    ${JSON.stringify(name)}: lambda: ${door()},`).join('\n')}
}.items():
    try:
        said.append(f'{name} got {door()}')
    except Exception as error:
        said.append(f'{name} refused: {type(error).__name__}')
sys.exit('; '.join(said))
`);
  const packed = await workspace.run(['pack', 'src/work', '--plan'], { TOKEN_OF_TEST: SECRET });
  assert.equal(packed.code, 1, packed.stderr);
  for (const name of DOORS.keys()) assert.match(packed.stderr, new RegExp(`\\b${name} refused: \\w+`));
  assert.doesNotMatch(packed.stderr, new RegExp(`${SECRET}| got `));
  assert.equal(callers, 0);
});

test('doors that end Python itself end the pack with a message', async () => {
  addPackage('doors', 'import os\nos.system("env")\n');
  addPackage('native', `import ctypes, sys
run = ctypes.CDLL(None).emscripten_run_script_string
run.restype = ctypes.c_char_p
sys.exit(run(b"process.env.TOKEN_OF_TEST").decode())
`);
  const packed = await workspace.run(['pack', 'src/work', '--plan'], { TOKEN_OF_TEST: SECRET });
  assert.equal(packed.code, 1);
  assert.match(packed.stderr, /error\[R2W0516\]: setup\.py of package `doors` cannot be read[^]*ERR_ACCESS_DENIED/);
  assert.match(packed.stderr, /error\[R2W0516\]: setup\.py of package `native` cannot be read[^]*EvalError/);
  assert.doesNotMatch(packed.stderr, new RegExp(SECRET));
});

test('links lead to files of the workspace, not out of it', async () => {
  const data = "from setuptools import setup\nsetup(name='doors', version='1.0', data_files=[('share/doors', ['notes'])])\n";
  addPackage('doors', data);
  addPackage('native', "from setuptools import setup\nsetup(version=open('more/id_rsa').read())\n");
  symlinkSync(join(workspace.root, 'id_rsa'), join(workspace.root, 'src/work/doors/notes'));
  symlinkSync(workspace.root, join(workspace.root, 'src/work/native/more'));
  const packed = await workspace.run(['pack', 'src/work', '--plan']);
  assert.equal(packed.code, 1);
  assert.match(packed.stderr, /--> src\/work\/doors\/setup\.py:2\n {2}= why: 'notes' is a link that leads out of the workspace/);
  assert.match(packed.stderr, /--> src\/work\/native\/setup\.py:2\n {2}= why: FileNotFoundError/);
  assert.doesNotMatch(packed.stderr, new RegExp(SECRET));
});
