// Signatures of sites: ours as Debian's minisign reads them, minisign's as `ros2wasm verify` reads them, and what is refused.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { closeSync, cpSync, openSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { after, before, beforeEach, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { CLI, PackWorkspace } from '../support/pack_workspace.ts';

let ws: PackWorkspace;
let sha256: string;

const password = 'correct horse';

function minisign(args: readonly string[], input = ''): string {
  const ran = spawnSync('minisign', args, { cwd: ws.root, input, encoding: 'utf8' });
  assert.equal(ran.status, 0, `minisign ${args.join(' ')}: ${ran.stdout}${ran.stderr}`);
  return ran.stdout;
}

before(async () => {
  ws = new PackWorkspace('shared');
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  minisign(['-G', '-W', '-p', 'plain.pub', '-s', 'plain.key']);
  minisign(['-G', '-p', 'locked.pub', '-s', 'locked.key'], `${password}\n${password}\n`);
  const bare = await ws.run(['--json', 'pack', '-o', 'bare']);
  assert.equal(bare.code, 0, bare.stderr);
  sha256 = (JSON.parse(bare.stdout) as { sha256: string; }).sha256;
  const packed = await ws.run(['pack', '-o', 'packed', '--sign', 'plain.key']);
  assert.equal(packed.code, 0, packed.stderr);
});

beforeEach(() => {
  rmSync(join(ws.root, 'site'), { recursive: true, force: true });
  cpSync(join(ws.root, 'packed'), join(ws.root, 'site'), { recursive: true });
});

after(() => ws.close());

const keyOf = (file: string): string => readFileSync(join(ws.root, file), 'utf8').split('\n')[1] ?? '';

// Guarantee, verified: `pack --sign` signs a site as Debian's minisign verifies it, and the site's sha256 stays the same
test('minisign verifies what pack signed; the site is the same site', async () => {
  const said = minisign(['-V', '-m', 'site/site.json', '-p', 'plain.pub']);
  assert.match(said, new RegExp(`Signature and comment signature verified\nTrusted comment: sha256 ${sha256}\n`));
  minisign(['-V', '-m', 'site/site.json', '-p', 'site/minisign.pub']);
  const whole = await ws.run(['verify', 'site', '--key', 'plain.pub', '--hash', sha256]);
  assert.equal(whole.code, 0, whole.stderr);
  assert.doesNotMatch(whole.stderr, /R2W0653/);
  assert.match(whole.stdout, new RegExp(`\nsigned with the key [0-9A-F]+: sha256 ${sha256}\n`));
  const again = await ws.run(['pack', '-o', 'again', '--sign', 'plain.key']);
  assert.equal(again.code, 0, again.stderr);
  assert.deepEqual(readFileSync(join(ws.root, 'again/site.json.minisig')), readFileSync(join(ws.root, 'packed/site.json.minisig')));
});

// Guarantee, verified: `verify --key` takes signatures that minisign made
test('what minisign signed is verified, by the line of the key too', async () => {
  minisign(['-S', '-m', 'site/site.json', '-s', 'locked.key', '-t', 'lab 3, version 2'], `${password}\n`);
  const whole = await ws.run(['--json', 'verify', 'site', '--key', keyOf('locked.pub')]);
  assert.equal(whole.code, 0, whole.stderr);
  const { signed } = JSON.parse(whole.stdout) as { signed: { key: string; comment: string; }; };
  assert.equal(signed.comment, 'lab 3, version 2');
  assert.ok(readFileSync(join(ws.root, 'locked.pub'), 'utf8').includes(signed.key), signed.key);
});

// Guarantee, verified: `pack --sign` takes minisign's keys with a password, from the environment, a file descriptor or a terminal
test('a key with a password: from the environment, a file descriptor and a terminal', async () => {
  const site = join(ws.root, 'locked');
  const named = ['pack', '-o', 'locked', '--sign', 'locked.key', '--sign-comment', 'Über uns'];
  const signed = (how: string): void => {
    const said = minisign(['-V', '-m', 'locked/site.json', '-p', 'locked.pub']);
    assert.match(said, /Trusted comment: Über uns\n/, how);
    rmSync(site, { recursive: true });
  };
  const variable = await ws.run(named, { ROS2WASM_KEY_PASSWORD: password });
  assert.equal(variable.code, 0, variable.stderr);
  signed('environment');
  ws.write('password.txt', `${password}\n`);
  const descriptor = openSync(join(ws.root, 'password.txt'), 'r');
  const environment = { ...process.env, XDG_CACHE_HOME: join(ws.root, 'cache') };
  const read = spawnSync(CLI, [...named, '--password-fd', '3'], {
    cwd: ws.root,
    env: environment,
    stdio: ['ignore', 'pipe', 'pipe', descriptor],
    encoding: 'utf8',
  });
  closeSync(descriptor);
  assert.equal(read.status, 0, read.stderr);
  signed('file descriptor');
  // A terminal of its own, which shows nothing of what is typed.
  const typed = spawnSync('python3', ['-c', `
import os, pty, sys
child, terminal = pty.fork()
if child == 0:
    os.execv(sys.argv[1], sys.argv[1:])
seen = b''
typed = False
while True:
    try:
        part = os.read(terminal, 4096)
    except OSError:
        break
    if not part:
        break
    seen += part
    if not typed and b'Password of locked.key: ' in seen:
        typed = True
        os.write(terminal, b'${password}\\n')
status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
sys.stdout.buffer.write(seen)
sys.exit(status)
`, CLI, ...named], { cwd: ws.root, env: environment, encoding: 'utf8' });
  assert.equal(typed.status, 0, typed.stdout);
  assert.doesNotMatch(typed.stdout, new RegExp(password));
  signed('terminal');
});

// Guarantee, ci: Ctrl-C at the question for a password ends with 130, and the terminal shows again what is typed
test('an interrupt while a password is asked for', async () => {
  const asked = spawnSync('python3', ['-c', `
import os, pty, sys, termios
child, terminal = pty.fork()
if child == 0:
    os.execv(sys.argv[1], sys.argv[1:])
seen = b''
while b'Password of locked.key: ' not in seen:
    seen += os.read(terminal, 4096)
os.write(terminal, bytes([3]))
while True:
    try:
        part = os.read(terminal, 4096)
    except OSError:
        break
    if not part:
        break
    seen += part
status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
sys.stdout.buffer.write(seen)
sys.exit(status)
`, CLI, 'pack', '-o', 'no', '--sign', 'locked.key'], {
    cwd: ws.root,
    env: { ...process.env, XDG_CACHE_HOME: join(ws.root, 'cache') },
    encoding: 'utf8',
    timeout: 60_000,
  });
  assert.equal(asked.status, 130, asked.stdout);
  assert.match(asked.stdout, /interrupted/);
  assert.doesNotMatch(asked.stdout, /no terminal/);
});

test('another password, and none where nobody can be asked', async () => {
  const wrong = await ws.run(['pack', '-o', 'no', '--sign', 'locked.key'], { ROS2WASM_KEY_PASSWORD: 'battery' });
  assert.equal(wrong.code, 1);
  assert.match(wrong.stderr, /error\[R2W0659\]: the key `locked\.key` could not be opened\n {3}= why: it has another password/);
  const closed = await ws.run(['pack', '-o', 'no', '--sign', 'locked.key', '--password-fd', '77']);
  assert.equal(closed.code, 1);
  assert.match(closed.stderr, /error\[R2W0659\].*\n {3}= why: no password came from file descriptor 77/);
  const none = await ws.run(['pack', '-o', 'no', '--sign-comment', 'mine']);
  assert.equal(none.code, 2);
  assert.match(none.stderr, /error\[R2W0902\]: there is no key to sign with/);
  ws.write('labs/course.yaml', 'schema: 1\nname: lab_course\ntitle: Labs\nlabs:\n  - workspace: ..\n');
  const course = await ws.run(['pack', 'labs/course.yaml', '-o', 'no', '--sign', 'plain.key']);
  assert.equal(course.code, 2, course.stderr);
  assert.match(course.stderr, /error\[R2W0902\]: --sign is for sites/);
  const foreign = await ws.run(['pack', '-o', 'no', '--sign', 'plain.pub']);
  assert.match(foreign.stderr, /error\[R2W0658\]: `plain\.pub` is not a secret key of minisign/);
});

// Guarantee, verified: a changed site.json, another key and a missing signature are refused by `verify --key`
test('changed, signed by somebody else, not signed, no signature at all', async () => {
  const verify = (key: string) => ws.run(['verify', 'site', '--key', key]);
  const refused = async (key: string, words: RegExp): Promise<void> => {
    const checked = await verify(key);
    assert.equal(checked.code, 1, checked.stdout);
    assert.match(checked.stderr, words);
  };
  await refused('locked.pub', /error\[R2W0657\]: .*\n {3}= why: its signature names the key [0-9A-F]+, given was the key [0-9A-F]+/);
  await refused('plain.key', /error\[R2W0655\]: `plain\.key` is not a public key of minisign/);
  const file = join(ws.root, 'site/site.json');
  writeFileSync(file, readFileSync(file, 'utf8').replace('"reason"', '"reasom"'));
  await refused('plain.pub', /error\[R2W0657\]: .*\n {3}= why: the signature is of another site\.json/);
  writeFileSync(join(ws.root, 'site/site.json.minisig'), 'trust me\n');
  await refused('plain.pub', /error\[R2W0656\]: `site\.json\.minisig` is not a signature of minisign/);
  writeFileSync(join(ws.root, 'site/site.json.minisig'), Buffer.alloc(5_000_000, 65));
  await refused('plain.pub', /error\[R2W0656\]/);
  rmSync(join(ws.root, 'site/site.json.minisig'));
  await refused('plain.pub', /error\[R2W0654\]: the site is not signed/);
});

test('as an archive, as a page, and on the web', async () => {
  for (const name of ['signed.zip', 'signed.html']) {
    const packed = await ws.run(['pack', '-o', name, '--sign', 'plain.key']);
    assert.equal(packed.code, 0, packed.stderr);
  }
  const unpacked = spawnSync('python3', ['-m', 'zipfile', '-e', 'signed.zip', 'unpacked'], { cwd: ws.root, encoding: 'utf8' });
  assert.equal(unpacked.status, 0, unpacked.stderr);
  let there = true;
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname).slice(1);
    if (path === 'site.json.minisig' && !there) response.writeHead(404).end('no');
    else response.end(readFileSync(join(ws.root, 'site', path)));
  });
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  const url = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
  try {
    for (const site of ['unpacked', 'signed.html', url]) {
      const whole = await ws.run(['verify', site, '--key', 'plain.pub', '--hash', sha256]);
      assert.equal(whole.code, 0, `${site}: ${whole.stderr}`);
      assert.doesNotMatch(whole.stderr, /R2W0653/);
      assert.match(whole.stdout, /\nsigned with the key /);
    }
    there = false;
    const bare = await ws.run(['verify', url, '--key', 'plain.pub']);
    assert.equal(bare.code, 1);
    assert.match(bare.stderr, /error\[R2W0654\]/);
  } finally {
    server.closeAllConnections();
    await new Promise((closed) => server.close(closed));
  }
});

// Guarantee, verified: the page says which key's signature lies beside it, its comment, and that no page vouches for itself
test('the page says which key signed, and that this is to be checked elsewhere', async () => {
  const [, keyId] = /public key ([0-9A-F]+)/.exec(readFileSync(join(ws.root, 'plain.pub'), 'utf8')) ?? assert.fail();
  const packed = await ws.run(['pack', '-o', 'shown.html', '--sign', 'plain.key', '--sign-comment', 'Lab 3 <b>bold</b>']);
  assert.equal(packed.code, 0, packed.stderr);
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    const ask = async (file: string): Promise<void> => {
      await page.goto(pathToFileURL(join(ws.root, file)).href);
      await page.getByRole('button', { name: /about/i }).first().click();
      await page.getByRole('button', { name: 'Who signed it?' }).click();
    };
    await ask('shown.html');
    await page.getByText(
      `A signature by the key ${keyId} is beside this site, with the comment \u201cLab 3 <b>bold</b>\u201d. This page cannot vouch for itself`,
    ).waitFor();
    const bare = await ws.run(['pack', '-o', 'unsigned.html']);
    assert.equal(bare.code, 0, bare.stderr);
    await ask('unsigned.html');
    await page.getByText('This site has no signature.').waitFor();
  } finally {
    await browser.close();
  }
});
