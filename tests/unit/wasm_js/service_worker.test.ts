// What the service worker keeps of a site, with a host and a cache of the test's own.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const scope = 'https://host/site/';
let code: string;

before(async () => {
  const entry = fileURLToPath(new URL('../../../runtime/wasm_js/service_worker.ts', import.meta.url));
  const { outputFiles } = await build({ entryPoints: [entry], bundle: true, write: false, format: 'iife', target: 'es2024' });
  code = outputFiles[0]!.text;
});

const sha256 = (text: string): string => createHash('sha256').update(text).digest('hex');

/** A host with a site, a browser's cache, and the service worker between them. */
class Stage {
  readonly files = new Map<string, string>();
  private readonly cache = new Map<string, Response>();
  private readonly listeners = new Map<string, (event: unknown) => void>();

  constructor() {
    const addEventListener = (kind: string, listener: (event: unknown) => void): void => void this.listeners.set(kind, listener);
    const cache = {
      put: async (url: string, response: Response) => void this.cache.set(url, response),
      match: async (url: string) => this.cache.get(url)?.clone(),
      keys: async () => [...this.cache.keys()].map((url) => ({ url })),
      delete: async (url: string) => this.cache.delete(url),
    };
    const host = async (url: string): Promise<Response> => {
      const text = this.files.get(url.slice(scope.length));
      return text === undefined ? new Response('', { status: 404 }) : new Response(text);
    };
    const start = new Function('self', 'caches', 'fetch', code);
    start({ registration: { scope }, clients: { matchAll: async () => [] }, addEventListener }, { open: async () => cache }, host);
  }

  /** The host gets another version of the site; what is in `altered` comes otherwise than site.json says. */
  publish(files: Readonly<Record<string, string>>, altered: readonly string[] = []): void {
    this.files.clear();
    const named = Object.entries(files).map(([path, text]) => ({ path, sha256: sha256(text) }));
    for (const [path, text] of Object.entries(files)) this.files.set(path, altered.includes(path) ? `${text} altered` : text);
    this.files.set('site.json', JSON.stringify({ files: named }));
  }

  /** What the page does when it is idle. */
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
