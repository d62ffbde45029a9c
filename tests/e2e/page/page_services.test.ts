// The panel of services and actions in Chromium, with a server on a real graph: calls, goals, and what stays.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "services".
  var leave: () => void;
  /** Whether the service answers nothing. */
  var hush: (on: boolean) => void;
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const SCENE = `services#layout=${encodeURIComponent(JSON.stringify('services'))}`;

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

test('a call shows its reply, which stays when the server has gone', () =>
  stage.on(SCENE, {}, async (page) => {
    assert.equal(await page.getByText('/server/get_parameters').count(), 0);
    await page.getByRole('button', { name: /^\/add demo\/srv\/Add/ }).click();
    await page.getByRole('textbox', { name: 'a of /add' }).fill('9007199254740993');
    await page.getByRole('textbox', { name: 'b of /add' }).fill('4');
    await page.getByRole('textbox', { name: 'b of /add' }).press('Enter');
    const reply = page.getByRole('group', { name: 'Reply of /add' });
    await reply.getByText('9007199254740997').waitFor();
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'services.png') });
    await page.evaluate(() => leave());
    await page.getByText('its server has gone').waitFor();
    await reply.getByText('9007199254740997').waitFor();
    await page.getByRole('textbox', { name: 'a of /add' }).fill('x');
    await page.getByRole('button', { name: 'Call' }).click();
    await page.getByRole('alert').getByText(/^a: /).waitFor();
  }));

test('a call that is given up is not a problem, and another one can be made', () =>
  stage.on(SCENE, {}, async (page) => {
    await page.getByRole('button', { name: /^\/add demo\/srv\/Add/ }).click();
    await page.getByRole('textbox', { name: 'a of /add' }).fill('1');
    await page.evaluate(() => hush(true));
    await page.getByRole('button', { name: 'Call' }).click();
    await page.getByRole('button', { name: 'Give up' }).click();
    await page.locator('form .hint').getByText('The call was given up.').waitFor();
    assert.equal(await page.getByRole('alert').count(), 0);
    await page.evaluate(() => hush(false));
    await page.getByRole('button', { name: 'Call' }).click();
    await page.getByRole('group', { name: 'Reply of /add' }).waitFor();
    assert.equal(await page.locator('form .hint').getByText('The call was given up.').count(), 0);
  }));

test('a goal shows its feedback, is canceled, and shows its result', () =>
  stage.on(SCENE, {}, async (page) => {
    await page.getByRole('button', { name: /^\/count demo\/action\/Count/ }).click();
    await page.getByRole('textbox', { name: 'to of /count' }).fill('5');
    await page.getByRole('button', { name: 'Send goal' }).click();
    await page.getByRole('group', { name: 'Feedback of /count' }).getByText('42').waitFor();
    await page.getByRole('button', { name: 'Cancel' }).click();
    await page.getByText('Canceled', { exact: true }).waitFor();
    await page.getByRole('group', { name: 'Result of /count' }).getByText('9').waitFor();
    await expectAccessible(page);
  }));

test('a phone shows the form of a service', () =>
  stage.on(SCENE, { ...phone, colorScheme: 'dark' }, async (page) => {
    await page.getByRole('button', { name: /^\/add demo\/srv\/Add/ }).click();
    await page.getByRole('textbox', { name: 'a of /add' }).waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth), false);
    await expectAccessible(page);
  }));
