// Threads of a program that wait for a time in the program's own memory (condition variables, futures): how the page
// tells them that the site's time has changed. The list is templates/toolchain/src/thread_support.cpp's.

/** The memory of a program with threads, and the address of its list of timed waits. */
export interface ThreadMemory {
  readonly memory: WebAssembly.Memory;
  readonly waits: number;
}

const entry = { address: 0, version: 1, next: 2 };

/** Wakes those that went to wait under an older law than `version`. True when there were none. */
export function tellThreads({ memory, waits }: ThreadMemory, version: number): boolean {
  const words = new Int32Array(memory.buffer);
  const load = (address: number): number => Atomics.load(words, address >>> 2);
  let told = true;
  for (let at = load(waits); at !== 0; at = load(at + 4 * entry.next)) {
    const address = load(at + 4 * entry.address);
    if (address === 0 || load(at + 4 * entry.version) === version) continue;
    Atomics.notify(words, address >>> 2);
    told = false;
  }
  return told;
}
