// A page tells its service worker which site.json it was opened with. The service worker ends when nothing is asked of it,
// and what it has cached of that can be written by every page of the origin; this page's memory cannot.

import { sha256Of } from './expected_files.ts';

/** The service worker's question; the answer, through the port that comes with it, is the sha256 of site.json. */
export const askForList = 'which site.json';

/** `text`: site.json as the page got it. */
export function answerForList(text: string): void {
  try {
    const { serviceWorker } = navigator as { readonly serviceWorker?: ServiceWorkerContainer; };
    serviceWorker?.addEventListener('message', ({ data, ports }: MessageEvent<unknown>) => {
      if (data === askForList) void sha256Of(new TextEncoder().encode(text)).then((hash) => ports[0]?.postMessage(hash));
    });
    serviceWorker?.startMessages();
  } catch {
    // Some frames have no service worker, and then nobody asks.
  }
}
