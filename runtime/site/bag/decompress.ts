// The two compressions of chunks in MCAP files. The output is bounded by the size that the chunk declares, which
// is bounded too: false sizes give an error, never more memory.

import { decompress as zstd } from 'fzstd';

/** Upper bound of the bytes of one chunk. Writers make chunks of some MiB. */
export const mostChunkBytes = 128 * 2 ** 20;

export type Decompress = (data: Uint8Array, size: bigint) => Uint8Array;

const bounded = (work: (data: Uint8Array, out: Uint8Array) => Uint8Array): Decompress => (data, size) => {
  if (size > BigInt(mostChunkBytes)) throw new Error(`a chunk of ${size} bytes is too large`);
  const out = work(data, new Uint8Array(Number(size)));
  if (out.length !== Number(size)) throw new Error(`a chunk has ${out.length} bytes, and said ${size}`);
  return out;
};

export const decompressHandlers: Readonly<Record<'lz4' | 'zstd', Decompress>> = {
  // Given where to write it writes nowhere else, whatever its header says.
  zstd: bounded((data, out) => zstd(data, out)),
  lz4: bounded(lz4Frame),
};

const lz4Magic = 0x184d2204;

/** A frame of LZ4, one after the other when there are several. Checksums are not looked at: chunks have their own. */
export function lz4Frame(data: Uint8Array, out: Uint8Array): Uint8Array {
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  let at = 0;
  let to = 0;
  while (at < data.length) {
    if (view.getUint32(at, true) !== lz4Magic) throw new Error('this is not a frame of LZ4');
    const flags = view.getUint8(at + 4);
    if (flags >> 6 !== 1) throw new Error('a newer LZ4 than this reads');
    if ((flags & 1) !== 0) throw new Error('LZ4 with a dictionary');
    const hasBlockSums = (flags & 16) !== 0;
    at += 7 + ((flags & 8) === 0 ? 0 : 8);
    for (;;) {
      const head = view.getUint32(at, true);
      at += 4;
      if (head === 0) break;
      const length = head & 0x7fffffff;
      if (at + length > data.length) throw new Error('LZ4 data end early');
      const block = data.subarray(at, at + length);
      if (head >>> 31 === 0) {
        to = lz4Block(block, out, to);
      } else {
        // RangeError when there is no room.
        out.set(block, to);
        to += length;
      }
      at += length + (hasBlockSums ? 4 : 0);
    }
    if ((flags & 4) !== 0) at += 4;
  }
  return out.subarray(0, to);
}

/** Writes from `to` on; gives where it ended. Matches may reach back into earlier blocks. */
function lz4Block(block: Uint8Array, out: Uint8Array, to: number): number {
  let at = 0;
  /** 15 goes on in the bytes behind it. */
  const length = (first: number): number => {
    let sum = first;
    if (first !== 15) return sum;
    for (;;) {
      const more = block[at++];
      if (more === undefined) throw new Error('LZ4 data end early');
      sum += more;
      if (more !== 255) return sum;
    }
  };
  while (at < block.length) {
    const token = block[at++]!;
    const literals = length(token >> 4);
    if (at + literals > block.length || to + literals > out.length) throw new Error('LZ4 data have another length than they say');
    out.set(block.subarray(at, at + literals), to);
    at += literals;
    to += literals;
    // The last part of a block has no match.
    if (at === block.length) break;
    const back = (block[at] ?? 0) | (block[at + 1] ?? 0) << 8;
    at += 2;
    const match = 4 + length(token & 15);
    if (back === 0 || back > to || to + match > out.length) throw new Error('LZ4 data point outside of what they made');
    // One by one: a match may overlap itself.
    for (const end = to + match; to < end; to += 1) out[to] = out[to - back]!;
  }
  return to;
}
