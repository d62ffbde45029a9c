// Fetches a file of the site in the middle of a call: workers, unlike pages, may wait for an answer. `addressOf` gives where
// a file is that has that address in the site.

import type { ReadNow } from './site_files.ts';

export const fetchNow = (addressOf: (address: string) => string): ReadNow => (place, path) => {
  const address = addressOf(new URL(path.split('/').map(encodeURIComponent).join('/'), place).href);
  const request = new XMLHttpRequest();
  try {
    request.open('GET', address, false);
    request.responseType = 'arraybuffer';
    request.send();
  } catch {
    return undefined;
  }
  return request.status === 200 ? new Uint8Array(request.response as ArrayBuffer) : undefined;
};
