// Entry of a conformance worker under Node.js whose program is Python.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname } from 'node:path';
import { parentPort, workerData } from 'node:worker_threads';
import { loadPyodide } from 'pyodide';
import { servePythonPeer } from './python_serving.ts';

/** The data with which the worker is started. */
export interface PythonPeerData {
  /** Folder of the archive, with "/" at the end. */
  readonly base: string;
}

if (parentPort === null) throw new Error('this file is a worker');
const port = parentPort;
const pyodide = `${dirname(createRequire(import.meta.url).resolve('pyodide'))}/`;
const handle = servePythonPeer((message) => port.postMessage(message), {
  base: (workerData as PythonPeerData).base,
  home: '',
  module: () => WebAssembly.compile(readFileSync(`${pyodide}pyodide.asm.wasm`)),
  files: {
    pyodide: async () => (options) => loadPyodide({ ...options, indexURL: pyodide }),
    bytes: async (place) => Uint8Array.from(readFileSync(place)),
  },
  line: (text) => void process.stderr.write(`${text}\n`),
});
port.on('message', handle);
