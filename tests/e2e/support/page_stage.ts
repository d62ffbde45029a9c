// Tests of the page in a browser share these: the built page with the fake session, served; a page that fails on
// any trouble; axe-core.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import type { Browser, BrowserContextOptions, Frame, Page } from 'playwright-core';
import type { FakeSession } from '../../unit/ui/fake_session.ts';
import { chromiumOptions } from './chromium.ts';
import { buildFakePage } from './page_site.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';

declare global {
  // Set by page_fake.tsx in the browser.
  var fake: FakeSession;
}

interface AxeResult {
  readonly id: string;
  readonly help: string;
  readonly nodes: readonly {
    readonly target: readonly unknown[];
    readonly failureSummary?: string;
  }[];
}

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

export const phone: BrowserContextOptions = { viewport: { width: 360, height: 740 } };

/** The built page, served, and a browser. Opened in before(), closed in after(). */
export class PageStage {
  readonly folder: string;
  readonly served: StaticServer;
  readonly browser: Browser;

  private constructor(folder: string, served: StaticServer, browser: Browser) {
    this.folder = folder;
    this.served = served;
    this.browser = browser;
  }

  /** `flags`: more of Chromium's. */
  static async open(flags: readonly string[] = []): Promise<PageStage> {
    const folder = await buildFakePage(mkdtempSync(join(tmpdir(), 'ros2wasm-page-')));
    return new PageStage(
      folder,
      await serveFolder(folder),
      await chromium.launch(chromiumOptions(flags)),
    );
  }

  async close(): Promise<void> {
    await this.browser.close();
    await this.served.close();
    rmSync(this.folder, { recursive: true, force: true });
  }

  /** Opens a scene, waits for what is `shown`, runs the body, and fails on any console error, exception or request outside the site. */
  async on(
    scene: string,
    options: BrowserContextOptions,
    body: (page: Page) => Promise<void>,
    expected: RegExp | null = null,
    shown = '.page, .lone-failure',
  ): Promise<void> {
    const context = await this.browser.newContext({
      viewport: { width: 1280, height: 800 },
      ...options,
    });
    const page = await context.newPage();
    const troubles: string[] = [];
    page.setDefaultTimeout(60_000);
    page.on('console', (message) => {
      if (message.type() === 'error' || message.type() === 'warning') troubles.push(message.text());
    });
    page.on('pageerror', (error) => troubles.push(error.message));
    page.on('request', (request) => {
      if (!request.url().startsWith(this.served.url)) troubles.push(`request to ${request.url()}`);
    });
    try {
      await page.goto(`${this.served.url}?scene=${scene}`);
      await page.waitForSelector(shown);
      await body(page);
      assert.deepEqual(
        troubles.filter((text) => expected?.test(text) !== true),
        [],
      );
    } finally {
      await context.close();
    }
  }
}

/** Fails when axe-core finds anything, best practices included. */
export async function expectAccessible(page: Page | Frame): Promise<void> {
  if (!await page.evaluate(() => 'axe' in globalThis)) await page.evaluate(AXE);
  const violations = await page.evaluate(async () => {
    const { axe } = globalThis as unknown as {
      axe: { run: (options: object) => Promise<{ violations: AxeResult[]; }>; };
    };
    // The only rule of WCAG 2.2 AA, and the only one of A and AA that does not run unasked.
    return (await axe.run({ rules: { 'target-size': { enabled: true } }, resultTypes: ['violations'] })).violations;
  });
  const told = violations.map((violation) => {
    const nodes = violation.nodes.map(
      (node) => `  ${String(node.target)} ${node.failureSummary ?? ''}`,
    );
    return [`${violation.id}: ${violation.help}`, ...nodes].join('\n');
  });
  assert.deepEqual(told, []);
}

/** The name of what has the keyboard focus. */
export function focused(page: Page): Promise<string> {
  return page.evaluate(() => {
    const element = document.activeElement;
    return element?.getAttribute('aria-label') || element?.id || element?.textContent || '';
  });
}
