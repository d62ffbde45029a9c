// How a page comes by the files of its site: some pages carry them (`pack -o NAME.html`, page_files.ts), all others fetch
// them, from beside site.json or where it says that they lie.

import type { SiteFile } from '../contract/session.ts';

/** Set by the page's own loader before anything else runs. */
export interface CarriedFiles {
  /** Unpacked, and as site.json lists it; undefined: the site has no such file. Throws SiteError R2W0724. */
  readonly file: (path: string) => Promise<Blob | undefined>;
  /** An address that lasts as long as the page. Rejects as file(), and where there is no such file. */
  readonly address: (path: string) => Promise<string>;
}

export function carriedFiles(): CarriedFiles | undefined {
  return (globalThis as { ros2wasmFiles?: CarriedFiles; }).ros2wasmFiles;
}

/** By paths. Bundles that have this module each share it, so it is the page's own. */
type Places = ReadonlyMap<string, readonly string[]>;
const page = globalThis as { ros2wasmPlaces?: Places; };

/** To be called once the list is read. */
export function setPlaces(files: readonly SiteFile[]): void {
  page.ros2wasmPlaces = new Map(files.flatMap(({ path, at }) => (at === undefined ? [] : [[path, at]])));
}

/** Whether its address is another one than beside the page: in a store, or in parts. */
export function isElsewhere(path: string): boolean {
  return page.ros2wasmPlaces?.has(path) ?? false;
}

function encoded(path: string): string {
  return path.split('/').map(encodeURIComponent).join('/');
}

/** Relative to site.json: more than one when it lies in parts. */
function addressesOf(path: string): readonly string[] {
  return (page.ros2wasmPlaces?.get(path) ?? [path]).map(encoded);
}

/** Where an element finds it, relative to the page; undefined: addressOfSite() has to make an address. */
export function addressBeside(path: string): string | undefined {
  const [address, ...more] = addressesOf(path);
  return carriedFiles() === undefined && more.length === 0 ? address : undefined;
}

async function joined(parts: readonly Response[]): Promise<Response> {
  const failed = parts.find(({ ok }) => !ok);
  const [only] = parts;
  if (failed !== undefined || (only !== undefined && parts.length === 1)) return failed ?? only as Response;
  // blob() fails now and then in Chromium for what the page's head asked for already and is still on its way.
  return new Response(new Blob(await Promise.all(parts.map((part) => part.arrayBuffer()))));
}

/** Asks for a file of the site, by its path in site.json. */
export async function fetchOfSite(path: string, base?: URL, cache: RequestCache = 'default'): Promise<Response> {
  const carried = carriedFiles();
  if (carried === undefined) {
    return joined(await Promise.all(addressesOf(path).map((at) => fetch(new URL(at, base ?? document.baseURI), { cache }))));
  }
  const file = await carried.file(path);
  return file === undefined ? new Response(null, { status: 404 }) : new Response(file);
}

/** Where the page's elements find it. */
export async function addressOfSite(path: string): Promise<string> {
  const carried = carriedFiles();
  if (carried !== undefined) return carried.address(path);
  return addressBeside(path) ?? URL.createObjectURL(await (await fetchOfSite(path)).blob());
}

/** A file as a worker gets it: its bytes, or the addresses of its parts. */
export type WorkerFile = Blob | readonly string[];

/**
 * The files that workers load by themselves, by the addresses that they would have beside site.json. Programs come from the page.
 * They are bytes, not addresses, where they are embedded in the page: a worker cannot read addresses of a file: page.
 */
export async function workerFiles(base: URL, paths: readonly string[]): Promise<ReadonlyMap<string, WorkerFile> | undefined> {
  const carried = carriedFiles();
  if (carried === undefined && (page.ros2wasmPlaces?.size ?? 0) === 0) return undefined;
  const own = paths.filter((path) => /^(share|python|pyodide)\/|^python_worker\.js$/.test(path) && !path.endsWith('.wasm'));
  const places = (path: string): readonly string[] => addressesOf(path).map((at) => new URL(at, base).href);
  const files = await Promise.all(
    own.map(async (path) => [new URL(encoded(path), base).href, carried === undefined ? places(path) : await carried.file(path)] as const),
  );
  return new Map(files.flatMap(([address, file]) => (file === undefined ? [] : [[address, file]])));
}
