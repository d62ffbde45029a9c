// Sites that share a store of objects: what lies where, in Chromium on every kind of host and in Node.js; what the command
// line makes of them; links to earlier packs.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { appendFileSync, cpSync, existsSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium, type Page } from 'playwright-core';
import { eventually } from '../../support/eventually.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { ServedSite } from '../support/served_site.ts';

const watchdog = { timeout: 240_000 };
const patience = { timeout: 100_000 };
const store = ['--store', 'course/objects'];

let ws: PackWorkspace;
let browser: Browser;
/** By name of the site. */
const hashes = new Map<string, string>();

const manifest = (name: string, title: string): string =>
  `schema: 1
name: ${name}
title: ${title}
distro: jazzy
packages: [src/*]
launch:
  - {package: chatter_py, executable: count}
  - {package: quick, executable: hello}
`;

async function pack(name: string): Promise<string> {
  const packed = await ws.run(['--json', 'pack', `${name}.yaml`, '-o', `course/${name}`, ...store]);
  assert.equal(packed.code, 0, packed.stderr);
  return (JSON.parse(packed.stdout) as { sha256: string; }).sha256;
}

before(async () => {
  ws = new PackWorkspace('shared');
  cpSync(resolve(import.meta.dirname, '../../packages/chatter_py'), join(ws.root, 'src/chatter_py'), { recursive: true });
  appendFileSync(join(ws.root, 'src/chatter_py/chatter_py/__init__.py'),
    '\nimport ros2wasm.start\nprint(f"from an image: {ros2wasm.start.from_image}", flush=True)\n');
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello from the store"); }\n' });
  for (const name of ['one', 'two']) {
    ws.write(`${name}.yaml`, manifest(name, `The lab ${name}`));
    hashes.set(name, await pack(name));
  }
  browser = await chromium.launch(chromiumOptions());
}, watchdog);

after(async () => {
  await browser.close();
  ws.close();
});

// Guarantee, verified: sites of one store (`pack --store`): every object has its sha256 as its name, and lies there once
test('a site of a store has what is its own; the rest lies in the store, under its sha256', async () => {
  const files = ws.files('course');
  const beside = [...files.keys()].filter((path) => !path.startsWith('objects/'));
  assert.deepEqual(beside,
    ['one', 'two'].flatMap((name) => ['app.webmanifest', 'icon.svg', 'index.html', 'service_worker.js', 'site.json'].map((file) => `${name}/${file}`)));
  const scripts: string[] = [];
  for (const [path, bytes] of files) {
    const [, name] = /^objects\/([0-9a-f]{64})(?:\.[a-z0-9]+)?$/.exec(path) ?? [];
    if (name !== undefined) assert.equal(createHash('sha256').update(bytes, 'latin1').digest('hex'), name, path);
    else if (path.startsWith('objects/') && path !== 'objects/store.json') scripts.push(path);
  }
  // The page's modules find each other by name: they lie together, under the sha256 of their list.
  assert.equal(new Set(scripts.map((path) => path.split('/')[1])).size, 1);
  assert.ok(scripts.some((path) => path.endsWith('/start.js')));
  for (const name of ['one', 'two']) {
    const whole = await ws.run(['verify', `course/${name}`, '--hash', hashes.get(name) ?? '']);
    assert.equal(whole.code, 0, whole.stderr);
  }
  const plain = await ws.run(['pack', 'one.yaml', '-o', 'plain']);
  assert.equal(plain.code, 0, plain.stderr);
  const size = (folder: string): number => [...ws.files(folder).values()].reduce((sum, { length }) => sum + length, 0);
  assert.ok(size('course') < 1.05 * size('plain'), `${size('course')} and ${size('plain')} bytes`);
});

test('the same workspace gives the same site and the same objects', async () => {
  const before = ws.files('course');
  assert.equal(await pack('one'), hashes.get('one'));
  assert.deepEqual([...ws.files('course')], [...before]);
});

test('it runs in Node.js, and diff reads it', watchdog, async () => {
  for (const until of ['Python counts 3', 'hello from the store']) {
    const run = await ws.run(['run', 'course/one', '--until', until, '--for', '60s']);
    assert.equal(run.code, 0, run.stderr + run.stdout);
  }
  const diff = await ws.run(['diff', 'course/one', 'course/two']);
  assert.equal(diff.code, 1, diff.stderr);
  assert.match(diff.stdout, /site\.json: differs in .*`name`/);
});

function shows(page: Page, text: string): Promise<unknown> {
  return page.waitForFunction((wanted) => document.body?.textContent?.includes(wanted), text, patience);
}

async function runs(page: Page): Promise<void> {
  await shows(page, 'Python counts 2');
  await shows(page, 'hello from the store');
}

for (
  const [host, isolated, serviceWorkers] of [
    ['that isolates', true, 'block'],
    ['without headers', false, 'allow'],
    ['without headers or service workers', false, 'block'],
  ] as const
) {
  test(`it runs in Chromium below a path of a host ${host}`, watchdog, async () => {
    const served = await serveFolder(join(ws.root, 'course'), { isolated });
    const context = await browser.newContext({ serviceWorkers });
    try {
      const page = await context.newPage();
      await page.goto(`${served.url}one/`);
      await runs(page);
      const policy = await page.evaluate(() => document.querySelector('meta[http-equiv]')?.getAttribute('content') ?? '');
      assert.match(policy, /script-src 'self' 'wasm-unsafe-eval';/);
      await shows(page, 'from an image: False');
      await page.getByRole('button', { name: /about/i }).first().click();
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name: 'Licenses' }).first().click()]);
      assert.equal(download.suggestedFilename(), 'LICENSES.txt');
      assert.match(readFileSync(await download.path(), 'utf8'), /^What this site is made of/);
      await page.keyboard.press('Escape');
      await eventually('an image is kept', () => page.evaluate(async () => (await (await caches.open('ros2wasm-kept')).keys()).length > 0));
      await page.reload();
      await shows(page, 'from an image: True');
    } finally {
      await context.close();
      await served.close();
    }
  });
}

test('it is kept for visits without a network, with what it needs of the store', watchdog, async () => {
  const served = await serveFolder(join(ws.root, 'course'));
  const context = await browser.newContext();
  try {
    const page = await context.newPage();
    await page.goto(`${served.url}two/`);
    await page.waitForSelector('html[data-offline=kept]', { ...patience, state: 'attached' });
    await served.close();
    await page.reload();
    await runs(page);
    const scopes = await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).map(({ scope }) => scope));
    assert.deepEqual(scopes, [`${served.url}two/`]);
  } finally {
    await context.close();
    await served.close();
  }
});

// Guarantee, verified: an object of a store that is not what its name says is found by `verify` and refused by page and `run`
test('a changed object is refused', watchdog, async () => {
  cpSync(join(ws.root, 'course'), join(ws.root, 'changed'), { recursive: true });
  const { files } = JSON.parse(ws.read('changed/one/site.json').toString()) as { files: { path: string; sha256: string; }[]; };
  const program = files.find(({ path }) => path.endsWith('hello.wasm'))?.sha256 ?? '';
  appendFileSync(join(ws.root, `changed/objects/${program}.wasm`), '\0');
  const verified = await ws.run(['verify', 'changed/one']);
  assert.match(verified.stderr, /error\[R2W0650\]: `programs\/quick\/hello\.wasm`/);
  const run = await ws.run(['run', 'changed/one', '--for', '3s', '--until', 'hello from']);
  assert.match(run.stderr, /R2W0724/);
  const served = await serveFolder(join(ws.root, 'changed'), { isolated: true });
  const page = await browser.newPage();
  try {
    await page.goto(`${served.url}one/`);
    await shows(page, 'programs/quick/hello.wasm is not the file that the site was packed with');
  } finally {
    await page.close();
    await served.close();
  }
});

// Guarantee, verified: a link with the hash of an earlier pack opens that one, where packs share a store
test('what a site was before stays beside it, and links that name it lead there', watchdog, async () => {
  const earlier = hashes.get('two') ?? '';
  ws.write('two.yaml', manifest('two', 'The lab two as it is now'));
  const now = await pack('two');
  assert.notEqual(now, earlier);
  const folder = `course/two@${earlier.slice(0, 16)}`;
  const old = await ws.run(['verify', folder, '--hash', earlier]);
  assert.equal(old.code, 0, old.stderr);
  const served = await serveFolder(join(ws.root, 'course'), { isolated: true });
  const page = await browser.newPage();
  const visit = async (path: string): Promise<string> => {
    await page.goto('about:blank');
    await page.goto(`${served.url}${path}`);
    await runs(page);
    return new URL(page.url()).pathname.slice('/some/path/'.length);
  };
  try {
    assert.equal(await visit(`two/?nodes=count-1,hello-2#site=${earlier.slice(0, 16)}`), folder.slice('course/'.length) + '/');
    assert.match(page.url(), /\?nodes=count-1,hello-2#site=/);
    assert.equal(await visit(`two/#site=${now.slice(0, 16)}`), 'two/');
    assert.equal(await visit('two/#site=0123456789abcdef'), 'two/');
    assert.equal(await visit(`two@${earlier.slice(0, 16)}/#site=${now.slice(0, 16)}`), 'two/');
    assert.match(await page.title(), /^The lab two as it is now/);
  } finally {
    await page.close();
    await served.close();
  }
});

test('serve gives the store too', watchdog, async () => {
  await using served = await ServedSite.start([join(ws.root, 'course/one'), '--port', '0']);
  assert.match(served.url, /\/one\/$/);
  const page = await browser.newPage();
  await page.goto(served.url);
  await runs(page);
  await page.close();
  const verified = await ws.run(['verify', served.url, '--hash', hashes.get('one') ?? '']);
  assert.equal(verified.code, 0, verified.stderr);
  // The lab beside it is not asked for, and what proves the store is not an object.
  for (const path of ['two/', 'two/site.json', 'objects/store.json', 'objects/']) {
    assert.equal((await fetch(new URL(`../${path}`, served.url))).status, 404, path);
  }
});

test('serve lets an earlier pack run too', watchdog, async () => {
  await using served = await ServedSite.start([join(ws.root, 'course/two'), '--port', '0']);
  const page = await browser.newPage();
  await page.goto(new URL(`../two@${(hashes.get('two') ?? '').slice(0, 16)}/`, served.url).href);
  await runs(page);
  await page.close();
});

// Guarantee, hostile input: documents of a lab in a store that sites share: each lies with its site, whose service worker opens it
// without scripts
test('documents that a lab brings along lie with its site, not in the store', watchdog, async () => {
  ws.write('notes/picture.svg', '<svg xmlns="http://www.w3.org/2000/svg"><script>localStorage.setItem("owned", "1")</script></svg>\n');
  ws.write('notes/lab.md', '# Lab\n\n![a picture](picture.svg)\n');
  ws.write('three.yaml', `${manifest('three', 'The lab three')}ui:\n  text: notes/lab.md\n`);
  await pack('three');
  const files = [...ws.files('course').keys()];
  assert.deepEqual(files.filter((path) => path.startsWith('objects/') && /\.(?:svg|html?|xml)$/.test(path)), []);
  assert.equal(files.filter((path) => path.startsWith('three/') && path.endsWith('/picture.svg')).length, 1, files.join('\n'));
});

test('a store that cannot be shared is refused, and nothing is written', async () => {
  for (
    const [output, place] of [['lab', 'lab/objects'], ['course/objects/lab', 'course/objects'], ['lab.zip', 'objects'], ['lab', 'with space'], ['lab',
      'one.yaml']] as const
  ) {
    const packed = await ws.run(['pack', 'one.yaml', '-o', output, '--store', place]);
    assert.match(packed.stderr, /^error\[R2W0614\]: the site `\S+` cannot share the store/, `${output} ${place}: ${packed.stderr}`);
    assert.ok(!existsSync(join(ws.root, output)));
  }
});

// Guarantee, hostile input: a site.json that leads elsewhere than into a store of objects is refused by `verify`, `run` and page
test('a site.json with another store is refused', async () => {
  cpSync(join(ws.root, 'course'), join(ws.root, 'hostile'), { recursive: true });
  renameSync(join(ws.root, 'hostile/objects'), join(ws.root, 'hostile/o'));
  assert.equal(readdirSync(join(ws.root, 'hostile')).includes('o'), true);
  const text = readFileSync(join(ws.root, 'course/one/site.json'), 'utf8');
  for (const objects of ['/etc/', 'https://example.org/', '../.ssh/', '../../', 'objects/', '../a/../../', '../o']) {
    writeFileSync(join(ws.root, 'hostile/one/site.json'), text.replace('"../objects/"', JSON.stringify(objects)));
    assert.match((await ws.run(['verify', 'hostile/one'])).stderr, /error\[R2W0605\]/, objects);
    assert.match((await ws.run(['run', 'hostile/one', '--for', '1s'])).stderr, /error\[R2W0700\]: site\.json: site\.store/, objects);
  }
});
