// Time as programs see it, in halves of an int64, without BigInt on the way of a message.

const high = 2 ** 32;

/** Writes ns (a whole number below 2^63) as two words. */
export function putNanoseconds(i32: Int32Array, word: number, ns: number): void {
  i32[word] = ns % high | 0;
  i32[word + 1] = Math.floor(ns / high);
}

/** ns since 1970; the clock resolves some hundred ns. */
export function systemNanoseconds(): number {
  return (performance.timeOrigin + performance.now()) * 1e6;
}

/** A monotonic time that all workers of a page share, in ns. */
export function steadyNanoseconds(): number {
  return (performance.timeOrigin - steadyZero + performance.now()) * 1e6;
}

// performance.now() counts from the worker's own start; a late zero (ms since 1970) keeps a double exact to 16 ns.
const steadyZero = 1.7e12;
