// Every panel on one packed site, with nodes of C++ and of Python: what each shows of them, and that it is fit for everyone:
// axe-core in both themes, at 200 % zoom, on a phone; and no sink that Trusted Types guard but for workers. A picture of each is in
// tests/output/panels; with ROS2WASM_BLESS=1, docs/images/panels gets those of docs/page.md.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import type { Browser, Locator, Page } from 'playwright-core';
import { texts } from '../../../runtime/site/ui/texts.ts';
import { nightly } from '../../support/nightly.ts';
import { chromiumOptions, SOFTWARE_WEB_GL } from '../support/chromium.ts';
import { packEveryPanel } from '../support/every_panel_site.ts';
import { expectAccessible } from '../support/page_stage.ts';
import { pixels } from '../support/scene_pixels.ts';
import { Scratch, ServedSite } from '../support/served_site.ts';

const OUTPUT = fileURLToPath(new URL('../../output/panels', import.meta.url));
const PICTURES = fileURLToPath(new URL('../../../docs/images/panels', import.meta.url));
const watchdog = { timeout: 900_000 };
const scratch = new Scratch();
const troubles: string[] = [];
let browser: Browser;
let server: ServedSite;
let page: Page;

interface Shown {
  readonly state?: unknown;
  /** Done once, in the first view. */
  readonly act?: (panel: Locator) => Promise<void>;
  /** Waits for what the nodes tell. */
  readonly seen: (panel: Locator) => Promise<void>;
}

/** Waits for a text that fits. */
async function text(within: Locator, words: RegExp | string): Promise<void> {
  await within.getByText(words).first().waitFor();
}

async function command(panel: Locator, line: string): Promise<void> {
  await panel.locator('.terminal-input input:not([readonly])').fill(line);
  await page.keyboard.press('Enter');
}

async function show(id: keyof typeof texts.panels): Promise<void> {
  await page.getByRole('tab', { name: texts.panels[id], exact: true }).click();
}

/** Calls the service that is open in the panel Services. */
async function call(): Promise<void> {
  const panel = page.locator('.panel-services');
  await panel.getByRole('button', { name: 'Call', exact: true }).click();
  await text(panel, /^held/);
}

const DIAGNOSTICS =
  'ros2 topic pub -r 2 /diagnostics diagnostic_msgs/msg/DiagnosticArray "{status: [{level: 1, name: motor, message: warm, hardware_id: SN 7}]}"';

/** A Figure panel comes to the front by itself when a program shows a figure: see figures.test.ts. */
type Id = Exclude<keyof typeof texts.panels, 'figure'>;

const SHOWN: Readonly<Record<Id, Shown>> = {
  text: {
    async seen(panel) {
      await panel.getByRole('heading', { name: 'Tune a controller' }).waitFor();
      await panel.locator('math').first().waitFor();
    },
  },
  notebook: {
    async act(panel) {
      await panel.getByRole('button', { name: 'Run this cell' }).first().click();
      await text(panel, "'lab'");
    },
    seen: (panel) => text(panel, "'lab'"),
  },
  nodes: {
    seen: (panel) => text(panel, /\d+ of 12 running|Running/),
  },
  console: { seen: (panel) => text(panel, /Driving to|Goal reached/) },
  topics: {
    state: { topic: '/turtle1/pose' },
    async seen(panel) {
      await text(panel, /5\.544/);
      // The topic that the state names stands in sight, with what is inside.
      await page.waitForFunction(() => {
        const panel = document.querySelector('.panel-topics')?.getBoundingClientRect();
        const row = document.querySelector('.topic-open')?.getBoundingClientRect();
        return panel !== undefined && row !== undefined && row.top > panel.top && (row.top < panel.top + 100 || row.bottom <= panel.bottom);
      });
    },
  },
  plot: {
    state: { paths: ['/odom.pose.pose.position.x', '/turtle1/pose.x'], seconds: 30 },
    seen: async (panel) => {
      await panel.locator('.path-value').nth(1).getByText(/^5\.54/).waitFor();
      await panel.locator('.path-value').nth(0).getByText(/^-?\d/).waitFor();
    },
  },
  graph: {
    async seen(panel) {
      await panel.getByRole('button', { name: 'Node /controller' }).waitFor();
      await panel.getByRole('button', { name: /^Topic \/cmd_vel/ }).waitFor();
    },
  },
  frames: {
    async seen(panel) {
      await text(panel, 'base_link');
      await text(panel, 'left_wheel');
    },
  },
  terminal: {
    // It publishes until the page goes, or its layout changes.
    async seen(panel) {
      if ((await panel.getByText(/publishing #/).count()) > 0) return;
      await command(panel, 'ros2 topic list');
      await text(panel, '/turtle1/cmd_vel');
      await command(panel, DIAGNOSTICS);
      await text(panel, /publishing #3/);
    },
  },
  diagnostics: {
    seen: async (panel) => {
      await text(panel, 'motor');
      await text(panel, 'warm');
    },
  },
  lifecycle: {
    async act(panel) {
      await panel.getByRole('button', { name: 'configure /lab/sensor' }).click();
      await text(panel, 'configure: done');
    },
    seen: (panel) => text(panel, /^inactive/),
  },
  timeline: {
    state: { paths: ['/odom.header.frame_id', '/turtle1/color_sensor.r'], seconds: 30 },
    seen: (panel) => panel.getByRole('img', { name: 'States of /odom.header.frame_id, now odom' }).waitFor(),
  },
  checks: { seen: (panel) => text(panel, '2 of 2 checks passed') },
  tasks: {
    async act(panel) {
      await panel.getByRole('button', { name: 'Show hint: Listen' }).click();
      await text(panel, 'It comes by itself.');
    },
    seen: (panel) => text(panel, /[01] of 2 tasks done/),
  },
  publish: {
    state: { topic: '/turtle1/cmd_vel', type: 'geometry_msgs/msg/Twist', message: '{linear: {x: 0.0}, angular: {z: 0.5}}' },
    async act(panel) {
      await panel.getByRole('button', { name: 'Publish once' }).click();
      await text(panel, '1 message sent');
    },
    seen: (panel) => panel.getByRole('button', { name: 'Publish once' }).waitFor(),
  },
  teleop: {
    state: { topic: '/turtle1/cmd_vel' },
    seen: (panel) => panel.getByRole('application', { name: /^Pad that drives \/turtle1\/cmd_vel/ }).waitFor(),
  },
  source: {
    state: { file: 'relay.py' },
    seen: (panel) => text(panel.locator('.cm-content'), 'Answers on topic_c'),
  },
  log: {
    // A line that was logged before the panel was there.
    act: (panel) => text(panel, /\[controller\]: Driving to/),
    // And a line that comes after that: a call makes a node log it.
    async seen(panel) {
      await show('services');
      await call();
      await show('log');
      await text(panel, /\[countdown_server\]: held for 2/);
    },
  },
  image: {
    state: { topic: '/camera/image_raw' },
    async seen(panel) {
      const picture = panel.getByRole('img', { name: 'Image of /camera/image_raw, 64 \u00d7 48, rgb8' });
      await picture.waitFor();
      // The middle of each bar of the test card, above the dot.
      const bars = await picture.evaluate((canvas) =>
        Array.from({ length: 8 }, (_, bar) => {
          const one = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
          if (canvas instanceof HTMLCanvasElement) one?.drawImage(canvas, -(8 * bar + 4), -6);
          return [...(one?.getImageData(0, 0, 1, 1).data ?? [])].slice(0, 3).map((part) => part >> 7).join('');
        })
      );
      assert.deepEqual(bars, ['111', '110', '011', '010', '101', '100', '001', '000']);
    },
  },
  simulation: {
    async seen(panel) {
      await text(panel, /^\d+ models$/);
      await panel.getByRole('button', { name: 'ground_plane', exact: true }).waitFor();
      await text(panel, /real time$/);
    },
  },
  scene: {
    state: { view: { distance: 9, azimuth: -1.5708, elevation: 1 }, names: false, list: false, topics: ['/map', '/scan', '/trail', '/robot_description'] },
    async seen() {
      // The robot is orange.
      while ((await pixels(page, 'red')) < 30) await new Promise((go) => setTimeout(go, 200));
    },
  },
  joints: { seen: (panel) => panel.getByRole('slider', { name: 'left_wheel_joint' }).waitFor() },
  services: {
    state: { name: '/hold', request: '{steps: 2}' },
    async seen(panel) {
      await call();
      await text(panel, '/countdown');
    },
  },
  parameters: {
    state: { text: 'k_' },
    seen: (panel) => panel.getByRole('slider', { name: /k_heading/ }).waitFor(),
  },
  bag: {
    async act(panel) {
      await panel.getByRole('button', { name: 'Record', exact: true }).click();
      await panel.getByRole('button', { name: 'Stop recording' }).waitFor();
      await text(panel, /[1-9]\d+ messages/);
      await panel.getByRole('button', { name: 'Stop recording' }).click();
    },
    seen: (panel) => panel.getByRole('button', { name: 'Record', exact: true }).waitFor(),
  },
  turtlesim: { seen: (panel) => panel.getByRole('application', { name: /turtle1/ }).waitFor() },
};

const IDS = Object.keys(SHOWN) as Id[];

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  server = await ServedSite.start([await packEveryPanel(scratch), '--port', '0']);
  browser = await chromium.launch(chromiumOptions(SOFTWARE_WEB_GL));
  page = await browser.newPage({ viewport: { width: 1280, height: 800 }, colorScheme: 'light', reducedMotion: 'reduce' });
  page.setDefaultTimeout(180_000);
  page.on('console', (message) => {
    if (message.type() === 'error' && !message.text().startsWith('[Report Only]')) troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  const tabs = IDS.map((id) => (SHOWN[id].state === undefined ? id : { [id]: SHOWN[id].state }));
  // A second policy for the document. It only reports, because it also covers the addresses of workers, and nodes are workers.
  await page.addInitScript(() => {
    document.addEventListener('securitypolicyviolation', ({ sample }) => {
      if (!/^(Worker constructor|ServiceWorkerContainer register)\|/.test(sample)) console.error(`Trusted Types: ${sample}`);
    });
  });
  await page.route(server.url, async (route) => {
    const response = await route.fetch();
    const policy = "require-trusted-types-for 'script'; trusted-types 'none'";
    await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy-report-only': policy } });
  });
  await page.goto(`${server.url}#layout=${encodeURIComponent(JSON.stringify({ tabs }))}`);
  await page.locator('.page').waitFor();
});

after(async () => {
  await browser.close();
  await server[Symbol.asyncDispose]();
  scratch[Symbol.dispose]();
});

/** The parts of the page that cannot be reached: text or controls beyond its edge without scrolling, and buttons with cut words. */
function cutOff(): Promise<readonly string[]> {
  return page.evaluate(() => {
    const scrolls = (from: Element): boolean => {
      for (let element: Element | null = from; element !== null; element = element.parentElement)
        if (/auto|scroll/.test(getComputedStyle(element).overflowX) && element.scrollWidth > element.clientWidth) return true;
      return false;
    };
    const found = document.documentElement.scrollWidth > innerWidth ? [`the page is ${document.documentElement.scrollWidth} px wide`] : [];
    const bottom = document.querySelector('.page')?.getBoundingClientRect().bottom ?? 0;
    if (document.documentElement.scrollHeight > bottom + scrollY + 1 && document.documentElement.scrollHeight > innerHeight)
      found.push(`the page is ${document.documentElement.scrollHeight} px long, and what it shows ends at ${bottom + scrollY}`);
    for (const element of document.querySelectorAll('.panel *, .head *')) {
      const box = element.getBoundingClientRect();
      if (box.width === 0 || box.height === 0 || element.closest('.visually-hidden, svg, [aria-hidden=true], .u-wrap, .picture-view, .cm-editor') !== null)
        continue;
      const own = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim() !== '');
      const control = element.matches('button, input, select, textarea');
      if (!own && !control) continue;
      const name = `${element.tagName.toLowerCase()}.${element.className} \u201c${
        (element.getAttribute('aria-label') ?? element.textContent ?? '').slice(0, 40)
      }\u201d`;
      if ((box.right > innerWidth + 1 || box.left < -1) && !scrolls(element)) found.push(`${name} is beyond the edge`);
      else if (element.matches('button') && element.scrollWidth > element.clientWidth + 1) found.push(`${name} is cut`);
    }
    return found;
  });
}

/** The picture of the panel for the documentation: as in a column of a page. */
async function takePicture(id: string, panel: Locator): Promise<void> {
  const usual = page.viewportSize();
  await page.setViewportSize({ width: 760, height: 520 });
  // Drawings follow the size in the next frames.
  await page.waitForTimeout(1500);
  mkdirSync(PICTURES, { recursive: true });
  await panel.screenshot({ path: join(PICTURES, `${id}.png`) });
  if (usual !== null) await page.setViewportSize(usual);
}

// Guarantee, hostile input: the page sets no markup from text: of what Trusted Types guard it uses nothing but the start
// of workers
const VIEWS = [
  { name: 'light', width: 1280, height: 800, colorScheme: 'light', often: true },
  { name: 'dark', width: 1280, height: 800, colorScheme: 'dark', often: false },
  // 1280 by 800 at 200 %.
  { name: 'zoom', width: 640, height: 400, colorScheme: 'light', often: false },
  { name: 'phone', width: 320, height: 740, colorScheme: 'dark', often: true },
] as const;

for (const { name, width, height, colorScheme } of VIEWS.filter(({ often }) => often || nightly)) {
  test(`every panel shows what the nodes tell, and axe finds nothing: ${name}`, watchdog, async () => {
    await page.setViewportSize({ width, height });
    await page.emulateMedia({ colorScheme });
    const wrong: string[] = [];
    for (const id of IDS) {
      const { act, seen } = SHOWN[id];
      await show(id);
      const panel = page.locator(`.panel-${id}`);
      try {
        await panel.waitFor();
        if (name === 'light') await act?.(panel);
        await seen(panel);
        wrong.push(...(await cutOff()).map((words) => `${id}: ${words}`));
        await expectAccessible(page);
      } catch (error) {
        wrong.push(`${id}: ${String(error)}`);
      }
      await page.screenshot({ path: join(OUTPUT, `${id}_${name}.png`) });
      if (name === 'light' && process.env['ROS2WASM_BLESS'] === '1') await takePicture(id, panel);
    }
    assert.deepEqual(wrong, []);
    assert.deepEqual(troubles, []);
  });
}

test('a sink that Trusted Types guard would have been seen', async () => {
  await page.evaluate(() => {
    document.createElement('div').innerHTML = '<b></b>';
  });
  await page.waitForTimeout(100);
  assert.deepEqual(troubles.splice(0), ['Trusted Types: Element innerHTML|<b></b>']);
});
