// Tabs of one site: pages of one context.
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';

const patience = { timeout: 120_000 };

export function shows(page: Page, text: string): Promise<unknown> {
  return page.waitForFunction((wanted) => (document.body?.innerText ?? '').includes(wanted), text, patience);
}

export function lacks(page: Page, text: string): Promise<unknown> {
  return page.waitForFunction((unwanted) => !(document.body?.innerText ?? '').includes(unwanted), text, patience);
}

/** `use` opens tabs by what stands in the address behind the site's; they are closed at its end. */
export async function withTabs(
  browser: Browser,
  folder: string,
  link: 'shared' | 'port',
  use: (open: (query: string) => Promise<Page>, context: BrowserContext) => Promise<void>,
): Promise<void> {
  const host = await serveFolder(folder, { isolated: link === 'shared' });
  const context = await browser.newContext({ serviceWorkers: link === 'shared' ? 'allow' : 'block' });
  try {
    await use(async (query) => {
      const page = await context.newPage();
      await page.goto(`${host.url}${query}`);
      return page;
    }, context);
  } finally {
    await context.close();
    await host.close();
  }
}
