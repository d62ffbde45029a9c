// The image of a started interpreter: its memory with rclpy imported, and the files that were unpacked. It is made
// once by a worker of its own, and further nodes begin with it. Everything that belongs to one node (environment,
// arguments, clocks, seeds of random numbers) is set again: ros2wasm/start.py.

import { unzipSync } from 'fflate';
import type { PyodideInterface } from 'pyodide';
import type { PyBuffer, PyCallable, PyProxy } from 'pyodide/ffi';
import { BlobParts } from '../program/blob_parts.ts';
import { ExpectedFiles } from '../program/expected_files.ts';
import { openPyodide, type OpenImage, pageBytes } from './pyodide_loader.ts';
import type { PythonParts } from './python_files.ts';
import type { WorkerFiles } from './worker_files.ts';

/** Where the archives are unpacked: an installation, as colcon makes it. */
export const prefix = '/ros';
const sitePackages = `${prefix}/lib/python3.12/site-packages`;

/** The inputs of an image. */
export interface ImageStart {
  /** The folder of the site, and Pyodide's in it, as in PythonStart. */
  readonly base: string;
  readonly home: string;
  /** The archives of the site that are loaded into it. */
  readonly archives: readonly string[];
  /** Where the share files of the site are for programs. */
  readonly share: string;
  /** All of it. */
  readonly parts: PythonParts;
}

/** How python_worker.js is called in a browser to make an image. Throws when there can be none. */
export type MakePythonImage = (module: WebAssembly.Module, start: ImageStart, files: WorkerFiles) => Promise<Blob>;

/** An image of which the memory is yet to be read, and then the files. */
export interface PythonImage extends Omit<OpenImage, 'host' | 'withFiles'> {
  readonly files: readonly (readonly [path: string, size: number])[];
  /** The files of what was imported, below the installation. */
  readonly loaded: readonly string[];
}

/** Changes when what lies in an image does. */
export const imageVersion = 3;
const magic = 0x494d3252;
/** magic, version, bytes of the head. */
const prologueSize = 12;
/** In the place of the site's functions. */
const hostMark = 'ros2wasm_host';

interface Head {
  readonly description: number;
  /** Begin and length of each. */
  readonly runs: readonly (readonly [begin: number, length: number])[];
  readonly size: number;
  readonly files: readonly (readonly [path: string, size: number])[];
  readonly loaded: readonly string[];
}

export function pythonEnvironment(environment: Readonly<Record<string, string>>, share: string): Record<string, string> {
  return { HOME: '/home', ...environment, AMENT_PREFIX_PATH: `${prefix}:${share}` };
}

/** The part of Emscripten's file system that is used here. */
interface FileSystem {
  readonly mkdirTree: (path: string) => void;
  readonly readdir: (path: string) => readonly string[];
  readonly stat: (path: string) => { readonly mode: number; };
  readonly isDir: (mode: number) => boolean;
  readonly readFile: (path: string) => Uint8Array<ArrayBuffer>;
  readonly writeFile: (path: string, bytes: Uint8Array, options: { readonly canOwn: boolean; }) => void;
}

function fileSystem(python: PyodideInterface): FileSystem {
  return python['FS'] as unknown as FileSystem;
}

function* filesBelow(system: FileSystem, folder: string): Generator<readonly [string, Uint8Array<ArrayBuffer>]> {
  for (const name of system.readdir(folder)) {
    if (name === '.' || name === '..') continue;
    const path = `${folder}/${name}`;
    if (system.isDir(system.stat(path).mode)) yield* filesBelow(system, path);
    else yield [path, system.readFile(path)];
  }
}

/** Where the bytes of a bytearray lie, which stay there for good. `kept` holds them. */
export function addressOf(bytes: PyProxy, kept: PyBuffer[]): number {
  const buffer = (bytes as PyProxy & { getBuffer(type: string): PyBuffer; }).getBuffer('u8');
  kept.push(buffer);
  return (buffer['data'] as Uint8Array).byteOffset;
}

/** The site's files as a worker has them. */
type Start = Pick<ImageStart, 'base' | 'parts'>;

/** For Pyodide, when it asks for its own files. */
export function fetchedOf({ base, parts }: Start): (address: string) => Blob | undefined {
  return (address) => address.startsWith(base) ? parts.found.get(address.slice(base.length)) : undefined;
}

/** The bytes of archives: those that were given, else those that were packed. Throws SiteError R2W0724. */
export function archivesOf({ base, parts }: Start, paths: readonly string[], files: WorkerFiles): Promise<Uint8Array<ArrayBuffer>[]> {
  const expected = new ExpectedFiles();
  expected.set(parts.listed);
  return Promise.all(paths.map(async (path) => {
    const given = parts.found.get(path);
    return given === undefined ? expected.checked(path, await files.bytes(base + path)) : new Uint8Array(await given.arrayBuffer());
  }));
}

function writeFiles(system: FileSystem, files: Iterable<readonly [path: string, bytes: Uint8Array<ArrayBuffer>]>): void {
  let folder = '';
  for (const [path, bytes] of files) {
    const own = path.slice(0, path.lastIndexOf('/'));
    if (own !== folder) system.mkdirTree(own);
    folder = own;
    system.writeFile(path, bytes, { canOwn: true });
  }
}

/**
 * Unpacks archives over each other, where Python has not looked yet, or forgets that it has (ros2wasm/start.py, renew). Not
 * by Python itself, which takes half a second for what takes a hundredth here.
 */
export function install(python: PyodideInterface, archives: readonly Uint8Array[], place = prefix): void {
  const system = fileSystem(python);
  for (const archive of archives) {
    const files = Object.entries(unzipSync(archive)).filter(([path]) => !path.endsWith('/'));
    writeFiles(system, files.map(([path, bytes]) => [`${place}/${path}`, bytes]));
  }
}

/** The module that starts programs. */
export interface StartModule {
  readonly prepare: PyCallable;
  readonly renew: PyCallable;
  readonly run: PyCallable;
}

export function startModule(python: PyodideInterface): StartModule {
  const globals = python.toPy({ place: sitePackages }) as PyProxy;
  python.runPython('import sys\nif place not in sys.path: sys.path.insert(0, place)', { globals });
  globals.destroy();
  return python.pyimport('ros2wasm.start') as StartModule;
}

export const makeImage: MakePythonImage = async (module, start, files) => {
  const home = start.base + start.home;
  const archives = await archivesOf(start, start.archives, files);
  const { python } = await openPyodide({
    module,
    home,
    open: await files.pyodide(home),
    environment: pythonEnvironment({}, start.share),
    place: undefined,
    image: undefined,
    toBeKept: true,
    fetched: fetchedOf(start),
  });
  const buffers: PyBuffer[] = [];
  const host = { address: (bytes: PyProxy): number => addressOf(bytes, buffers) };
  python.registerJsModule(hostMark, host);
  install(python, archives);
  startModule(python).prepare();
  const loaded = loadedFiles(python);
  const keeper = python as unknown as { makeMemorySnapshot(options: object): Uint8Array<ArrayBuffer>; };
  const snapshot = keeper.makeMemorySnapshot({
    serializer: (object: unknown): string => {
      if (object !== host) throw new TypeError('the interpreter holds an object of JavaScript that cannot be stored');
      return hostMark;
    },
  });
  return pack(snapshot, [...filesBelow(fileSystem(python), prefix)], loaded);
};

/** As a text, so that nothing of JavaScript comes into the memory. */
function loadedFiles(python: PyodideInterface): readonly string[] {
  const text = python.runPython(
    'import json, sys\njson.dumps([f for m in [*sys.modules.values()] if isinstance(f := getattr(m, "__file__", None), str)])',
  ) as string;
  const below = `${prefix}/`;
  return (JSON.parse(text) as string[]).filter((file) => file.startsWith(below)).map((file) => file.slice(below.length)).sort();
}

/** Pyodide's snapshot is its description, whose length is its second word, and the memory. */
function pack(
  snapshot: Uint8Array<ArrayBuffer>,
  files: readonly (readonly [string, Uint8Array<ArrayBuffer>])[],
  loaded: readonly string[],
): Blob {
  const description = new Uint32Array(snapshot.buffer, snapshot.byteOffset, 2)[1] ?? 0;
  const memory = snapshot.subarray(description);
  const runs = filledRuns(memory);
  const head: Head = { description, runs, size: memory.length, files: files.map(([path, bytes]) => [path, bytes.length]), loaded };
  const text = new TextEncoder().encode(JSON.stringify(head));
  const prologue = new Uint32Array([magic, imageVersion, text.length]);
  const filled = runs.map(([begin, length]) => memory.subarray(begin, begin + length));
  return new Blob([prologue, text, snapshot.subarray(0, description), ...filled, ...files.map(([, bytes]) => bytes)]);
}

/** Where a memory, of whole pages, is not 0. */
export function filledRuns(memory: Uint8Array): [begin: number, length: number][] {
  const runs: [number, number][] = [];
  const whole = memory.byteOffset % 4 === 0 ? memory : memory.slice();
  const words = new Int32Array(whole.buffer, whole.byteOffset, whole.length >> 2);
  for (let page = 0; page < memory.length; page += pageBytes) {
    const end = Math.min(page + pageBytes, memory.length);
    let word = page >> 2;
    while (word < end >> 2 && words[word] === 0) word += 1;
    if (word === end >> 2) continue;
    const last = runs.at(-1);
    if (last !== undefined && last[0] + last[1] === page) last[1] += end - page;
    else runs.push([page, end - page]);
  }
  return runs;
}

/** Throws when it is none. */
export async function readImage(blob: Blob): Promise<PythonImage> {
  const parts = new BlobParts(blob);
  const next = async (size: number): Promise<Uint8Array<ArrayBuffer>> => {
    const bytes = new Uint8Array(size);
    await parts.read(bytes);
    return bytes;
  };
  const [mark, version, length = 0] = new Uint32Array((await next(prologueSize)).buffer);
  if (mark !== magic || version !== imageVersion) throw new TypeError('these bytes are no image of an interpreter');
  const head = JSON.parse(new TextDecoder().decode(await next(length))) as Head;
  const { description, runs, size, files, loaded } = head;
  const sizes = [prologueSize, length, description, ...runs.map(([, bytes]) => bytes), ...files.map(([, bytes]) => bytes)];
  if (sizes.reduce((sum, bytes) => sum + bytes, 0) !== blob.size) throw new RangeError('the image is not complete');
  return { description: await next(description), runs, size, read: (target) => parts.read(target), files, loaded };
}

/** Puts the files of an image in their places. */
export async function restoreFiles(python: PyodideInterface, { files, read }: PythonImage): Promise<void> {
  const system = fileSystem(python);
  const whole = new Uint8Array(files.reduce((sum, [, size]) => sum + size, 0));
  await read(whole);
  let at = 0;
  writeFiles(system, files.map(([path, size]) => [path, whole.subarray(at, at += size)]));
}
