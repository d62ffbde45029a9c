// The files of a site whose page carries them (`pack -o NAME.html`, page_files.ts). All others are fetched.

/** Set by the page's own loader before anything else runs. */
export interface CarriedFiles {
  /** Unpacked, and as site.json lists it; undefined: the site has no such file. Throws SiteError R2W0724. */
  readonly file: (path: string) => Promise<Blob | undefined>;
  /** An address that lasts as long as the page. Rejects as file(), and where there is no such file. */
  readonly address: (path: string) => Promise<string>;
}

export function carriedFiles(): CarriedFiles | undefined {
  return (globalThis as { ros2wasmFiles?: CarriedFiles }).ros2wasmFiles;
}

/** Relative to the page. */
export function addressBeside(path: string): string {
  return path.split('/').map(encodeURIComponent).join('/');
}

/** Asks for a file of the site, by its path in site.json. */
export async function fetchOfSite(path: string, base?: URL, cache: RequestCache = 'default'): Promise<Response> {
  const carried = carriedFiles();
  if (carried === undefined) return fetch(new URL(addressBeside(path), base ?? document.baseURI), { cache });
  const file = await carried.file(path);
  return file === undefined ? new Response(null, { status: 404 }) : new Response(file);
}

/** Where the page's elements find it. */
export function addressOfSite(path: string): Promise<string> {
  return carriedFiles()?.address(path) ?? Promise.resolve(addressBeside(path));
}

/**
 * What workers ask for by themselves, by the addresses that it would have. Programs come from the page. Not addresses of
 * the page: from file: a worker cannot read those.
 */
export async function workerFiles(base: URL, paths: readonly string[]): Promise<ReadonlyMap<string, Blob> | undefined> {
  const carried = carriedFiles();
  if (carried === undefined) return undefined;
  const own = paths.filter((path) => /^(share|python|pyodide)\/|^python_worker\.js$/.test(path) && !path.endsWith('.wasm'));
  const files = await Promise.all(own.map(async (path) => [new URL(addressBeside(path), base).href, await carried.file(path)] as const));
  return new Map(files.flatMap(([address, file]) => (file === undefined ? [] : [[address, file]])));
}
