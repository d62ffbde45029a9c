// Helpers for tests of bags: bags in memory, and waiting.

import type { BagSource } from '../../../runtime/site/bag/bag_file.ts';

export class MemorySink {
  readonly parts: Uint8Array[] = [];

  write(bytes: Uint8Array): void {
    this.parts.push(bytes);
  }

  bytes(): Uint8Array {
    return new Uint8Array(Buffer.concat(this.parts));
  }
}

export function sourceOf(bytes: Uint8Array, name = 'run.mcap'): BagSource {
  return { name, size: bytes.length, read: (from, length) => Promise.resolve(bytes.slice(from, from + length)) };
}

/** Resolves when the condition holds; the test's watchdog ends it otherwise. */
export async function until(condition: () => boolean): Promise<void> {
  while (!condition()) await new Promise((done) => setTimeout(done, 1));
}
