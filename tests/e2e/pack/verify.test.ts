// `ros2wasm verify`: a packed site in a folder and behind a server, whole, and changed in every way that bytes can be.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, cpSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { after, before, beforeEach, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

let ws: PackWorkspace;
let site: string;
let sha256: string;

before(async () => {
  ws = new PackWorkspace('shared');
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  const packed = await ws.run(['--json', 'pack', '-o', 'packed']);
  assert.equal(packed.code, 0, packed.stderr);
  sha256 = (JSON.parse(packed.stdout) as { sha256: string; }).sha256;
});

beforeEach(() => {
  site = join(ws.root, 'site');
  rmSync(site, { recursive: true, force: true });
  cpSync(join(ws.root, 'packed'), site, { recursive: true });
});

after(() => ws.close());

const program = 'programs/quick/hello.wasm';

// Guarantee, verified: `pack` prints the sha256 of the site, which `verify --hash` compares
test('what was packed is as it was packed, and the hash that pack said is that of site.json', async () => {
  const whole = await ws.run(['verify', 'site', '--hash', sha256]);
  assert.equal(whole.code, 0, whole.stderr);
  assert.match(whole.stdout, /^site: \d+ files, \d+ bytes, all as packed\nsha256 [0-9a-f]{64}\n$/);
  assert.equal(createHash('sha256').update(readFileSync(join(site, 'site.json'))).digest('hex'), sha256);
});

// Guarantee, same bytes: as one archive: `pack -o NAME.zip`
test('-o NAME.zip writes the same site as one archive, the same one each time', async () => {
  for (const name of ['one.zip', 'two.zip']) {
    const packed = await ws.run(['pack', '-o', name]);
    assert.equal(packed.code, 0, packed.stderr);
  }
  assert.deepEqual(readFileSync(join(ws.root, 'one.zip')), readFileSync(join(ws.root, 'two.zip')));
  const unpacked = spawnSync('python3', ['-m', 'zipfile', '-e', 'one.zip', 'unpacked'], { cwd: ws.root, encoding: 'utf8' });
  assert.equal(unpacked.status, 0, unpacked.stderr);
  const whole = await ws.run(['verify', 'unpacked', '--hash', sha256]);
  assert.equal(whole.code, 0, whole.stderr);
});

// Guarantee, verified: `sha256sum --check SHA256SUMS` finds every file
test('sha256sum finds every file as SHA256SUMS says, site.json too', () => {
  const checked = spawnSync('sha256sum', ['--check', '--strict', 'SHA256SUMS'], { cwd: site, encoding: 'utf8' });
  assert.equal(checked.status, 0, checked.stderr);
  assert.match(checked.stdout, /^site\.json: OK$/m);
  assert.match(checked.stdout, /^programs\/quick\/hello\.wasm: OK$/m);
});

// Guarantee, verified: one changed bit is found
test('one bit of a program', async () => {
  const bytes = readFileSync(join(site, program));
  bytes[bytes.length - 1] = (bytes[bytes.length - 1] ?? 0) ^ 1;
  writeFileSync(join(site, program), bytes);
  const changed = await ws.run(['verify', 'site']);
  assert.equal(changed.code, 1);
  assert.match(changed.stderr, /error\[R2W0650\]: `programs\/quick\/hello\.wasm` is not the file that the site was packed with/);
  assert.match(changed.stderr, /\n1 error;/);
});

// Guarantee, verified: a list of hashes that was made to fit changed files is another site
test('a list of hashes that was made to fit a changed program is another site', async () => {
  writeFileSync(join(site, program), 'another program');
  const other = createHash('sha256').update('another program').digest('hex');
  const text = readFileSync(join(site, 'site.json'), 'utf8');
  const own = createHash('sha256').update(readFileSync(join(ws.root, 'packed', program))).digest('hex');
  const size = readFileSync(join(ws.root, 'packed', program)).length;
  const forged = text.replaceAll(own, other).replace(`"size":${size}`, '"size":15');
  writeFileSync(join(site, 'site.json'), forged);
  const sums = readFileSync(join(site, 'SHA256SUMS'), 'utf8');
  writeFileSync(join(site, 'SHA256SUMS'), sums.replace(own, other).replace(sha256, createHash('sha256').update(forged).digest('hex')));
  const unasked = await ws.run(['verify', 'site']);
  assert.equal(unasked.code, 0, unasked.stderr);
  const asked = await ws.run(['verify', 'site', '--hash', `sha256:${sha256}`]);
  assert.equal(asked.code, 1);
  assert.match(asked.stderr, /error\[R2W0652\]: this is another site than the one that was asked for/);
});

test('a link to the same bytes is not the file', async () => {
  copyFileSync(join(site, program), join(ws.root, 'elsewhere.wasm'));
  rmSync(join(site, program));
  symlinkSync(join(ws.root, 'elsewhere.wasm'), join(site, program));
  const linked = await ws.run(['verify', 'site']);
  assert.equal(linked.code, 1);
  assert.match(linked.stderr, /error\[R2W0651\]: `programs\/quick\/hello\.wasm` is missing/);
});

/** The folder over HTTP, on loopback; `change` may answer in its place. */
async function served<T>(change: (path: string) => { status: number; body: Buffer; } | undefined, use: (url: string) => Promise<T>): Promise<T> {
  const server: Server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname).slice(1);
    try {
      const answer = change(path) ?? { status: 200, body: readFileSync(join(site, path)) };
      response.writeHead(answer.status, { 'content-length': answer.body.length });
      response.end(answer.body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  try {
    return await use(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
  } finally {
    server.closeAllConnections();
    await new Promise((closed) => server.close(closed));
  }
}

// Guarantee, verified: a site on the web, by its address
test('behind a server: whole, by the address of the page too', async () => {
  await served(() => undefined, async (url) => {
    for (const address of [url, `${url}index.html?graph=lab`, `${url}site.json`]) {
      const whole = await ws.run(['verify', address, '--hash', sha256]);
      assert.equal(whole.code, 0, whole.stderr);
      assert.match(whole.stdout, /all as packed/);
    }
  });
});

test('behind a server: a file that is gone, one that grew, one that was rewritten', async () => {
  const grown = Buffer.concat([readFileSync(join(site, program)), Buffer.alloc(4_000_000)]);
  await served((path) => {
    if (path === 'interfaces.json') return { status: 403, body: Buffer.alloc(0) };
    if (path === program) return { status: 200, body: grown };
    if (path === 'boot.js') return { status: 200, body: Buffer.from(readFileSync(join(site, 'boot.js'), 'latin1').replace(/;/, ','), 'latin1') };
    return undefined;
  }, async (url) => {
    const changed = await ws.run(['verify', url], { ROS2WASM_RETRIES: '0' });
    assert.equal(changed.code, 1, changed.stderr);
    assert.match(changed.stderr, /error\[R2W0651\]: `interfaces\.json` is missing/);
    assert.match(changed.stderr, /error\[R2W0650\]: `programs\/quick\/hello\.wasm` .*\n {3}= why: it has more bytes than the \d+ that site\.json says/);
    assert.match(changed.stderr, /error\[R2W0650\]: `boot\.js` .*\n {3}= why: its sha256 is/);
    assert.match(changed.stderr, /\n3 errors;/);
  });
});

test('behind a server: no site there', async () => {
  await served(() => ({ status: 404, body: Buffer.from('nothing') }), async (url) => {
    const nothing = await ws.run(['verify', url], { ROS2WASM_RETRIES: '0' });
    assert.equal(nothing.code, 1);
    assert.match(nothing.stderr, /error\[R2W0605\]: there is no site at http:/);
  });
});
