// The page that plays a site in a browser: `playSite` is called from outside.
import { browserPlatform } from '../../runtime/site/session/browser_platform.ts';
import { type Played, play } from './play.ts';
import { received } from './posted.ts';

async function playSite(text: string): Promise<Played> {
  const platform = browserPlatform(new URL('./', document.baseURI), 'node_worker.js');
  try {
    return await play(platform, received(text));
  } finally {
    platform.close();
  }
}

Object.assign(globalThis, { playSite });
