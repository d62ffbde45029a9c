// The page in another language: one in which every sentence stands in double brackets. What problems, checks and the page
// before its program say is told in it.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';

const build = resolve(import.meta.dirname, '../../../runtime/build.mjs');
let folder: string;
let site: string;
let browser: Browser;

const marked = (text: string): string => `\u27e6${text}\u27e7`;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), 'ros2wasm-language-'));
  const texts = join(folder, 'qps');
  mkdirSync(texts);
  const list = join(folder, 'list.json');
  execFileSync(process.execPath, [build, '--out', join(folder, 'english'), '--sentences', list]);
  const english = Object.keys(JSON.parse(readFileSync(list, 'utf8')) as object);
  assert.ok(english.includes('the address asks for the node `{1}`, which this site has not'));
  assert.ok(english.includes('its files did not arrive, or this browser is too old for them'));
  assert.ok(!english.some((text) => text.includes('--bags')), 'what is said on a terminal is none of the page');
  writeFileSync(join(texts, 'sentences.json'), JSON.stringify(Object.fromEntries(english.map((text) => [text, marked(text)]))));
  site = makeSite([{ program: 'talker.c' }], {}, { layout: 'checks' }, undefined, texts);
  const file = join(site, 'site.json');
  writeFileSync(file, JSON.stringify({
    ...(JSON.parse(readFileSync(file, 'utf8')) as object),
    checks: [
      { kind: 'rate', topic: '/chatter', above: 2, within_ms: 120_000 },
      { kind: 'state', node: 'talker-1', state: 'crashed', within_ms: 1000 },
    ],
  }));
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 240_000 });

after(async () => {
  await browser.close();
  for (const each of [folder, site]) rmSync(each, { recursive: true, force: true });
});

test('problems, checks and the page without its program speak the language that it was built in', { timeout: 240_000 }, async () => {
  const host = await serveFolder(site);
  try {
    const page = await browser.newPage();
    await page.goto(host.url);
    assert.equal(await page.locator('html').getAttribute('lang'), 'qps');
    const rows = page.locator('.check-row');
    await rows.nth(0).getByText(`/chatter ${marked('above 2\u27e6 Hz\u27e7')}`).waitFor();
    await rows.nth(0).getByText(/\u27e6[\d.]+ Hz\u27e7/).waitFor();
    await rows.nth(1).getByText(marked('talker-1 crashes')).waitFor();
    await rows.nth(1).getByText(marked('it runs')).waitFor();
    await page.goto(`${host.url}?nodes=nobody`);
    await page.getByText(marked('the address asks for the node `nobody`, which this site has not')).waitFor();
    await page.getByText(marked('correct `nodes=` in the address, or leave it out to start the site as it was made')).waitFor();
    await page.close();
    const plain = await browser.newContext({ javaScriptEnabled: false });
    const still = await plain.newPage();
    await still.goto(host.url);
    assert.match(await still.locator('noscript').innerHTML(), /<p>\u27e6This page runs ROS 2 nodes/);
    assert.match(await still.locator('.if-late dd').first().textContent() ?? '', /^\u27e6its files did not arrive.*\u27e7$/);
    await plain.close();
  } finally {
    await host.close();
  }
});
