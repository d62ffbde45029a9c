// `pack --max-file-size`: files that a host would not take lie in parts; in Chromium on three kinds of host, in Node.js, and for the
// commands that read sites.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { appendFileSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };
const program = 'programs/large/sum.wasm';
const megabyte = 1_000_000;
let ws: PackWorkspace;
let browser: Browser;
let sha256 = '';

/** So many different bytes that no compiler or link leaves them out: their sum is what the program says. */
const lines = 2500;
const line = 'all of the bytes of this text count, '.repeat(27);
const said = `the sum is ${lines * [...line].reduce((sum, letter) => sum + letter.charCodeAt(0), 0)}`;

before(async () => {
  ws = new PackWorkspace('shared');
  ws.addPackage('large', {
    sum: `#include <cstdio>
static volatile const char text[] =
${`"${line}"\n`.repeat(lines)};
int main() {
  long sum = 0;
  for (const volatile char& letter : text) sum += letter;
  std::printf("the sum is %ld\\n", sum);
}
`,
  });
  const packed = await ws.run(['--json', 'pack', '-o', 'site', '--max-file-size', '1']);
  assert.equal(packed.code, 0, packed.stderr);
  sha256 = (JSON.parse(packed.stdout) as { sha256: string; }).sha256;
  browser = await chromium.launch(chromiumOptions());
}, watchdog);

after(async () => {
  await browser.close();
  ws.close();
});

// Guarantee, verified: with a ceiling for files (`pack --max-file-size`), no file is larger; parts are joined by page and `run`, and their hashes checked
test('no file is larger than it may be, and all commands read the parts', watchdog, async () => {
  for (const [path, bytes] of ws.files('site')) assert.ok(bytes.length <= megabyte, path);
  assert.ok(existsSync(join(ws.root, `site/${program}.part3`)));
  assert.ok(!existsSync(join(ws.root, 'site', program)));
  const verified = await ws.run(['verify', 'site', '--hash', sha256]);
  assert.equal(verified.code, 0, verified.stderr);
  const sums = spawnSync('sha256sum', ['--check', '--strict', '--quiet', 'SHA256SUMS'], { cwd: join(ws.root, 'site'), encoding: 'utf8' });
  assert.equal(sums.status, 0, sums.stderr);
  const run = await ws.run(['run', 'site', '--until', said, '--for', '60s']);
  assert.equal(run.code, 0, run.stdout + run.stderr);
  assert.equal((await ws.run(['pack', '-o', 'plain'])).code, 0);
  const diff = await ws.run(['diff', 'site', 'plain']);
  assert.doesNotMatch(diff.stdout, /programs\/large\/sum\.wasm:/);
  assert.equal((await ws.run(['pack', '-o', 'site.zip', '--max-file-size', '1'])).code, 0);
  const list = spawnSync('python3', ['-m', 'zipfile', '-l', 'site.zip'], { cwd: ws.root, encoding: 'utf8' }).stdout;
  assert.match(list, /sum\.wasm\.part3/);
});

for (
  const [host, isolated, serviceWorkers] of [
    ['that isolates', true, 'block'],
    ['without headers', false, 'allow'],
    ['without headers or service workers', false, 'block'],
  ] as const
) {
  test(`it runs in Chromium from a host ${host}`, watchdog, async () => {
    const served = await serveFolder(join(ws.root, 'site'), { isolated });
    const context = await browser.newContext({ serviceWorkers });
    try {
      const page = await context.newPage();
      await page.goto(served.url);
      const shown = (): Promise<unknown> => page.waitForFunction((text) => document.body?.textContent?.includes(text), said, { timeout: 100_000 });
      await shown();
      assert.ok(!served.requests.some((path) => path.endsWith('.wasm')));
      if (serviceWorkers === 'block') return;
      await page.waitForSelector('html[data-offline=kept]', { timeout: 100_000, state: 'attached' });
      await served.close();
      await page.reload();
      await shown();
    } finally {
      await context.close();
      await served.close();
    }
  });
}

test('a part that is changed is found, and its program does not run', watchdog, async () => {
  const part = join(ws.root, `site/${program}.part2`);
  const before = readFileSync(part);
  appendFileSync(part, '\0');
  try {
    assert.match((await ws.run(['verify', 'site'])).stderr, /error\[R2W0650\]: `programs\/large\/sum\.wasm`/);
    assert.match((await ws.run(['run', 'site', '--for', '3s', '--until', said])).stderr, /R2W0724/);
  } finally {
    writeFileSync(part, before);
  }
});

test('a list of parts that do not make up their file is refused before anything is read', watchdog, async () => {
  const file = join(ws.root, 'site/site.json');
  const before = readFileSync(file, 'utf8');
  type Listed = { files: { path: string; parts?: { size: unknown; sha256: unknown; }[]; }[]; };
  const changes: Readonly<Record<string, (parts: { size: unknown; sha256: unknown; }[]) => unknown>> = {
    none: () => [],
    'one less': (parts) => parts.slice(1),
    'one twice': (parts) => [...parts, parts[0]],
    'a size that wraps around': (parts) => [{ ...parts[0], size: 18446744073709551615 }, ...parts.slice(1)],
    'a negative size': (parts) => [{ ...parts[0], size: -1 }, ...parts.slice(1)],
    'a path in place of a hash': (parts) => [{ ...parts[0], sha256: '../../etc/passwd' }, ...parts.slice(1)],
    'a word in place of a list': () => 'parts',
  };
  try {
    for (const [what, change] of Object.entries(changes)) {
      const site = JSON.parse(before) as Listed;
      const listed = site.files.find(({ path }) => path === program);
      assert.ok(listed?.parts);
      Object.assign(listed, { parts: change(listed.parts) });
      writeFileSync(file, JSON.stringify(site));
      const verified = await ws.run(['verify', 'site']);
      assert.equal(verified.code, 1, what);
      assert.match(verified.stderr, /error\[R2W0605\]: .*the parts of `programs\/large\/sum\.wasm` do not make it up/s, what);
    }
  } finally {
    writeFileSync(file, before);
  }
});

test('a page in one file has no parts, and says so', watchdog, async () => {
  const packed = await ws.run(['pack', '-o', 'page.html', '--max-file-size', '1']);
  assert.equal(packed.code, 2);
  assert.match(packed.stderr, /error\[R2W0902\]: --max-file-size is for folders and archives/);
});

test('what browsers load in one piece is refused, and nothing is written', watchdog, async () => {
  ws.write('lab.md', '# Lab\n\n![large](large.svg)\n');
  ws.write('large.svg', `<svg xmlns="http://www.w3.org/2000/svg"><!--${'x'.repeat(megabyte)}--></svg>`);
  ws.write('workspace.yaml', 'schema: 1\nname: lab\npackages: [src/*]\nlaunch: [{package: large, executable: sum}]\nui: {text: lab.md}\n');
  const packed = await ws.run(['pack', '-o', 'refused', '--max-file-size', '1']);
  assert.equal(packed.code, 1);
  assert.match(packed.stderr, /error\[R2W0617\]: `text\/large\.svg` has 10000\d\d bytes, more than --max-file-size/);
  assert.ok(!existsSync(join(ws.root, 'refused')));
});
