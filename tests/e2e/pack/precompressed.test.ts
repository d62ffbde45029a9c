// `pack --precompress`: what lies beside the files of a site, what `verify` says of it, and how `serve` sends it.
import assert from 'node:assert/strict';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { brotliCompressSync, brotliDecompressSync, gunzipSync } from 'node:zlib';
import { type Browser, chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { ServedSite } from '../support/served_site.ts';

const watchdog = { timeout: 300_000 };
const program = 'programs/quick/hello.wasm';
let ws: PackWorkspace;
let browser: Browser;
let sha256 = '';

async function pack(...args: readonly string[]): Promise<string> {
  const packed = await ws.run(['--json', 'pack', ...args]);
  assert.equal(packed.code, 0, packed.stderr);
  return (JSON.parse(packed.stdout) as { sha256: string; }).sha256;
}

before(async () => {
  ws = new PackWorkspace('shared');
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello, compressed"); }\n' });
  sha256 = await pack('-o', 'site', '--precompress');
  browser = await chromium.launch(chromiumOptions());
}, watchdog);

after(async () => {
  await browser.close();
  ws.close();
});

// Guarantee, same bytes: with compressed files beside it (`pack --precompress`), which are the same each time too, with one zlib and one libbrotli
test('the site is the same with and without, and what lies beside it unpacks to its files', watchdog, async () => {
  assert.equal(await pack('-o', 'plain'), sha256);
  const plain = ws.files('plain');
  const site = ws.files('site');
  const more = [...site.keys()].filter((path) => !plain.has(path));
  for (const [path, bytes] of plain) assert.equal(site.get(path), bytes, path);
  for (const path of more) {
    assert.match(path, /\.(br|gz)$/);
    const packed = ws.read(`site/${path}`);
    const bytes = path.endsWith('.br') ? brotliDecompressSync(packed) : gunzipSync(packed);
    assert.ok(bytes.equals(ws.read(`plain/${path.slice(0, -3)}`)), path);
    assert.ok(packed.length < bytes.length, path);
  }
  for (const path of ['index.html', 'site.json', 'start.js', program]) {
    assert.ok(more.includes(`${path}.br`), path);
    assert.ok(more.includes(`${path}.gz`), path);
  }
  rmSync(join(ws.root, 'again'), { recursive: true, force: true });
  await pack('-o', 'again', '--precompress');
  assert.deepEqual([...ws.files('again')], [...site]);
});

// Guarantee, verified: compressed files beside a site unpack to its files, or `verify` says which does not
test('verify reads them', watchdog, async () => {
  const whole = await ws.run(['verify', 'site', '--hash', sha256]);
  assert.equal(whole.code, 0, whole.stderr);
  assert.doesNotMatch(whole.stderr, /R2W0653/);
  for (
    const [path, bytes] of [
      ['index.html.gz', Buffer.concat([ws.read('site/index.html.gz'), Buffer.from('x')])],
      [`${program}.br`, brotliCompressSync(Buffer.from('another program'))],
      [`${program}.br`, brotliCompressSync(Buffer.alloc(200_000_000))],
      ['site.json.gz', Buffer.from('no gzip')],
      ['start.js.gz', Buffer.from('1f8b08000000000002030300', 'hex')],
    ] as const
  ) {
    const before = ws.read(`site/${path}`);
    writeFileSync(join(ws.root, 'site', path), bytes);
    const found = await ws.run(['verify', 'site']);
    assert.equal(found.code, 1, path);
    assert.ok(found.stderr.includes(`error[R2W0650]: \`${path}\``), found.stderr);
    writeFileSync(join(ws.root, 'site', path), before);
  }
});

interface Answer {
  readonly encoding: string | undefined;
  readonly vary: string | undefined;
  readonly status: number | undefined;
  readonly body: Buffer;
}

function ask(url: string, headers: Readonly<Record<string, string>>): Promise<Answer> {
  return new Promise((done, fail) => {
    request(url, { headers }, (response) => {
      const parts: Buffer[] = [];
      response.on('data', (part: Buffer) => parts.push(part));
      response.on('end', () =>
        done({
          encoding: response.headers['content-encoding'],
          vary: response.headers.vary,
          status: response.statusCode,
          body: Buffer.concat(parts),
        }));
    }).on('error', fail).end();
  });
}

test('serve sends what the browser accepts, and the page runs', watchdog, async () => {
  await using served = await ServedSite.start([join(ws.root, 'site'), '--port', '0']);
  const whole = readFileSync(join(ws.root, 'site', program));
  const url = `${served.url}${program}`;
  for (
    const [accepted, encoding] of [
      ['gzip, deflate, br', 'br'],
      ['gzip', 'gzip'],
      ['br;q=0, gzip;q=0.5', 'gzip'],
      ['br;q=0.0', undefined],
      ['identity', undefined],
      ['', undefined],
      ['brotli', undefined],
    ] as const
  ) {
    const answer = await ask(url, { 'accept-encoding': accepted });
    assert.equal(answer.encoding, encoding, accepted);
    assert.equal(answer.vary, 'Accept-Encoding');
    const body = encoding === 'br' ? brotliDecompressSync(answer.body) : encoding === 'gzip' ? gunzipSync(answer.body) : answer.body;
    assert.ok(body.equals(whole), accepted);
  }
  const part = await ask(url, { 'accept-encoding': 'br', range: 'bytes=0-3' });
  assert.deepEqual([part.status, part.encoding, part.body.toString('latin1')], [206, undefined, '\0asm']);
  const page = await browser.newPage();
  const encodings = new Set<string>();
  page.on('response', (response) => encodings.add(response.headers()['content-encoding'] ?? ''));
  await page.goto(served.url);
  await page.waitForFunction(() => document.body?.textContent?.includes('hello, compressed'), undefined, { timeout: 60_000 });
  assert.ok(encodings.has('br'), [...encodings].join());
  await page.close();
});

test('a course has them too, and none that are old', watchdog, async () => {
  ws.write('course.yaml', 'schema: 1\nname: c\ntitle: One\ntext: "' + 'word '.repeat(400) + '"\nlabs: [{workspace: workspace.yaml, name: lab}]\n');
  ws.write('workspace.yaml', 'schema: 1\nname: lab\npackages: [src/*]\nlaunch: [{package: quick, executable: hello}]\n');
  await pack('course.yaml', '-o', 'course', '--precompress');
  assert.equal(brotliDecompressSync(ws.read('course/index.html.br')).toString(), ws.read('course/index.html').toString());
  assert.ok([...ws.files('course').keys()].some((path) => /^objects\/[0-9a-f]{64}\.wasm\.br$/.test(path)));
  const whole = await ws.run(['verify', 'course']);
  assert.equal(whole.code, 0, whole.stderr);
  const before = [...ws.files('course').keys()];
  await pack('course.yaml', '-o', 'course', '--precompress', '--prune');
  assert.deepEqual([...ws.files('course').keys()], before);
  await pack('course.yaml', '-o', 'course');
  assert.ok(!ws.files('course').has('index.html.br'));
});
