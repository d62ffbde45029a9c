// Loads Pyodide, as it comes in its npm package, in ways that it has no options for: with the module that the page has
// compiled already, with the site's clocks and random numbers, and with a memory that is there already.

import type { loadPyodide, PyodideInterface } from 'pyodide';
import type { FileSystem } from '../program/late_file.ts';
import type { Link } from '../bus/link.ts';
import { ProgramMemory } from '../program/program_memory.ts';

/** -ENOSYS of Emscripten. */
const noSuchFunction = -52;

type ModuleImports = Record<string, WebAssembly.ImportValue>;

/** The functions of the host that the interpreter calls. */
export interface PythonPlace {
  readonly clock: Pick<Link['clock'], 'steadyNs' | 'systemNs'>;
  readonly random: ((bytes: Uint8Array) => void) | undefined;
}

/** A memory with an interpreter in it. */
export interface OpenImage {
  /** Pyodide's own description of the image, in Pyodide's format. */
  readonly description: Uint8Array;
  /** Bytes of the memory. */
  readonly size: number;
  /** Its parts that are not 0, in order: whole pages. */
  readonly runs: readonly (readonly [begin: number, length: number])[];
  /** Gives the bytes of the runs, one after the other. */
  readonly read: (target: Uint8Array) => Promise<void>;
  /** Called before Python goes on, when the files are there that Pyodide puts there itself. */
  readonly withFiles: (system: FileSystem) => void;
  /** The site's functions, in place of those that were there when the image was made. */
  readonly host: object;
}

export interface PyodideOptions {
  readonly module: WebAssembly.Module;
  readonly open: typeof loadPyodide;
  /** Pyodide's folder, with "/" at the end. */
  readonly home: string;
  readonly environment: Readonly<Record<string, string>>;
  /** undefined: the browser's. */
  readonly place: PythonPlace | undefined;
  readonly image: OpenImage | undefined;
  /** An image will be made of it. */
  readonly toBeKept: boolean;
  /** Files that are already loaded, by the address from which Pyodide would fetch them. */
  readonly fetched: (address: string) => Blob | undefined;
}

export interface LoadedPyodide {
  readonly python: PyodideInterface;
  readonly memory: ProgramMemory;
}

/** Python's clocks are the site's, and its random numbers the run's, from the first instruction on. */
function followHost(imports: WebAssembly.Imports, { clock, random }: PythonPlace, memory: ProgramMemory): void {
  const env = imports['env'] as ModuleImports;
  const wasi = imports['wasi_snapshot_preview1'] as ModuleImports;
  env['emscripten_get_now'] = () => clock.steadyNs() / 1e6;
  env['emscripten_date_now'] = () => clock.systemNs() / 1e6;
  wasi['clock_time_get'] = (id: number, ...rest: readonly (number | bigint)[]): number => {
    const time = id === 0 ? clock.systemNs() : clock.steadyNs();
    memory.setI64(Number(rest.at(-1)), BigInt(Math.floor(time)));
    return 0;
  };
  if (random === undefined) return;
  env['getentropy'] = (address: number, length: number): number => {
    const bytes = new Uint8Array(length);
    random(bytes);
    memory.u8.set(bytes, address);
    return 0;
  };
}

/** In Node.js, Emscripten has commands of C's system() run by a shell: a site must not reach the machine. */
function startNothing(imports: WebAssembly.Imports): void {
  (imports['env'] as ModuleImports)['_emscripten_system'] = () => noSuchFunction;
}

/**
 * Functions of C that compiled modules import and this interpreter does not have, so that a call would end the program. numpy
 * asks for the callers of an expression when its arrays have 256 kB or more, to write the result into one of them. It finds
 * none, and makes a new array.
 */
export const notOfPyodide: Readonly<Record<string, () => number>> = { backtrace: () => 0 };

function addMissing(imports: WebAssembly.Imports): void {
  Object.assign(imports['env'] as ModuleImports, notOfPyodide);
}

/** As the time zone database has it where people have no letters for a zone: "-03", "+0530". */
function zoneName(minutesWest: number): string {
  if (minutesWest === 0) return 'UTC';
  const minutes = Math.abs(minutesWest);
  const two = (value: number): string => String(value).padStart(2, '0');
  return `${minutesWest > 0 ? '-' : '+'}${two(Math.floor(minutes / 60))}${minutes % 60 === 0 ? '' : two(minutes % 60)}`;
}

/** Emscripten asks the browser for a text of a time, for the zone's name in it: 60 ms of every start. */
function nameZones(imports: WebAssembly.Imports, memory: ProgramMemory): void {
  (imports['env'] as ModuleImports)['_tzset_js'] = (timezone: number, daylight: number, standardName: number, summerName: number) => {
    const year = new Date().getFullYear();
    const offsets = [0, 6].map((month) => new Date(year, month, 1).getTimezoneOffset());
    const [standard, summer] = [Math.max(...offsets), Math.min(...offsets)];
    memory.set(timezone, standard * 60);
    memory.set(daylight, Number(standard !== summer));
    for (const [at, offset] of [[standardName, standard], [summerName, summer]] as const) {
      const text = new TextEncoder().encode(zoneName(offset));
      memory.u8.set(text, at);
      memory.u8[at + text.length] = 0;
    }
  };
}

/** Calls `load`; in the meantime, requests for Pyodide's wasm file get the given module, and loaded files are not fetched again. */
async function withModule<T>(
  { module, fetched }: PyodideOptions,
  prepare: (imports: WebAssembly.Imports) => void,
  load: () => Promise<T>,
): Promise<T> {
  const wasm = WebAssembly as { instantiate: unknown; instantiateStreaming: unknown; };
  const scope = globalThis as { fetch: unknown; };
  const kept = { instantiate: wasm.instantiate, instantiateStreaming: wasm.instantiateStreaming, fetch: scope.fetch };
  const given = async (_source: unknown, imports: WebAssembly.Imports): Promise<WebAssembly.WebAssemblyInstantiatedSource> => {
    prepare(imports);
    return { module, instance: new WebAssembly.Instance(module, imports) };
  };
  wasm.instantiate = given;
  wasm.instantiateStreaming = given;
  const fetchOther = fetch;
  scope.fetch = (what: URL | string, ...rest: readonly RequestInit[]) => {
    const address = String(what);
    if (address.endsWith('/pyodide.asm.wasm')) return Promise.resolve(new Response());
    const blob = fetched(address);
    return blob === undefined ? fetchOther(what, ...rest) : Promise.resolve(new Response(blob));
  };
  try {
    return await load();
  } finally {
    Object.assign(WebAssembly, { instantiate: kept.instantiate, instantiateStreaming: kept.instantiateStreaming });
    scope.fetch = kept.fetch;
  }
}

/** The part of Emscripten's module that is used here. */
interface EmscriptenModule {
  readonly HEAPU8: Uint8Array;
  readonly FS: FileSystem;
}
type CreateModule = (settings: { INITIAL_MEMORY?: number; }) => Promise<EmscriptenModule>;

/** The size of a memory page in bytes, as in operating systems. */
export const pageBytes = 4096;

/** The memory becomes the image's. What is 0 in both is only read: such pages take no memory. */
export async function fillMemory(heap: Uint8Array, { runs, read }: Pick<OpenImage, 'runs' | 'read'>): Promise<void> {
  const words = new Int32Array(heap.buffer, heap.byteOffset, heap.length >> 2);
  const clear = (from: number, to: number): void => {
    for (let page = from; page < to; page += pageBytes) {
      const end = (page + pageBytes) >> 2;
      let word = page >> 2;
      while (word < end && words[word] === 0) word += 1;
      if (word < end) words.fill(0, word, end);
    }
  };
  let at = 0;
  for (const [begin, length] of runs) {
    clear(at, begin);
    at = begin + length;
    await read(heap.subarray(begin, at));
  }
  clear(at, heap.length);
}

const factory = '_createPyodideModule';

/**
 * Calls `load` while Pyodide's modules begin with the image's memory. Pyodide itself is given only the image's
 * description: its own way would have the whole image in one buffer more.
 */
async function withMemory<T>(image: OpenImage | undefined, load: () => Promise<T>): Promise<T> {
  if (image === undefined) return load();
  const scope = globalThis as unknown as Record<string, CreateModule | undefined>;
  let create = scope[factory];
  const fill: CreateModule = async (settings) => {
    if (create === undefined) throw new TypeError('Pyodide has no module');
    const made = await create({ ...settings, INITIAL_MEMORY: image.size });
    if (made.HEAPU8.length !== image.size) throw new RangeError('the image is of a memory of another size');
    await fillMemory(made.HEAPU8, image);
    image.withFiles(made.FS);
    return made;
  };
  if (create !== undefined) {
    // A script that was loaded before has declared it: for good, but it can be assigned.
    scope[factory] = fill;
    try {
      return await load();
    } finally {
      scope[factory] = create;
    }
  }
  // The script that Pyodide loads assigns it, in a browser also what it reads back.
  Object.defineProperty(scope, factory, {
    configurable: true,
    get: () => create === undefined ? undefined : fill,
    set: (made: CreateModule) => {
      if (made !== fill) create = made;
    },
  });
  try {
    return await load();
  } finally {
    Object.defineProperty(scope, factory, { configurable: true, writable: true, value: create });
  }
}

/** Throws what Pyodide throws. */
export async function openPyodide(options: PyodideOptions): Promise<LoadedPyodide> {
  const { open, home, environment, place, image, toBeKept } = options;
  let memory: ProgramMemory | undefined;
  const prepare = (imports: WebAssembly.Imports): void => {
    memory = new ProgramMemory((imports['env'] as ModuleImports)['memory'] as WebAssembly.Memory);
    startNothing(imports);
    addMissing(imports);
    nameZones(imports, memory);
    if (place !== undefined) followHost(imports, place, memory);
  };
  const settings = {
    indexURL: home,
    env: { ...environment },
    ...(toBeKept ? { _makeSnapshot: true } : {}),
    ...(image === undefined ? {} : { _loadSnapshot: image.description, _snapshotDeserializer: () => image.host }),
  };
  const python = await withModule(options, prepare, () => withMemory(image, () => open(settings)));
  if (memory === undefined) throw new TypeError('Pyodide took another wasm file');
  return { python, memory };
}
