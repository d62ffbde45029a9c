// Node.js as the place where a site runs: files instead of fetch, worker threads instead of workers.

import { closeSync, constants, fstatSync, openSync, readFileSync } from 'node:fs';
import { open } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { loadPyodide } from 'pyodide';
import { ExpectedFiles } from '../program/expected_files.ts';
import type { Platform, WorkerEvents, WorkerHandle } from '../workers/platform.ts';
import { plainFolder } from '../program/plain_folder.ts';
import type { WorkerFiles } from '../python/worker_files.ts';
import { SiteError } from '../contract/site_error.ts';
import type { ReadNow } from '../program/site_files.ts';
import { strangeReport, takeReport } from '../workers/worker_reports.ts';

/** The workerData of a worker thread that is to serve a node. */
export const workerMark = 'ros2wasm node worker';

/** Bytes; a list of a site is far smaller. */
const mostOfJson = 128 << 20;
/** Opening a pipe does not wait for who writes into it. */
const reading = constants.O_RDONLY | (constants.O_NONBLOCK ?? 0);

/** Pipes and devices have no end. */
async function readRegular(path: string, most = Infinity): Promise<Buffer<ArrayBuffer>> {
  const file = await open(path, reading);
  try {
    const found = await file.stat();
    if (!found.isFile()) throw new Error('it is not a regular file');
    if (found.size > most) throw new Error(`it is larger than ${most} bytes`);
    return await file.readFile();
  } finally {
    await file.close();
  }
}

async function bytesOf(folder: string, path: string, most?: number): Promise<Buffer<ArrayBuffer>> {
  try {
    return await readRegular(join(folder, path), most);
  } catch (error) {
    throw new SiteError('R2W0706', `the site's file ${path} cannot be read: ${error instanceof Error ? error.message : ''}`, {
      why: 'the folder is not a complete site',
      fix: 'pack the workspace again',
    });
  }
}

export const readFileNow: ReadNow = (place, path) => {
  let file: number | undefined;
  try {
    file = openSync(join(place, path), reading);
    return fstatSync(file).isFile() ? readFileSync(file) : undefined;
  } catch {
    return undefined;
  } finally {
    if (file !== undefined) closeSync(file);
  }
};

/** For the worker threads. */
export const nodeFiles: WorkerFiles = {
  pyodide: async (home) => {
    interface Door {
      readonly loadPyodide: typeof loadPyodide;
    }
    const script = pathToFileURL(`${home}pyodide.js`).href;
    const { default: module } = await import(script) as { default?: Door; };
    if (module !== undefined) return module.loadPyodide;
    // Within a project of npm whose scripts are modules it has no exports, and its other script no way to ask for modules.
    Object.assign(globalThis, { require: createRequire(script), __dirname: home });
    return (globalThis as unknown as Door).loadPyodide;
  },
  bytes: async (place) => {
    const { buffer, byteOffset, byteLength } = await readRegular(place);
    return new Uint8Array(buffer, byteOffset, byteLength);
  },
};

/** `entry`: the script that serves nodes when it is started as a worker thread. */
export function nodePlatform(folder: string, entry: URL): Platform & { close(): void; } {
  const modules = new Map<string, Promise<WebAssembly.Module>>();
  const workers = new Set<Worker>();

  const expected = new ExpectedFiles();
  let plain: ReturnType<typeof plainFolder>;
  const place = (): string => plain?.place ?? folder;

  const compile = async (path: string): Promise<WebAssembly.Module> => {
    const bytes = await expected.checked(path, await bytesOf(place(), path));
    try {
      return await WebAssembly.compile(bytes);
    } catch (error) {
      throw new SiteError('R2W0703', `${path}: ${error instanceof Error ? error.message : String(error)}`);
    }
  };
  return {
    get place() {
      return place();
    },
    json: async (path) => {
      const text = (await bytesOf(place(), path, mostOfJson)).toString('utf8');
      try {
        return JSON.parse(text) as unknown;
      } catch (error) {
        throw new SiteError('R2W0700', `${path}: ${error instanceof Error ? error.message : String(error)}`);
      }
    },
    expect: (files) => {
      expected.set(files);
      plain = plainFolder(folder, files);
    },
    compile: (path) => {
      let module = modules.get(path);
      if (module === undefined) {
        module = compile(path);
        modules.set(path, module);
      }
      return module;
    },
    bytes: async (path) => {
      const { buffer, byteOffset, byteLength } = await expected.checked(path, await bytesOf(place(), path));
      return buffer.slice(byteOffset, byteOffset + byteLength);
    },
    startWorker: (name, events: WorkerEvents): WorkerHandle => {
      const worker = new Worker(entry, { workerData: workerMark, name });
      workers.add(worker);
      worker.on('message', (data: unknown) => takeReport(data, events));
      worker.on('messageerror', () => events.failed(strangeReport.message, strangeReport.code));
      worker.on('error', (error) => events.failed(error instanceof Error ? error.message : String(error)));
      worker.on('exit', () => {
        workers.delete(worker);
        events.failed('the worker ended');
      });
      return {
        post: (order, transfer) => worker.postMessage(order, transfer as never),
        terminate: async () => {
          worker.removeAllListeners();
          workers.delete(worker);
          await worker.terminate();
        },
      };
    },
    frame: (task) => void setImmediate(task),
    close: () => {
      for (const worker of workers) void worker.terminate();
      plain?.close();
    },
  };
}
