// The site's service worker. Adds the headers that shared memory needs and the site's Content-Security-Policy to every
// response, worker scripts too; keeps the site for visits without a network, by content: site.json names the sha256 of
// each file, and a file is taken from the cache only under the hash that a site.json gives it: for a page that is open the one
// that it was opened with, so that it goes on as it is when the site is packed anew, and the newest one for the next visit.

import { type ListedPlace, placesOf, readStore } from './site_places.ts';

const scope = self as unknown as ServiceWorkerGlobalScope;
const cacheName = `ros2wasm ${scope.registration.scope}`;

export const contentSecurityPolicy = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
  + "img-src 'self' blob: data:; connect-src 'self'; worker-src 'self' blob:; manifest-src 'self'; base-uri 'none'; form-action 'none'";

const headers: readonly (readonly [string, string])[] = [
  ['Cross-Origin-Opener-Policy', 'same-origin'],
  ['Cross-Origin-Embedder-Policy', 'require-corp'],
  ['Cross-Origin-Resource-Policy', 'same-origin'],
  ['Content-Security-Policy', contentSecurityPolicy],
  ['X-Content-Type-Options', 'nosniff'],
];

/** Absolute URL of a file, or of a part of one -> its sha256, by the newest site.json. */
type Manifest = ReadonlyMap<string, string>;

function withHeaders(response: Response): Response {
  if (response.type === 'opaque' || response.type === 'error' || response.status === 0) return response;
  const all = new Headers(response.headers);
  for (const [name, value] of headers) all.set(name, value);
  const bodiless = response.status === 204 || response.status === 304;
  return new Response(bodiless ? null : response.body, { status: response.status, statusText: response.statusText, headers: all });
}

function siteUrl(): string {
  return new URL('site.json', scope.registration.scope).href;
}

function parseManifest(text: string): Manifest {
  const map = new Map<string, string>();
  try {
    const site = JSON.parse(text) as { store?: unknown; files?: Partial<ListedPlace>[] };
    const store = readStore(site.store);
    for (const { path, sha256, ...rest } of site.files ?? []) {
      if (typeof path !== 'string' || typeof sha256 !== 'string' || sha256 === '') continue;
      for (const place of placesOf({ path, sha256, ...rest }, store)) {
        map.set(new URL(place.at, scope.registration.scope).href, place.sha256);
      }
    }
  } catch {
    // A site.json that cannot be read names no files: everything comes from the network.
  }
  return map;
}

let manifest: Promise<Manifest> | undefined;

/** The newest site.json: from the network, without it from the cache. Renews the manifest. */
async function freshSite(): Promise<Response> {
  const cache = await caches.open(cacheName);
  try {
    const response = await fetch(siteUrl(), { cache: 'no-cache' });
    if (response.ok) {
      const text = await response.clone().text();
      manifest = Promise.resolve(parseManifest(text));
      await cache.put(siteUrl(), response.clone());
    }
    return response;
  } catch (error) {
    const kept = await cache.match(siteUrl());
    if (kept === undefined) throw error;
    manifest = Promise.resolve(parseManifest(await kept.clone().text()));
    return kept;
  }
}

/** Where the site.json lies that a page was opened with. */
function ownSiteUrl(client: string): string {
  return `${siteUrl()}?client=${encodeURIComponent(client)}`;
}

/** The newest site.json is that page's from now on. */
async function remember(client: string): Promise<void> {
  const cache = await caches.open(cacheName);
  const newest = await cache.match(siteUrl());
  if (client !== '' && newest !== undefined) await cache.put(ownSiteUrl(client), newest);
}

async function ownSite(client: string): Promise<Response | undefined> {
  return client === '' ? undefined : (await caches.open(cacheName)).match(ownSiteUrl(client));
}

const own = new Map<string, Promise<Manifest>>();

/** Of the page that asks, or the newest one. */
function manifestOf(client: string): Promise<Manifest> {
  const known = own.get(client);
  if (known !== undefined) return known;
  const read = ownSite(client).then(async (site) => {
    if (site !== undefined) return parseManifest(await site.text());
    own.delete(client);
    return currentManifest();
  });
  own.set(client, read);
  return read;
}

async function currentManifest(): Promise<Manifest> {
  manifest ??= (async () => {
    const kept = await (await caches.open(cacheName)).match(siteUrl());
    return kept === undefined ? new Map<string, string>() : parseManifest(await kept.text());
  })();
  return manifest;
}

async function digest(bytes: ArrayBuffer): Promise<string> {
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

function keyOf(url: string, sha256: string): string {
  return `${url}?sha256=${sha256}`;
}

/** Stores a file under its hash, if it has it; else false. */
async function keep(url: string, sha256: string, response: Response): Promise<boolean> {
  const bytes = await response.arrayBuffer();
  if (await digest(bytes) !== sha256) return false;
  const cache = await caches.open(cacheName);
  await cache.put(keyOf(url, sha256), new Response(bytes, { headers: response.headers }));
  return true;
}

async function answer(event: FetchEvent): Promise<Response> {
  const { request } = event;
  const url = request.url.replace(/[?#].*$/, '');
  const client = event.clientId;
  if (url === siteUrl()) return withHeaders(await ownSite(client) ?? await freshSite());
  const folder = url === scope.registration.scope;
  const file = folder ? new URL('index.html', url).href : url;
  // A visit begins with what the site is now.
  if (request.mode === 'navigate') {
    await freshSite().catch(() => undefined);
    // A page in a frame within is no visit of the site.
    if (file === new URL('index.html', scope.registration.scope).href) await remember(event.resultingClientId);
  }
  const manifestNow = request.mode === 'navigate' ? currentManifest() : manifestOf(client);
  const sha256 = (await manifestNow).get(file);
  // Not of this site.
  if (sha256 === undefined && !url.startsWith(scope.registration.scope)) return fetch(request);
  const cache = await caches.open(cacheName);
  const kept = sha256 === undefined ? undefined : await cache.match(keyOf(file, sha256));
  if (kept !== undefined) return withHeaders(kept);
  // The host may let the browser keep files for long: the site was packed anew since, so ask.
  const response = sha256 === undefined ? await fetch(request) : await fetch(request, { cache: 'no-cache' });
  if (sha256 !== undefined && response.ok && response.type === 'basic') {
    event.waitUntil(keep(file, sha256, response.clone()).catch(() => undefined));
  }
  return withHeaders(response);
}

/** Fetches and keeps a file, unless it does not come as site.json names it. */
async function fetchAndKeep(url: string, sha256: string): Promise<boolean> {
  try {
    const response = await fetch(url, { cache: 'no-cache' });
    return response.ok && await keep(url, sha256, response);
  } catch {
    return false;
  }
}

/** Fetches all files of the site that are not kept yet, and drops those of older versions that no open page needs. Throws when one did not come. */
async function keepAll(client: string): Promise<void> {
  // One that was there before this worker: it has just fetched the newest.
  if (await ownSite(client) === undefined) {
    await freshSite();
    await remember(client);
  }
  const cache = await caches.open(cacheName);
  const wanted = new Set([siteUrl()]);
  for (const { id } of await scope.clients.matchAll({ includeUncontrolled: true })) {
    if (await ownSite(id) === undefined) continue;
    wanted.add(ownSiteUrl(id));
    for (const [url, sha256] of await manifestOf(id)) wanted.add(keyOf(url, sha256));
  }
  const missing: string[] = [];
  for (const [url, sha256] of await currentManifest()) {
    const key = keyOf(url, sha256);
    wanted.add(key);
    // Names of functions are for crash reports: kept once they were asked for.
    if (url.endsWith('.names')) continue;
    if (await cache.match(key) !== undefined) continue;
    if (!await fetchAndKeep(url, sha256)) missing.push(url);
  }
  for (const { url } of await cache.keys()) if (!wanted.has(url)) await cache.delete(url);
  if (missing.length > 0) throw new Error(`these did not come as site.json names them: ${missing.join(', ')}`);
}

scope.addEventListener('install', () => void scope.skipWaiting());
scope.addEventListener('activate', (event) => event.waitUntil(scope.clients.claim()));
scope.addEventListener('fetch', (event) => {
  const { request } = event;
  // A store that sites share lies beside them.
  if (request.method !== 'GET' || !request.url.startsWith(new URL('/', scope.registration.scope).href)) return;
  // A browser quirk: such a request must not be answered.
  if (request.cache === 'only-if-cached' && request.mode !== 'same-origin') return;
  event.respondWith(answer(event));
});
scope.addEventListener('message', (event) => {
  if (event.data !== 'keep') return;
  const port = event.ports[0];
  event.waitUntil(keepAll(event.source !== null && 'id' in event.source ? event.source.id : '').then(() => port?.postMessage('kept'), () => port?.postMessage('failed')));
});
