// `ros2wasm pack -o NAME.html`: a site in one page, opened from disk in Chromium, compiled and Python nodes; that it is the
// same page each time, that its policy holds, and that what was changed in it is found and does not run.
import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { deflateRawSync, inflateRawSync } from 'node:zlib';
import { type Browser, type Page, chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { Scratch, runCli } from '../support/served_site.ts';

const WATCHDOG = { timeout: 600_000 };
const EXAMPLES = join(import.meta.dirname, '../../../examples');

const scratch = new Scratch();
let browser: Browser;
let file: string;

async function pack(example: string, name: string): Promise<string> {
  const workspace = join(scratch.path, example);
  cpSync(join(EXAMPLES, example), workspace, { recursive: true });
  const packed = await runCli(['pack', join(workspace, 'workspace.yaml'), '-o', join(scratch.path, name)]);
  assert.equal(packed.code, 0, packed.errors);
  return join(scratch.path, name);
}

before(async () => {
  browser = await chromium.launch(chromiumOptions());
  file = await pack('01_talker_listener', 'site.html');
}, WATCHDOG);

after(async () => {
  await browser.close();
  scratch[Symbol.dispose]();
});

/** Opens it from disk; what it asks of any network, and what went wrong in it. */
async function open(path: string): Promise<{ page: Page; asked: string[]; wrong: string[]; }> {
  const page = await browser.newPage();
  const asked: string[] = [];
  const wrong: string[] = [];
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && request.url() !== pathToFileURL(path).href) asked.push(request.url());
  });
  page.on('pageerror', (error) => wrong.push(String(error)));
  page.on('console', (message) => {
    if (message.type() === 'error') wrong.push(message.text());
  });
  await page.goto(pathToFileURL(path).href);
  return { page, asked, wrong };
}

async function shows(page: Page, text: string): Promise<void> {
  await page.waitForFunction((wanted) => (document.body?.textContent ?? '').includes(wanted), text, { timeout: 120_000 });
}

// Guarantee, same bytes: as one page that runs from a double click: `pack -o NAME.html`
test('the same site is the same page, which says which site it is', WATCHDOG, async () => {
  const again = await pack('01_talker_listener', 'again.html');
  assert.deepEqual(readFileSync(again), readFileSync(file));
  const folder = await pack('01_talker_listener', 'folder');
  const verified = await runCli(['verify', folder]);
  const [, hash] = /sha256 ([0-9a-f]{64})/.exec(verified.output) ?? assert.fail(verified.errors);
  assert.ok(readFileSync(file, 'latin1').startsWith(`<!doctype html>\n<!-- site of ros2wasm 0.1.0, sha256 ${hash} -->\n`));
});

test('compiled nodes run from file:, on message ports, and nothing is asked of any network or folder', WATCHDOG, async () => {
  const { page, asked, wrong } = await open(file);
  await shows(page, "I heard: 'Hello, world! 3'");
  await shows(page, '4 of 4 checks passed');
  await shows(page, 'Message ports');
  // A part that is loaded when it is opened, with its styles and its sha256 of the site.
  await page.getByRole('button', { name: /about/i }).first().click();
  await page.getByRole('link', { name: 'Licenses' }).first().waitFor();
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name: 'Licenses' }).first().click()]);
  assert.equal(download.suggestedFilename(), 'LICENSES.txt');
  assert.deepEqual(asked, []);
  assert.deepEqual(wrong, []);
  await page.close();
});

test('Python nodes run from file:', WATCHDOG, async () => {
  const { page, asked, wrong } = await open(await pack('07_python', 'python.html'));
  await shows(page, "I heard: 'Good morning 3");
  assert.deepEqual(asked, []);
  assert.deepEqual(wrong, []);
  await page.close();
});

// Guarantee, hostile input: the policy of a site in one page: no text runs as code, and no host is reached, from page or worker
test('its policy holds: no text becomes code, and no host is reached, from the page or from a worker', WATCHDOG, async () => {
  const reached: string[] = [];
  const host = createServer((request, response) => {
    reached.push(request.url ?? '');
    response.writeHead(200, { 'access-control-allow-origin': '*' }).end('{}');
  });
  await new Promise<void>((listening) => host.listen(0, '127.0.0.1', listening));
  const url = `http://127.0.0.1:${(host.address() as AddressInfo).port}/`;
  const { page } = await open(file);
  await shows(page, 'I heard:');
  await page.addScriptTag({ content: "globalThis.owned = 'inline'" }).catch(() => undefined);
  const found = await page.evaluate(async (address) => {
    document.body.insertAdjacentHTML('beforeend', '<img src=x onerror="globalThis.owned = \'handler\'"><style>body{color:red}</style>');
    const tried = async (task: () => unknown): Promise<string> => {
      try {
        await task();
        return 'allowed';
      } catch (error) {
        return (error as Error).name;
      }
    };
    const script = `onmessage = async () => {
      const tried = async (task) => { try { await task(); return 'allowed'; } catch (error) { return error.name; } };
      postMessage([await tried(() => fetch('${address}worker')), await tried(() => eval('1'))]);
    }`;
    const worker = new Worker(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));
    const inWorker = await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => resolve(data);
      worker.onerror = reject;
      worker.postMessage('go');
    });
    return {
      page: [await tried(() => fetch(`${address}page`)), await tried(() => new Function('return 1')())],
      inWorker,
      owned: (globalThis as { owned?: string; }).owned,
    };
  }, url);
  assert.deepEqual(found, { page: ['TypeError', 'EvalError'], inWorker: ['TypeError', 'EvalError'], owned: undefined });
  assert.deepEqual(reached, []);
  await page.close();
  await new Promise((closed) => host.close(closed));
});

function changed(name: string, change: (page: string) => string): string {
  const page = readFileSync(file, 'latin1');
  const other = change(page);
  assert.notEqual(other, page);
  const path = join(scratch.path, name);
  writeFileSync(path, other, 'latin1');
  return path;
}

/** The page with other bytes in one of its files. */
function changedFile(name: string, path: string, change: (text: string) => string): string {
  const block = new RegExp(`(data-path="${path}">)([^<]*)`);
  return changed(name, (page) =>
    page.replace(block, (_, mark: string, text: string) => {
      const bytes = inflateRawSync(Buffer.from(text, 'base64')).toString('latin1');
      return mark + deflateRawSync(Buffer.from(change(bytes), 'latin1')).toString('base64');
    }));
}

// Guarantee, verified: a site in one page: `verify` reads each file and what stands around them, and the page runs none that is changed
test('what was changed in the page is found by verify, and a changed script or program does not run', WATCHDOG, async () => {
  const whole = await runCli(['verify', file]);
  assert.equal(whole.code, 0, whole.errors);
  const script = changedFile('script.html', 'start.js', (text) => `globalThis.owned = 1;${text}`);
  const program = changedFile('program.html', 'programs/tutorial_talker/talker.wasm',
    (text) => text.slice(0, -1) + String.fromCharCode(text.charCodeAt(text.length - 1) ^ 1));
  for (const [path, of] of [[script, 'start\\.js'], [program, 'programs/tutorial_talker/talker\\.wasm']] as const) {
    const found = await runCli(['verify', path]);
    assert.equal(found.code, 1);
    assert.match(found.errors, new RegExp(`error\\[R2W0650\\]: \`${of}\` is not the file`));
    const { page } = await open(path);
    await shows(page, 'R2W0724');
    assert.equal(await page.evaluate(() => (globalThis as { owned?: number; }).owned), undefined);
    await page.close();
  }
  for (
    const change of [
      (page: string) => page.replace('-->', '--><script>alert(1)</script><!-- -->'),
      (page: string) => page.replace("default-src 'none'", 'default-src *'),
      (page: string) => page.replace('</body>', '<script>alert(1)</script></body>'),
    ]
  ) {
    const found = await runCli(['verify', changed('around.html', change)]);
    assert.equal(found.code, 1);
    assert.match(found.errors, /error\[R2W0650\]: `around\.html` .*\n {3}= why: what stands around the site's files is not its own/);
  }
  const damaged = await runCli(['verify', changed('damaged.html', (page) => page.replace(/(data-path="site\.json">)..../, '$1!!!!'))]);
  assert.match(damaged.errors, /error\[R2W0202\]/);
  const none = await runCli(['verify', scratch.file('letter.html', '<!doctype html>\n<p>a letter')]);
  assert.equal(none.code, 1);
  assert.match(none.errors, /error\[R2W0605\]/);
});

// Guarantee, same bytes: with the last archive or page of it lying in a package
test('only its own pages are replaced, and a site in one file is not a source of the package that it lies in', WATCHDOG, async () => {
  const letter = scratch.file('kept.html', '<!doctype html>\n<p>a letter to be kept');
  const workspace = join(scratch.path, 'own');
  cpSync(join(EXAMPLES, '01_talker_listener'), workspace, { recursive: true });
  const refused = await runCli(['pack', workspace, '-o', letter]);
  assert.equal(refused.code, 1);
  assert.match(refused.errors, /error\[R2W0601\]/);
  assert.equal(readFileSync(letter, 'utf8'), '<!doctype html>\n<p>a letter to be kept');
  for (const name of ['site.html', 'site.zip']) {
    const place = join(workspace, 'src/tutorial_talker', name);
    const first = await runCli(['pack', workspace, '-o', place]);
    assert.equal(first.code, 0, first.errors);
    const bytes = readFileSync(place);
    const second = await runCli(['pack', workspace, '-o', place]);
    assert.equal(second.code, 0, second.errors);
    assert.match(second.errors, /nothing to build/);
    assert.deepEqual(readFileSync(place), bytes);
  }
});
