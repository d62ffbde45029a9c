// The image of a started interpreter: its memory with rclpy imported, and the files that were unpacked meanwhile. Made
// once by a worker of its own, it is what further nodes begin with. Everything that belongs to one node (environment,
// arguments, clocks, seeds of random numbers) is given anew: ros2wasm/start.py.

import type { PyodideInterface } from 'pyodide';
import type { PyBuffer, PyCallable, PyProxy } from 'pyodide/ffi';
import { ExpectedFiles } from './expected_files.ts';
import { openPyodide, type OpenImage } from './pyodide_loader.ts';
import type { PythonParts } from './python_files.ts';
import type { WorkerFiles } from './python_program.ts';

/** Where the archives are unpacked: an installation, as colcon makes it. */
export const prefix = '/ros';
const sitePackages = `${prefix}/lib/python3.12/site-packages`;

/** What an image is made of. */
export interface ImageStart {
  /** The folder of the site, and Pyodide's in it, as in PythonStart. */
  readonly base: string;
  readonly home: string;
  /** Of the site. */
  readonly archives: readonly string[];
  /** Where the share files of the site are for programs. */
  readonly share: string;
  /** All of it. */
  readonly parts: PythonParts;
}

/** How python_worker.js is called in a browser to make an image. Throws when there can be none. */
export type MakePythonImage = (module: WebAssembly.Module, start: ImageStart, files: WorkerFiles) => Promise<Blob>;

/** An image that was read. */
export interface PythonImage extends Omit<OpenImage, 'host'> {
  readonly files: readonly (readonly [path: string, bytes: Uint8Array])[];
  /** The files of what was imported, below the installation. */
  readonly loaded: readonly string[];
}

/** Changes when what lies in an image does. */
export const imageVersion = 2;
const magic = 0x494d3252;
/** magic, version, bytes of the head. */
const prologueSize = 12;
/** In the place of the site's functions. */
const hostMark = 'ros2wasm_host';

interface Head {
  readonly description: number;
  readonly used: number;
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
  readonly stat: (path: string) => { readonly mode: number };
  readonly isDir: (mode: number) => boolean;
  readonly readFile: (path: string) => Uint8Array<ArrayBuffer>;
  readonly writeFile: (path: string, bytes: Uint8Array, options: { readonly canOwn: boolean }) => void;
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
  const buffer = (bytes as PyProxy & { getBuffer(type: string): PyBuffer }).getBuffer('u8');
  kept.push(buffer);
  return (buffer['data'] as Uint8Array).byteOffset;
}

/** What a worker has of the site's files. */
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

/** Unpacks archives over each other, and has Python look among them. */
export function install(python: PyodideInterface, archives: readonly Uint8Array[]): void {
  for (const bytes of archives) python.unpackArchive(bytes, 'zip', { extractDir: prefix });
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
    module, home, open: await files.pyodide(home), environment: pythonEnvironment({}, start.share),
    place: undefined, image: undefined, toBeKept: true, fetched: fetchedOf(start),
  });
  const buffers: PyBuffer[] = [];
  const host = { address: (bytes: PyProxy): number => addressOf(bytes, buffers) };
  python.registerJsModule(hostMark, host);
  install(python, archives);
  startModule(python).prepare();
  const loaded = loadedFiles(python);
  const keeper = python as unknown as { makeMemorySnapshot(options: object): Uint8Array<ArrayBuffer> };
  const snapshot = keeper.makeMemorySnapshot({
    serializer: (object: unknown): string => {
      if (object !== host) throw new TypeError('the interpreter holds an object of JavaScript that cannot be kept');
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
  snapshot: Uint8Array<ArrayBuffer>, files: readonly (readonly [string, Uint8Array<ArrayBuffer>])[], loaded: readonly string[],
): Blob {
  const description = new Uint32Array(snapshot.buffer, snapshot.byteOffset, 2)[1] ?? 0;
  const memory = snapshot.subarray(description);
  let used = memory.length;
  while (used > 0 && memory[used - 1] === 0) used -= 1;
  const head: Head = { description, used, size: memory.length, files: files.map(([path, bytes]) => [path, bytes.length]), loaded };
  const text = new TextEncoder().encode(JSON.stringify(head));
  const prologue = new Uint32Array([magic, imageVersion, text.length]);
  return new Blob([prologue, text, snapshot.subarray(0, description + used), ...files.map(([, bytes]) => bytes)]);
}

/** Throws when it is none. The buffer is of no use afterwards. */
export function readImage(buffer: ArrayBuffer): PythonImage {
  const [mark, version, length = 0] = new Uint32Array(buffer, 0, 3);
  if (mark !== magic || version !== imageVersion) throw new TypeError('these bytes are no image of an interpreter');
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, prologueSize, length))) as Head;
  let at = prologueSize + length;
  const next = (size: number): Uint8Array => {
    const bytes = new Uint8Array(buffer, at, size);
    at += size;
    return bytes;
  };
  // Copied, since it is read as words, and the files stay in use.
  const description = next(head.description).slice();
  const memory = next(head.used);
  const whole = new Uint8Array(buffer, at).slice();
  let begin = 0;
  const files = head.files.map(([path, size]) => [path, whole.subarray(begin, begin += size)] as const);
  if (begin !== whole.length) throw new RangeError('the image is not complete');
  return { description, memory, size: head.size, files, loaded: head.loaded };
}

/** Puts the files of an image in their places. */
export function restoreFiles(python: PyodideInterface, { files }: PythonImage): void {
  const system = fileSystem(python);
  let folder = '';
  for (const [path, bytes] of files) {
    const own = path.slice(0, path.lastIndexOf('/'));
    if (own !== folder) system.mkdirTree(own);
    folder = own;
    system.writeFile(path, bytes, { canOwn: true });
  }
}
