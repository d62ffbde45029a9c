// Threads of a Python program, as JavaScript has them: stacks of which one runs, and what interrupts Python in between.
// ros2wasm/threads.py says who is next.

import type { PyCallable } from 'pyodide/ffi';

/** SIGINT. */
export const interrupt = 2;
/** As long a thread computes before others get their turn, as in CPython. */
export const sliceMs = 5;
/** SIGVTALRM: Python's handler lets other threads go on (threads.py). */
export const sliceSignal = 26;

/**
 * Interrupts Python while it computes: Pyodide looks at [0] now and then, and stores 0 there after each look. For a stop,
 * which only the main thread hears of, and when a thread has run for its slice of time.
 */
export class Interrupts {
  private readonly stops: () => number;
  private readonly sliced: boolean;
  private forgotten = 0;
  private shown = false;
  private told = false;
  private threads = 1;
  private mainRuns = true;
  private sliceEnd = 0;
  /** Python waits in a suspension, out of which nobody may be interrupted: the wait itself tells. */
  suspended = false;

  /** `sliced`: threads are interrupted by time. */
  constructor(stops: () => number, sliced: boolean) {
    this.stops = stops;
    this.sliced = sliced;
  }

  get 0(): number {
    if (this.suspended) return 0;
    if (!this.told && this.mainRuns && this.stops() !== this.forgotten) {
      this.shown = true;
      return interrupt;
    }
    if (this.threads === 1 || !this.sliceIsOver()) return 0;
    // In the middle of our own code nobody is interrupted: it is tried again soon.
    this.sliceEnd = performance.now() + sliceMs / 8;
    return sliceSignal;
  }

  set 0(_seen: number) {
    if (this.shown) this.told = true;
  }

  /** Whether a stop that a wait tells of is news; it is none from then on. */
  take(): boolean {
    const news = !this.told;
    this.told = true;
    return news;
  }

  /** The program goes on, and hears of the next stop. */
  forget(): void {
    this.forgotten = this.stops();
    this.told = false;
    this.shown = false;
  }

  setThreads(count: number): void {
    this.threads = count;
  }

  threadRuns(isMain: boolean): void {
    this.mainRuns = isMain;
    this.suspended = false;
    this.sliceEnd = performance.now() + sliceMs;
  }

  sliceIsOver(): boolean {
    return this.sliced && performance.now() > this.sliceEnd;
  }
}

/**
 * Stacks of one Python program: one runs, the others are suspended until somebody lets them go on. `died`: a stack ended
 * in another way than Python does, so that nobody goes on any more.
 */
export function threadFunctions(
  interrupts: Interrupts,
  wait: (promise: Promise<void>) => void,
  died: (error: unknown) => void,
): Record<string, unknown> {
  const parked = new Map<number, () => void>();
  const runStack = async (begin: PyCallable): Promise<void> => {
    await begin.callPromising();
    begin.destroy();
  };
  return {
    set_threads: (count: number) => interrupts.setThreads(count),
    thread_runs: (_ident: number, isMain: boolean) => interrupts.threadRuns(isMain),
    slice_is_over: () => interrupts.sliceIsOver(),
    // A thread that lets another one run then rests, or ends: until that one runs, only Pyodide's own code does (see `wait`).
    begin_thread: (begin: PyCallable) => {
      interrupts.suspended = true;
      const kept = begin.copy() as PyCallable;
      queueMicrotask(() => void runStack(kept).catch(died));
    },
    park: (ident: number) => wait(new Promise<void>((resolve) => parked.set(ident, resolve))),
    unpark: (ident: number) => {
      interrupts.suspended = true;
      parked.get(ident)?.();
      parked.delete(ident);
    },
  };
}
