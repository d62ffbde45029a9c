// The files of a site that the service worker caches, with a host and a cache of the test's own.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const scope = 'https://host/site/';
let code: string;

before(async () => {
  const entry = fileURLToPath(new URL('../../../runtime/site/session/service_worker.ts', import.meta.url));
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, write: false, format: 'iife', target: 'es2024' });
  code = outputFiles[0]!.text;
});

const sha256 = (text: string): string => createHash('sha256').update(text).digest('hex');

interface OpenPage {
  /** The site.json that it says it was opened with; undefined: it does not answer. */
  readonly list: string | undefined;
}

interface Asked {
  readonly text: string;
  readonly headers: Headers;
}

/** A host with a site, a browser's cache, and the service worker between them. */
class Stage {
  readonly files = new Map<string, string>();
  readonly pages = new Map<string, OpenPage>();
  /** Every page of the origin may write to it. */
  readonly cache = new Map<string, Response>();
  online = true;
  /** The status with which the host answers for site.json, with cookies and without; 0: it breaks the connection. */
  refuses = { cookies: 200, plain: 200 };
  /** The browser has room for no more. */
  full = false;
  private listeners = new Map<string, (event: unknown) => void>();

  constructor() {
    this.restart();
  }

  /** The browser has ended it, and what it knew is gone. */
  restart(): void {
    this.listeners = new Map();
    const addEventListener = (kind: string, listener: (event: unknown) => void): void => void this.listeners.set(kind, listener);
    const cache = {
      put: async (url: string, response: Response) => {
        if (this.full) throw new DOMException('no room', 'QuotaExceededError');
        this.cache.set(url, response);
      },
      match: async (url: string) => this.cache.get(url)?.clone(),
      keys: async () => [...this.cache.keys()].map((url) => ({ url })),
      delete: async (url: string) => this.cache.delete(url),
    };
    const host = async (asked: string | { readonly url: string; }, options: RequestInit = {}): Promise<Response> => {
      if (!this.online) throw new TypeError('no network');
      const url = typeof asked === 'string' ? asked : asked.url;
      assert.ok(url.startsWith(scope), url);
      const path = decodeURIComponent(url.slice(scope.length));
      const status = path === 'site.json' ? this.refuses[options.credentials === 'omit' ? 'plain' : 'cookies'] : 200;
      if (status === 0) throw new TypeError('the connection was reset');
      if (status !== 200) return new Response('', { status });
      const text = this.files.get(path === '' ? 'index.html' : path);
      const response = text === undefined ? new Response('', { status: 404 }) : new Response(text);
      Object.defineProperty(response, 'type', { value: 'basic' });
      return response;
    };
    const page = (id: string): unknown => {
      const open = this.pages.get(id);
      return open === undefined ? undefined : {
        id,
        postMessage: (_question: unknown, [port]: readonly MessagePort[]) => {
          if (open.list !== undefined) port?.postMessage(sha256(open.list));
          else port?.postMessage('nothing');
        },
      };
    };
    const clients = { matchAll: async () => [...this.pages.keys()].map(page), get: async (id: string) => page(id) };
    const start = new Function('self', 'caches', 'fetch', code);
    start({ registration: { scope }, clients, addEventListener }, { open: async () => cache }, host);
  }

  /** The response that a page gets. `opens`: it is a visit of the site, by the page of that id. */
  async ask(path: string, client = '', opens = false): Promise<Asked> {
    const { promise, resolve, reject } = Promise.withResolvers<Asked>();
    this.listeners.get('fetch')?.({
      request: { url: scope + path, method: 'GET', mode: opens ? 'navigate' : 'cors', cache: 'default' },
      clientId: opens ? '' : client,
      resultingClientId: opens ? client : '',
      waitUntil: () => undefined,
      respondWith: (answer: Promise<Response>) =>
        void answer.then(
          async (response) => resolve({ text: await response.text(), headers: response.headers }),
          reject,
        ),
    });
    return promise;
  }

  /** The host gets another version of the site; what is in `altered` comes otherwise than site.json says. */
  publish(files: Readonly<Record<string, string>>, altered: readonly string[] = []): void {
    this.files.clear();
    const named = Object.entries(files).map(([path, text]) => ({ path, sha256: sha256(text) }));
    for (const [path, text] of Object.entries(files)) this.files.set(path, altered.includes(path) ? `${text} altered` : text);
    this.files.set('site.json', JSON.stringify({ files: named }));
  }

  /** Sends the message `keep`, as the page does when it is idle. */
  keep(): Promise<unknown> {
    return new Promise((answer) => {
      this.listeners.get('message')?.({ data: 'keep', source: { id: '' }, ports: [{ postMessage: answer }], waitUntil: () => undefined });
    });
  }

  kept(): string[] {
    return [...this.cache.keys()].map((url) => url.slice(scope.length).replace(/\?sha256=.*/, '')).sort();
  }

  keeps(path: string, text: string): boolean {
    return this.cache.has(`${scope}${path}?sha256=${sha256(text)}`);
  }
}

test('a file that the host alters is not kept; all others are, and none of older versions', async () => {
  const stage = new Stage();
  stage.publish({ 'a.js': 'a1', 'b.js': 'b1', 'c.js': 'c1', 'd.js': 'd' });
  assert.equal(await stage.keep(), 'kept');
  assert.deepEqual(stage.kept(), ['a.js', 'b.js', 'c.js', 'd.js', 'site.json']);
  stage.publish({ 'a.js': 'a2', 'b.js': 'b2', 'c.js': 'c2', 'd.js': 'd' }, ['b.js']);
  assert.equal(await stage.keep(), 'failed');
  assert.deepEqual(stage.kept(), ['a.js', 'c.js', 'd.js', 'site.json']);
  assert.ok(stage.keeps('a.js', 'a2') && stage.keeps('c.js', 'c2') && stage.keeps('d.js', 'd'));
});

test('a file that does not come is no reason to keep old ones', async () => {
  const stage = new Stage();
  stage.publish({ 'a.js': 'a1', 'b.js': 'b1' });
  await stage.keep();
  stage.publish({ 'a.js': 'a2', 'b.js': 'b2' });
  stage.files.delete('a.js');
  assert.equal(await stage.keep(), 'failed');
  assert.deepEqual(stage.kept(), ['b.js', 'site.json']);
});

/** As somebody else of the origin does it: under the names that the service worker has. */
function plant(stage: Stage, path: string, text: string, planted: string): void {
  stage.cache.set(`${scope}${path}?sha256=${sha256(text)}`, new Response(planted));
}

/** The list and the file of a hostile page, as the service worker would cache them. */
function plantSite(stage: Stage): void {
  const evil = { files: [{ path: 'index.html', sha256: sha256('evil') }, { path: 'a.js', sha256: sha256('evil') }] };
  stage.cache.set(`${scope}site.json`, new Response(JSON.stringify(evil)));
  plant(stage, 'index.html', 'evil', 'evil');
  plant(stage, 'a.js', 'evil', 'evil');
}

// Guarantee, hostile input: cookies with which a page of the origin makes the host refuse a neighbour's site.json, and a full disk, do not make the service worker believe a planted list
test('a host that answers with an error, or breaks the connection, is a network', async () => {
  for (
    const refuses of [
      { cookies: 431, plain: 200 },
      { cookies: 0, plain: 200 },
      { cookies: 431, plain: 431 },
      { cookies: 503, plain: 0 },
    ]
  ) {
    const stage = new Stage();
    stage.publish({ 'index.html': 'the page', 'a.js': 'a1' });
    plantSite(stage);
    stage.refuses = refuses;
    assert.equal((await stage.ask('', 'one', true)).text, 'the page', JSON.stringify(refuses));
    assert.equal((await stage.ask('a.js', 'one')).text, 'a1', JSON.stringify(refuses));
    const list = (await stage.ask('site.json', 'one')).text;
    assert.equal(list, refuses.plain === 200 ? stage.files.get('site.json') : '', JSON.stringify(refuses));
    // An error of the host is not remembered.
    stage.refuses = { cookies: 200, plain: 200 };
    assert.equal((await stage.ask('site.json')).text, stage.files.get('site.json'));
  }
});

test('a file has one address, however the page and a link write it, and none on another host', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'the page', 'text/a@b, c+d.png': 'picture', '\t/\tother/x': 'elsewhere' });
  assert.equal(await stage.keep(), 'kept');
  await stage.ask('', 'one', true);
  stage.online = false;
  for (const address of ['text/a%40b%2C%20c%2Bd.png', 'text/a@b,%20c+d.png']) {
    assert.equal((await stage.ask(address, 'one')).text, 'picture', address);
  }
  assert.deepEqual([...stage.cache.keys()].filter((url) => !url.startsWith(scope)), []);
});

// Guarantee, hostile input: HTML and SVG files of a lab that are opened in a tab run no script and have no part in the origin
test('documents of a lab are in a sandbox, the page itself is not', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'the page', 'share/lab/evil.html': 'evil', 'a.js': 'a1' });
  const policy = async (path: string, opens: boolean): Promise<string> => {
    const { headers } = await stage.ask(path, 'one', opens);
    return headers.get('content-security-policy') ?? '';
  };
  for (const round of ['from the host', 'from the cache']) {
    const usual = await policy('', true);
    assert.notEqual(usual, '', round);
    assert.equal(await policy('index.html', true), usual, round);
    assert.equal(await policy('a.js', false), usual, round);
    assert.equal(await policy('share/lab/evil.html', true), `sandbox; ${usual}`, round);
    // Other addresses by which a host gives the same files, and folders' index.html.
    for (const other of ['share/lab/', 'share/lab', 'share/lab/evil', 'SHARE/lab/', '/share/lab/', 'share%2Flab/', 'other/..%2fshare/lab/', 'share%5Clab/']) {
      assert.equal(await policy(other, true), `sandbox; ${usual}`, `${other} ${round}`);
    }
    // The page of another site in a folder of its own.
    assert.equal(await policy('lab2/', true), usual, round);
    await stage.keep();
  }
});

test('without room in the cache the page comes from the host', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'the page', 'a.js': 'a1' });
  plantSite(stage);
  stage.full = true;
  assert.equal((await stage.ask('', 'one', true)).text, 'the page');
  assert.equal((await stage.ask('a.js', 'one')).text, 'a1');
  assert.equal((await stage.ask('site.json', 'one')).text, stage.files.get('site.json'));
});

// Guarantee, hostile input: what another page of the origin writes into the cache of a site is never run while there is a network: bytes are hashed when they are taken out
test('what another one of the origin put into the cache is dropped and fetched anew', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'page', 'a.js': 'a' });
  plant(stage, 'index.html', 'page', 'mine');
  plant(stage, 'a.js', 'a', 'mine');
  assert.equal((await stage.ask('', 'p', true)).text, 'page');
  assert.equal((await stage.ask('a.js', 'p')).text, 'a');
  assert.equal(await stage.keep(), 'kept');
  // Between two answers, too: what was right before is hashed again.
  plant(stage, 'a.js', 'a', 'mine');
  assert.equal((await stage.ask('a.js', 'p')).text, 'a');
  // Without a network there is no file rather than another one.
  plant(stage, 'a.js', 'a', 'mine');
  stage.online = false;
  await assert.rejects(stage.ask('a.js', 'p'));
});

test('only the bytes of a cached file count, not the headers that lie with them', async () => {
  const stage = new Stage();
  stage.publish({ 'a.js': 'a' });
  await stage.ask('', 'p', true);
  const headers = { 'content-type': 'text/plain', refresh: '0;url=/other/', link: '</other.css>; rel=stylesheet' };
  stage.cache.set(`${scope}a.js?sha256=${sha256('a')}`, new Response('a', { headers }));
  const { headers: given } = await stage.ask('a.js', 'p');
  assert.equal(given.get('content-type'), 'text/javascript');
  assert.equal(given.get('refresh'), null);
  assert.equal(given.get('link'), null);
});

const lists = (files: Readonly<Record<string, string>>): string =>
  JSON.stringify({ files: Object.entries(files).map(([path, text]) => ({ path, sha256: sha256(text) })) });

test('a page goes on as it was opened after the site was packed anew and the service worker began again', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'page', 'a.js': 'a1' });
  await stage.ask('', 'p', true);
  const list = (await stage.ask('site.json', 'p')).text;
  stage.pages.set('p', { list });
  await stage.keep();
  stage.publish({ 'index.html': 'page', 'a.js': 'a2' });
  stage.restart();
  assert.equal((await stage.ask('a.js', 'p')).text, 'a1');
  assert.equal((await stage.ask('site.json', 'p')).text, list);
  // Without a network the page's word is enough.
  stage.online = false;
  stage.restart();
  assert.equal((await stage.ask('a.js', 'p')).text, 'a1');
  // The next visit has the new one.
  stage.online = true;
  await stage.ask('', 'q', true);
  assert.equal((await stage.ask('a.js', 'q')).text, 'a2');
});

test('a list in the cache is believed only with the host or the open page', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'page', 'a.js': 'a' });
  await stage.ask('', 'p', true);
  const list = (await stage.ask('site.json', 'p')).text;
  await stage.keep();
  const planted = lists({ 'index.html': 'mine', 'a.js': 'mine' });
  const attack = (): void => {
    stage.cache.set(`${scope}site.json`, new Response(planted));
    stage.cache.set(`${scope}site.json?client=p`, new Response(planted));
    plant(stage, 'a.js', 'mine', 'mine');
    plant(stage, 'index.html', 'mine', 'mine');
  };
  for (const page of [{ list }, { list: undefined }]) {
    stage.pages.set('p', page);
    attack();
    stage.restart();
    assert.equal((await stage.ask('a.js', 'p')).text, 'a');
    assert.equal((await stage.ask('site.json', 'p')).text, list);
    assert.equal((await stage.ask('a.js', 'worker')).text, 'a');
    attack();
    assert.equal((await stage.ask('', 'q', true)).text, 'page');
    assert.equal((await stage.ask('site.json', 'q')).text, list);
  }
});

test('two lives of the service worker at once, as when it is updated, answer alike', async () => {
  const stage = new Stage();
  stage.publish({ 'index.html': 'page', 'a.js': 'a1' });
  await stage.ask('', 'p', true);
  const early = stage.ask('a.js', 'p');
  const keeping = stage.keep();
  stage.publish({ 'index.html': 'page', 'a.js': 'a2' });
  stage.restart();
  stage.pages.set('p', { list: lists({ 'index.html': 'page', 'a.js': 'a1' }) });
  const late = await stage.ask('', 'q', true);
  assert.equal(late.text, 'page');
  assert.match((await early).text, /^a[12]$/);
  await keeping;
  // Whatever came meanwhile: under a hash lie the bytes of that hash.
  for (const [url, response] of stage.cache) {
    const wanted = new URL(url).searchParams.get('sha256');
    if (wanted !== null) assert.equal(sha256(await response.clone().text()), wanted);
  }
  assert.equal((await stage.ask('a.js', 'q')).text, 'a2');
});
