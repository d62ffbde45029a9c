// OpenCV as npm's build of OpenCV.js, for the module `cv2` of the embedded channel (runtime/packages/vendor/py_opencv). It
// has a memory of its own: pixels are copied from Python's memory and back. All else goes as JSON, which costs microseconds
// where an operation on a picture costs milliseconds. build.mjs takes dynamic code and the WebAssembly out of OpenCV.js.

import createOpenCv from '@opencvjs/web/lib/opencv_js.js';
import { decodePicture, encodePicture } from './picture_files.ts';

/** Everything that embind makes has these. */
interface Bound {
  delete(): void;
  isDeleted(): boolean;
}

interface Mat extends Bound {
  readonly rows: number;
  readonly cols: number;
  readonly data: Uint8Array;
  type(): number;
  elemSize(): number;
  isContinuous(): boolean;
  clone(): Mat;
  create(rows: number, cols: number, type: number): void;
}

interface Vector extends Bound {
  size(): number;
  get(index: number): unknown;
  push_back(value: unknown): void;
}

type Callable = (...values: unknown[]) => unknown;
type Class = new(...values: unknown[]) => Bound;

interface OpenCvModule {
  readonly [name: string]: unknown;
  readonly Mat: new(rows?: number, cols?: number, type?: number) => Mat;
  exceptionFromPtr(address: number): { readonly code: number; readonly msg: string; };
}

/** Address in Python's memory, rows, columns and type of a Mat. */
type MatHead = readonly [address: number, rows: number, cols: number, type: number];

/** An argument of a call. Others than objects go as they are. */
interface Argument {
  readonly m?: MatHead;
  readonly M?: readonly MatHead[];
  /** An empty object of a class, to be filled. */
  readonly n?: string;
  /** Class and elements of a vector. */
  readonly v?: readonly [string, readonly unknown[]];
  /** An object that an earlier call gave. */
  readonly o?: number;
  /** Class and number of an enumeration's value. */
  readonly c?: readonly [string, number];
  /** A value of JavaScript: a size, a point. */
  readonly j?: unknown;
}

interface Call {
  /** A function; `new NAME` for a constructor; `.NAME`, `get NAME` and `set NAME` for a method and an attribute of `on`. */
  readonly f: string;
  readonly on?: number;
  readonly a: readonly unknown[];
  /** Indices of arguments that are results, too. */
  readonly out: readonly number[];
}

const VECTORS = /Vector$/;
/** In a type of OpenCV: the depth is below, the number of channels less one above. */
const channelBits = 3;

export class OpenCv {
  private readonly cv: OpenCvModule;
  private readonly memory: () => Uint8Array;
  private readonly objects = new Map<number, unknown>();
  private last = 0;

  /** `memory`: Python's. */
  constructor(wasm: Uint8Array<ArrayBuffer>, memory: () => Uint8Array) {
    this.memory = memory;
    const cv = {
      instantiateWasm(imports: WebAssembly.Imports, receive: (instance: WebAssembly.Instance) => void): WebAssembly.Exports {
        const instance = new WebAssembly.Instance(new WebAssembly.Module(wasm), imports);
        receive(instance);
        return instance.exports;
      },
    };
    // It is complete when this returns: nothing of it is fetched.
    void createOpenCv(cv);
    this.cv = cv as unknown as OpenCvModule;
  }

  /** Names of all functions and classes, and the values of all constants. */
  names(): string {
    const constants: Record<string, number> = {};
    const functions: string[] = [];
    for (const [name, value] of Object.entries(this.cv)) {
      if (typeof value === 'number') constants[name] = value;
      if (typeof value === 'function') functions.push(name);
    }
    return JSON.stringify({ constants, functions });
  }

  /** Both are JSON: a Call; and `r`, what it returned, with `o`, its other results, or `e`, the code and text of an error. */
  call(text: string): string {
    const { f, on, a, out } = JSON.parse(text) as Call;
    const made: Bound[] = [];
    try {
      const values = a.map((argument) => this.argument(argument, made));
      const returned = this.carryOut(f, on, values);
      if (typeof returned === 'object' && returned !== null && 'delete' in returned) made.push(returned as Bound);
      const r = this.result(returned);
      const o = out.map((index) => this.result(values[index]));
      return JSON.stringify({ r, o });
    } catch (error) {
      return JSON.stringify({ e: this.problem(error) });
    } finally {
      // Results live until Python has fetched them.
      const kept = new Set([...this.objects.values()].flat());
      for (const one of made) if (!kept.has(one) && !one.isDeleted()) one.delete();
    }
  }

  /** Copies what `m` or `M` of a result stands for to that address of Python's memory, one Mat after the other, and frees it. */
  fetch(id: number, address: number): void {
    const mats = this.objects.get(id) as readonly Mat[];
    this.objects.delete(id);
    const bytes = this.memory();
    let at = address;
    for (const mat of mats) {
      if (mat.rows * mat.cols > 0) {
        const whole = mat.isContinuous() ? mat : mat.clone();
        bytes.set(whole.data, at);
        at += whole.data.length;
        if (whole !== mat) whole.delete();
      }
      mat.delete();
    }
  }

  /** The picture in a file at that address: as a Mat with blue first; without `m` it is not one that is known. */
  decode(address: number, length: number): string {
    const picture = decodePicture(this.memory().slice(address, address + length));
    if (picture === undefined) return '{}';
    const { rows, cols, channels, depth, bytes } = picture;
    const mat = new this.cv.Mat(rows, cols, depth | ((channels - 1) << channelBits));
    mat.data.set(bytes);
    return JSON.stringify({ m: [this.keep([mat]), ...headOf(mat)] });
  }

  /** The file, as a Mat of one row. `ending` is that of its name, `quality` that of JPEG. */
  encode(ending: string, address: number, rows: number, cols: number, type: number, quality: number): string {
    const channels = (type >> channelBits) + 1;
    const depth = type & ((1 << channelBits) - 1);
    const size = rows * cols * channels * (depth === 0 ? 1 : 2);
    const file = encodePicture(ending, { rows, cols, channels, depth, bytes: this.memory().slice(address, address + size) }, quality);
    const mat = new this.cv.Mat(1, file.length, 0);
    mat.data.set(file);
    return JSON.stringify({ m: [this.keep([mat]), ...headOf(mat)] });
  }

  /** Frees an object. */
  release(id: number): void {
    (this.objects.get(id) as Bound | undefined)?.delete();
    this.objects.delete(id);
  }

  private carryOut(f: string, on: number | undefined, values: readonly unknown[]): unknown {
    if (f.startsWith('new ')) return new (this.cv[f.slice(4)] as Class)(...values);
    if (on === undefined) return (this.cv[f] as Callable)(...values);
    const object = this.objects.get(on) as Record<string, unknown>;
    if (f.startsWith('get ')) return object[f.slice(4)];
    if (f.startsWith('set ')) {
      object[f.slice(4)] = values[0];
      return undefined;
    }
    return (object[f.slice(1)] as Callable).apply(object, [...values]);
  }

  private mat([address, rows, cols, type]: MatHead, made: Bound[]): Mat {
    const mat = new this.cv.Mat(rows, cols, type);
    made.push(mat);
    const { data } = mat;
    if (rows * cols > 0) data.set(this.memory().subarray(address, address + data.length));
    return mat;
  }

  private argument(given: unknown, made: Bound[]): unknown {
    if (typeof given !== 'object' || given === null) return given;
    const { m, M, n, v, o, j, c } = given as Argument;
    if (m !== undefined) return this.mat(m, made);
    if (M !== undefined) return this.vector('MatVector', M.map((head) => this.mat(head, made)), made);
    if (v !== undefined) return this.vector(...v, made);
    if (n !== undefined) {
      const empty = new (this.cv[n] as Class)();
      made.push(empty);
      return empty;
    }
    if (c !== undefined) return (this.cv[c[0]] as { readonly values: Readonly<Record<number, unknown>>; }).values[c[1]];
    return o === undefined ? j : this.objects.get(o);
  }

  private vector(name: string, elements: readonly unknown[], made: Bound[]): Vector {
    const vector = new (this.cv[name] as Class)() as Vector;
    made.push(vector);
    for (const one of elements)
      vector.push_back(Array.isArray(one) && name.endsWith('VectorVector') ? this.vector(name.slice(0, -'Vector'.length), one, made) : one);
    return vector;
  }

  private keep(value: unknown): number {
    this.last += 1;
    this.objects.set(this.last, value);
    return this.last;
  }

  private result(value: unknown): unknown {
    if (typeof value === 'bigint') return Number(value);
    if (typeof value !== 'object' || value === null) return value;
    if (value instanceof this.cv.Mat) return { m: [this.keep([value]), ...headOf(value)] };
    const name = value.constructor.name;
    if (!VECTORS.test(name)) return 'delete' in value ? { O: this.keep(value), p: attributesOf(value) } : value;
    const vector = value as Vector;
    const elements = Array.from({ length: vector.size() }, (_, i) => vector.get(i));
    if (name !== 'MatVector') return elements.map((one) => this.result(one));
    // Each get() is a Mat of its own over the same pixels.
    const mats = elements as readonly Mat[];
    return { M: [this.keep(mats), mats.map(headOf)] };
  }

  private problem(error: unknown): readonly [number, string] {
    const address = typeof error === 'number' ? error : (error as { readonly excPtr?: number; } | undefined)?.excPtr;
    if (address !== undefined) {
      const { code, msg } = this.cv.exceptionFromPtr(address);
      return [code, msg];
    }
    return [0, error instanceof Error ? error.message : String(error)];
  }
}

/** Members of the class that are not methods. */
function attributesOf(value: object): readonly string[] {
  const described = Object.entries(Object.getOwnPropertyDescriptors(Object.getPrototypeOf(value) as object));
  return described.filter(([, { get }]) => get !== undefined).map(([name]) => name);
}

function headOf(mat: Mat): readonly [number, number, number] {
  return [mat.rows, mat.cols, mat.type()];
}
