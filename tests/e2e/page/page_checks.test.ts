// The panel of checks in Chromium: what is decided, what was seen, and beginning again.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';
import type { FakeChecks } from '../../unit/ui/fake_session.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const SCENE = `checks#layout=${encodeURIComponent(JSON.stringify({ row: ['checks', 'console'], sizes: [1, 2] }))}`;

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

test('each check says how far it is and what was seen, and is told when all are decided', () =>
  stage.on(SCENE, {}, async (page) => {
    const rows = page.locator('.check-row');
    await rows.nth(2).waitFor();
    assert.match(await rows.nth(0).innerText(), /\/topic above 1 Hz\s+Seen\s+after 1 s\s+Seen: 2 Hz$/);
    // Where it is declared is for authors, and shown on request.
    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: 'Show where the manifest declares nodes' }).click();
    assert.match(await rows.nth(0).innerText(), /Seen: 2 Hz\s+workspace\.yaml:12:5$/);
    assert.match(await rows.nth(1).innerText(), /<img src=x.*Not seen within 5 s/s);
    assert.match(await rows.nth(2).innerText(), /Not seen yet, within 20 s\s+Seen: no line/);
    assert.match(await page.locator('.panel-checks').innerText(), /1 of 3 checks passed/);
    await page.screenshot({ path: join(OUTPUT, 'checks.png') });
    await page.evaluate(() => {
      const checks = fake.checks as FakeChecks;
      checks.set(checks.views().map((view) => (view.state === 'waiting' ? { ...view, state: 'passed', afterMs: 3000, seen: 'I heard' } : view)));
    });
    await page.getByRole('status').getByText('2 of 3 checks passed').waitFor({ state: 'attached' });
    await page.getByRole('button', { name: 'Forget what was seen, and check again from now on' }).press('Enter');
    await page.getByText('0 of 3 checks passed').waitFor();
    assert.equal(await page.evaluate(() => (fake.checks as FakeChecks).begun), 1);
    assert.notEqual(await page.title(), 'owned');
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, ${colorScheme}`, () =>
    stage.on(SCENE, { colorScheme }, async (page) => {
      await page.locator('.check-row').nth(2).waitFor();
      await expectAccessible(page);
    }));
}

test('a site without checks says so, and a phone shows the list', async () => {
  const layout = encodeURIComponent(JSON.stringify('checks'));
  await stage.on(`empty#layout=${layout}`, {}, async (page) => {
    await page.getByText('This workspace says nothing of what must be seen').waitFor();
  });
  await stage.on(`checks#layout=${layout}`, phone, async (page) => {
    await page.locator('.check-row').nth(2).waitFor();
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
    assert.equal(wide, false);
    await expectAccessible(page);
  });
});
