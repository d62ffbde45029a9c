// The site's service worker. Adds the headers that shared memory needs and the site's Content-Security-Policy to every
// response, worker scripts too; caches the site for visits without a network, by content: site.json names the sha256 of
// each file, and a file is taken from the cache only under the hash that a site.json gives it: for a page that is open the one
// that it was opened with, so that it continues unchanged when the site is packed again, and the newest one for the next visit.
// Every page of the origin can write to the cache. So nothing in it is trusted: a file is hashed each time it is
// taken out, and a list that this worker did not fetch itself counts only when the host or the open page has the same one.

import { mimeTypeOf } from '../contract/mime_types.ts';
import { askForList } from '../program/own_list.ts';
import { type ListedPlace, placesOf, readStore } from '../contract/site_places.ts';

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

/** Absolute URL of a file, or of a part of one -> its sha256, by a site.json. */
type Manifest = ReadonlyMap<string, string>;

/** A site.json that can be believed, and what it lists. */
interface SiteList {
  readonly text: string;
  readonly files: Manifest;
  /** Those directly below the site's own, as comparableNames() writes them. */
  readonly folders: ReadonlySet<string>;
}

/** `sandboxed`: as a document it runs no script, and has no part in the origin. */
function withHeaders(response: Response, sandboxed = false): Response {
  if (response.type === 'opaque' || response.type === 'error' || response.status === 0) return response;
  const all = new Headers(response.headers);
  for (const [name, value] of headers) all.set(name, value);
  if (sandboxed) all.set('Content-Security-Policy', `sandbox; ${contentSecurityPolicy}`);
  const bodiless = response.status === 204 || response.status === 304;
  return new Response(bodiless ? null : response.body, { status: response.status, statusText: response.statusText, headers: all });
}

function siteUrl(): string {
  return new URL('site.json', scope.registration.scope).href;
}

/** One way to write an address: links in a text leave characters as they are that the page encodes. */
function canonical(href: string): string {
  const { origin, pathname } = new URL(href);
  try {
    return origin + pathname.split('/').map((part) => encodeURIComponent(decodeURIComponent(part))).join('/');
  } catch {
    return origin + pathname;
  }
}

/**
 * The names in an address below the site, in the one form in which all addresses that a host may take for the same file agree:
 * hosts ignore capitals, decode slashes and join several slashes.
 */
function comparableNames(href: string): readonly string[] {
  const encoded = href.slice(scope.registration.scope.length);
  let path = encoded;
  try {
    path = decodeURIComponent(encoded);
  } catch {
    // It is compared as it is.
  }
  return path.normalize('NFKC').toLowerCase().split(/[\\/]/).filter((name) => name !== '' && name !== '.');
}

const pageAddresses: ReadonlySet<string> = new Set(['', 'index', 'index.html'].map((name) => scope.registration.scope + name));

/**
 * HTML or SVG that a lab brings along, opened in a tab or a frame, would act as a page of the site. The host chooses which file
 * it gives for `folder/` or `name`, so everything in the site's folders counts. Other folders may have other sites.
 */
function isDocumentOfLab(url: string, { files, folders }: SiteList): boolean {
  if (pageAddresses.has(url)) return false;
  if (files.size === 0 || files.has(canonical(url))) return true;
  const names = comparableNames(url);
  return names.includes('..') || folders.has(names[0] ?? '');
}

function parseManifest(text: string): Manifest {
  const map = new Map<string, string>();
  try {
    const site = JSON.parse(text) as { store?: unknown; files?: Partial<ListedPlace>[]; };
    const store = readStore(site.store);
    for (const { path, sha256, ...rest } of site.files ?? []) {
      if (typeof path !== 'string' || typeof sha256 !== 'string' || sha256 === '') continue;
      for (const place of placesOf({ path, sha256, ...rest }, store)) {
        // Encoded, as the page asks for it: a part of a path is never a host, a query or a fragment.
        const encoded = place.at.split('/').map(encodeURIComponent).join('/');
        map.set(canonical(new URL(encoded, scope.registration.scope).href), place.sha256);
      }
    }
  } catch {
    // A site.json that cannot be read names no files: everything comes from the network.
  }
  return map;
}

function listOf(text: string): SiteList {
  const files = parseManifest(text);
  const folders = new Set<string>();
  for (const url of files.keys()) {
    const names = url.startsWith(scope.registration.scope) ? comparableNames(url) : [];
    if (names.length > 1) folders.add(names[0]!);
  }
  return { text, files, folders };
}

function listResponse({ text }: SiteList): Response {
  return new Response(text, { headers: { 'content-type': 'application/json' } });
}

/** By this worker's own memory, which nobody else can write to. */
let newest: Promise<SiteList> | undefined;

/** Caches the list for later visits. Without room for it the site still opens, but not offline. */
async function putList(url: string, list: SiteList): Promise<void> {
  try {
    await (await caches.open(cacheName)).put(url, listResponse(list));
  } catch {
    // The browser has no room left.
  }
}

/**
 * The host's answer for site.json. Throws without a network. Pages of the origin can set cookies that make the host refuse
 * the request, so it is repeated without cookies.
 */
async function askHost(): Promise<Response> {
  const plain = (): Promise<Response> => fetch(siteUrl(), { cache: 'no-cache', credentials: 'omit' });
  let response: Response;
  try {
    response = await fetch(siteUrl(), { cache: 'no-cache' });
  } catch {
    return plain();
  }
  if (response.ok) return response;
  const again = await plain().catch(() => undefined);
  return again?.ok === true ? again : response;
}

/** Asks the host. `list`: undefined when it does not give one. Throws without a network. Renews the newest list. */
async function fetchList(): Promise<{ readonly response: Response; readonly list: SiteList | undefined; }> {
  const response = await askHost();
  if (!response.ok) return { response, list: undefined };
  const list = listOf(await response.text());
  newest = Promise.resolve(list);
  await putList(siteUrl(), list);
  return { response: listResponse(list), list };
}

/** The list of an earlier visit, for a visit without a network. */
async function cachedList(url: string): Promise<SiteList | undefined> {
  const cached = await (await caches.open(cacheName)).match(url);
  return cached === undefined ? undefined : listOf(await cached.text());
}

/** The newest site.json: from the network, without it from the cache. */
async function freshSite(): Promise<Response> {
  try {
    return (await fetchList()).response;
  } catch (error) {
    const cached = await cachedList(siteUrl());
    if (cached === undefined) throw error;
    newest = Promise.resolve(cached);
    return listResponse(cached);
  }
}

let asking: Promise<SiteList> | undefined;

/** The newest list that this worker knows; without one it asks, as freshSite() does. An error of the host counts as an empty list. */
function currentList(): Promise<SiteList> {
  if (newest !== undefined) return newest;
  asking ??= (async () => {
    try {
      return (await fetchList()).list ?? listOf('{}');
    } catch {
      const list = await cachedList(siteUrl()) ?? listOf('{}');
      newest ??= Promise.resolve(list);
      return await newest;
    }
  })().finally(() => {
    asking = undefined;
  });
  return asking;
}

/** Where the site.json is cached that a page was opened with. */
function ownSiteUrl(client: string): string {
  return `${siteUrl()}?client=${encodeURIComponent(client)}`;
}

/** The lists of open pages; undefined: of those that were not opened by way of this worker. */
const own = new Map<string, Promise<SiteList | undefined>>();

/** The newest site.json is that page's from now on. */
async function remember(client: string): Promise<void> {
  if (client === '' || newest === undefined) return;
  const list = await newest;
  own.set(client, Promise.resolve(list));
  await putList(ownSiteUrl(client), list);
}

/** A page that does not answer is about to start, or is gone. */
const answerMs = 3000;

/** Whether the open page says that this is the list that it was opened with. */
async function vouched(client: string, { text }: SiteList): Promise<boolean> {
  const page = await scope.clients.get(client);
  if (page === undefined) return false;
  const channel = new MessageChannel();
  const answer = new Promise<unknown>((resolve) => {
    channel.port1.onmessage = ({ data }: MessageEvent<unknown>) => resolve(data);
    setTimeout(() => resolve(undefined), answerMs);
  });
  page.postMessage(askForList, [channel.port2]);
  const said = await answer;
  channel.port1.close();
  return said === await digest(new TextEncoder().encode(text));
}

/** The list of a page that an earlier life of this worker has opened. The cache alone is not believed. */
async function cachedOwnList(client: string): Promise<SiteList | undefined> {
  const cached = await cachedList(ownSiteUrl(client));
  if (cached === undefined) return undefined;
  const current = await currentList();
  if (current.text === cached.text || await vouched(client, cached)) return cached;
  await (await caches.open(cacheName)).delete(ownSiteUrl(client));
  return undefined;
}

/** undefined: it was not opened by way of this worker. */
function ownList(client: string): Promise<SiteList | undefined> {
  if (client === '') return Promise.resolve(undefined);
  const known = own.get(client) ?? cachedOwnList(client);
  own.set(client, known);
  void known.then((list) => {
    if (list === undefined && own.get(client) === known) own.delete(client);
  });
  return known;
}

/** The requesting page's site list, or the newest one. */
async function listFor(client: string): Promise<SiteList> {
  return await ownList(client) ?? await currentList();
}

async function digest(bytes: ArrayBuffer | Uint8Array<ArrayBuffer>): Promise<string> {
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

/** A file from the cache, when its bytes have that hash; others are dropped. */
async function cachedFile(url: string, sha256: string): Promise<Response | undefined> {
  const cache = await caches.open(cacheName);
  const cached = await cache.match(keyOf(url, sha256));
  if (cached === undefined) return undefined;
  const bytes = await cached.arrayBuffer();
  // The head is not in the hash: the type follows from the name, as on hosts.
  if (await digest(bytes) === sha256) return new Response(bytes, { headers: { 'content-type': mimeTypeOf(url) } });
  await cache.delete(keyOf(url, sha256));
  return undefined;
}

async function answer(event: FetchEvent): Promise<Response> {
  const { request } = event;
  const url = request.url.replace(/[?#].*$/, '');
  const client = event.clientId;
  if (url === siteUrl()) {
    const opened = await ownList(client);
    return withHeaders(opened === undefined ? await freshSite() : listResponse(opened));
  }
  const folder = url === scope.registration.scope;
  const file = folder ? new URL('index.html', url).href : url;
  // A visit begins with what the site is now.
  if (request.mode === 'navigate') {
    await freshSite().catch(() => undefined);
    // A page in a frame within is not a visit of the site.
    if (file === new URL('index.html', scope.registration.scope).href) await remember(event.resultingClientId);
  }
  const list = request.mode === 'navigate' ? await currentList() : await listFor(client);
  const address = canonical(file);
  const sha256 = list.files.get(address);
  // Not of this site.
  if (sha256 === undefined && !url.startsWith(scope.registration.scope)) return fetch(request);
  const cached = sha256 === undefined ? undefined : await cachedFile(address, sha256);
  const sandboxed = request.mode === 'navigate' && isDocumentOfLab(url, list);
  if (cached !== undefined) return withHeaders(cached, sandboxed);
  // The host may let the browser keep files for long, and the site may have been packed again: so ask the host.
  const response = sha256 === undefined ? await fetch(request) : await fetch(request, { cache: 'no-cache' });
  if (sha256 !== undefined && response.ok && response.type === 'basic') {
    event.waitUntil(keep(address, sha256, response.clone()).catch(() => undefined));
  }
  return withHeaders(response, sandboxed);
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
  if (await ownList(client) === undefined) {
    await freshSite();
    await remember(client);
  }
  const cache = await caches.open(cacheName);
  const wanted = new Set([siteUrl()]);
  for (const { id } of await scope.clients.matchAll({ includeUncontrolled: true })) {
    const list = await ownList(id);
    if (list === undefined) continue;
    wanted.add(ownSiteUrl(id));
    for (const [url, sha256] of list.files) wanted.add(keyOf(url, sha256));
  }
  const missing: string[] = [];
  for (const [url, sha256] of (await currentList()).files) {
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
  event.waitUntil(
    keepAll(event.source !== null && 'id' in event.source ? event.source.id : '').then(() => port?.postMessage('kept'), () => port?.postMessage('failed')),
  );
});
