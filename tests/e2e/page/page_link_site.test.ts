// "Copy a link to this view" on a packed site: launch arguments, parameters and layout come along into another browser, over
// https:// or localhost and over plain http from another machine, where browsers have no digests; a link of another site says so.

import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium, type Page } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const example = resolve(import.meta.dirname, '../../../examples/02_launch');
const watchdog = { timeout: 400_000 };
let workspace: PackWorkspace;
let browser: Browser;

before(async () => {
  workspace = new PackWorkspace('shared');
  cpSync(example, workspace.root, { recursive: true });
  workspace.write('start.launch.xml', `<launch>
  <arg name="robot" default="gamma" description="who drives"><choice value="gamma"/><choice value="delta"/></arg>
  <node pkg="two_robots" exec="robot" namespace="$(var robot)"><param name="speed" value="1.0"/></node>
</launch>
`);
  const manifest = readFileSync(join(example, 'workspace.yaml'), 'utf8');
  writeFileSync(join(workspace.root, 'workspace.yaml'), manifest.replace(/^launch: .*$/m, 'launch: start.launch.xml'));
  await workspace.packed();
  // A name that is not localhost stands for another machine.
  browser = await chromium.launch(chromiumOptions(['--host-resolver-rules=MAP lab.example 127.0.0.1']));
}, { timeout: 500_000 });

after(async () => {
  await browser.close();
  workspace.close();
});

const panels = (page: Page): Promise<readonly string[]> => page.getByRole('tab').allInnerTexts();
const speed = (page: Page) => page.getByRole('textbox', { name: 'speed of /delta/robot', exact: true });
const isFast = (page: Page): Promise<unknown> =>
  page.waitForFunction(() => document.querySelector<HTMLInputElement>('input[type="text"][aria-label="speed of /delta/robot"]')?.value === '3.5');

async function visited<T>(address: string, look: (page: Page) => Promise<T>): Promise<T> {
  const context = await browser.newContext();
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(120_000);
    await page.goto(address);
    return await look(page);
  } finally {
    await context.close();
  }
}

for (
  const [how, isolated, name] of [['shared memory, localhost', true, '127.0.0.1'], ['message ports, plain http of another machine', false,
    'lab.example']] as const
) {
  test(`${how}: a link brings launch arguments, parameters and layout, and says when it is of another site`, watchdog, async () => {
    const host = await serveFolder(join(workspace.root, 'site'), { isolated });
    const address = host.url.replace('127.0.0.1', name).replace('localhost', name);
    try {
      const beside = encodeURIComponent(JSON.stringify({ row: ['nodes', { tabs: ['parameters', 'console'] }, 'graph'], sizes: [1, 2, 1] }));
      const { link, shown } = await visited(`${address}#layout=${beside}`, async (page) => {
        assert.equal(await page.evaluate(() => isSecureContext), isolated);
        await page.getByText('Launch arguments').click();
        await page.getByLabel('robot', { exact: true }).selectOption('delta');
        await page.getByRole('button', { name: 'Apply and restart' }).click();
        await speed(page).waitFor();
        await speed(page).fill('3.5');
        await speed(page).press('Enter');
        await page.getByRole('status').getByText('speed of /delta/robot is set').waitFor();
        // The layout of the visitor: one panel less.
        await page.getByRole('button', { name: 'Move or close Graph' }).click();
        await page.getByRole('menuitem', { name: 'Close Graph' }).click();
        await page.getByRole('tab', { name: 'Graph' }).waitFor({ state: 'detached' });
        await page.getByRole('button', { name: 'Layout of the page' }).click();
        await page.getByRole('menuitem', { name: 'Copy a link to this view' }).click();
        await page.waitForFunction(() => location.hash.includes('site='));
        return { link: page.url(), shown: await panels(page) };
      });
      assert.match(link, /\?robot:=delta#/);
      assert.match(new URLSearchParams(new URL(link).hash.slice(1)).get('site') ?? '', /^[0-9a-f]{16}$/);
      assert.deepEqual(shown, ['Nodes', 'Parameters', 'Consoles']);
      await visited(link, async (page) => {
        await page.getByText('The link brings a parameter, set when its node runs.').waitFor();
        await isFast(page);
        assert.deepEqual(await panels(page), shown);
        assert.doesNotMatch(await page.getByRole('region', { name: 'About the link' }).innerText(), /another version/);
        await page.getByText('Launch arguments').click();
        assert.equal(await page.getByLabel('robot', { exact: true }).inputValue(), 'delta');
      });
      await visited(link.replace(/site=[0-9a-f]{16}/, 'site=0123456789abcdef'), async (page) => {
        await page.getByText('This link was made for another version of this site.').waitFor();
        await isFast(page);
        assert.deepEqual(await panels(page), shown);
      });
    } finally {
      await host.close();
    }
  });
}
