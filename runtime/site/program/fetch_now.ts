// Fetches a file of the site in the middle of a call: workers, unlike pages, may wait for an answer. `addressesOf` gives
// where a file is, part by part, that has that address beside site.json.

import type { ReadNow } from './site_files.ts';

export function joinedBytes(parts: readonly ArrayBuffer[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(parts.reduce((sum, { byteLength }) => sum + byteLength, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(new Uint8Array(part), at);
    at += part.byteLength;
  }
  return bytes;
}

export const fetchNow = (addressesOf: (address: string) => readonly string[]): ReadNow => (place, path) => {
  const parts: ArrayBuffer[] = [];
  for (const address of addressesOf(new URL(path.split('/').map(encodeURIComponent).join('/'), place).href)) {
    const request = new XMLHttpRequest();
    try {
      request.open('GET', address, false);
      request.responseType = 'arraybuffer';
      request.send();
    } catch {
      return undefined;
    }
    if (request.status !== 200) return undefined;
    parts.push(request.response as ArrayBuffer);
  }
  return joinedBytes(parts);
};
