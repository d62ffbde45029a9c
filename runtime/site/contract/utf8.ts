// Bytes to text, as TextDecoder does it (a wrong sequence becomes U+FFFD), for what workers read over and over: in Chromium
// a worker that never returns to its event loop grows with every text of a TextDecoder. `./dev bench lines` measures it.

/** More arguments a call may not have everywhere. */
const mostUnits = 1024;

export function decodeUtf8(bytes: Uint8Array): string {
  let text = '';
  const units: number[] = [];
  const add = (point: number): void => {
    if (units.length + 2 > mostUnits) {
      text += String.fromCharCode(...units);
      units.length = 0;
    }
    if (point < 0x10000) units.push(point);
    else units.push(0xd7c0 + (point >> 10), 0xdc00 | (point & 0x3ff));
  };
  let point = 0;
  let missing = 0;
  // The limits of the next byte of a sequence.
  let least = 0x80;
  let most = 0xbf;
  for (let i = 0; i < bytes.length; i += 1) {
    const byte = bytes[i]!;
    if (missing > 0) {
      const fits = byte >= least && byte <= most;
      least = 0x80;
      most = 0xbf;
      missing = fits ? missing - 1 : 0;
      if (missing > 0) point = (point << 6) | (byte & 0x3f);
      else add(fits ? (point << 6) | (byte & 0x3f) : 0xfffd);
      // A byte that does not fit may begin something itself.
      if (!fits) i -= 1;
    } else if (byte >= 0xc2 && byte <= 0xf4) {
      missing = byte < 0xe0 ? 1 : byte < 0xf0 ? 2 : 3;
      point = byte & (0x3f >> missing);
      // Neither longer than need be, nor half of a pair, nor above the last point.
      if (byte === 0xe0) least = 0xa0;
      if (byte === 0xed) most = 0x9f;
      if (byte === 0xf0) least = 0x90;
      if (byte === 0xf4) most = 0x8f;
    } else {
      add(byte < 0x80 ? byte : 0xfffd);
    }
  }
  if (missing > 0) add(0xfffd);
  return text + String.fromCharCode(...units);
}
