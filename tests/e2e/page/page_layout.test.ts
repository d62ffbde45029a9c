// The dock of the page: tabs and splits by mouse and by keyboard, kept by the browser, carried by a link.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { parse } from 'yaml';
import { PageStage, expectAccessible, focused, phone } from '../support/page_stage.ts';

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

/** The groups as texts of their tabs, in the order of the document; the front one has a star. */
function groups(page: Page): Promise<readonly string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll('.group')].map((group) =>
      [...group.querySelectorAll('[role="tab"]')]
        .map((tab) => tab.textContent + (tab.ariaSelected === 'true' ? '*' : ''))
        .join(' ')
    )
  );
}

async function groupsBecome(page: Page, expected: readonly string[]): Promise<void> {
  await page
    .waitForFunction(
      (wanted) =>
        wanted
          === JSON.stringify(
            [...document.querySelectorAll('.group')].map((group) =>
              [...group.querySelectorAll('[role="tab"]')]
                .map((tab) => tab.textContent + (tab.ariaSelected === 'true' ? '*' : ''))
                .join(' ')
            ),
          ),
      JSON.stringify(expected),
      { timeout: 30_000 },
    )
    .catch(async () => assert.deepEqual(await groups(page), expected));
}

async function drag(page: Page, tab: string, to: { readonly x: number; readonly y: number; }): Promise<void> {
  const box = (await page.getByRole('tab', { name: tab }).boundingBox()) ?? assert.fail();
  await page.mouse.move(box.x + 20, box.y + 10);
  await page.mouse.down();
  await page.mouse.move(box.x + 40, box.y + 20);
  await page.mouse.move(to.x, to.y, { steps: 4 });
}

test('tabs are dragged into other groups and beside them, and the browser keeps it', () =>
  stage.on('quiet', {}, async (page) => {
    await groupsBecome(page, ['Nodes*', 'Consoles*', 'Topics*']);
    const console = (await page.locator('.panel-console').boundingBox()) ?? assert.fail();
    await drag(page, 'Topics', { x: console.x + console.width / 2, y: console.y + console.height - 10 });
    await page.locator('.dock-drop').waitFor();
    await page.mouse.up();
    await groupsBecome(page, ['Nodes*', 'Consoles*', 'Topics*']);
    await page.locator('.split-column').waitFor();
    const strip = (await page.getByRole('tab', { name: 'Consoles' }).boundingBox()) ?? assert.fail();
    await drag(page, 'Nodes', { x: strip.x + 4, y: strip.y + 10 });
    await page.mouse.up();
    await groupsBecome(page, ['Nodes* Consoles', 'Topics*']);
    assert.equal(await page.locator('.dock-drop').count(), 0);
    await page.reload();
    await page.waitForSelector('.page');
    await groupsBecome(page, ['Nodes* Consoles', 'Topics*']);
    // Escape lets a tab be.
    await drag(page, 'Consoles', { x: 640, y: 600 });
    await page.locator('.dock-drop').waitFor();
    await page.keyboard.press('Escape');
    await page.locator('.dock-drop').waitFor({ state: 'detached' });
    await page.mouse.up();
    await groupsBecome(page, ['Nodes* Consoles', 'Topics*']);
    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: 'Usual layout' }).click();
    await groupsBecome(page, ['Nodes*', 'Consoles*', 'Topics*']);
  }));

test('all of it by keyboard: move, split, close, open', () =>
  stage.on('quiet', {}, async (page) => {
    const more = async (title: string, ...keys: readonly string[]): Promise<void> => {
      await page.getByRole('button', { name: `Move or close ${title}` }).focus();
      await page.keyboard.press('ArrowDown');
      await page.getByRole('menu').waitFor();
      for (const key of keys) await page.keyboard.press(key);
    };
    await more('Nodes', 'i', 'i', 'Enter');
    await groupsBecome(page, ['Consoles Nodes*', 'Topics*']);
    await page.waitForFunction(() => document.activeElement?.id === 'tab-nodes');
    await page.keyboard.press('ArrowLeft');
    await groupsBecome(page, ['Consoles* Nodes', 'Topics*']);
    assert.equal(await focused(page), 'tab-console');
    await page.keyboard.press('End');
    await groupsBecome(page, ['Consoles Nodes*', 'Topics*']);
    await more('Nodes', 'o', 'Enter');
    await groupsBecome(page, ['Nodes* Consoles', 'Topics*']);
    await more('Nodes', 'End', 'ArrowUp', 'Enter');
    await groupsBecome(page, ['Consoles*', 'Topics*', 'Nodes*']);
    await more('Nodes', 'Escape');
    assert.equal(await focused(page), 'Move or close Nodes');
    await page.getByRole('tab', { name: 'Nodes' }).focus();
    await page.keyboard.press('Delete');
    await groupsBecome(page, ['Consoles*', 'Topics*']);
    await page.getByRole('button', { name: 'Open a panel here' }).last().focus();
    await page.keyboard.press('Enter');
    // Two have this letter: the notebook, and round again.
    await page.keyboard.press('n');
    await page.keyboard.press('n');
    await page.keyboard.press('Enter');
    await groupsBecome(page, ['Consoles*', 'Topics Nodes*']);
    await page.getByText('2 of 2 running').waitFor();
    // Everything closed: there is a way back.
    for (const name of ['Nodes', 'Topics', 'Consoles']) {
      await page.getByRole('button', { name: `Move or close ${name}` }).click();
      await page.getByRole('menuitem', { name: `Close ${name}` }).click();
    }
    await page.getByText('Nothing is open here.').waitFor();
    await expectAccessible(page);
    await page.getByRole('link', { name: 'Skip to the consoles' }).focus();
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement?.id === 'panel-console');
  }));

test('a link carries the layout and the site\u2019s hash, and tells when it is for another site', () =>
  stage.on('quiet', { permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    await page.getByRole('button', { name: 'Move or close Nodes' }).click();
    await page.getByRole('menuitem', { name: 'Below Topics' }).click();
    await groupsBecome(page, ['Consoles*', 'Topics*', 'Nodes*']);
    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: 'Copy a link to this view' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    const hash = createHash('sha256').update(readFileSync(join(stage.folder, 'site.json'))).digest('hex');
    const fields = new URLSearchParams(new URL(link).hash.slice(1));
    assert.equal(fields.get('site'), hash.slice(0, 16));
    assert.match(link, /\?scene=quiet#/);

    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: 'Usual layout' }).click();
    await groupsBecome(page, ['Nodes*', 'Consoles*', 'Topics*']);
    assert.equal(new URL(page.url()).hash, '');
    // The same tab follows a link that differs in its fragment only.
    await page.goto(link);
    await groupsBecome(page, ['Consoles*', 'Topics*', 'Nodes*']);
    assert.equal(await page.getByRole('region', { name: 'About the link' }).count(), 0);
    await page.goto(link.replace(/site=./, 'site=x'));
    await page.getByText('This link was made for another version of this site.').waitFor();
    await expectAccessible(page);
    await page.getByRole('button', { name: 'Dismiss' }).click();
    // A change of one's own takes the layout out of the address, so that a reload shows it.
    await page.getByRole('tab', { name: 'Nodes' }).focus();
    await page.keyboard.press('Delete');
    await groupsBecome(page, ['Consoles*', 'Topics*']);
    assert.equal(new URL(page.url()).hash, '');
    await page.reload();
    await page.waitForSelector('.page');
    await groupsBecome(page, ['Consoles*', 'Topics*']);
  }));

test('a hostile link changes nothing but a notice', () =>
  stage.on('quiet', {}, async (page) => {
    const markup = '<img src=x onerror="document.title=\'owned\'">';
    await page.goto(`${stage.served.url}?scene=quiet#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', markup] }))}`);
    await page.getByText(`without them: ${markup}`.slice(0, 30)).waitFor();
    await groupsBecome(page, ['Nodes*']);
    assert.equal(await page.locator('.page img').count(), 0);
    await page.goto(`${stage.served.url}?scene=quiet#layout=%7B`);
    await page.getByText('The view in this link cannot be read.').waitFor();
    assert.match(await page.title(), /^Talker and listener/);
  }));

test('bars between groups work by mouse and keyboard, and the parts are remembered', () =>
  stage.on('quiet', {}, async (page) => {
    const bar = page.getByRole('separator', { name: 'Border between Nodes and Consoles' });
    const width = (): Promise<number> => page.locator('.panel-nodes').evaluate((panel) => Math.round(panel.getBoundingClientRect().width));
    const becomes = (least: number, most: number): Promise<unknown> =>
      page.waitForFunction(
        ([a, b]) => {
          const now = document.querySelector('.panel-nodes')?.getBoundingClientRect().width ?? -1;
          return now >= (a ?? 0) - 1.5 && now <= (b ?? 0) + 1.5;
        },
        [least, most],
      );
    const start = await width();
    await bar.focus();
    await page.keyboard.press('ArrowRight');
    await becomes(start + 16, start + 16);
    await page.keyboard.press('ArrowRight');
    await becomes(start + 32, start + 32);
    await page.reload();
    await page.waitForSelector('.page');
    await becomes(start + 32, start + 32);
    const box = (await bar.boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + 5, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x - 59, box.y + 100);
    await page.mouse.up();
    await becomes(start - 32, start - 32);
    const both = await page.evaluate(() =>
      ['.panel-nodes', '.panel-console'].reduce(
        (sum, panel) => sum + (document.querySelector(panel)?.getBoundingClientRect().width ?? 0),
        0,
      )
    );
    await bar.dblclick();
    await becomes(both / 2, both / 2);
  }));

test('on a phone all tabs stand in one column, and a closed panel is opened again', () =>
  stage.on('crowd', phone, async (page) => {
    await groupsBecome(page, ['Nodes Consoles* Topics']);
    await page.getByRole('button', { name: 'Move or close Consoles' }).click();
    await page.getByRole('menuitem', { name: 'Close Consoles' }).click();
    await groupsBecome(page, ['Nodes Topics*']);
    await page.getByRole('button', { name: 'Open a panel here' }).click();
    await expectAccessible(page);
    await page.getByRole('menuitem', { name: 'Consoles' }).click();
    await page.locator('.panel-console').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 360);
  }));

const fieldsOf = (link: string): URLSearchParams => new URLSearchParams(new URL(link).hash.slice(1));

async function copyLink(page: Page): Promise<string> {
  await page.getByRole('button', { name: 'Layout of the page' }).click();
  await page.getByRole('menuitem', { name: 'Copy a link to this view' }).click();
  await page.waitForFunction(() => location.hash.includes('site='));
  return page.url();
}

test('a link brings the parameters that were set, and whether nodes run', async () => {
  let link = '';
  const beside = encodeURIComponent(JSON.stringify({ row: ['nodes', 'parameters'] }));
  await stage.on(`parameters#layout=${beside}`, {}, async (page) => {
    await page.getByRole('textbox', { name: 'speed of /robot', exact: true }).fill('2.0');
    await page.keyboard.press('Enter');
    await page.getByRole('status').getByText('speed of /robot is set').waitFor();
    await page.getByRole('button', { name: 'Stop all' }).click();
    link = await copyLink(page);
    assert.deepEqual(JSON.parse(fieldsOf(link).get('params') ?? ''), { '/robot': { speed: [3, '2.0'] } });
    assert.equal(fieldsOf(link).get('autorun'), '0');
    // The way back to the usual layout leaves nothing of it in the address.
    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: 'Usual layout' }).click();
    assert.equal(new URL(page.url()).hash, '');
  });
  const bring = (params: string): string => `parameters#layout=${beside}&params=${encodeURIComponent(params)}`;
  await stage.on(bring(fieldsOf(link).get('params') ?? ''), {}, async (page) => {
    await page.getByText('The link brings a parameter, set when its node runs.').waitFor();
    await page.waitForFunction(() => (document.querySelector('[aria-label="speed of /robot"]') as HTMLInputElement | null)?.value === '2.0');
  });
  const odd = { '/robot': { speed: [3, '9'], frame: 'x', motto: [4, '<b>'], joints: [9, '[a'] }, 'no name': { a: [1, 'true'] }, '/nobody': { a: [2, '1'] } };
  await stage.on(bring(JSON.stringify(odd)), {}, async (page) => {
    await page.getByText(/speed of \/robot was not set: speed must not be above 2\.0/).waitFor();
    await page.getByText(/joints of \/robot was not set: /).waitFor();
    assert.match(await page.getByRole('region', { name: 'About the link' }).innerText(), /^The link brings 4 parameters/);
    assert.equal(await page.locator('.notice b').count(), 0);
  });
  await stage.on(bring('{"/robot": 1'), {}, async (page) => {
    await page.getByText('The parameters in this link cannot be read.').waitFor();
  });
});

test('the layout is copied as lines of a manifest', () =>
  stage.on(`quiet#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', { plot: { paths: ['/a.b'] } }], sizes: [1, 3] }))}`, {
    permissions: ['clipboard-read', 'clipboard-write'],
  }, async (page) => {
    await page.getByRole('tab', { name: 'Plot' }).waitFor();
    await page.getByRole('button', { name: 'Layout of the page' }).click();
    await page.getByRole('menuitem', { name: /^Copy as .ui: layout:/ }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    const { ui } = parse(await page.evaluate(() => navigator.clipboard.readText())) as { ui: { layout: { row: unknown; }; }; };
    assert.deepEqual(ui.layout.row, ['nodes', { plot: { paths: ['/a.b'] } }]);
  }));

test('a group fills the page, by keyboard, and what is behind goes on unseen', () =>
  stage.on('quiet', {}, async (page) => {
    await page.getByRole('button', { name: 'Move or close Topics' }).focus();
    for (const key of ['Enter', 'f', 'Enter']) await page.keyboard.press(key);
    await page.getByRole('button', { name: 'Back to all panels' }).waitFor();
    const width = (): Promise<number> => page.locator('.group:has(#tab-topics)').evaluate((group) => group.getBoundingClientRect().width);
    assert.ok((await width()) > 1200, String(await width()));
    assert.equal(await page.getByRole('tab', { name: 'Nodes' }).count(), 0);
    assert.equal(await page.locator('#tab-nodes').count(), 1);
    await expectAccessible(page);
    await page.getByRole('button', { name: 'Back to all panels' }).focus();
    await page.keyboard.press('Enter');
    await page.getByRole('tab', { name: 'Nodes' }).waitFor();
    assert.ok((await width()) < 700);
  }));

test('links bring what panels show: a filter, a message, a request, a line that is not run', async () => {
  const layout = (panels: unknown): string => `#layout=${encodeURIComponent(JSON.stringify(panels))}`;
  await stage.on(
    `publish${
      layout({
        row: [{ console: { text: 'hello', level: 'WARN' } }, { publish: { topic: '/cmd_vel', type: 'geometry_msgs/msg/Twist', message: '{linear: {x: 0.5}}' } },
          { terminal: { line: 'ros2 topic list\n<b>' } }],
      })
    }`,
    {},
    async (page) => {
      assert.equal(await page.getByRole('searchbox', { name: 'Filter lines' }).inputValue(), 'hello');
      assert.equal(await page.getByRole('combobox', { name: 'Lowest level shown' }).inputValue(), 'WARN');
      await page.getByRole('textbox', { name: 'YAML of the message for /cmd_vel' }).waitFor();
      assert.equal(await page.getByRole('textbox', { name: 'YAML of the message for /cmd_vel' }).inputValue(), '{linear: {x: 0.5}}');
      assert.equal(await page.getByRole('textbox', { name: 'Command' }).inputValue(), 'ros2 topic list <b>');
      assert.equal(await page.getByText('$ ros2 topic list').count(), 0);
      // The written text is in the next link, once its field has lost the focus.
      await page.getByRole('textbox', { name: 'YAML of the message for /cmd_vel' }).fill('{angular: {z: 2}}');
      await page.getByRole('searchbox', { name: 'Filter lines' }).fill('world');
      assert.match(fieldsOf(await copyLink(page)).get('layout') ?? '', /"text":"world".*"message":"\{angular: \{z: 2\}\}"/);
    },
  );
  await stage.on(`services${layout({ services: { name: '/add', request: '{a: 20, b: 3}' } })}`, {}, async (page) => {
    await page.getByRole('button', { name: 'Call' }).click();
    await page.getByText('sum:').waitFor();
    assert.match(await page.locator('.message').innerText(), /sum: 23/);
  });
});
