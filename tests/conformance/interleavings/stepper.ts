// Runs stepped code (stepped_code.ts): processes that yield before they touch a word that others touch too,
// and a memory whose every change goes into a hash. Single-threaded, so that a run is exactly its list of choices.

const wasmPage = 1 << 16;

/** Programs have plain memory; all that is shared is the bus, also after it has grown into another buffer. */
function isShared(array: Int32Array | Uint8Array | WebAssembly.Memory): boolean {
  return array instanceof WebAssembly.Memory || array.buffer instanceof SharedArrayBuffer;
}

export type Step = Generator<unknown, unknown, unknown>;

export type ProcessState = 'ready' | 'asleep' | 'done' | 'dead' | 'unborn';

export class Process {
  readonly index: number;
  readonly name: string;
  state: ProcessState;
  /** Hash of all it has read so far: with the code it says where the process is. */
  history = 0;
  /** Word it sleeps on. */
  asleepOn = 0;
  clock = 1000;
  private readonly start: () => Step;
  private step: Step | undefined;
  operation = 0;
  array: Int32Array | Uint8Array | WebAssembly.Memory | undefined;
  at = 0;
  a = 0;
  b = 0;

  constructor(index: number, name: string, start: () => Step, unborn: boolean) {
    this.index = index;
    this.name = name;
    this.start = start;
    this.state = unborn ? 'unborn' : 'ready';
  }

  /** Goes on to the next point; what it does there is not done yet. */
  resume(): void {
    // A store that changes nothing is a step all the same.
    this.history = mix(this.history, 0x51ed270b);
    this.step ??= this.start();
    if (this.step.next().done === true) this.state = 'done';
  }
}

function mix(a: number, b: number): number {
  let h = Math.imul(a ^ Math.imul(b, 0x9e3779b1), 0x85ebca6b);
  h ^= h >>> 15;
  h = Math.imul(h, 0xc2b2ae35);
  return h ^ (h >>> 13);
}

/** Accesses of a pass, by word: bits of the processes. */
export class Accesses {
  readonly readers: Uint8Array;
  readonly writers: Uint8Array;
  /** Words that several processes touch and one of them changes, as known before this pass: only there does order matter. */
  readonly contended: Uint8Array;
  private readonly known: Uint8Array;
  private found: number[] = [];

  constructor(words: number) {
    this.readers = new Uint8Array(words);
    this.writers = new Uint8Array(words);
    this.contended = new Uint8Array(words);
    this.known = new Uint8Array(words);
  }

  forget(): void {
    for (const each of [this.readers, this.writers, this.contended, this.known]) each.fill(0);
    this.found = [];
  }

  get grown(): boolean {
    return this.found.length > 0;
  }

  /** For the next pass: what this one has found counts. */
  learn(focus: (word: number) => boolean): void {
    for (const word of this.found) if (focus(word)) this.contended[word] = 1;
    this.found = [];
  }

  note(word: number, process: number, changes: boolean): void {
    const bit = 1 << process;
    const of = changes ? this.writers : this.readers;
    if ((of[word]! & bit) !== 0) return;
    of[word]! |= bit;
    const all = this.readers[word]! | this.writers[word]!;
    if (this.writers[word] !== 0 && (all & (all - 1)) !== 0 && this.known[word] === 0) {
      this.known[word] = 1;
      this.found.push(word);
    }
  }
}

/** The stand-in for Atomics and for plain accesses; `S` in stepped code. */
export class Stepper {
  readonly load = 0;
  readonly store = 1;
  readonly add = 2;
  readonly sub = 3;
  readonly compareExchange = 4;
  readonly exchange = 5;
  readonly notify = 6;
  readonly get = 7;
  readonly put = 8;
  readonly size = 9;
  readonly resize = 10;
  readonly or = 11;
  called: unknown;
  current: Process | undefined;
  processes: Process[] = [];
  readonly accesses: Accesses;
  /** Hash of the contended words' contents. */
  memory = 0;
  memoryToo = 0;
  readonly timers: (() => unknown)[] = [];
  private readonly outside = new Process(31, 'setup', function*() {/* Runs in drive(). */}, false);
  /** Blocks of 1024 words that the run has changed. */
  readonly changed = new Set<number>();
  private readonly views = new WeakMap<object, Int32Array>();

  constructor(words: number) {
    this.accesses = new Accesses(words);
  }

  /** A new run. */
  begin(processes: Process[]): void {
    this.processes = processes;
    this.current = undefined;
    this.memory = 0;
    this.memoryToo = 0;
    this.timers.length = 0;
    this.changed.clear();
  }

  /** Carries a call out in one go, unobserved. */
  drive(step: unknown): unknown {
    if (!this.follows(step)) return step;
    const before = this.current;
    this.current = undefined;
    try {
      for (;;) {
        const { done, value } = (step as Step).next();
        if (done === true) return value;
      }
    } finally {
      this.current = before;
    }
  }

  follows(value: unknown): boolean {
    return typeof value === 'object' && value !== null && typeof (value as Step).next === 'function';
  }

  now(): number {
    const process = this.current ?? this.outside;
    process.clock += 1;
    return process.clock;
  }

  private wordOf(array: Int32Array | Uint8Array | WebAssembly.Memory, at: number): number {
    return array instanceof Int32Array ? at : at >> 2;
  }

  /** Announces an access. True when others could get in between: the caller yields. */
  enter(operation: number, array: Int32Array | Uint8Array | WebAssembly.Memory, at: number, a = 0, b = 0): boolean {
    const process = this.current ?? this.outside;
    process.operation = operation;
    process.array = array;
    process.at = at;
    process.a = a;
    process.b = b;
    if (this.current === undefined) return false;
    if (!isShared(array)) return false;
    const word = this.wordOf(array, at);
    const changes = (operation >= this.store && operation <= this.exchange) || operation === this.put || operation === this.resize || operation === this.or;
    this.accesses.note(word, process.index, changes);
    if (this.accesses.contended[word] === 0) return false;
    // For the plain words of a frame, one in each line of 16 words is enough: a torn frame is torn there as well.
    if (operation === this.get || operation === this.put) return (word & 15) === 0;
    return true;
  }

  perform(): number {
    const process = this.current ?? this.outside;
    const { operation, at, a, b } = process;
    if (operation === this.size) return this.read((process.array as WebAssembly.Memory).buffer.byteLength / wasmPage);
    if (operation === this.resize) {
      (process.array as WebAssembly.Memory).grow(a);
      return 0;
    }
    const array = process.array as Int32Array;
    if (this.current === undefined || !isShared(array)) return this.plainly(operation, array, at, a, b);
    const old = array[at]!;
    switch (operation) {
      case this.load:
      case this.get:
        return this.read(old);
      case this.store:
      case this.put:
        this.change(array, at, old, a);
        return a;
      case this.add:
        this.change(array, at, old, old + a);
        return this.read(old);
      case this.sub:
        this.change(array, at, old, old - a);
        return this.read(old);
      case this.or:
        this.change(array, at, old, old | a);
        return this.read(old);
      case this.exchange:
        this.change(array, at, old, a);
        return this.read(old);
      case this.compareExchange:
        if (old === (a | 0)) this.change(array, at, old, b);
        return this.read(old);
      case this.notify:
        for (const other of this.processes) if (other.state === 'asleep' && other.asleepOn === at) other.state = 'ready';
        return 0;
      default:
        throw new Error(`no operation ${operation}`);
    }
  }

  private plainly(operation: number, array: Int32Array, at: number, a: number, b: number): number {
    const old = array[at]!;
    if (isShared(array)) this.changed.add(at >> 10);
    if (operation === this.store || operation === this.put || operation === this.exchange) array[at] = a;
    else if (operation === this.add) array[at] = old + a;
    else if (operation === this.sub) array[at] = old - a;
    else if (operation === this.or) array[at] = old | a;
    else if (operation === this.compareExchange && old === a) array[at] = b;
    return operation === this.store || operation === this.put ? a : old;
  }

  private read(value: number): number {
    const process = this.current;
    if (process !== undefined) process.history = mix(process.history + 1, value);
    return value;
  }

  private change(array: Int32Array | Uint8Array, at: number, old: number, value: number): void {
    array[at] = value;
    this.changed.add(this.wordOf(array, at) >> 10);
    const place = array instanceof Int32Array ? at : at | 0x40000000;
    const now = array[at]!;
    if (old === now) return;
    this.memory ^= mix(mix(place, 17), old) ^ mix(mix(place, 17), now);
    this.memoryToo ^= mix(mix(place, 91), old) ^ mix(mix(place, 91), now);
  }

  *wait(array: Int32Array, at: number, expected: number, timeout = Infinity): Generator<undefined, string> {
    const process = this.current;
    if (process === undefined) throw new Error('setup must not wait');
    this.accesses.note(at, process.index, false);
    yield;
    if (this.read(array[at]!) !== expected) return 'not-equal';
    // Nothing may rely on a timeout's length: here it is over at once.
    if (timeout !== Infinity) return 'timed-out';
    process.state = 'asleep';
    process.asleepOn = at;
    yield;
    return 'ok';
  }

  /** One point for a range that is read or changed at once. */
  private range(array: Int32Array | Uint8Array, from: number, to: number, changes: boolean): boolean {
    const process = this.current;
    if (!isShared(array)) return false;
    if (changes) { for (let block = this.wordOf(array, from) >> 10; block <= this.wordOf(array, to) >> 10; block += 1) this.changed.add(block); }
    if (process === undefined) return false;
    let contended = false;
    for (let word = this.wordOf(array, from); word <= this.wordOf(array, Math.max(from, to - 1)); word += 1) {
      this.accesses.note(word, process.index, changes);
      if (this.accesses.contended[word] !== 0) contended = true;
    }
    return contended;
  }

  private observed(array: Int32Array | Uint8Array): boolean {
    return this.current !== undefined && isShared(array);
  }

  *fill(array: Int32Array | Uint8Array, value: number, from: number, to: number): Generator<undefined, unknown> {
    if (this.range(array, from, to, true)) yield;
    if (!this.observed(array)) return array.fill(value, from, to);
    for (let i = from; i < to; i += 1) this.change(array, i, array[i]!, value);
    return array;
  }

  *slice(array: Int32Array | Uint8Array, from: number, to: number): Generator<undefined, unknown> {
    if (this.range(array, from, to, false)) yield;
    const copy = array.slice(from, to);
    if (this.observed(array)) { for (const value of copy) this.read(value); }
    return copy;
  }

  /** In two halves, each with a point of its own. */
  *set(array: Int32Array | Uint8Array, source: ArrayLike<number>, to = 0): Generator<undefined, void> {
    const given = source as Uint8Array;
    const half = source.length >> 1;
    for (const [begin, end] of [[0, half], [half, source.length]] as const) {
      const scale = array instanceof Int32Array ? 0 : given.byteOffset;
      const reading = this.range(given, scale + begin, scale + end, false);
      if (this.range(array, to + begin, to + end, true) || reading) yield;
      for (let i = begin; i < end; i += 1) {
        if (i + 4 <= end && this.setWord(array, to + i, given, i)) {
          i += 3;
          continue;
        }
        const value = isShared(given) ? this.read(given[i]!) : given[i]!;
        if (this.observed(array)) this.change(array, to + i, array[to + i]!, value);
        else array[to + i] = value;
      }
    }
  }

  /** Four bytes at once where they are a word on both sides. */
  private setWord(array: Int32Array | Uint8Array, to: number, given: Uint8Array, from: number): boolean {
    const source = given.byteOffset + from;
    if (array instanceof Int32Array || ((to | source) & 3) !== 0 || array.byteOffset !== 0) return false;
    const words = this.wordsOf(array);
    const value = this.wordsOf(given)[source >> 2]!;
    if (isShared(given)) this.read(value);
    if (this.observed(array)) this.change(words, to >> 2, words[to >> 2]!, value);
    else words[to >> 2] = value;
    return true;
  }

  private wordsOf(array: Uint8Array): Int32Array {
    const buffer = array.buffer;
    let words = this.views.get(buffer);
    if (words === undefined || words.length !== buffer.byteLength >> 2) {
      words = new Int32Array(buffer, 0, buffer.byteLength >> 2);
      this.views.set(buffer, words);
    }
    return words;
  }

  *copyWithin(array: Uint8Array, to: number, from: number, end: number): Generator<undefined, unknown> {
    const reading = this.range(array, from, end, false);
    if (this.range(array, to, to + end - from, true) || reading) yield;
    if (!this.observed(array)) return array.copyWithin(to, from, end);
    for (let i = 0; i < end - from; i += 1) this.change(array, to + i, array[to + i]!, this.read(array[from + i]!));
    return array;
  }

  /** Array methods whose callback may yield. */
  readonly each = {
    *some(list: readonly unknown[], test: (item: unknown) => Step): Step {
      for (const item of list) if ((yield* test(item)) === true) return true;
      return false;
    },
    *every(list: readonly unknown[], test: (item: unknown) => Step): Step {
      for (const item of list) if ((yield* test(item)) !== true) return false;
      return true;
    },
    *filter(list: readonly unknown[], test: (item: unknown) => Step): Step {
      const kept: unknown[] = [];
      for (const item of list) if ((yield* test(item)) === true) kept.push(item);
      return kept;
    },
    *map(list: readonly unknown[], change: (item: unknown) => Step): Step {
      const made: unknown[] = [];
      for (const item of list) made.push(yield* change(item));
      return made;
    },
    *forEach(list: readonly unknown[], act: (item: unknown) => Step): Generator<unknown, void> {
      for (const item of list) yield* act(item);
    },
  };
}
