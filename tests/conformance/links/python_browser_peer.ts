// Entry of a conformance worker in a browser whose program is Python.

import type { loadPyodide } from 'pyodide';
import { holdLife } from '../../../runtime/site/workers/worker_life.ts';
import { servePythonPeer } from './python_serving.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope & { readonly loadPyodide: typeof loadPyodide; };
const base = new URL('./', scope.location.href).href;
const home = 'pyodide/';
const handle = servePythonPeer((message) => scope.postMessage(message), {
  base,
  home,
  module: () => WebAssembly.compileStreaming(fetch(`${base}${home}pyodide.asm.wasm`)),
  files: {
    pyodide: async (place) => {
      scope.importScripts(`${place}pyodide.js`);
      return scope.loadPyodide;
    },
    bytes: async (place) => new Uint8Array(await (await fetch(place)).arrayBuffer()),
  },
  line: (text) => console.error(text),
});
let held = Promise.resolve();
scope.onmessage = ({ data }: MessageEvent<{ life?: string; }>) => {
  if (data.life !== undefined) held = holdLife(data.life, navigator.locks);
  else void held.then(() => handle(data));
};
