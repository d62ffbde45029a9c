// The script of a node worker in a browser.

import type { loadPyodide } from 'pyodide';
import type { WorkerFile } from '../program/carried_files.ts';
import { fetchNow, joinedBytes } from '../program/fetch_now.ts';
import { serveWorker } from './node_worker.ts';
import type { HoldOrder, WorkerOrder } from './worker_messages.ts';
import type { PythonRuntime } from '../python/python_program.ts';
import { holdLife } from './worker_life.ts';
import { closeRealm, type KeptDoors } from './worker_realm.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;

/** undefined before anything of the site runs. */
let doors: KeptDoors | undefined = closeRealm(scope);

let elsewhere: ReadonlyMap<string, WorkerFile> | undefined;
const made = new Map<string, string>();

/** Where it is, part by part, that has this address beside site.json. */
function addressesOf(address: string): readonly string[] {
  const file = elsewhere?.get(address);
  if (file === undefined) return [address];
  if (!(file instanceof Blob)) return file;
  const own = made.get(address) ?? URL.createObjectURL(file);
  made.set(address, own);
  return [own];
}

const loaded = new Set<string>();

function load(url: string): void {
  if (loaded.has(url)) return;
  try {
    if (doors === undefined) throw new Error('the program has begun');
    doors.importScripts(...addressesOf(url));
    loaded.add(url);
  } catch (error) {
    throw new Error(`the site's file ${url} cannot be loaded: ${error instanceof Error ? error.message : String(error)}`);
  }
}

const handle = serveWorker((report) => scope.postMessage(report), fetchNow(addressesOf), {
  files: {
    pyodide: async (home) => {
      try {
        load(`${home}pyodide.js`);
        // Pyodide would load it later, and from its own folder, where it need not be.
        load(`${home}pyodide.asm.js`);
      } finally {
        // The last script; what runs now may be of the site.
        doors = undefined;
      }
      return (scope as unknown as { loadPyodide: typeof loadPyodide; }).loadPyodide;
    },
    bytes: async (place) => {
      const parts = await Promise.all(addressesOf(place).map(async (address) => {
        const response = await fetch(address);
        if (!response.ok) throw new Error(`${place} cannot be fetched: the host answers ${response.status}`);
        return response.arrayBuffer();
      }));
      return joinedBytes(parts);
    },
  },
  python: async (base) => {
    load(`${base}python_worker.js`);
    return (scope as unknown as { ros2wasmPython: PythonRuntime; }).ros2wasmPython;
  },
  openChannel: (name) => {
    if (doors?.openChannel === undefined) throw new Error('this browser has no way between tabs');
    return doors.openChannel(name);
  },
});
let held = Promise.resolve();
// Not as `scope.onmessage`, which a script of the site could call.
const receive = ({ data: order, isTrusted }: MessageEvent<HoldOrder | WorkerOrder>): void => {
  // A program can make events itself.
  if (!isTrusted) return;
  if (order.t === 'hold') {
    elsewhere = order.files;
    held = holdLife(order.life, doors?.locks);
    return;
  }
  // It loads what runs Python, and then one order is carried out.
  if (order.t !== 'python') scope.removeEventListener('message', receive);
  // A hostile site.json may name a script of its own as Pyodide. Python has no use for locks and channels.
  else if (doors !== undefined) doors = { ...doors, locks: undefined, openChannel: undefined };
  void held.then(() => {
    if (order.t === 'start' && order.start.python === undefined) doors = undefined;
    handle(order);
  });
};
scope.addEventListener('message', receive);
