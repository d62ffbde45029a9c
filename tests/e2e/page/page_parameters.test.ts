// The panel of parameters in Chromium, with nodes on a real graph: every type, refusals, changes from elsewhere, a node
// that says nothing, one that goes, and links of a lab sheet.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

interface Robot {
  readonly declared: ReadonlyMap<string, { readonly value: Readonly<Record<string, unknown>>; }>;
  change(name: string, value: unknown): void;
  remove(name: string): void;
  leave(): void;
  come(): void;
}

declare global {
  // Set by page_fake_parameters.ts.
  var robot: Robot;
  var silent: Robot;
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const scene = (layout: unknown = 'parameters'): string => `parameters#layout=${encodeURIComponent(JSON.stringify(layout))}`;

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

/** Until the node has this value, by its text. */
const has = (page: Page, name: string, text: string): Promise<unknown> =>
  page.waitForFunction(
    ([of, wanted]) => {
      const value = robot.declared.get(of)?.value ?? {};
      return Object.entries(value).some(([field, own]) =>
        field !== 'type' && (Array.isArray(own) || ArrayBuffer.isView(own)
            ? Array.from(own as ArrayLike<unknown>).join('|')
            : String(own)) === wanted
      );
    },
    [name, text] as const,
  );

/** Until the field says this. */
const says = (page: Page, label: string, text: string): Promise<unknown> =>
  page.waitForFunction(
    ([of, wanted]) => document.querySelector<HTMLInputElement>(`:is(input:not([type="range"]), textarea)[aria-label="${of}"]`)?.value === wanted,
    [label, text] as const,
  );

const row = (page: Page, name: string) => page.locator('.parameter', { has: page.locator('.parameter-name', { hasText: name }) });

test('every type has an editor, and what is typed is set', () =>
  stage.on(scene(), {}, async (page) => {
    const field = (name: string) => page.getByRole('textbox', { name: `${name} of /robot`, exact: true });
    await says(page, 'speed of /robot', '1.5');
    // Parameters that every node has come last, on request.
    const names = page.locator('.topic', { hasText: '/robot' }).first().locator('.parameter-name');
    assert.ok(!(await names.allTextContents()).includes('use_sim_time'));
    await page.getByRole('button', { name: '1 more that every node has' }).click();
    assert.equal((await names.allTextContents()).at(-1), 'use_sim_time');
    await field('wheels.radius').fill('2');
    await field('wheels.radius').press('Enter');
    await has(page, 'wheels.radius', '2');
    await says(page, 'wheels.radius of /robot', '2.0');
    await page.getByRole('checkbox', { name: 'use_sim_time of /robot' }).check();
    await has(page, 'use_sim_time', 'true');
    await field('joints').fill('[one, "two, three"]');
    await field('joints').press('Enter');
    await has(page, 'joints', 'one|two, three');
    await says(page, 'joints of /robot', '["one", "two, three"]');
    await field('lengths').fill('[1, 2.5]');
    await field('lengths').press('Enter');
    await has(page, 'lengths', '1|2.5');
    await field('motto').fill('only\nthis');
    await field('motto').blur();
    await has(page, 'motto', 'only\nthis');
    await field('__proto__').fill('9007199254740995');
    await field('__proto__').press('Enter');
    await has(page, '__proto__', '9007199254740995');
    // One of any type takes what YAML makes of the text.
    await field('anything').fill('[true, false]');
    await field('anything').press('Enter');
    await has(page, 'anything', 'true|false');
    await row(page, 'anything').getByText('boolean array').waitFor();
    // Shown only.
    await page.getByRole('group', { name: 'image of /robot' }).getByText('de ad be ef').waitFor();
    assert.equal(await field('frame').getAttribute('readonly'), '');
    await row(page, 'frame').getByText('Decided at the start').waitFor();
  }));

test('a slider and a field set the same value, in the steps of its range', () =>
  stage.on(scene(), {}, async (page) => {
    await row(page, 'speed').getByText('from 0.0 to 4.0 in steps of 0.5').waitFor();
    const slider = page.getByRole('slider', { name: 'speed of /robot' });
    await slider.focus();
    await page.keyboard.press('ArrowLeft');
    await has(page, 'speed', '1');
    await says(page, 'speed of /robot', '1.0');
    const count = page.getByRole('slider', { name: 'wheels.count of /robot' });
    await count.focus();
    await page.keyboard.press('End');
    await has(page, 'wheels.count', '8');
    await page.keyboard.press('ArrowLeft');
    await has(page, 'wheels.count', '6');
  }));

test('what the node refuses is told with its reason, and the old value stays', () =>
  stage.on(scene(), {}, async (page) => {
    const speed = page.getByRole('textbox', { name: 'speed of /robot', exact: true });
    await speed.fill('3.5');
    await speed.press('Enter');
    await row(page, 'speed').getByRole('alert').getByText('The node refused 3.5: speed must not be above 2.0').waitFor();
    await says(page, 'speed of /robot', '1.5');
    await expectAccessible(page);
    await page.screenshot({ path: join(OUTPUT, 'parameters.png') });
    // A text that is not a number is not sent to the node, and stays to be corrected; Escape brings the value back.
    await speed.fill('fast');
    await speed.press('Enter');
    await row(page, 'speed').getByText('Not set to fast: not a number').waitFor();
    await says(page, 'speed of /robot', 'fast');
    await speed.press('Escape');
    await says(page, 'speed of /robot', '1.5');
    const list = page.getByRole('textbox', { name: 'lengths of /robot', exact: true });
    await list.fill('[a]');
    await list.press('Enter');
    await row(page, 'lengths').getByText('no double array: a list is written as [1, 2]').waitFor();
    await speed.fill('2');
    await speed.press('Enter');
    await has(page, 'speed', '2');
    await row(page, 'speed').getByRole('alert').waitFor({ state: 'detached' });
  }));

test('changes from elsewhere are followed; a node that goes keeps its last values, and is read again when it comes', () =>
  stage.on(scene(), {}, async (page) => {
    await says(page, 'speed of /robot', '1.5');
    await page.evaluate(() => robot.change('speed', { type: 3, double_value: 0.5 }));
    await says(page, 'speed of /robot', '0.5');
    await page.evaluate(() => robot.change('gain', { type: 2, integer_value: 7n }));
    await says(page, 'gain of /robot', '7');
    await row(page, 'gain').getByText('came later').waitFor();
    await page.evaluate(() => robot.remove('gain'));
    await row(page, 'gain').waitFor({ state: 'detached' });
    await page.evaluate(() => robot.leave());
    await page.getByText('has gone; the last known values').waitFor();
    await says(page, 'speed of /robot', '0.5');
    assert.equal(await page.getByRole('textbox', { name: 'speed of /robot', exact: true }).getAttribute('readonly'), '');
    assert.equal(await page.getByRole('slider', { name: 'speed of /robot' }).count(), 0);
    await page.evaluate(() => {
      robot.change('speed', { type: 3, double_value: 1 });
      robot.come();
    });
    await says(page, 'speed of /robot', '1.0');
    await page.getByRole('slider', { name: 'speed of /robot' }).waitFor();
  }));

test('a node that does not answer is said so, with a way to ask again', () =>
  stage.on(scene(), {}, async (page) => {
    const again = page.getByRole('button', { name: 'Read the parameters of /silent again' });
    await page.getByText(/^Could not be read: the service `\/silent\/list_parameters` did not answer within 10 s/).waitFor();
    await says(page, 'speed of /robot', '1.5');
    await again.click();
    await page.evaluate(() => silent.leave());
    await page.getByText('has gone', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'Pause the time of all nodes' }).click();
    await page.getByText('The time of the site is held.').waitFor();
  }));

test('the filter finds nodes and parameters, and a node is copied as ros2 param dump writes it', () =>
  stage.on(scene(), { permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    await says(page, 'speed of /robot', '1.5');
    await page.getByRole('searchbox', { name: 'Filter parameters' }).fill('WHEELS');
    await row(page, 'speed').waitFor({ state: 'detached' });
    assert.deepEqual(await page.locator('.parameter-name').allTextContents(), ['wheels.count', 'wheels.radius']);
    await page.getByRole('searchbox', { name: 'Filter parameters' }).fill('nothing like it');
    await page.getByText('No parameter matches the filter.').waitFor();
    await page.getByRole('searchbox', { name: 'Filter parameters' }).fill('');
    await page.getByRole('button', { name: 'Copy the parameters of /robot as YAML' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    const yaml = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(yaml, /^\/robot:\n {2}ros__parameters:\n/);
    assert.match(yaml, /\n {4}wheels:\n {6}count: 4\n {6}radius: 0\.1\n/);
    assert.match(yaml, /\n {4}speed: 1\.5\n/);
    await page.getByRole('button', { name: /^\/robot/ }).click();
    await row(page, 'speed').waitFor({ state: 'detached' });
  }));

test('hostile names are only text', () =>
  stage.on(scene(), {}, async (page) => {
    await row(page, '<img src=x').getByText('<script>').first().waitFor();
    assert.equal(await page.locator('#page img, #page script, #page iframe').count(), 0);
    assert.match(await page.title(), /^Talker and listener/);
  }));

test('a link of a lab sheet sets a parameter, and tells when the node refuses', async () => {
  mkdirSync(join(stage.folder, 'text/lab'), { recursive: true });
  writeFileSync(join(stage.folder, 'text/lab/README.md'),
    '[Slow](ros2wasm:set_param?node=/robot&name=speed&value=0.5), [too fast](ros2wasm:set_param?node=robot&name=speed&value=9.5)\n');
  await stage.on(scene({ row: ['text', 'parameters'] }), {}, async (page) => {
    await says(page, 'speed of /robot', '1.5');
    await page.getByRole('button', { name: 'Slow' }).click();
    await page.getByRole('status').getByText('Set speed of /robot').waitFor();
    await says(page, 'speed of /robot', '0.5');
    await page.getByRole('button', { name: 'too fast' }).click();
    await page.getByRole('status').getByText('Refused by /robot: speed must not be above 2.0').waitFor();
  });
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`a phone of 320 px shows it, and axe finds nothing, ${colorScheme}`, () =>
    stage.on(scene(), { ...phone, viewport: { width: 320, height: 568 }, colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await says(page, 'speed of /robot', '1.5');
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth), false);
      const over = await page.locator('.panel-parameters .panel-body').evaluate((body) => body.scrollWidth - body.clientWidth);
      assert.ok(over <= 0, `${over} px too wide`);
      await expectAccessible(page);
      await page.screenshot({ path: join(OUTPUT, `parameters_phone_${colorScheme}.png`) });
    }));
}
