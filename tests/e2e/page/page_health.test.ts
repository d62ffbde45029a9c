// Diagnostics and managed nodes in Chromium, with messages and calls that really pass the graph.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

interface Managed {
  refuses: boolean;
  silent: boolean;
  go(label: string, to: number): void;
  leave(): void;
  come(): void;
}

declare global {
  // Set by page_fake.tsx in the scene "health".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
  var driver: Managed;
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const HOSTILE = '<img src=x onerror="document.title=\'owned\'">';
let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

const withPanel = (panel: unknown, shown: string): string =>
  `health#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', panel], sizes: [1, 3], shown }))}`;
const diagnostics = (state: unknown = {}): string => withPanel({ diagnostics: state }, 'diagnostics');

interface Status {
  readonly level: number;
  readonly name: string;
  readonly message?: string;
  readonly hardware_id?: string;
  readonly values?: readonly { readonly key: string; readonly value: string; }[];
}

async function tell(page: Page, status: readonly Status[]): Promise<void> {
  // Makes the publisher, so that the panel's subscription can be waited for.
  if ((await page.evaluate(() => heard('/diagnostics'))) === 0) {
    await page.evaluate(() => send('/diagnostics', 'diagnostic_msgs/msg/DiagnosticArray', {}));
    await page.waitForFunction(() => heard('/diagnostics') > 0);
  }
  await page.evaluate((list) => send('/diagnostics', 'diagnostic_msgs/msg/DiagnosticArray', { status: list }), status);
}

const STATUSES: readonly Status[] = [
  { level: 0, name: 'battery', message: '12.1 V' },
  {
    level: 2,
    name: 'motor: left',
    message: 'does not answer',
    hardware_id: 'SN 42',
    values: [{ key: 'Temperature', value: '81.5' }, { key: HOSTILE, value: HOSTILE }],
  },
  { level: 1, name: 'laser', message: 'slow: 7 Hz' },
  { level: 0, name: HOSTILE, message: HOSTILE },
];

/** Names with their levels, in order. */
const rows = (page: Page): Promise<string[]> =>
  page.locator('.panel-diagnostics .topic').evaluateAll((all) =>
    all.map((each) => `${each.querySelector('.topic-name')?.textContent ?? ''}: ${each.querySelector('.diagnostics-level')?.textContent ?? ''}`)
  );

test('statuses stand by level, the worst first, with counts, and what is silent is stale', () =>
  stage.on(diagnostics(), {}, async (page) => {
    await page.getByText('No diagnostics have arrived').waitFor();
    // Time stands still, so that nothing grows stale by itself.
    await page.evaluate(() => {
      const view = fake.time.view();
      fake.time.view = () => view;
    });
    await tell(page, STATUSES);
    await page.getByText('12.1 V').waitFor();
    assert.deepEqual(await rows(page), ['motor: left: Error', 'laser: Warning', `${HOSTILE}: OK`, 'battery: OK']);
    const levels = page.getByRole('group', { name: 'Level shown' });
    assert.deepEqual(await levels.getByRole('button').allTextContents(), ['All 4', 'Error 1', 'Warning 1', 'Stale 0', 'OK 2']);
    await page.getByRole('button', { name: /^motor: left/ }).click();
    const facts = page.locator('.diagnostics-facts');
    assert.match((await facts.textContent()) ?? '', /Messagedoes not answerHardwareSN 42Temperature81\.5<img/);
    assert.equal(await page.locator('.panel-diagnostics img').count(), 0);
    assert.notEqual(await page.title(), 'owned');
    await page.screenshot({ path: join(OUTPUT, 'diagnostics.png') });
    await levels.getByRole('button', { name: /^OK/ }).click();
    await page.waitForFunction(() => document.querySelectorAll('.panel-diagnostics .topic').length === 2);
    await page.getByRole('searchbox', { name: 'Filter diagnostics' }).fill('BATT');
    await page.waitForFunction(() => document.querySelectorAll('.panel-diagnostics .topic').length === 1);
    await page.getByRole('searchbox', { name: 'Filter diagnostics' }).fill('');
    await levels.getByRole('button', { name: /^All/ }).click();
    // A newer status takes the place of the older one of its name.
    await tell(page, [{ level: 0, name: 'motor: left', message: 'answers again' }]);
    await levels.getByRole('button', { name: 'Error 0' }).waitFor();
    // Five seconds of the site's time later.
    await page.evaluate(() => {
      const view = { ...fake.time.view(), now: Date.now() + 6000 };
      fake.time.view = () => view;
    });
    await levels.getByRole('button', { name: 'Stale 4' }).waitFor();
    await page.getByText('Stale, was Warning').waitFor();
    await page.getByRole('button', { name: 'Clear the diagnostics' }).click();
    await page.getByText('No diagnostics have arrived').waitFor();
  }));

const lifecycle = withPanel('lifecycle', 'lifecycle');
const node = (page: Page, name: string) => page.locator('.panel-lifecycle .node').filter({ has: page.getByRole('heading', { name, exact: true }) });

test('managed nodes show their states and take the transitions that there are', () =>
  stage.on(lifecycle, {}, async (page) => {
    const row = node(page, '/driver');
    await row.getByText('unconfigured').waitFor();
    await node(page, '/camera').getByText('unconfigured').waitFor();
    assert.deepEqual(await row.getByRole('button').allTextContents(), ['configure', 'shutdown']);
    await page.getByRole('button', { name: 'configure /driver' }).click();
    await row.getByText('inactive', { exact: true }).waitFor();
    await row.getByText('configure: done').waitFor();
    await page.getByRole('button', { name: 'activate /driver', exact: true }).click();
    await row.getByText('active', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'deactivate /driver' }).waitFor();
    await page.screenshot({ path: join(OUTPUT, 'lifecycle.png') });
    // By somebody else.
    await page.evaluate(() => driver.go('deactivate', 2));
    await row.getByText('inactive', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'cleanup /driver' }).waitFor();
    await page.evaluate(() => {
      driver.refuses = true;
    });
    await page.getByRole('button', { name: 'activate /driver', exact: true }).click();
    await row.getByRole('alert').getByText('activate: the node has not made this transition').waitFor();
    await row.getByText('inactive', { exact: true }).waitFor();
  }));

test('a node that goes while it is asked stays as gone, and is read again when it comes', () =>
  stage.on(lifecycle, {}, async (page) => {
    const row = node(page, '/driver');
    await page.getByRole('button', { name: 'configure /driver' }).waitFor();
    await page.evaluate(() => {
      driver.silent = true;
    });
    await page.getByRole('button', { name: 'configure /driver' }).click();
    await row.getByText('configure: waits for the answer').waitFor();
    assert.equal(await page.getByRole('button', { name: 'shutdown /driver' }).getAttribute('aria-disabled'), 'true');
    await page.evaluate(() => driver.leave());
    await row.getByText('has gone', { exact: true }).waitFor();
    assert.equal(await row.getByRole('button').count(), 0);
    await page.evaluate(() => {
      driver.silent = false;
      driver.come();
    });
    await row.getByText('unconfigured').waitFor();
    await page.getByRole('button', { name: 'configure /driver' }).focus();
    await page.keyboard.press('Enter');
    await row.getByText('inactive', { exact: true }).waitFor();
    // Its button has gone: the keyboard is at the first of those that came.
    await page.waitForFunction(() => document.activeElement?.getAttribute('aria-label') === 'cleanup /driver');
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in diagnostics and lifecycle, ${colorScheme}`, () =>
    stage.on(withPanel({ column: ['diagnostics', 'lifecycle'] }, 'diagnostics'), { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await page.getByRole('button', { name: 'configure /driver' }).click();
      await node(page, '/driver').getByText('inactive', { exact: true }).waitFor();
      await tell(page, STATUSES);
      await page.getByRole('button', { name: /^motor: left/ }).click();
      await expectAccessible(page);
    }));
}

test('diagnostics and lifecycle fit a phone', async () => {
  await stage.on(diagnostics(), { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await tell(page, STATUSES);
    await page.getByRole('button', { name: /^motor: left/ }).click();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    await page.screenshot({ path: join(OUTPUT, 'diagnostics_phone.png') });
    await expectAccessible(page);
  });
  await stage.on(lifecycle, { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await page.getByRole('button', { name: 'configure /driver' }).waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    await expectAccessible(page);
  });
});
