// Guarantee, hostile input: names of services, topics, nodes, states and transitions, fields, defaults and values with markup
// are shown as text in the panels that work with them

// Names, fields, values, states and transitions of nodes that are markup, in the panels that show them: text, and
// nothing else.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { PageStage } from '../support/page_stage.ts';

declare global {
  // Set by page_fake_hostile.ts.
  var kept: readonly Uint8Array[];
}

/** As in page_fake.tsx. */
const MARKUP = '<img src=x onerror="document.title=\'owned\'">';
/** As it stands between quotes in a definition. */
const DEFAULT = MARKUP.replaceAll('"', "'");

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

/** Shows the panel, runs the body and looks that no markup became an element. */
const shows = (layout: unknown, body: (page: Page) => Promise<void>): Promise<void> =>
  stage.on(`hostile_work#layout=${encodeURIComponent(JSON.stringify(layout))}`, {}, async (page) => {
    await body(page);
    assert.equal(await page.locator('img[src=x], [onerror]').count(), 0);
    assert.notEqual(await page.title(), 'owned');
  });

test('services: names, types, fields, defaults and replies', () =>
  shows('services', async (page) => {
    const panel = page.locator('.panel-services');
    await panel.getByText(`/${MARKUP}`, { exact: true }).waitFor();
    await panel.getByRole('button', { name: `/odd_type ${MARKUP}` }).click();
    await panel.getByText(MARKUP).last().waitFor();
    await panel.getByRole('button', { name: /^\/odd_fields / }).click();
    await panel.getByText(`Could not parse line: 'string ${MARKUP}'`).waitFor();
    await panel.getByRole('button', { name: `/${MARKUP} demo/srv/Echo service` }).click();
    const word = panel.getByRole('textbox', { name: `word of /${MARKUP}`, exact: true });
    assert.equal(await word.inputValue(), DEFAULT);
    await panel.getByRole('button', { name: 'Call' }).first().click();
    await panel.getByRole('alert').getByText(`/${MARKUP}`).waitFor();
    await panel.getByRole('button', { name: /^\/echo / }).click();
    await panel.getByRole('textbox', { name: 'word of /echo' }).fill(MARKUP);
    await panel.getByRole('button', { name: 'Call' }).last().click();
    const reply = panel.getByRole('group', { name: 'Reply of /echo' });
    await reply.getByText(MARKUP).first().waitFor();
    assert.equal((await reply.textContent())?.split(MARKUP).length, 3, 'a value and one in a list');
  }));

test('publish: topics, types, fields, defaults and values', async () => {
  await shows({ publish: { topic: `/${MARKUP}`, type: 'demo/msg/Word' } }, async (page) => {
    const panel = page.locator('.panel-publish');
    assert.equal(await panel.getByRole('textbox', { name: `word of /${MARKUP}` }).inputValue(), DEFAULT);
    await panel.getByRole('button', { name: 'Publish once' }).click();
    await panel.getByRole('alert').getByText(`/${MARKUP}`).waitFor();
  });
  await shows({ publish: { topic: '/odd_type', type: MARKUP } }, (page) => page.locator('.panel-publish').getByText(MARKUP).waitFor());
  await shows({ publish: { topic: '/odd_fields', type: 'demo/msg/Odd' } },
    (page) => page.locator('.panel-publish').getByText(`Could not parse line: 'string ${MARKUP}'`).waitFor());
  await shows({ publish: { topic: '/ground', type: 'demo/msg/Word' } }, async (page) => {
    const panel = page.locator('.panel-publish');
    await panel.getByRole('textbox', { name: 'word of /ground' }).fill(MARKUP);
    await panel.getByRole('button', { name: 'Publish once' }).click();
    await page.waitForFunction(() => kept.length === 1);
    // Behind the encapsulation and the length, before the zero.
    assert.equal(await page.evaluate(() => new TextDecoder().decode(kept[0]?.subarray(8, -1))), MARKUP);
    await panel.getByRole('button', { name: 'YAML' }).click();
    assert.ok((await panel.getByRole('textbox', { name: 'YAML of the message for /ground' }).inputValue()).includes('<img src=x'));
  });
});

test('timeline: values, and paths of a link', () =>
  shows({ timeline: { paths: ['/ground.word', `/${MARKUP}.word`], seconds: 60 } }, async (page) => {
    // Until the panel listens.
    await page.waitForFunction((word) => {
      send('/ground', 'demo/msg/Word', { word });
      return document.querySelector('.state-span') !== null;
    }, MARKUP);
    const panel = page.locator('.panel-timeline');
    await panel.locator('.state-span').getByText(MARKUP).waitFor();
    assert.equal(await panel.locator('.state-span').getAttribute('title'), MARKUP);
    await panel.getByRole('img', { name: `States of /ground.word, now ${MARKUP}` }).waitFor();
    await panel.getByText(`/${MARKUP}.word`).waitFor();
  }));

test('lifecycle: nodes, states and transitions', () =>
  shows('lifecycle', async (page) => {
    const panel = page.locator('.panel-lifecycle');
    await panel.getByRole('heading', { name: `/${MARKUP}`, exact: true }).waitFor();
    await panel.getByRole('alert').getByText(`/${MARKUP}/get_state`).waitFor();
    await panel.getByText(`${MARKUP} unconfigured`, { exact: true }).waitFor();
    await panel.getByRole('button', { name: `${MARKUP} configure /driver`, exact: true }).click();
    await panel.getByText(`${MARKUP} inactive`, { exact: true }).waitFor();
    await panel.getByText(`${MARKUP} configure: done`).waitFor();
  }));
