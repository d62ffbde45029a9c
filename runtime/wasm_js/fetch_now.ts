// Fetches a file of the site in the middle of a call: workers, unlike pages, may wait for an answer.

import type { ReadNow } from './site_files.ts';

export const fetchNow: ReadNow = (place, path) => {
  const address = new URL(path.split('/').map(encodeURIComponent).join('/'), place);
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
