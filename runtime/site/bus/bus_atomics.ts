// Atomic accesses to the words of a bus, as functions of a WebAssembly module that has the bus as its memory. Engines call
// such a function in a few ns; V8 runs Atomics.load and its kin as calls out of optimised code, five times as long, and a
// message makes some thirty of them. All accesses are sequentially consistent, as those of Atomics are.

export interface BusAtomics {
  load(word: number): number;
  store(word: number, value: number): void;
  /** These return what was there before. */
  add(word: number, value: number): number;
  sub(word: number, value: number): number;
  or(word: number, value: number): number;
  exchange(word: number, value: number): number;
  compareExchange(word: number, expected: number, value: number): number;
  /** Bytes of the memory now, whichever thread has grown it, in wasm pages of 64 KiB. */
  size(): number;
}

/** Function types of the module: parameters and results, all of them i32. */
const types = { load: [1, 1], store: [2, 0], change: [2, 1], compare: [3, 1], size: [0, 1] } as const;
type TypeName = keyof typeof types;
const typeNames = Object.keys(types) as TypeName[];

/** Second byte of the opcodes 0xfe.. of the threads proposal; all access a word. */
const functions: readonly (readonly [keyof BusAtomics, TypeName, number])[] = [
  ['load', 'load', 0x10],
  ['store', 'store', 0x17],
  ['add', 'change', 0x1e],
  ['sub', 'change', 0x25],
  ['or', 'change', 0x33],
  ['exchange', 'change', 0x41],
  ['compareExchange', 'compare', 0x48],
  ['size', 'size', 0],
];

const i32 = 0x7f;
const localGet = 0x20;
const end = 0x0b;
/** log2 of a word's alignment, and no offset. */
const wordAccess = [2, 0];
/** As many 64 KiB pages as a memory can have: any memory fits. */
const mostPages = 65536;

function unsigned(value: number): number[] {
  return value < 128 ? [value] : [(value & 127) | 128, ...unsigned(value >>> 7)];
}

function text(value: string): number[] {
  return [value.length, ...new TextEncoder().encode(value)];
}

function section(id: number, count: number, content: readonly number[]): number[] {
  const body = [...unsigned(count), ...content];
  return [id, ...unsigned(body.length), ...body];
}

/** The first parameter is a word's index; its address is four times that. */
function body(type: TypeName, opcode: number): number[] {
  const address = [localGet, 0, 0x41, 2, 0x74];
  const values = Array.from({ length: Math.max(0, types[type][0] - 1) }, (_, i) => [localGet, i + 1]).flat();
  const code = type === 'size' ? [0x3f, 0] : [...address, ...values, 0xfe, opcode, ...wordAccess];
  const whole = [0, ...code, end];
  return [...unsigned(whole.length), ...whole];
}

function moduleBytes(): Uint8Array<ArrayBuffer> {
  const parameters = (count: number): number[] => [count, ...Array.from({ length: count }, () => i32)];
  return new Uint8Array([
    0,
    0x61,
    0x73,
    0x6d,
    1,
    0,
    0,
    0,
    ...section(1, typeNames.length, typeNames.flatMap((name) => [0x60, ...parameters(types[name][0]), ...parameters(types[name][1])])),
    // A shared memory with a limit.
    ...section(2, 1, [...text('bus'), ...text('memory'), 2, 3, 0, ...unsigned(mostPages)]),
    ...section(3, functions.length, functions.map(([, type]) => typeNames.indexOf(type))),
    ...section(7, functions.length, functions.flatMap(([name], index) => [...text(name), 0, index])),
    ...section(10, functions.length, functions.flatMap(([, type, opcode]) => body(type, opcode))),
  ]);
}

let compiled: WebAssembly.Module | undefined;
const known = new WeakMap<WebAssembly.Memory, BusAtomics>();

/** The functions for a memory; the same ones for all who ask in this thread, so that engines can put them in line. */
export function atomicsOf(memory: WebAssembly.Memory): BusAtomics {
  const made = known.get(memory);
  if (made !== undefined) return made;
  compiled ??= new WebAssembly.Module(moduleBytes());
  const { exports } = new WebAssembly.Instance(compiled, { bus: { memory } });
  const atomics = exports as unknown as BusAtomics;
  known.set(memory, atomics);
  return atomics;
}
