// A course: forty labs in one folder, what they cost, the page that lists them, and what a course is when it is packed again.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { appendFileSync, cpSync, existsSync, readFileSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { nightly } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { ServedSite } from '../support/served_site.ts';

const watchdog = { timeout: 400_000 };
const patience = { timeout: 100_000 };
const labs = nightly ? 40 : 12;
/** Enough for what is not about the number of labs: each packs in half a second. */
const few = 3;
const hostile = '<img src=x onerror=alert(1)><script>alert(2)</script> "quoted" & so on';

interface Packed {
  readonly sha256: string;
  readonly bytes: number;
  readonly labs: readonly { readonly name: string; readonly sha256: string; }[];
}

let ws: PackWorkspace;
let browser: Browser;
let first: Packed;
let short: Packed;

const nameOf = (number: number): string => `lab${String(number).padStart(2, '0')}`;

function writeLab(number: number, text: string): void {
  const name = nameOf(number);
  ws.write(`labs/${name}/workspace.yaml`, `schema: 1
name: ${name}
title: The lab number ${number}
distro: jazzy
packages: [../../src/*]
launch:
  - {package: chatter_py, executable: count}
ui: {text: lab.md}
`);
  ws.write(`labs/${name}/lab.md`, text);
}

function writeCourse(file: string, count: number): void {
  const up = file.includes('/') ? '../' : '';
  const items = Array.from({ length: count },
    (_, i) => `  - {workspace: ${up}labs/${nameOf(i)}, description: ${JSON.stringify(i === 0 ? hostile : `About ${i}.`)}}\n`);
  ws.write(file,
    `schema: 1\nname: forty\ntitle: ${JSON.stringify(`Forty labs ${hostile}`)}\ntext: ${JSON.stringify(`First paragraph.\n\n${hostile}`)}\nlabs:\n${
      items.join('')
    }`);
}

async function pack(file: string, folder: string, ...more: readonly string[]): Promise<Packed> {
  const packed = await ws.run(['--json', 'pack', file, '-o', folder, ...more]);
  assert.equal(packed.code, 0, packed.stderr);
  return JSON.parse(packed.stdout) as Packed;
}

before(async () => {
  ws = new PackWorkspace('shared');
  cpSync(resolve(import.meta.dirname, '../../packages/chatter_py'), join(ws.root, 'src/chatter_py'), { recursive: true });
  for (let i = 0; i < labs; ++i) writeLab(i, `# Lab ${i}\n\nWhat to do in it.\n`);
  writeCourse('course.yaml', labs);
  writeCourse('few/course.yaml', few);
  first = await pack('course.yaml', 'course');
  short = await pack('few/course.yaml', 'short');
  browser = await chromium.launch(chromiumOptions());
}, watchdog);

after(async () => {
  await browser.close();
  ws.close();
});

// Guarantee, verified: forty labs of a course cost under 1.3 times one lab and their own code, all bytes of all files counted
test(`${labs} labs cost under 1.3 times one lab and what is their own`, watchdog, async () => {
  assert.equal(first.labs.length, labs);
  const one = await ws.run(['pack', `labs/${nameOf(0)}`, '-o', 'plain']);
  assert.equal(one.code, 0, one.stderr);
  const size = (folder: string): number => [...ws.files(folder).values()].reduce((sum, { length }) => sum + length, 0);
  const own = Array.from({ length: labs - 1 }, (_, i) => readFileSync(join(ws.root, 'labs', nameOf(i + 1), 'lab.md')).length).reduce((a, b) => a + b, 0);
  assert.equal(size('course'), first.bytes);
  assert.ok(first.bytes < 1.3 * size('plain') + own, `${first.bytes} for ${labs} labs, ${size('plain')} for one`);
});

test('each byte is as packed, by verify and by sha256sum; the same course is the same bytes', watchdog, async () => {
  const whole = await ws.run(['verify', 'course', '--hash', first.sha256]);
  assert.equal(whole.code, 0, whole.stderr);
  const sums = spawnSync('sha256sum', ['--check', '--strict', '--quiet', 'SHA256SUMS'], { cwd: join(ws.root, 'course'), encoding: 'utf8' });
  assert.equal(sums.status, 0, sums.stderr);
  const before = ws.files('short');
  assert.deepEqual(await pack('few/course.yaml', 'short'), short);
  assert.deepEqual([...ws.files('short').keys()], [...before.keys()]);
});

// Guarantee, hostile input: texts of a course.yaml are shown as text; its page runs no script and loads from nowhere else
test('the page lists the labs, shows texts as text, and leads to them', watchdog, async () => {
  const served = await serveFolder(join(ws.root, 'course'), { isolated: true });
  const page = await browser.newPage();
  const dialogs: string[] = [];
  page.on('dialog', (dialog) => {
    dialogs.push(dialog.message());
    void dialog.dismiss();
  });
  try {
    await page.goto(served.url);
    assert.equal(await page.textContent('h1'), `Forty labs ${hostile}`);
    assert.deepEqual(await page.locator('main > p').allTextContents(), ['First paragraph.', hostile]);
    assert.equal(await page.locator('li').count(), labs);
    assert.equal(await page.locator('li').first().locator('p').textContent(), hostile);
    assert.deepEqual(await page.evaluate(() => document.querySelectorAll('script, img, [onerror], [style]').length), 0);
    const policy = await page.evaluate(() => document.querySelector('meta[http-equiv]')?.getAttribute('content') ?? '');
    assert.match(policy, /^default-src 'none'; style-src 'self';/);
    await page.getByRole('link', { name: 'The lab number 7' }).click();
    await page.waitForFunction(() => document.body?.textContent?.includes('Python counts 2'), undefined, patience);
    assert.equal(new URL(page.url()).pathname, '/some/path/lab07/index.html');
    assert.deepEqual(dialogs, []);
  } finally {
    await page.close();
    await served.close();
  }
});

test('serve serves the whole, run one of its labs', watchdog, async () => {
  await using served = await ServedSite.start([join(ws.root, 'course'), '--port', '0']);
  assert.equal((await fetch(served.url)).status, 200);
  const policy = async (path: string): Promise<string | null> => (await fetch(served.url + path)).headers.get('content-security-policy');
  for (const page of ['', 'lab03/', 'lab03/index.html']) assert.match(await policy(page) ?? '', /^default-src/, page);
  assert.equal((await fetch(`${served.url}lab03/site.json`)).status, 200);
  const run = await ws.run(['run', 'course/lab03', '--until', 'Python counts 1', '--for', '60s']);
  assert.equal(run.code, 0, run.stderr);
});

// Guarantee, same bytes: a course as one archive: `pack course.yaml -o NAME.zip`
test('-o NAME.zip is the course as one archive', watchdog, async () => {
  for (const name of ['one.zip', 'two.zip', 'one.zip']) {
    const packed = await ws.run(['pack', 'few/course.yaml', '-o', name]);
    assert.equal(packed.code, 0, packed.stderr);
  }
  assert.deepEqual(readFileSync(join(ws.root, 'one.zip')), readFileSync(join(ws.root, 'two.zip')));
  const unpacked = spawnSync('python3', ['-m', 'zipfile', '-e', 'one.zip', 'unpacked'], { cwd: ws.root, encoding: 'utf8' });
  assert.equal(unpacked.status, 0, unpacked.stderr);
  const whole = await ws.run(['verify', 'unpacked', '--hash', short.sha256]);
  assert.equal(whole.code, 0, whole.stderr);
});

test('a changed page, lab or object is found', watchdog, async () => {
  for (const [file, code] of [['index.html', 'R2W0650'], ['lab01/index.html', 'R2W0650'], ['lab02/site.json', 'R2W0652']] as const) {
    rmSync(join(ws.root, 'changed'), { recursive: true, force: true });
    cpSync(join(ws.root, 'unpacked'), join(ws.root, 'changed'), { recursive: true });
    appendFileSync(join(ws.root, 'changed', file), '\n');
    const found = await ws.run(['verify', 'changed']);
    assert.equal(found.code, 1, file);
    assert.match(found.stderr, new RegExp(`error\\[${code}\\]`), file);
  }
});

// Guarantee, verified: old links keep working when a course is packed again, until `--prune`
test('a lab that changed keeps what it was, one that went stays, until --prune', watchdog, async () => {
  const old = short.labs[1]?.sha256 ?? '';
  writeLab(1, '# Lab 1\n\nAs it is now.\n');
  writeCourse('few/course.yaml', few - 1);
  const now = await pack('few/course.yaml', 'short');
  const earlier = `short/lab01@${old.slice(0, 16)}`;
  const kept = await ws.run(['verify', earlier, '--hash', old]);
  assert.equal(kept.code, 0, kept.stderr);
  assert.ok(existsSync(join(ws.root, 'short', nameOf(few - 1))));
  ws.write('short/notes/mine.txt', 'not of ros2wasm');
  assert.equal((await pack('few/course.yaml', 'short', '--prune')).sha256, now.sha256);
  assert.ok(!existsSync(join(ws.root, earlier)));
  assert.ok(!existsSync(join(ws.root, 'short', nameOf(few - 1))));
  assert.ok(existsSync(join(ws.root, 'short/notes/mine.txt')));
  const whole = await ws.run(['verify', 'short', '--hash', now.sha256]);
  assert.equal(whole.code, 0, whole.stderr);
  const named = new Set(readFileSync(join(ws.root, 'short/SHA256SUMS'), 'utf8').split('\n').map((line) => line.slice(66)));
  for (const path of ws.files('short').keys()) if (path.startsWith('objects/') && path !== 'objects/store.json') assert.ok(named.has(path), path);
});
