// The script of a node worker in a browser.

import type { loadPyodide } from 'pyodide';
import { fetchNow } from './fetch_now.ts';
import { type HoldOrder, serveWorker, type WorkerOrder } from './node_worker.ts';
import type { PythonRuntime } from './python_program.ts';
import { holdLife } from './worker_life.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;

function load(url: string): void {
  try {
    scope.importScripts(url);
  } catch (error) {
    throw new Error(`the site's file ${url} cannot be loaded: ${error instanceof Error ? error.message : String(error)}`);
  }
}

const handle = serveWorker((report) => scope.postMessage(report), fetchNow, {
  files: {
    pyodide: async (home) => {
      load(`${home}pyodide.js`);
      return (scope as unknown as { loadPyodide: typeof loadPyodide }).loadPyodide;
    },
    bytes: async (place) => {
      const response = await fetch(place);
      if (!response.ok) throw new Error(`${place} cannot be fetched: the host answers ${response.status}`);
      return new Uint8Array(await response.arrayBuffer());
    },
  },
  python: async (base) => {
    load(`${base}python_worker.js`);
    return (scope as unknown as { ros2wasmPython: PythonRuntime }).ros2wasmPython;
  },
});
let held = Promise.resolve();
scope.onmessage = ({ data: order }: MessageEvent<HoldOrder | WorkerOrder>) => {
  if (order.t === 'hold') held = holdLife(order.life);
  else void held.then(() => handle(order));
};
