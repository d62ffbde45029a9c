// Bytes to text, as TextDecoder does it (a wrong sequence becomes U+FFFD), for what a program says over and over: in Chromium
// a worker that never returns to its event loop grows with every text of a TextDecoder. `./dev bench lines` measures it.

const mostUnits = 1024;

export class Utf8Decoder {
  private readonly units = new Uint16Array(mostUnits);
  private used = 0;
  private text = '';

  decode(bytes: Uint8Array): string {
    this.text = '';
    let point = 0;
    let missing = 0;
    // What the next byte of a sequence may be.
    let [least, most] = [0x80, 0xbf];
    for (let i = 0; i < bytes.length; i += 1) {
      const byte = bytes[i]!;
      if (missing === 0) {
        if (byte < 0x80) {
          point = byte;
        } else if (byte >= 0xc2 && byte <= 0xf4) {
          missing = byte < 0xe0 ? 1 : byte < 0xf0 ? 2 : 3;
          point = byte & (0x3f >> missing);
          // Neither longer than need be, nor half of a pair, nor above the last point.
          if (byte === 0xe0) least = 0xa0;
          if (byte === 0xed) most = 0x9f;
          if (byte === 0xf0) least = 0x90;
          if (byte === 0xf4) most = 0x8f;
          continue;
        } else {
          point = 0xfffd;
        }
      } else if (byte >= least && byte <= most) {
        point = (point << 6) | (byte & 0x3f);
        missing -= 1;
        [least, most] = [0x80, 0xbf];
        if (missing > 0) continue;
      } else {
        point = 0xfffd;
        missing = 0;
        [least, most] = [0x80, 0xbf];
        // It may begin something itself.
        i -= 1;
      }
      this.add(point);
    }
    if (missing > 0) this.add(0xfffd);
    this.flush();
    return this.text;
  }

  private add(point: number): void {
    if (this.used + 2 > mostUnits) this.flush();
    if (point < 0x10000) {
      this.units[this.used++] = point;
      return;
    }
    this.units[this.used++] = 0xd7c0 + (point >> 10);
    this.units[this.used++] = 0xdc00 | (point & 0x3ff);
  }

  private flush(): void {
    this.text += String.fromCharCode(...this.units.subarray(0, this.used));
    this.used = 0;
  }
}
