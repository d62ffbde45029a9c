// A conversation by lines over standard input and output, without the event loop: Python's code runs in between.

import { readSync, writeSync } from 'node:fs';

const input = 0;
const output = 1;
const bufferSize = 1 << 16;
const again = 'EAGAIN';

let pending = Buffer.alloc(0);

/** The next line; nothing at the end. */
export function receive() {
  const pieces = [];
  for (;;) {
    const end = pending.indexOf('\n');
    if (end >= 0) {
      pieces.push(pending.subarray(0, end));
      pending = pending.subarray(end + 1);
      return Buffer.concat(pieces).toString();
    }
    pieces.push(pending);
    const buffer = Buffer.alloc(bufferSize);
    let count;
    try {
      count = readSync(input, buffer);
    } catch (error) {
      if (error.code === again) continue;
      throw error;
    }
    if (count === 0) return undefined;
    pending = buffer.subarray(0, count);
  }
}

/** Waits until all of the line is written. */
export function send(text) {
  let bytes = Buffer.from(`${text}\n`);
  while (bytes.length > 0) {
    try {
      bytes = bytes.subarray(writeSync(output, bytes));
    } catch (error) {
      if (error.code !== again) throw error;
    }
  }
}
