// One file of a zip archive as `pack` writes them: stored as it is, in less than 4 GB. Other archives give no file.

const endMark = 0x06054b50;
const entryMark = 0x02014b50;
const fileMark = 0x04034b50;
const endSize = 22;
const entrySize = 46;
const fileSize = 30;
const stored = 0;

/** undefined: it is not in there, or the archive is broken. Nothing is copied. */
export function zipMember(archive: Uint8Array<ArrayBuffer>, name: string): Uint8Array<ArrayBuffer> | undefined {
  const view = new DataView(archive.buffer, archive.byteOffset, archive.byteLength);
  const wanted = new TextEncoder().encode(name);
  const isWanted = (at: number, length: number): boolean =>
    length === wanted.length && at + length <= archive.length && wanted.every((byte, i) => archive[at + i] === byte);
  // Without a comment, as `pack` writes it.
  const end = archive.length - endSize;
  if (end < 0 || view.getUint32(end, true) !== endMark) return undefined;
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  for (let i = 0; i < count; i += 1) {
    if (at + entrySize > end || view.getUint32(at, true) !== entryMark) return undefined;
    const length = view.getUint16(at + 28, true);
    if (isWanted(at + entrySize, length)) return bytesOf(archive, view, at);
    at += entrySize + length + view.getUint16(at + 30, true) + view.getUint16(at + 32, true);
  }
  return undefined;
}

function bytesOf(archive: Uint8Array<ArrayBuffer>, view: DataView, entry: number): Uint8Array<ArrayBuffer> | undefined {
  const size = view.getUint32(entry + 24, true);
  const file = view.getUint32(entry + 42, true);
  if (view.getUint16(entry + 10, true) !== stored || file + fileSize > archive.length || view.getUint32(file, true) !== fileMark) return undefined;
  const begin = file + fileSize + view.getUint16(file + 26, true) + view.getUint16(file + 28, true);
  return begin + size > archive.length ? undefined : archive.subarray(begin, begin + size);
}
