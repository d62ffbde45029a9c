// SHA-256 of bytes that come piece by piece; what the browser has wants all of them at once. FIPS 180-4.

const blockBytes = 64;

/** The first 32 bits behind the binary point of `power`-th roots of the first `count` primes. */
function rootBits(count: number, power: number): Int32Array {
  const bits: number[] = [];
  const primes: number[] = [];
  for (let n = 2; bits.length < count; n += 1) {
    if (primes.some((prime) => n % prime === 0)) continue;
    primes.push(n);
    // Exact: a root of numbers this small has 8 bits before the point, and a double 53 in all.
    bits.push(((n ** (1 / power)) % 1) * 2 ** 32 | 0);
  }
  return Int32Array.from(bits);
}

const constants = rootBits(64, 3);

export class RunningSha256 {
  private state = rootBits(8, 2);
  private readonly block = new Uint8Array(blockBytes);
  private readonly view = new DataView(this.block.buffer);
  private readonly words = new Int32Array(64);
  private filled = 0;
  private length = 0;

  add(bytes: Uint8Array): void {
    this.length += bytes.length;
    for (let at = 0; at < bytes.length;) {
      const part = bytes.subarray(at, at + blockBytes - this.filled);
      this.block.set(part, this.filled);
      this.filled += part.length;
      at += part.length;
      if (this.filled === blockBytes) this.compress();
    }
  }

  /** Of all bytes so far; more may come. */
  hex(): string {
    const end = new RunningSha256();
    end.state = this.state.slice();
    end.block.set(this.block);
    end.filled = this.filled;
    const padding = new Uint8Array((this.filled < 56 ? 64 : 128) - this.filled);
    padding[0] = 0x80;
    const view = new DataView(padding.buffer);
    view.setUint32(padding.length - 8, Math.floor(this.length / 2 ** 29));
    view.setUint32(padding.length - 4, (this.length << 3) >>> 0);
    end.add(padding);
    return Array.from(end.state, (word) => (word >>> 0).toString(16).padStart(8, '0')).join('');
  }

  private compress(): void {
    const { words: w, state, view } = this;
    const turned = (x: number, n: number): number => (x >>> n) | (x << (32 - n));
    for (let i = 0; i < 16; i += 1) w[i] = view.getInt32(4 * i);
    for (let i = 16; i < 64; i += 1) {
      const [x, y] = [w[i - 15]!, w[i - 2]!];
      const s0 = turned(x, 7) ^ turned(x, 18) ^ (x >>> 3);
      const s1 = turned(y, 17) ^ turned(y, 19) ^ (y >>> 10);
      w[i] = w[i - 16]! + s0 + w[i - 7]! + s1;
    }
    let [a, b, c, d, e, f, g, h] = state as unknown as [number, number, number, number, number, number, number, number];
    for (let i = 0; i < 64; i += 1) {
      const s1 = turned(e, 6) ^ turned(e, 11) ^ turned(e, 25);
      const t1 = (h + s1 + ((e & f) ^ (~e & g)) + constants[i]! + w[i]!) | 0;
      const s0 = turned(a, 2) ^ turned(a, 13) ^ turned(a, 22);
      const t2 = (s0 + ((a & b) ^ (a & c) ^ (b & c))) | 0;
      [a, b, c, d, e, f, g, h] = [(t1 + t2) | 0, a, b, c, (d + t1) | 0, e, f, g];
    }
    [a, b, c, d, e, f, g, h].forEach((word, i) => {
      state[i]! += word;
    });
    this.filled = 0;
  }
}
