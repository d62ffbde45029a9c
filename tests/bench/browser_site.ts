// A page of a folder with shared memory, in a browser of its own.
import { chromium, type Page } from 'playwright-core';
import { wholeChromium } from '../e2e/support/chromium.ts';
import { serveFolder } from '../support/static_server.ts';

/** `use` gets an empty page, the browser's process, and the address of the folder. */
export async function inBrowser(folder: string, use: (page: Page, pid: number, url: string) => Promise<void>): Promise<void> {
  const host = await serveFolder(folder, { isolated: true });
  const server = await chromium.launchServer(wholeChromium());
  const browser = await chromium.connect(server.wsEndpoint());
  try {
    await use(await browser.newPage(), server.process().pid ?? 0, host.url);
  } finally {
    await browser.close();
    await server.close();
    await host.close();
  }
}
