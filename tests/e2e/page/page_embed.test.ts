// The page in a frame of a page on another origin: panels only, as the address says, and the way to the whole page.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import type { Frame } from 'playwright-core';
import { EmbeddingPage } from '../support/embedding_page.ts';
import { PageStage, expectAccessible } from '../support/page_stage.ts';

const SHOTS = process.env['ROS2WASM_SCREENSHOTS'];
let stage: PageStage;
let parent: EmbeddingPage;

before(async () => {
  [stage, parent] = await Promise.all([PageStage.open(), EmbeddingPage.serve()]);
  if (SHOTS !== undefined) mkdirSync(SHOTS, { recursive: true });
});

after(async () => {
  await stage.close();
  await parent.close();
});

const address = (rest: string): string => `${stage.served.url}?scene=talker&embed=1${rest}`;

function panelsOf(frame: Frame): Promise<readonly string[]> {
  return frame.evaluate(() => [...document.querySelectorAll('section.panel')].map((panel) => panel.id));
}

test('one panel: no header, no tabs, a link to the whole page with the same view', async () => {
  const layout = encodeURIComponent('{"row":["nodes",{"plot":{"paths":["/odom.x"],"seconds":5}}]}');
  const { page, frame } = await parent.open(stage.browser, address(`&panel=plot&seed=3#layout=${layout}`));
  await frame.locator('#panel-plot').waitFor();
  assert.deepEqual(await panelsOf(frame), ['panel-plot']);
  assert.equal(await frame.locator('header, [role="tablist"], .strip').count(), 0);
  // The panel shows the path that the link names.
  await frame.getByText('/odom.x').first().waitFor();
  assert.equal(await frame.evaluate(() => crossOriginIsolated), false);
  const [whole] = await Promise.all([
    page.context().waitForEvent('page'),
    frame.getByRole('link', { name: /Open the whole page/ }).click(),
  ]);
  await whole.locator('header').waitFor();
  const url = new URL(whole.url());
  assert.equal(url.search, '?scene=talker&seed=3');
  assert.match(url.hash, /odom/);
  assert.equal(await whole.evaluate(() => window.opener === null), true);
  if (SHOTS !== undefined) await page.screenshot({ path: `${SHOTS}/embed_plot.png` });
  await page.context().close();
});

test('several panels side by side, or as tabs where there is little room; accessible', async () => {
  const { page, frame } = await parent.open(stage.browser, address('&panel=console,topics'), { width: 800 });
  await frame.locator('#panel-topics').waitFor();
  assert.deepEqual(await panelsOf(frame), ['panel-console', 'panel-topics']);
  assert.equal(await frame.locator('[role="tablist"]').count(), 0);
  await expectAccessible(frame);
  if (SHOTS !== undefined) await page.screenshot({ path: `${SHOTS}/embed_two.png` });
  await page.evaluate(() => document.querySelector('iframe')!.setAttribute('width', '400'));
  await frame.getByRole('tab', { name: 'Topics' }).click();
  await frame.locator('#panel-topics').waitFor();
  assert.deepEqual(await panelsOf(frame), ['panel-topics']);
  await expectAccessible(frame);
  if (SHOTS !== undefined) await page.screenshot({ path: `${SHOTS}/embed_tabs.png` });
  await page.context().close();
});

test('a panel that is none is said, as markup in its name is', async () => {
  const name = '<img src=x onerror=alert(1)>';
  const { page, frame } = await parent.open(stage.browser, address(`&panel=topics,${encodeURIComponent(name)}`));
  await frame.getByText(`This page has no such panels, so the layout is shown without them: ${name}.`).waitFor();
  assert.deepEqual(await panelsOf(frame), ['panel-topics']);
  assert.equal(await frame.locator('img').count(), 0);
  await page.context().close();
});

test('the page around it changes the view by the fragment', async () => {
  const { page, frame } = await parent.open(stage.browser, address('#layout=%22topics%22'));
  await frame.locator('#panel-topics').waitFor();
  const other = address('#layout=%22nodes%22');
  await page.evaluate((src) => document.querySelector('iframe')!.setAttribute('src', src), other);
  await frame.locator('#panel-nodes').waitFor();
  assert.deepEqual(await panelsOf(frame), ['panel-nodes']);
  await page.context().close();
});

test('in a sandbox: it works with allow-same-origin, and says what is missing without', async () => {
  const works = await parent.open(stage.browser, address('&panel=nodes'), { sandbox: 'allow-scripts allow-same-origin' });
  await works.frame.locator('#panel-nodes').waitFor();
  await works.page.context().close();
  const alone = await parent.open(stage.browser, address('&panel=nodes'), { sandbox: 'allow-scripts' });
  await alone.frame.getByText('R2W0793').waitFor();
  await alone.frame.getByText('allow-same-origin').waitFor();
  assert.equal(await alone.frame.getByText('R2W0792').isVisible(), false);
  if (SHOTS !== undefined) await alone.page.screenshot({ path: `${SHOTS}/embed_sandbox.png` });
  await alone.page.context().close();
  // Without scripts the page can say it all the same.
  const none = await parent.open(stage.browser, address('&panel=nodes'), { sandbox: '' });
  await none.frame.waitForFunction(() => document.body.innerText.includes('A frame with sandbox needs allow-scripts allow-same-origin'));
  await none.page.context().close();
});
