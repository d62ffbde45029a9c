// The part of WASI that a node program needs: arguments, environment, clocks, random, console, standard input, exit.
// Descriptors beyond 2 are files, which the program keeps itself (wasm_cpp/src/fd_calls.cpp).

import { WaitResult } from '../../protocol/generated/constants.ts';
import { putNanoseconds, type SiteClock } from '../bus/clock.ts';
import type { ProgramMemory } from './program_memory.ts';

const success = 0;
const badf = 8;
const inval = 28;
const intr = 27;
const spipe = 70;
const nosys = 52;
/** File types. */
const characterDevice = 2;
const regularFile = 4;

/** The exit code of a program that calls proc_exit or exit(), or returns from main. */
export class ProgramExit {
  readonly code: number;

  /** The lowest 8 bits count, as for whoever waits for a process: -1 is 255. */
  constructor(code: number) {
    this.code = code & 0xff;
  }
}

/**
 * Ends the program from inside one of its calls. A throw would not do: clean-up code and functions that promise not to
 * throw catch whatever comes out of JavaScript.
 */
export type Leave = (reason: ProgramExit | Error) => never;

/** Functions that a program exports for descriptors beyond 2, when it uses files. Each returns 0 or an errno. */
export interface FileExports {
  readonly ros2wasm_fd_read?: (fd: number, vectors: number, count: number, out: number) => number;
  readonly ros2wasm_fd_write?: (fd: number, vectors: number, count: number, out: number) => number;
  readonly ros2wasm_fd_seek?: (fd: number, low: number, high: number, whence: number, out: number) => number;
  readonly ros2wasm_fd_close?: (fd: number) => number;
  readonly ros2wasm_fd_is_open?: (fd: number) => number;
}

/** The event that ended a wait for input. */
export type Arrival = 'input' | 'timeout' | 'stop';

export interface Input {
  /** Waits for input. `undefined`: a stop was requested; empty: there will be no more. */
  readonly read: (capacity: number) => Uint8Array | undefined | Promise<Uint8Array | undefined>;
  /** Waits until a read would not wait, for so long at most. Infinity: for ever. */
  readonly arrives: (milliseconds: number) => Arrival | Promise<Arrival>;
}

export interface WasiHost {
  /** Set before the program runs. */
  readonly memory: () => ProgramMemory;
  readonly arguments: readonly string[];
  readonly environment: Readonly<Record<string, string>>;
  readonly write: (stream: 'stdout' | 'stderr', bytes: Uint8Array) => void;
  readonly input: Input;
  readonly leave: Leave;
  readonly clock: SiteClock;
  readonly random: (bytes: Uint8Array) => void;
  /** Sleeps for poll_oneoff. */
  readonly sleep: (milliseconds: number) => WaitResult | Promise<WaitResult>;
  readonly files: () => FileExports;
}

/** Names of the functions that may suspend the program on the port link. */
export const suspendingWasi: ReadonlySet<string> = new Set(['fd_read', 'poll_oneoff']);

type WasiFunction = (...args: never[]) => unknown;

export function wasiImports(host: WasiHost): Record<string, WasiFunction> {
  const { memory } = host;
  const args = host.arguments.map((text) => new TextEncoder().encode(`${text}\0`));
  const environment = Object.entries(host.environment).map(([k, v]) => new TextEncoder().encode(`${k}=${v}\0`));

  const sizes = (list: readonly Uint8Array[]) => (countAt: number, bytesAt: number): number => {
    memory().set(countAt, list.length);
    memory().set(bytesAt, list.reduce((sum, item) => sum + item.length, 0));
    return success;
  };
  const put = (list: readonly Uint8Array[]) => (pointersAt: number, bytesAt: number): number => {
    let at = bytesAt;
    list.forEach((item, i) => {
      memory().set(pointersAt + 4 * i, at);
      memory().u8.set(item, at);
      at += item.length;
    });
    return success;
  };
  const now = (clock: number): number | undefined => {
    // Times of day; the others (process and thread time too) count steadily.
    if (clock === 0) return Math.floor(host.clock.systemNs());
    if (clock === 1 || clock === 2 || clock === 3) return Math.floor(host.clock.steadyNs());
    return undefined;
  };

  const clockTimeGet = (clock: number, ...rest: readonly (number | bigint)[]): number => {
    // The precision comes as one i64, or as two halves from a program whose int64 were cut in two.
    const out = Number(rest[rest.length - 1]);
    const time = now(clock);
    if (time === undefined) return inval;
    putNanoseconds(memory().i32, out >>> 2, time);
    return success;
  };

  const readInto = (vectors: number, count: number, out: number, bytes: Uint8Array | undefined): number => {
    if (bytes === undefined) return intr;
    let at = 0;
    for (let i = 0; i < count && at < bytes.length; i += 1) {
      const length = Math.min(memory().u32(vectors + 8 * i + 4), bytes.length - at);
      memory().u8.set(bytes.subarray(at, at + length), memory().u32(vectors + 8 * i));
      at += length;
    }
    memory().set(out, at);
    return success;
  };

  const isOpen = (fd: number): number => (fd <= 2 ? success : host.files().ros2wasm_fd_is_open?.(fd) ?? badf);

  const pollOneoff = (input: number, output: number, count: number, done: number): number | Promise<number> => {
    let shortest = Infinity;
    let clock = -1;
    const reads: number[] = [];
    const writes: number[] = [];
    for (let i = 0; i < count; i += 1) {
      const at = input + 48 * i;
      const kind = memory().u8[at + 8];
      if (kind === 1 && memory().u32(at + 16) === 0) reads.push(i);
      if (kind === 2) writes.push(i);
      if (kind !== 0) continue;
      const absolute = (memory().u32(at + 40) & 1) !== 0;
      const time = memory().i64(at + 24);
      const wait = Number(absolute ? time - BigInt(now(memory().u32(at + 16)) ?? 0) : time) / 1e6;
      if (wait < shortest) {
        shortest = wait;
        clock = i;
      }
    }
    if (clock < 0 && reads.length === 0 && writes.length === 0) return nosys;
    const finish = (happened: readonly number[]): number => {
      happened.forEach((index, n) => {
        const at = output + 32 * n;
        memory().u8.fill(0, at, at + 32);
        memory().u8.set(memory().slice(input + 48 * index, 8), at);
        memory().u8[at + 10] = memory().u8[input + 48 * index + 8] ?? 0;
      });
      memory().set(done, happened.length);
      return success;
    };
    if (reads.length > 0) {
      const answer = (arrival: Arrival): number => {
        if (arrival === 'stop') return finish([]);
        const happened = [...writes, ...(arrival === 'input' ? reads : [])];
        return finish(happened.length > 0 ? happened : [clock]);
      };
      const arrival = host.input.arrives(writes.length > 0 ? 0 : Math.max(0, shortest));
      return arrival instanceof Promise ? arrival.then(answer) : answer(arrival);
    }
    if (writes.length > 0) return finish(writes);
    const answer = (result: WaitResult): number => finish(result === WaitResult.stop ? [] : [clock]);
    const slept = host.sleep(Math.max(0, shortest));
    return slept instanceof Promise ? slept.then(answer) : answer(slept);
  };

  return {
    args_sizes_get: sizes(args),
    args_get: put(args),
    environ_sizes_get: sizes(environment),
    environ_get: put(environment),
    clock_time_get: clockTimeGet,
    clock_res_get: (clock: number, out: number): number => {
      if (now(clock) === undefined) return inval;
      memory().setI64(out, 1000n);
      return success;
    },
    fd_write: (fd: number, vectors: number, count: number, out: number): number => {
      if (fd > 2) return host.files().ros2wasm_fd_write?.(fd, vectors, count, out) ?? badf;
      if (fd !== 1 && fd !== 2) return badf;
      let total = 0;
      for (let i = 0; i < count; i += 1) {
        const length = memory().u32(vectors + 8 * i + 4);
        if (length === 0) continue;
        host.write(fd === 1 ? 'stdout' : 'stderr', memory().slice(memory().u32(vectors + 8 * i), length));
        total += length;
      }
      memory().set(out, total);
      return success;
    },
    fd_read: (fd: number, vectors: number, count: number, out: number): number | Promise<number> => {
      if (fd > 2) return host.files().ros2wasm_fd_read?.(fd, vectors, count, out) ?? badf;
      if (fd !== 0) return badf;
      let capacity = 0;
      for (let i = 0; i < count; i += 1) capacity += memory().u32(vectors + 8 * i + 4);
      if (capacity === 0) return readInto(vectors, count, out, new Uint8Array());
      const bytes = host.input.read(capacity);
      if (bytes instanceof Promise) return bytes.then((got) => readInto(vectors, count, out, got));
      return readInto(vectors, count, out, bytes);
    },
    fd_seek: (fd: number, ...rest: readonly (number | bigint)[]): number => {
      if (fd <= 2) return spipe;
      // The offset comes as one i64, or as two halves.
      const [offset, whence, out] = typeof rest[0] === 'bigint'
        ? [rest[0], rest[1], rest[2]]
        : [(BigInt(rest[1] ?? 0) << 32n) | BigInt(Number(rest[0]) >>> 0), rest[2], rest[3]];
      const low = Number(BigInt.asIntN(32, offset));
      return host.files().ros2wasm_fd_seek?.(fd, low, Number(offset >> 32n), Number(whence), Number(out)) ?? badf;
    },
    fd_close: (fd: number): number => (fd <= 2 ? success : host.files().ros2wasm_fd_close?.(fd) ?? badf),
    fd_sync: isOpen,
    fd_datasync: isOpen,
    fd_fdstat_get: (fd: number, out: number): number => {
      const error = isOpen(fd);
      if (error !== success) return error;
      memory().u8.fill(0, out, out + 24);
      // A character device: the C library then buffers by lines.
      memory().u8[out] = fd <= 2 ? characterDevice : regularFile;
      memory().setI64(out + 8, fd === 0 ? 2n : fd <= 2 ? 64n : -1n);
      return success;
    },
    fd_fdstat_set_flags: (): number => success,
    fd_prestat_get: (): number => badf,
    fd_prestat_dir_name: (): number => badf,
    path_open: (): number => badf,
    path_filestat_get: (): number => badf,
    fd_filestat_get: (): number => badf,
    fd_pread: (): number => badf,
    fd_pwrite: (): number => badf,
    fd_readdir: (): number => badf,
    poll_oneoff: pollOneoff,
    sched_yield: (): number => success,
    random_get: (address: number, length: number): number => {
      const bytes = new Uint8Array(length);
      host.random(bytes);
      memory().u8.set(bytes, address);
      return success;
    },
    proc_exit: (code: number): never => host.leave(new ProgramExit(code)),
  };
}
