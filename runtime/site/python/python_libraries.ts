// Loads the compiled libraries that compiled modules of Python wheels need, before any code imports these. The modules
// themselves are loaded by Python when they are imported.

import type { PyodideInterface } from 'pyodide';
import { SiteError } from '../contract/site_error.ts';

/** The part of Pyodide that its own installer of packages uses, which sites have not. */
interface LibraryLoader {
  /** Afterwards the library is known by its file name. `global`: modules that are loaded later find its functions. */
  readonly loadDynlib: (path: string, global: boolean) => Promise<void>;
}

/** In this order, each as it was unpacked below `place`. Throws SiteError R2W0728. */
export async function loadLibraries(python: PyodideInterface, paths: readonly string[], place: string): Promise<void> {
  const loader = (python as unknown as { readonly _api: LibraryLoader; })._api;
  for (const path of paths) {
    try {
      await loader.loadDynlib(`${place}/${path}`, true);
    } catch (error) {
      throw new SiteError('R2W0728', `the library ${path} cannot be loaded: ${error instanceof Error ? error.message : String(error)}`);
    }
  }
}
