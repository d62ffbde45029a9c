// Example 01 in Chromium on every kind of host: with isolation headers, without, below a path, offline,
// and where no service worker may run. Each time a message is heard, nothing leaves the site, and a
// node's worker can neither run text as code nor reach another host.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { type IncomingMessage, createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import type { Duplex } from 'node:stream';
import { after, before, describe, test } from 'node:test';
import { type Browser, type BrowserContextOptions, type Page, chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { packExample } from '../support/example_site.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';
import { Scratch, ServedSite } from '../support/served_site.ts';

const WATCHDOG = { timeout: 600_000 };
const HEARD_MS = 60_000;
const CHANNEL = 'ros2wasm-probe';

const scratch = new Scratch();
let browser: Browser;
let gate: Gate;
let foreign: StaticServer;
let site: string;
let probed: string;

/** The results of a worker that tries forbidden actions. It tries them all at once: a node's worker soon blocks. */
interface Probe {
  readonly eval: string;
  readonly construct: string;
  readonly request: string;
}

/** The script that tries it and tells the page. `mark` is what a host that is reached would see. */
function probeScript(foreignUrl: string, mark: string): string {
  return `(() => {
  const attempt = (task) => { try { task(); return 'allowed'; } catch (error) { return error.name; } };
  void fetch('${foreignUrl}${mark}-fetch', { mode: 'no-cors' }).catch(() => {});
  new BroadcastChannel('${CHANNEL}').postMessage({
    eval: attempt(() => eval('1')),
    construct: attempt(() => new Function('return 1')()),
    request: attempt(() => {
      const request = new XMLHttpRequest();
      request.open('GET', '${foreignUrl}${mark}-request', false);
      request.send();
    }),
  });
})();
`;
}

/** A copy of the site whose node workers run the probe first, as its list of files says. */
function probedCopy(from: string, foreignUrl: string): string {
  const folder = join(scratch.path, 'probed');
  cpSync(from, folder, { recursive: true });
  const name = 'node_worker.js';
  const script = probeScript(foreignUrl, 'node') + readFileSync(join(folder, name), 'utf8');
  writeFileSync(join(folder, name), script);
  const list = join(folder, 'site.json');
  const json = JSON.parse(readFileSync(list, 'utf8')) as { files: { path: string; size: number; sha256: string; }[]; };
  const entry = json.files.find(({ path }) => path === name) ?? assert.fail();
  entry.size = Buffer.byteLength(script);
  entry.sha256 = createHash('sha256').update(script).digest('hex');
  writeFileSync(list, JSON.stringify(json));
  return folder;
}

/** Chromium asks its maker for updates and the like by itself; pages ask for fonts and scripts there. */
const BROWSERS_OWN = /(?<!fonts|ajax|storage|maps)\.(google|googleapis|gvt1|gstatic)\.com$/;

/** The browser's only way to other machines: it notes who is asked for and lets nobody through. */
interface Gate {
  readonly port: number;
  readonly asked: string[];
  close(): Promise<void>;
}

async function closedGate(): Promise<Gate> {
  const asked: string[] = [];
  const note = (url: string): void => {
    const { hostname } = new URL(url.includes('://') ? url : `https://${url}`);
    if (!BROWSERS_OWN.test(hostname)) asked.push(hostname);
  };
  const server = createServer((request, response) => {
    note(request.url ?? '');
    response.writeHead(502).end();
  });
  server.on('connect', (request: IncomingMessage, socket: Duplex) => {
    note(request.url ?? '');
    socket.end('HTTP/1.1 502 Bad Gateway\r\n\r\n');
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    port: (server.address() as AddressInfo).port,
    asked,
    close: () => new Promise((resolve) => server.close(() => resolve())),
  };
}

before(async () => {
  foreign = await serveFolder('/nowhere');
  site = await packExample(scratch);
  probed = probedCopy(site, foreign.url);
  gate = await closedGate();
  browser = await chromium.launch(
    chromiumOptions([`--proxy-server=http://127.0.0.1:${gate.port}`]),
  );
}, WATCHDOG);

after(async () => {
  await browser.close();
  await gate.close();
  await foreign.close();
  scratch[Symbol.dispose]();
});

interface Visit {
  readonly page: Page;
  /** Addresses that the page, its workers and its service worker asked for. */
  readonly requests: string[];
  /** How often the page was loaded. */
  readonly loads: () => number;
  readonly [Symbol.asyncDispose]: () => Promise<void>;
}

async function visit(options: BrowserContextOptions = {}): Promise<Visit> {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const requests: string[] = [];
  let loads = 0;
  context.on('request', (request) => requests.push(request.url()));
  // A page that is loaded again at once may never be complete the first time.
  page.on('request', (request) => {
    if (request.isNavigationRequest() && request.frame() === page.mainFrame()) loads += 1;
  });
  await page.addInitScript((channel) => {
    const found: unknown[] = [];
    Object.assign(globalThis, { found });
    new BroadcastChannel(channel).onmessage = (event) => found.push(event.data);
  }, CHANNEL);
  return { page, requests, loads: () => loads, [Symbol.asyncDispose]: () => context.close() };
}

async function heard(page: Page): Promise<void> {
  await page.waitForFunction(
    () => /I heard: 'Hello, world! \d+'/.test(document.body?.innerText ?? ''),
    null,
    { timeout: HEARD_MS },
  );
}

function isolated(page: Page): Promise<boolean> {
  return page.evaluate(() => crossOriginIsolated);
}

function assertNothingLeft(requests: readonly string[], base: string): void {
  const outside = requests.filter((url) => !url.startsWith(base) && !url.startsWith('blob:'));
  assert.deepEqual(outside, []);
  assert.deepEqual(gate.asked, []);
  assert.ok(requests.length > 0);
}

async function probes(page: Page, count: number): Promise<Probe[]> {
  await page.waitForFunction(
    (wanted) => (globalThis as { found?: unknown[]; }).found?.length === wanted,
    count,
    { timeout: HEARD_MS },
  );
  return page.evaluate(() => (globalThis as unknown as { found: Probe[]; }).found);
}

const REFUSED: Probe = { eval: 'EvalError', construct: 'EvalError', request: 'NetworkError' };

describe('a message is heard and nothing leaves the site', WATCHDOG, () => {
  test('with the headers: isolated at once', async () => {
    await using server = await ServedSite.start([site, '--port', '0']);
    await using visitor = await visit();
    await visitor.page.goto(server.url);
    await heard(visitor.page);
    assert.equal(await isolated(visitor.page), true);
    assert.equal(visitor.loads(), 1);
    assertNothingLeft(visitor.requests, server.url);
  });

  test('without the headers: isolated by the service worker after one reload', async () => {
    await using server = await ServedSite.start([site, '--port', '0', '--no-isolation']);
    await using visitor = await visit();
    await visitor.page.goto(server.url);
    await heard(visitor.page);
    assert.equal(await isolated(visitor.page), true);
    assert.equal(visitor.loads(), 2);
    assertNothingLeft(visitor.requests, server.url);
    await visitor.page.reload();
    await heard(visitor.page);
    assert.equal(visitor.loads(), 3);
  });

  test('below a path of a host without headers', async () => {
    const host = await serveFolder(site);
    try {
      await using visitor = await visit();
      await visitor.page.goto(host.url);
      await heard(visitor.page);
      assert.equal(await isolated(visitor.page), true);
      assertNothingLeft(visitor.requests, host.url);
    } finally {
      await host.close();
    }
  });

  test('offline after the first visit', async () => {
    await using visitor = await visit();
    let url = '';
    {
      await using server = await ServedSite.start([site, '--port', '0', '--no-isolation']);
      url = server.url;
      await visitor.page.goto(url);
      await heard(visitor.page);
      await visitor.page.waitForFunction(
        () => document.documentElement.dataset['offline'] === 'kept',
        null,
        { timeout: HEARD_MS },
      );
    }
    await assert.rejects(fetch(url), 'the server is gone');
    await visitor.page.goto(url);
    await heard(visitor.page);
    assert.equal(await isolated(visitor.page), true);
  });

  test('where no service worker may run: message ports', async () => {
    await using server = await ServedSite.start([site, '--port', '0', '--no-isolation']);
    await using visitor = await visit({ serviceWorkers: 'block' });
    await visitor.page.goto(server.url);
    await heard(visitor.page);
    assert.equal(await isolated(visitor.page), false);
    assert.equal(visitor.loads(), 1);
    assertNothingLeft(visitor.requests, server.url);
  });

  test('another site on the same port is shown as it is', async () => {
    await using visitor = await visit();
    let url = '';
    {
      await using server = await ServedSite.start([site, '--port', '0', '--no-isolation']);
      url = server.url;
      await visitor.page.goto(url);
      await heard(visitor.page);
    }
    scratch.file('other/site/index.html', '<!doctype html><html><body>another site</body></html>');
    scratch.file('other/site/site.json', '{"schema":1,"files":[]}');
    const other = [join(scratch.path, 'other/site'), '--port', new URL(url).port];
    await using server = await ServedSite.start(other);
    await visitor.page.goto(server.url);
    await visitor.page.getByText('another site').waitFor();
  });
});

describe('what a node may not do', WATCHDOG, () => {
  const hosts: readonly [string, string[], BrowserContextOptions, boolean][] = [
    ['on a host with headers', [], {}, true],
    ['on a host without headers', ['--no-isolation'], {}, true],
    ['where no service worker may run', ['--no-isolation'], { serviceWorkers: 'block' }, false],
  ];
  for (const [name, flags, options, shared] of hosts) {
    test(name, async () => {
      await using server = await ServedSite.start([probed, '--port', '0', ...flags]);
      await using visitor = await visit(options);
      await visitor.page.goto(server.url);
      await heard(visitor.page);
      assert.equal(await isolated(visitor.page), shared);
      assert.deepEqual(await probes(visitor.page, 2), [REFUSED, REFUSED]);
      assert.deepEqual(foreign.requests.filter((path) => path.includes('node-')), []);
    });
  }

  test('without the policy the same is allowed, so that these tests can fail', async () => {
    scratch.file('plain/site/index.html', '<!doctype html><script src="start.js"></script>');
    scratch.file('plain/site/start.js', "new Worker('probe.js');");
    scratch.file('plain/site/probe.js', probeScript(foreign.url, 'plain'));
    // "ros2wasm serve" sends the policy with each page: another host does not.
    const host = await serveFolder(join(scratch.path, 'plain/site'));
    await using visitor = await visit();
    await visitor.page.goto(host.url);
    // The foreign host does not allow its answer to be read, but it was asked.
    const found = { eval: 'allowed', construct: 'allowed', request: 'NetworkError' };
    assert.deepEqual(await probes(visitor.page, 1), [found]);
    // The gate sees what goes to other machines.
    await visitor.page.goto('http://elsewhere.invalid/').catch(() => undefined);
    assert.deepEqual(gate.asked, ['elsewhere.invalid']);
    assert.ok(foreign.requests.some((path) => path.includes('plain-request')));
    await host.close();
  });
});
