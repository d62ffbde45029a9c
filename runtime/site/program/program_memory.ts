// A program's linear memory as the imports see it. Views are renewed when the memory has grown.

import type { Heap } from '../bus/link.ts';
import { decodeUtf8 } from '../contract/utf8.ts';

export class ProgramMemory implements Heap {
  readonly memory: WebAssembly.Memory;
  private buffer: ArrayBufferLike;
  private bytes: Uint8Array;
  private words: Int32Array;
  /** A shared buffer lives on beside the larger one; any other is detached, which its views tell at no cost. */
  private readonly shared: boolean;
  private readonly encoder = new TextEncoder();

  constructor(memory: WebAssembly.Memory) {
    this.memory = memory;
    this.buffer = memory.buffer;
    this.bytes = new Uint8Array(this.buffer);
    this.words = new Int32Array(this.buffer);
    this.shared = !(this.buffer instanceof ArrayBuffer);
  }

  private renew(): void {
    if (!this.shared && this.bytes.length !== 0) return;
    const { buffer } = this.memory;
    if (buffer === this.buffer) return;
    this.buffer = buffer;
    this.bytes = new Uint8Array(buffer);
    this.words = new Int32Array(buffer);
  }

  /** False when there is no more. */
  grow(bytes: number): boolean {
    try {
      this.memory.grow(Math.ceil(bytes / 65536));
      return true;
    } catch {
      return false;
    }
  }

  get u8(): Uint8Array {
    this.renew();
    return this.bytes;
  }

  get i32(): Int32Array {
    this.renew();
    return this.words;
  }

  u32(address: number): number {
    return this.i32[address >>> 2]! >>> 0;
  }

  set(address: number, value: number): void {
    this.i32[address >>> 2] = value;
  }

  setI64(address: number, value: bigint): void {
    this.set(address, Number(BigInt.asIntN(32, value)));
    this.set(address + 4, Number(BigInt.asIntN(32, value >> 32n)));
  }

  i64(address: number): bigint {
    return (BigInt(this.i32[(address >>> 2) + 1]!) << 32n) | BigInt(this.u32(address));
  }

  /** A copy. */
  slice(address: number, length: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.u8.subarray(address >>> 0, (address >>> 0) + length));
  }

  text(address: number, length: number): string {
    return decodeUtf8(this.u8.subarray(address >>> 0, (address >>> 0) + length));
  }

  /** Text up to a NUL. */
  cString(address: number): string {
    const bytes = this.u8;
    let end = address >>> 0;
    while (bytes[end] !== undefined && bytes[end] !== 0) end += 1;
    return this.text(address, end - (address >>> 0));
  }

  encode(text: string): Uint8Array {
    return this.encoder.encode(text);
  }
}
