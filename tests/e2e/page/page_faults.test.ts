// The page when things go wrong: hostile text, failing parts, failing starts, missing files.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { eventually } from '../../support/eventually.ts';
import { PageStage } from '../support/page_stage.ts';

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

// Guarantee, hostile input: names, logs and messages with markup are shown as text
test('hostile names, logs and messages are only text', () =>
  stage.on('hostile', {}, async (page) => {
    for (const head of await page.locator('.topic-head').all()) await head.click();
    await page.locator('.tree').waitFor();
    await page.getByRole('button', { name: 'Merged' }).click();
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    assert.equal(await page.locator('#page img, #page script, #page iframe').count(), 0);
    assert.match(await page.title(), /^<img src=x/);
    assert.match((await page.textContent('.tree')) ?? '', /<img src=x onerror=/);
    assert.match((await page.textContent('h1')) ?? '', /<script>/);
  }));

// Guarantee, hostile input: the page sets no markup from text: of what Trusted Types guard it uses nothing but the start
// of workers
test('the page needs no sink that Trusted Types guard', async () => {
  const context = await stage.browser.newContext();
  const page = await context.newPage();
  const troubles: string[] = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  await page.route('**/?scene=*', async (route) => {
    const response = await route.fetch();
    await route.fulfill({
      response,
      headers: {
        ...response.headers(),
        'content-security-policy': "require-trusted-types-for 'script'; trusted-types 'none'",
      },
    });
  });
  await page.goto(`${stage.served.url}?scene=crowd`);
  await page.locator('.topic-head').nth(3).click();
  await page.locator('.tree').waitFor();
  assert.deepEqual(troubles, []);
  await context.close();
});

test('one broken panel fails alone', () =>
  stage.on('broken', {}, async (page) => {
    await page.getByRole('alert').getByText('error[R2W0790]').waitFor();
    assert.match(
      (await page.getByRole('alert').textContent()) ?? '',
      /The panel \u201cTopics\u201d failed: topics are out of order/,
    );
    await page.locator('.panel-nodes').getByText('2 of 2 running').waitFor();
    await page.evaluate(() => {
      fake.topics = () => [];
    });
    await page.getByRole('button', { name: 'Try again' }).click();
    await page.locator('.panel-topics').waitFor();
  }));

test('a session that cannot start is explained', () =>
  stage.on('failure', { permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    const told = (await page.textContent('main')) ?? '';
    assert.match(
      told,
      /could not start.*error\[R2W0705\]: this browser can neither.*why.*Promise Integration.*fix.*open the page by itself/s,
    );
    await page.getByTitle('Copy this report').click();
    await eventually('the report is copied', async () => (await page.evaluate(() => navigator.clipboard.readText())).startsWith('error['));
    assert.match(
      await page.evaluate(() => navigator.clipboard.readText()),
      /^error\[R2W0705\]: this browser can neither.*\n {3}= why: .*Promise Integration.*\n {3}= fix: open the page by itself/,
    );
  }));

test('while the session starts the page says so, after a moment', () =>
  stage.on(
    'never',
    {},
    async (page) => {
      await page.getByText('Starting\u2026').waitFor({ state: 'visible' });
      assert.equal(await page.getByText('error[').filter({ visible: true }).count(), 0);
    },
    null,
    'html[lang]',
  ));

test('an unforeseen error is told in a bar that can be closed', async () => {
  const context = await stage.browser.newContext();
  const page = await context.newPage();
  await page.goto(`${stage.served.url}?scene=quiet`);
  await page.locator('.page').waitFor();
  await page.evaluate(() => {
    setTimeout(() => {
      throw new Error('out of <b>order</b>');
    }, 0);
  });
  const bar = page.getByRole('alert');
  await bar.getByText('out of <b>order</b>').waitFor();
  assert.match((await bar.textContent()) ?? '', /error\[R2W0792\]/);
  await page.getByRole('button', { name: 'Dismiss' }).click();
  await bar.waitFor({ state: 'detached' });
  await context.close();
});

test('never a blank page: no program, no JavaScript, opened from disk', async () => {
  const context = await stage.browser.newContext();
  const page = await context.newPage();
  await page.route('**/start.js', (route) => route.abort());
  await page.goto(stage.served.url);
  await page.evaluate(() => {
    for (const animation of document.getAnimations()) animation.finish();
  });
  await page.getByText('error[R2W0792]').waitFor();
  await page.goto(pathToFileURL(join(stage.folder, 'index.html')).href);
  await page.getByText('error[R2W0791]').waitFor();
  await page.getByText('ros2wasm serve FOLDER').waitFor();
  await context.close();
  const plain = await stage.browser.newContext({ javaScriptEnabled: false });
  const page2 = await plain.newPage();
  await page2.goto(stage.served.url);
  await page2.locator('noscript p').waitFor();
  assert.match(await page2.locator('noscript').innerText(), /needs JavaScript/);
  await plain.close();
});

test('no file of the page refers to another host', () => {
  for (const name of readdirSync(stage.folder)) {
    const addresses = readFileSync(join(stage.folder, name), 'utf8').match(/https?:\/\/[\w[][^"'`\s)]+/g) ?? [];
    // Names of XML, and where the Markdown reader wants to hear of its own errors: words, not requests.
    const words = ['http://www.w3.org/', 'https://github.com/markedjs/marked'];
    assert.deepEqual(
      addresses.filter((address) => !words.some((word) => address.startsWith(word))),
      [],
      name,
    );
  }
});
