// Where sites are played: worker threads of Node.js, or a page in Chromium.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { chromium } from 'playwright-core';
import { nodePlatform } from '../../runtime/site/session/node_platform.ts';
import { wholeChromium } from '../e2e/support/chromium.ts';
import { serveFolder } from '../support/static_server.ts';
import { type Asked, type Played, play } from './play.ts';
import { posted } from './posted.ts';

export interface Player {
  /** `folder`: a packed site. */
  play(folder: string, asked: Asked): Promise<Played>;
  close(): Promise<void>;
}

/** `headless`: the built headless.js, which serves nodes as worker threads. */
export function nodePlayer(headless: string): Player {
  return {
    play: async (folder, asked) => {
      const platform = nodePlatform(folder, pathToFileURL(headless));
      try {
        return await play(platform, asked);
      } finally {
        platform.close();
      }
    },
    close: () => Promise.resolve(),
  };
}

/** The nodes of a site are workers of a page on its host, beside the site's own. */
export async function chromiumPlayer(): Promise<Player> {
  const { outputFiles: [script] } = await build({
    entryPoints: [join(import.meta.dirname, 'play_page.ts')],
    bundle: true,
    format: 'iife',
    target: 'es2022',
    write: false,
    logLevel: 'warning',
  });
  if (script === undefined) throw new Error('the script of the page is not made');
  const browser = await chromium.launch(wholeChromium());
  return {
    play: async (folder, asked) => {
      writeFileSync(join(folder, 'play.js'), script.contents);
      writeFileSync(join(folder, 'play.html'), '<!doctype html><title>score board</title><script src="play.js"></script>');
      const host = await serveFolder(folder, { isolated: true });
      const page = await browser.newPage();
      try {
        await page.goto(`${host.url}play.html`);
        return await page.evaluate((text) => {
          const { playSite } = globalThis as unknown as { playSite: (text: string) => Promise<Played>; };
          return playSite(text);
        }, posted(asked));
      } finally {
        await page.close();
        await host.close();
      }
    },
    close: () => browser.close(),
  };
}
