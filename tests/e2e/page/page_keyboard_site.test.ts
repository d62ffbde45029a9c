// A packed site by keyboard alone, from the address bar on: nodes are stopped and started, panels opened, split and moved,
// a message published, a service called, a parameter set, a command run. After each key the focus is somewhere, and is seen.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import type { Browser, Page } from 'playwright-core';
import { eventually } from '../../support/eventually.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { packEveryPanel } from '../support/every_panel_site.ts';
import { Scratch, ServedSite } from '../support/served_site.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const watchdog = { timeout: 900_000 };
const MOST_TABS = 250;
const scratch = new Scratch();
let browser: Browser;
let server: ServedSite;
let page: Page;

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  server = await ServedSite.start([await packEveryPanel(scratch), '--port', '0']);
  browser = await chromium.launch(chromiumOptions());
  page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(180_000);
});

after(async () => {
  await browser.close();
  await server[Symbol.asyncDispose]();
  scratch[Symbol.dispose]();
});

interface Focus {
  /** Empty when nothing on the page has the focus. */
  readonly name: string;
  /** Why the focus cannot be seen; empty: it is seen. */
  readonly unseen: string;
}

/** The name that a screen reader reads for the focused element, and whether the focus can be seen. */
function focus(): Promise<Focus> {
  return page.evaluate(() => {
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement != null) element = element.shadowRoot.activeElement;
    if (element === null || element === document.body || element === document.documentElement) return { name: '', unseen: '' };
    const label = element instanceof HTMLInputElement ? element.labels?.[0]?.textContent : undefined;
    const name = (element.getAttribute('aria-label') ?? label ?? element.textContent ?? '').trim() || element.id || element.tagName;
    // A field within a frame of its own is seen by that frame's ring.
    const ringed = [element, element.closest('.search, .cell, .cm-editor')].find((one) => {
      const style = one === null || one === undefined ? null : getComputedStyle(one);
      return style !== null && style.outlineStyle !== 'none' && Number.parseFloat(style.outlineWidth) > 0;
    });
    if (ringed === undefined || ringed === null) return { name, unseen: 'it has no ring' };
    const style = getComputedStyle(ringed);
    const width = Number.parseFloat(style.outlineWidth);
    const reach = Number.parseFloat(style.outlineOffset) + width;
    const box = ringed.getBoundingClientRect();
    const ring = { left: box.left - reach, right: box.right + reach, top: box.top - reach, bottom: box.bottom + reach };
    // Which sides of the ring nothing cuts off; of something as large as its room, two that meet are enough.
    let [left, right, top, bottom] = [ring.left > -1, ring.right < innerWidth + 1, ring.top > -1, ring.bottom < innerHeight + 1];
    for (let around = ringed.parentElement; around !== null; around = around.parentElement) {
      const { overflowX, overflowY } = getComputedStyle(around);
      const clip = around.getBoundingClientRect();
      // A part of its width is enough.
      if (overflowX !== 'visible') [left, right] = [left && ring.left > clip.left - width, right && ring.right < clip.right + width];
      if (overflowY !== 'visible') [top, bottom] = [top && ring.top > clip.top - width, bottom && ring.bottom < clip.bottom + width];
    }
    return {
      name,
      unseen: (left || right) && (top || bottom)
        ? ''
        : `its ring is cut off: left, right, top, bottom ${[left, right, top, bottom].join()} at ${
          [ring.left, ring.right, ring.top, ring.bottom].map(Math.round).join()
        }`,
    };
  });
}

/** Presses a key, after which the focus is somewhere and is seen. */
async function press(key: string): Promise<string> {
  await page.keyboard.press(key);
  // An element that is shown again takes the focus in the next frame.
  await page.evaluate(() => new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(go))));
  const { name, unseen } = await focus();
  assert.notEqual(name, '', `after ${key} the focus is lost`);
  assert.equal(unseen, '', `after ${key}: ${name}`);
  return name;
}

/** Goes on with Tab to what has that name. At its end the page gives the focus to the browser, once. */
async function tabTo(wanted: RegExp | string, key = 'Tab'): Promise<void> {
  const met: string[] = [];
  for (let i = 0; i < MOST_TABS; i += 1) {
    await page.keyboard.press(key);
    const { name, unseen } = await focus();
    if (name === '') {
      assert.ok(!met.includes(''), `${String(wanted)} is not met in a round: ${met.join(' | ')}`);
    } else {
      assert.equal(unseen, '', `${key} to ${name}`);
      if (typeof wanted === 'string' ? name === wanted : wanted.test(name)) return;
    }
    met.push(name);
  }
  assert.fail(`${String(wanted)} is not reached; met: ${met.join(' | ')}`);
}

/** Chooses an item of the menu whose button has the focus. */
async function choose(item: string): Promise<void> {
  await press('Enter');
  const first = (await focus()).name;
  for (let name = first; name !== item;) {
    name = await press('ArrowDown');
    assert.notEqual(name, first, `the menu has no ${item}`);
  }
  await press('Enter');
}

/** Opens a panel in the group that the focus is in, or the next one. `field`: what is in it. `focused`: what has the focus then, usually its tab. */
async function open(title: string, field: string, focused = title): Promise<void> {
  await tabTo('Open a panel here');
  await choose(title);
  // A panel that takes the focus is loaded first.
  await eventually(`the focus is on ${focused}`, async () => (await focus()).name === focused);
  // And so are others: whoever tabs on before meets what is behind them, and an editor there takes Tab for itself.
  await page.getByLabel(field, { exact: true }).first().waitFor();
}

test('from the address bar to the last node stopped, without a pointer', watchdog, async () => {
  await page.goto(server.url);
  await page.locator('.page').waitFor();
  await page.getByText('11 of 12 running').waitFor();
  assert.equal(await press('Tab'), 'Skip to the consoles');

  await tabTo('Stop all');
  await press('Enter');
  await page.getByText('0 of 12 running').waitFor();
  await tabTo('Start all', 'Shift+Tab');
  await press('Enter');
  await page.getByText('11 of 12 running').waitFor();

  // A panel, beside the others, and back among them.
  await open('Publish', 'Topic');
  await tabTo('Move or close Publish');
  await choose('Beside the others, right');
  assert.equal((await focus()).name, 'Publish');
  const alone = page.getByRole('tablist').filter({ has: page.getByRole('tab', { name: 'Publish', exact: true }) });
  assert.equal(await alone.getByRole('tab').count(), 1);
  await tabTo('Move or close Publish');
  await choose('Into the group before');
  assert.equal((await focus()).name, 'Publish');
  assert.ok((await alone.getByRole('tab').count()) > 1);

  await tabTo('Topic');
  await page.keyboard.type('/turtle1/cmd_vel');
  await tabTo('Type');
  await page.keyboard.press('Control+A');
  await page.keyboard.type('geometry_msgs/msg/Twist');
  await tabTo('Publish once');
  await press('Enter');
  await page.getByText('1 message sent').waitFor();

  await open('Services and actions', 'Filter services');
  await tabTo('Filter services');
  await page.keyboard.type('/hold');
  await tabTo(/^\/hold/);
  await press('Enter');
  await tabTo('steps of /hold');
  await page.keyboard.press('Control+A');
  await page.keyboard.type('4');
  await tabTo('Call');
  await press('Enter');
  await page.locator('.panel-services').getByText(/^held/).first().waitFor();
  await page.getByText('held for 4').first().waitFor();

  await open('Parameters', 'Filter parameters');
  await tabTo('Filter parameters');
  await page.keyboard.type('k_heading');
  await page.locator('.panel-parameters').getByRole('slider', { name: /k_heading/ }).waitFor();
  await tabTo(/k_heading/);
  await tabTo(/k_heading/);
  await page.keyboard.press('Control+A');
  await page.keyboard.type('3.5');
  await press('Enter');

  // It is opened to be typed into.
  await open('Terminal', 'Command', 'Command');
  await page.keyboard.type('ros2 param get /controller k_heading');
  await press('Enter');
  await page.getByText('Double value is: 3.5').waitFor();
  await page.screenshot({ path: join(OUTPUT, 'keyboard_journey.png') });

  await tabTo('Stop all');
  await press('Enter');
  await page.getByText('0 of 12 running').waitFor();
  assert.equal((await focus()).name, 'Stop all');
});
