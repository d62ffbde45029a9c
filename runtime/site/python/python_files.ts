// The files that Python programs of a site are made of: Pyodide's, and the archives. The page fetches each once and finds
// it to be the one that was packed, before a worker has it.

import type { SiteHost } from '../program/site_host.ts';
import { carriedPrograms, type SiteDescription, type SiteFile } from '../contract/session.ts';

/** The files that a worker gets. */
export interface PythonParts {
  /** By their paths in the site; those that are scripts are not among them, but were looked at. */
  readonly found: ReadonlyMap<string, Blob>;
  /** All archives of the site, with the hashes that they must have when the worker loads one. */
  readonly listed: readonly SiteFile[];
}

/** Pyodide's folder in the site, with "/" at the end. */
export function homeOf(program: string): string {
  return program.slice(0, program.lastIndexOf('/') + 1);
}

/** With "/" at the end. */
export function folderOf(place: string): string {
  return place.endsWith('/') ? place : `${place}/`;
}

/** Beside the program itself, which is compiled. */
const ofPyodide = ['pyodide.js', 'pyodide.asm.js', 'pyodide-lock.json', 'python_stdlib.zip'];
/** In a browser (python_worker_main.ts). */
const script = 'python_worker.js';

function isScript(path: string): boolean {
  return path.endsWith('.js');
}

export class PythonFiles {
  private readonly site: SiteDescription;
  private readonly host: SiteHost;
  private readonly found = new Map<string, Promise<Blob>>();

  constructor(site: SiteDescription, host: SiteHost) {
    this.site = site;
    this.host = host;
  }

  /** Resolves when the scripts that run the program are there and found to be those that were packed. Rejects as parts(). */
  async scripts(program: string): Promise<void> {
    await Promise.all(this.own(program).filter(isScript).map((path) => this.whole(path)));
  }

  /** The files that run the program, with these archives. Throws SiteError R2W0706 or R2W0724. */
  async parts(program: string, archives: readonly string[]): Promise<PythonParts> {
    const listed = new Map(this.site.files.map((file) => [file.path, file]));
    const all = await Promise.all([...this.own(program), ...archives].map(async (path) => [path, await this.whole(path)] as const));
    return {
      found: new Map(all.filter(([path]) => !isScript(path))),
      listed: this.archives().flatMap((path) => listed.get(path) ?? []),
    };
  }

  private own(program: string): readonly string[] {
    const listed = new Set(this.site.files.map(({ path }) => path));
    const home = homeOf(program);
    return [script, ...ofPyodide.map((name) => home + name)].filter((path) => listed.has(path));
  }

  private archives(): readonly string[] {
    return [...new Set(carriedPrograms(this.site).flatMap(({ python }) => python?.archives ?? []))];
  }

  /** One of them. Rejects as parts(). */
  whole(path: string): Promise<Blob> {
    let blob = this.found.get(path);
    if (blob === undefined) {
      blob = this.host.bytes(path).then((bytes) => new Blob([bytes]));
      this.found.set(path, blob);
      // The next call may try again after an error.
      blob.catch(() => this.found.delete(path));
    }
    return blob;
  }
}
