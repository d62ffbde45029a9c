// Where a worker finds the files of the site.

import type { loadPyodide } from 'pyodide';

export interface WorkerFiles {
  readonly pyodide: (home: string) => Promise<typeof loadPyodide>;
  readonly bytes: (place: string) => Promise<Uint8Array<ArrayBuffer>>;
}
