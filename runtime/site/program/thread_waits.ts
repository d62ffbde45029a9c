// Threads of a program that wait for a time in the program's own memory (condition variables, futures): how the page
// tells them that the site's time has changed. The list is templates/toolchain/src/thread_support.cpp's.

/** The memory of a program with threads, and the address of its list of timed waits. */
export interface ThreadMemory {
  readonly memory: WebAssembly.Memory;
  readonly waits: number;
}

const entry = { address: 0, version: 1, next: 2 };

/** A longer list is not from ros2wasm: the program has overwritten it, maybe so that it has no end. */
const mostWaits = 4096;

/** Wakes those that went to wait under an older law than `version`. True when there were none. */
export function tellThreads({ memory, waits }: ThreadMemory, version: number): boolean {
  const words = new Int32Array(memory.buffer);
  /** 0 beyond the memory. */
  const load = (address: number): number => address >>> 2 < words.length ? Atomics.load(words, address >>> 2) : 0;
  let told = true;
  let left = mostWaits;
  for (let at = load(waits); at !== 0; at = load(at + 4 * entry.next)) {
    left -= 1;
    if (left < 0) return true;
    const address = load(at + 4 * entry.address);
    if (address === 0 || address >>> 2 >= words.length || load(at + 4 * entry.version) === version) continue;
    Atomics.notify(words, address >>> 2);
    told = false;
  }
  return told;
}
