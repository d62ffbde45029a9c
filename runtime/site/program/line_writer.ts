// Cuts what a program writes into lines. Bytes of an unfinished line wait until its end, or until flush().

import { decodeUtf8 } from '../contract/utf8.ts';

const longestLine = 64 << 10;

export class LineWriter {
  private readonly emit: (line: string) => void;
  private parts: Uint8Array[] = [];
  private length = 0;

  constructor(emit: (line: string) => void) {
    this.emit = emit;
  }

  /** Keeps `bytes`: the caller must not change them. */
  write(bytes: Uint8Array): void {
    let start = 0;
    for (let end = bytes.indexOf(10); end >= 0; end = bytes.indexOf(10, start)) {
      this.push(bytes.subarray(start, end));
      this.end();
      start = end + 1;
    }
    if (start < bytes.length) this.push(bytes.subarray(start));
    if (this.length > longestLine) this.end();
  }

  flush(): void {
    if (this.length > 0) this.end();
  }

  private push(bytes: Uint8Array): void {
    this.parts.push(bytes);
    this.length += bytes.length;
  }

  private end(): void {
    let line = '';
    if (this.parts.length === 1) {
      line = decodeUtf8(this.parts[0]!);
    } else {
      const all = new Uint8Array(this.length);
      let at = 0;
      for (const part of this.parts) {
        all.set(part, at);
        at += part.length;
      }
      line = decodeUtf8(all);
    }
    this.parts = [];
    this.length = 0;
    this.emit(line.endsWith('\r') ? line.slice(0, -1) : line);
  }
}
