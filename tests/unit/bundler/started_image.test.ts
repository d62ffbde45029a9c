// The image of a started interpreter in the channel's package of Pyodide: whoever begins with it sees what one sees who
// starts Pyodide.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { linkSync, copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('../../..', import.meta.url));
const source = join(root, 'node_modules/pyodide');
const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-image-'));
const [plain, begun] = ['plain', 'begun'].map((name) => join(folder, name)) as [string, string];
const image = join(begun, 'started.image');

function makeImage(to: string, environment: NodeJS.ProcessEnv = {}): string {
  const make = join(root, 'runtime/packages/vendor/pyodide/make_image.mjs');
  execFileSync(process.execPath, [make, source, join(source, 'python_stdlib.zip'), to], { env: { ...process.env, ...environment }, cwd: folder });
  return createHash('sha256').update(readFileSync(to)).digest('hex');
}

/** The result of code, as text, in a Python that starts from that folder. */
function printed(pyodide: string, code: string, environment: NodeJS.ProcessEnv = {}): string {
  const program = join(folder, 'look.mjs');
  writeFileSync(program, `
    import { startPython } from ${JSON.stringify(pathToFileURL(join(root, 'templates/python/pyodide.mjs')).href)};
    const python = await startPython(${JSON.stringify(pyodide)}, { ROBOT: 'a "b" \\\\ c' });
    process.stdout.write(String(python.runPython(${JSON.stringify(code)})));
  `);
  return execFileSync(process.execPath, [program], { encoding: 'utf8', env: { ...process.env, ...environment } });
}

before(() => {
  for (const to of [plain, begun]) {
    mkdirSync(to);
    for (const name of ['pyodide.js', 'pyodide.asm.js', 'pyodide.asm.wasm', 'pyodide-lock.json', 'python_stdlib.zip']) {
      try {
        linkSync(join(source, name), join(to, name));
      } catch {
        copyFileSync(join(source, name), join(to, name));
      }
    }
  }
});
after(() => rmSync(folder, { recursive: true }));

test('an image has the same bytes every time, and no path of where it was made', () => {
  assert.equal(makeImage(image), makeImage(join(folder, 'again'), { TZ: 'Asia/Tokyo', LC_ALL: 'de_DE.UTF-8', ROBOT: 'x' }));
  const bytes = readFileSync(image);
  for (const path of [root, folder]) assert.equal(bytes.indexOf(path), -1, path);
});

test('with an image Python has the same environment, clocks, random numbers, hashes and modules', () => {
  const code = [
    'import json, os, random, sys, time, uuid, secrets',
    'json.dumps([dict(sorted(os.environ.items())), random.random(), os.urandom(8).hex(), str(uuid.uuid4()), secrets.token_hex(4),',
    '            time.time(), time.monotonic(), time.tzname, time.localtime().tm_hour, hash("robot"), [n for n in ("js", "pyodide_js") if n in sys.modules],',
    '            sorted(os.listdir("/")), sys.path, sys.argv, sys.executable, sys.flags.hash_randomization, os.getcwd()], indent=1)',
  ].join('\n');
  const found = printed(begun, code);
  assert.match(found, /"ROBOT": "a \\"b\\" \\\\ c"/);
  assert.equal(found, printed(plain, code, { TZ: 'Asia/Tokyo', LC_ALL: 'de_DE.UTF-8' }));
});

test('with an image nothing of JavaScript can be imported either', () => {
  const code = 'try:\n    import js\nexcept ImportError as error:\n    found = str(error)\nfound';
  assert.equal(printed(begun, code), "No module named 'js'");
});
