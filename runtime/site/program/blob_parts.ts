// Reads a blob from its begin on, through one small buffer: a worker that sleeps in Atomics.wait collects no garbage, so
// that what it has read at once would stay.

const pieceBytes = 1 << 18;

export class BlobParts {
  private readonly blob: Blob;
  /** undefined: this browser cannot read into a given buffer. */
  private reader: ReadableStreamBYOBReader | undefined;
  private buffer = new ArrayBuffer(pieceBytes);
  private at = 0;

  constructor(blob: Blob) {
    this.blob = blob;
    try {
      this.reader = blob.stream().getReader({ mode: 'byob' });
    } catch {
      this.reader = undefined;
    }
  }

  /** Fills the target with what comes next. Throws RangeError when there is not so much. */
  async read(target: Uint8Array): Promise<void> {
    for (let filled = 0; filled < target.length;) {
      const piece = await this.piece(Math.min(pieceBytes, target.length - filled));
      if (piece.length === 0) throw new RangeError('the bytes end too early');
      target.set(piece, filled);
      filled += piece.length;
    }
  }

  private async piece(most: number): Promise<Uint8Array> {
    if (this.reader === undefined) {
      const bytes = new Uint8Array(await this.blob.slice(this.at, this.at + most).arrayBuffer());
      this.at += bytes.length;
      return bytes;
    }
    const { value } = await this.reader.read(new Uint8Array(this.buffer, 0, most));
    if (value === undefined) return new Uint8Array(0);
    this.buffer = value.buffer;
    this.at += value.length;
    // The browser's own buffer goes with the reader.
    if (this.at === this.blob.size) await this.reader.cancel();
    return value;
  }
}
