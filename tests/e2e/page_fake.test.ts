// The page in Chromium with a fake session: what it shows, keyboard, screen readers, hostile text, faults.
import assert from 'node:assert/strict';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import type { Browser, BrowserContextOptions, Page } from 'playwright-core';
import type { FakeSession } from '../unit/ui/fake_session.ts';
import { chromiumOptions } from './chromium.ts';
import { buildFakePage, serveFolder } from './page_site.ts';
import type { Served } from './page_site.ts';

declare global {
  // Set by page_fake.tsx in the browser.
  var fake: FakeSession;
}

interface AxeResult {
  readonly id: string;
  readonly help: string;
  readonly nodes: readonly { readonly target: readonly unknown[]; readonly failureSummary?: string }[];
}

const kAxe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

let folder = '';
let served: Served;
let browser: Browser;

before(async () => {
  folder = await buildFakePage(mkdtempSync(join(tmpdir(), 'ros2wasm-page-')));
  served = await serveFolder(folder);
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser?.close();
  await served?.close();
  rmSync(folder, { recursive: true, force: true });
});

/** Opens a scene, runs the body, and fails on any console error, exception or request outside the site. */
async function onPage(
  scene: string, options: BrowserContextOptions, body: (page: Page) => Promise<void>, expected: RegExp | null = null,
): Promise<void> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
  const page = await context.newPage();
  const troubles: string[] = [];
  page.setDefaultTimeout(20_000);
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => {
    if (!request.url().startsWith(served.url)) troubles.push(`request to ${request.url()}`);
  });
  try {
    await page.goto(`${served.url}?scene=${scene}`);
    await page.waitForSelector('.page, .lone-failure, .lone .mark');
    await body(page);
    assert.deepEqual(troubles.filter((text) => expected?.test(text) !== true), []);
  } finally {
    await context.close();
  }
}

async function axe(page: Page): Promise<void> {
  await page.evaluate(kAxe);
  const violations = await page.evaluate(async () => {
    const { axe } = globalThis as unknown as { axe: { run: () => Promise<{ violations: AxeResult[] }> } };
    return (await axe.run()).violations;
  });
  const told = violations.map((v) => `${v.id}: ${v.help}\n${v.nodes.map((n) => `  ${String(n.target)} ${n.failureSummary ?? ''}`).join('\n')}`);
  assert.deepEqual(told, []);
}

const phone: BrowserContextOptions = { viewport: { width: 360, height: 740 } };
const focused = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const element = document.activeElement;
    return element?.getAttribute('aria-label') || element?.id || element?.textContent || '';
  });

test('the first view shows nodes, consoles in the ROS 2 format, and topics', () =>
  onPage('talker', {}, async (page) => {
    assert.equal(await page.textContent('h1'), 'Talker and listener');
    assert.equal(await page.title(), 'Talker and listener \u2013 ros2wasm');
    assert.match((await page.textContent('.panel-nodes')) ?? '', /\/talker.*Running.*tutorial_talker.*workspace\.yaml:13:5/s);
    const line = await page.locator('[aria-label="Console of /talker"] .line').first().innerText();
    assert.match(line, /^\[INFO\] \[\d+\.\d{9}\] \[talker\]: Publishing: 'Hello, world! \d+'$/);
    assert.match((await page.textContent('.panel-topics')) ?? '', /\/topic.*std_msgs\/msg\/String.*2\.00 Hz/s);
    assert.equal(await page.getByText('/rosout').count(), 0);
    await page.getByRole('checkbox', { name: 'Show hidden topics' }).check();
    await page.getByText('/rosout').waitFor();
  }));

test('the first view is small, and the decoder comes only when a topic is opened', () =>
  onPage('talker', {}, async (page) => {
    const loaded = (): Promise<string[]> =>
      page.evaluate(() => performance.getEntriesByType('resource').map((entry) => entry.name.split('/').at(-1) ?? ''));
    const first = await loaded();
    assert.equal(first.some((name) => name.startsWith('decoder')), false);
    const bytes = ['index.html', ...first.filter((name) => name !== '')]
      .map((name) => gzipSync(readFileSync(join(folder, name)), { level: 9 }).length)
      .reduce((a, b) => a + b, 0);
    assert.ok(bytes < 45_000, `${bytes} bytes gzipped`);
    await page.getByRole('button', { name: /^\/topic/ }).click();
    await page.locator('.tree').getByText(/Hello, world! \d+/).waitFor();
    assert.equal((await loaded()).some((name) => name.startsWith('decoder')), true);
  }));

test('run control asks the session, for one node and for all', () =>
  onPage('quiet', {}, async (page) => {
    await page.getByRole('button', { name: 'Stop /talker' }).click();
    await page.getByRole('button', { name: 'Start /talker', exact: true }).click();
    await page.getByRole('button', { name: 'Restart /listener' }).click();
    await page.getByRole('button', { name: 'Stop all' }).click();
    await page.getByText('0 of 2 running').waitFor();
    await page.getByRole('button', { name: 'Start all' }).click();
    await page.getByText('2 of 2 running').waitFor();
    assert.deepEqual(await page.evaluate(() => fake.asked), [
      'stop talker-1', 'start talker-1', 'restart listener-2', 'stop talker-1', 'stop listener-2', 'start talker-1', 'start listener-2',
    ]);
  }));

test('states are words: starting, exited with code, crashed with code, message and place', () =>
  onPage('crowd', {}, async (page) => {
    const nodes = (await page.textContent('.panel-nodes')) ?? '';
    assert.match(nodes, /\/planner.*Crashed.*error\[R2W0720\].*vector::_M_range_check.*--> workspace\.yaml:17:5/s);
    assert.match(nodes, /\/safety.*Exited with code 1.*\/logger.*Starting/s);
    await page.evaluate(() => fake.setState('laser-2', { kind: 'crashed', code: 'R2W0720', message: 'unreachable' }));
    await page.getByRole('status').getByText('/robot/laser crashed: unreachable').waitFor();
    await page.evaluate(() => fake.setState('diff_drive-1', { kind: 'exited', code: 0 }));
    await page.locator('.panel-nodes').getByText('Finished, code 0').waitFor();
  }));

test('levels have colours, and colours of the program are kept as classes', () =>
  onPage('crowd', {}, async (page) => {
    for (const level of ['DEBUG', 'WARN', 'ERROR', 'FATAL']) {
      assert.equal(await page.locator(`.line.level-${level}`).first().locator('.line-level').innerText(), `[${level}]`);
    }
    assert.equal(await page.locator('.ansi-fg-2').innerText(), 'scan');
    assert.equal(await page.locator('[style*="color"]').count(), 0);
  }));

test('a hundred thousand lines: few in the document, follows the end, keeps a reader\u2019s place', () =>
  onPage('quiet', {}, async (page) => {
    await page.evaluate(() => {
      for (let batch = 0; batch < 100; batch += 1) {
        fake.print('talker-1', ...Array.from({ length: 1000 }, (_, i) => `line ${batch * 1000 + i}`));
      }
    });
    const tile = page.locator('.tile').first();
    const lines = tile.locator('.lines');
    await tile.getByText('line 99999', { exact: true }).waitFor();
    assert.ok((await tile.locator('.line').count()) < 100);
    const atEnd = (): Promise<boolean> => lines.evaluate((box) => box.scrollTop + box.clientHeight >= box.scrollHeight - 2);
    assert.equal(await atEnd(), true);
    await lines.evaluate((box) => {
      box.scrollTop = 20_000;
    });
    await tile.getByRole('button', { name: 'Latest' }).waitFor();
    const top = await tile.locator('.line').nth(20).innerText();
    await page.evaluate(() => fake.print('talker-1', 'one more', 'and another'));
    await tile.getByRole('button', { name: '2 new' }).waitFor();
    assert.equal(await tile.locator('.line').nth(20).innerText(), top);
    await tile.getByRole('button', { name: '2 new' }).click();
    await tile.getByText('and another', { exact: true }).waitFor();
    assert.equal(await atEnd(), true);
  }));

test('long lines wrap and their heights are right, ASCII or not', () =>
  onPage('quiet', {}, async (page) => {
    await page.evaluate(() => {
      fake.print('talker-1', ...Array.from({ length: 300 }, (_, i) => `${i} ${'some words-with/other signs, and '.repeat(i % 9)}${i % 3 === 0 ? '日本語 \u00e4\u{1f600}'.repeat(9) : ''}`));
    });
    const tile = page.locator('.tile').first();
    await tile.getByText('299 ', { exact: false }).first().waitFor();
    // The drawn lines end where the reckoned height ends.
    await page.waitForFunction(() => {
      const all = document.querySelector('.lines-all')?.getBoundingClientRect();
      const shown = document.querySelector('.lines-shown')?.getBoundingClientRect();
      return all !== undefined && shown !== undefined && Math.abs(all.bottom - shown.bottom) < 2;
    });
  }));

test('filter by text and level, merged view, one node alone, clear', () =>
  onPage('quiet', {}, async (page) => {
    await page.evaluate(() => {
      fake.log('talker-1', 'INFO', 'apple');
      fake.log('listener-2', 'WARN', 'pear');
    });
    await page.getByRole('button', { name: 'Merged' }).click();
    const merged = page.locator('[aria-label="Console of all nodes"]').first();
    assert.match(await merged.locator('.line').nth(0).innerText(), /^\[talker-1\] \[INFO\] \[.*\] \[talker\]: apple$/);
    assert.match(await merged.locator('.line').nth(1).innerText(), /^\[listener-2\] \[WARN\] \[.*\] \[listener\]: pear$/);
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('WARN');
    await merged.getByText('apple').waitFor({ state: 'detached' });
    await page.getByRole('searchbox', { name: 'Filter lines' }).fill('APPLE');
    await merged.getByText('None of 2 lines match the filter.').waitFor();
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('');
    await merged.getByText('apple').waitFor();
    await page.getByRole('searchbox', { name: 'Filter lines' }).fill('');
    await page.getByRole('button', { name: 'Show only the console of /listener' }).or(page.locator('.node-name').nth(1)).first().click();
    await page.locator('.tile-title').getByText('/listener').waitFor();
    assert.equal(await page.locator('.tile').count(), 1);
    await page.getByRole('button', { name: 'Clear the console of /listener' }).click();
    await page.getByText('Nothing printed yet.').waitFor();
    await page.getByRole('button', { name: 'Show all nodes' }).click();
    await merged.getByText('apple').waitFor();
  }));

test('switching views leaves no listener behind', () =>
  onPage('quiet', {}, async (page) => {
    const count = (): Promise<number> => page.evaluate(() => fake.listenerCount);
    const start = await count();
    for (let i = 0; i < 5; i += 1) {
      await page.getByRole('button', { name: 'Merged' }).click();
      await page.locator('[aria-label="Console of all nodes"]').first().waitFor();
      await page.getByRole('button', { name: 'Each node' }).click();
      await page.locator('[aria-label="Console of /listener"]').first().waitFor();
    }
    await page.waitForFunction((expected) => fake.listenerCount === expected, start);
  }));

test('copy puts the shown lines and a message\u2019s YAML on the clipboard', () =>
  onPage('talker', { permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    const clipboard = (): Promise<string> => page.evaluate(() => navigator.clipboard.readText());
    await page.getByRole('button', { name: 'Copy the console of /listener' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    assert.match(await clipboard(), /^\[INFO\] \[\d+\.\d{9}\] \[listener\]: I heard: 'Hello, world! 0'\n/);
    await page.getByRole('button', { name: /^\/topic/ }).click();
    await page.getByRole('button', { name: 'Copy the last message of /topic as YAML' }).click();
    await page.waitForFunction(async () => /^data: Hello, world! \d+\n$/.test(await navigator.clipboard.readText()));
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    await page.getByRole('button', { name: 'Copy a report' }).click();
    await page.waitForFunction(async () => /^site: talker_listener 1\.0\.0 .*\nlink: shared/.test(await navigator.clipboard.readText()));
  }));

test('standard input', () =>
  onPage('quiet', {}, async (page) => {
    await page.getByRole('button', { name: 'Type into /talker' }).click();
    assert.equal(await focused(page), 'Standard input of /talker');
    await page.keyboard.type('hello <b>');
    await page.keyboard.press('Enter');
    assert.deepEqual(await page.evaluate(() => fake.asked), ['input talker-1 hello <b>\n']);
    assert.equal(await page.getByRole('textbox', { name: 'Standard input of /talker' }).inputValue(), '');
  }));

test('messages are trees; long arrays are folded and cut', () =>
  onPage('crowd', {}, async (page) => {
    await page.getByRole('button', { name: /^\/scan/ }).click();
    const tree = page.locator('.tree');
    await tree.getByText('frame_id:').waitFor();
    assert.match(await tree.innerText(), /stamp:\s+sec: 1700000000\s+nanosec: 250000000/);
    await tree.getByText('360 \u00d7 float32').click();
    await tree.getByText('the first 128 of 360').waitFor();
    await page.getByRole('button', { name: /^\/odom/ }).click();
    await page.getByText('No message has been published yet.').waitFor();
  }));

test('the link is told in plain words, with the way to a faster one', () =>
  onPage('port', {}, async (page) => {
    await page.getByRole('button', { name: /^Link between the nodes: Message ports/ }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByText('Cross-Origin-Opener-Policy: same-origin').waitFor();
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    await dialog.waitFor();
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  for (const scene of ['talker', 'crowd', 'failure', 'empty', 'broken']) {
    test(`axe finds nothing: ${scene}, ${colorScheme}`, () =>
      onPage(scene, { colorScheme, reducedMotion: 'reduce' }, async (page) => {
        const topic = page.locator('.topic-head').nth(scene === 'crowd' ? 3 : 0);
        if (scene === 'talker' || scene === 'crowd') {
          await topic.click();
          await page.locator('.tree').waitFor();
          await page.getByRole('button', { name: /^Type into/ }).first().click();
          await page.locator('.node-name').first().click();
        }
        await axe(page);
      }));
  }
  test(`axe finds nothing: every tab of a phone and the dialog, ${colorScheme}`, () =>
    onPage('crowd', { ...phone, colorScheme, reducedMotion: 'reduce' }, async (page) => {
      for (const name of ['Nodes', 'Consoles', 'Topics']) {
        await page.getByRole('tab', { name }).click();
        await page.locator(`section:has(h2:text("${name}"))`).waitFor();
        await axe(page);
      }
      await page.getByRole('button', { name: 'About this page', exact: true }).click();
      await page.getByRole('dialog').waitFor();
      await axe(page);
    }));
}

test('the keyboard reaches and works everything', () =>
  onPage('quiet', {}, async (page) => {
    await page.keyboard.press('Tab');
    assert.equal(await focused(page), 'Skip to the consoles');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement?.id === 'panel-console');
    // Round the whole page: every control is met, and each shows a ring.
    const met = new Set<string>();
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    for (let i = 0; i < 60; i += 1) {
      await page.keyboard.press('Tab');
      const name = await focused(page);
      const ring = await page.evaluate(() => {
        const element = document.activeElement?.closest('.search') ?? document.activeElement;
        return element === null || element === document.body || getComputedStyle(element).outlineStyle !== 'none';
      });
      assert.ok(ring, `no focus ring on ${name}`);
      met.add(name);
    }
    for (const wanted of [
      'Start all', 'Stop all', 'Theme: as the system. Switch to light', 'About this page', '/talker', 'Stop /talker', 'Restart /listener',
      'Width of the nodes', 'Each node', 'Merged', 'Lowest level shown', 'Filter lines', 'Type into /talker', 'Clear the console of /talker',
      'Console of /talker', 'Width of the topics', 'Show hidden topics',
    ]) {
      assert.ok(met.has(wanted), `${wanted} is not reached; met: ${[...met].join(' | ')}`);
    }
    await page.getByRole('button', { name: 'Stop /talker' }).focus();
    await page.keyboard.press('Space');
    await page.getByText('1 of 2 running').waitFor();
  }));

test('columns are resized with the keyboard and remembered', () =>
  onPage('quiet', {}, async (page) => {
    const bar = page.getByRole('separator', { name: 'Width of the nodes' });
    const width = (): Promise<number> => page.locator('.panel-nodes').evaluate((panel) => panel.getBoundingClientRect().width);
    const start = await width();
    await bar.focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    await page.waitForFunction((expected) => document.querySelector('.panel-nodes')?.getBoundingClientRect().width === expected, start + 32);
    await page.reload();
    await page.waitForSelector('.page');
    assert.equal(await width(), start + 32);
    const box = (await bar.boundingBox()) ?? assert.fail();
    await page.mouse.move(box.x + 5, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x - 59, box.y + 100);
    await page.mouse.up();
    await page.waitForFunction((limit) => (document.querySelector('.panel-nodes')?.getBoundingClientRect().width ?? 999) < limit, start);
    await bar.dblclick();
    await page.waitForFunction((expected) => document.querySelector('.panel-nodes')?.getBoundingClientRect().width === expected, start);
  }));

test('tabs of the phone layout follow the arrow keys, and a chosen node opens its console', () =>
  onPage('crowd', phone, async (page) => {
    await page.getByRole('tab', { name: 'Consoles' }).focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await focused(page), 'tab-topics');
    await page.locator('.panel-topics').waitFor();
    await page.keyboard.press('Home');
    await page.locator('.panel-nodes').waitFor();
    await page.locator('.node-name').nth(1).click();
    await page.locator('.tile-title').getByText('/robot/laser').waitFor();
    assert.equal(await page.getByRole('tab', { name: 'Consoles' }).getAttribute('aria-selected'), 'true');
  }));

test('nothing is cut off at 320 and 360 px, nor at 200 % zoom', async () => {
  for (const [width, height] of [[320, 568], [360, 740], [640, 400], [720, 450]] as const) {
    for (const scene of ['crowd', 'hostile']) {
      await onPage(scene, { viewport: { width, height } }, async (page) => {
        for (const tab of await page.getByRole('tab').all()) {
          await tab.click();
          const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          assert.ok(over <= 0, `${scene} at ${width} px is ${over} px too wide`);
        }
      });
    }
  }
});

test('targets of touch are at least 24 px', () =>
  onPage('crowd', phone, async (page) => {
    for (const name of ['Nodes', 'Consoles', 'Topics']) {
      await page.getByRole('tab', { name }).click();
      const small = await page.evaluate(() =>
        [...document.querySelectorAll('button, select, label.search, label.check, input:not(label input), summary')]
          .map((element) => ({ name: element.getAttribute('aria-label') ?? element.textContent, box: element.getBoundingClientRect() }))
          .filter(({ box }) => box.width > 0 && (box.width < 24 || box.height < 24))
          .map(({ name }) => name),
      );
      assert.deepEqual(small, []);
    }
  }));

test('hostile names, logs and messages are only text', () =>
  onPage('hostile', {}, async (page) => {
    for (const head of await page.locator('.topic-head').all()) await head.click();
    await page.locator('.tree').waitFor();
    await page.getByRole('button', { name: 'Merged' }).click();
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    assert.equal(await page.locator('#page img, #page script, #page iframe').count(), 0);
    assert.match(await page.title(), /^<img src=x/);
    assert.match((await page.textContent('.tree')) ?? '', /<img src=x onerror=/);
    assert.match((await page.textContent('h1')) ?? '', /<script>/);
  }));

test('the page needs no sink that Trusted Types guard', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  const troubles: string[] = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  await page.route('**/?scene=*', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), 'content-security-policy': "require-trusted-types-for 'script'; trusted-types 'none'" } });
  });
  await page.goto(`${served.url}?scene=crowd`);
  await page.locator('.topic-head').nth(3).click();
  await page.locator('.tree').waitFor();
  assert.deepEqual(troubles, []);
  await context.close();
});

test('reduced motion stops every animation', () =>
  onPage('crowd', { reducedMotion: 'reduce' }, async (page) => {
    await page.waitForFunction(() => document.getAnimations().filter((animation) => animation.playState === 'running').length === 0);
  }));

test('the theme is chosen, kept, and set before anything is drawn', () =>
  onPage('quiet', { colorScheme: 'light' }, async (page) => {
    const ground = (): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await ground();
    await page.getByRole('button', { name: /^Theme: as the system/ }).click();
    await page.getByRole('button', { name: /^Theme: light/ }).click();
    assert.equal(await page.evaluate(() => document.documentElement.dataset['theme']), 'dark');
    assert.notEqual(await ground(), light);
    await page.route('**/main.js', (route) => route.abort());
    await page.goto(`${served.url}?scene=quiet`, { waitUntil: 'commit' });
    await page.locator('.lone-title').waitFor();
    assert.notEqual(await ground(), light);
    await page.unroute('**/main.js');
    await page.goto(`${served.url}?scene=quiet`);
    await page.getByRole('button', { name: /^Theme: dark/ }).click();
    assert.equal(await ground(), light);
  }, /ERR_FAILED/));

test('one broken panel fails alone', () =>
  onPage('broken', {}, async (page) => {
    await page.getByRole('alert').getByText('error[R2W0790]').waitFor();
    assert.match((await page.getByRole('alert').textContent()) ?? '', /The panel \u201cTopics\u201d failed: topics are out of order/);
    await page.locator('.panel-nodes').getByText('2 of 2 running').waitFor();
    await page.evaluate(() => {
      fake.topics = () => [];
    });
    await page.getByRole('button', { name: 'Try again' }).click();
    await page.locator('.panel-topics').waitFor();
  }));

test('a session that cannot start is explained', () =>
  onPage('failure', {}, async (page) => {
    const told = (await page.textContent('main')) ?? '';
    assert.match(told, /could not start.*error\[R2W0703\]: this browser can neither.*why.*Promise Integration.*fix.*open the page by itself/s);
  }));

test('while the session starts the page says so', () =>
  onPage('never', {}, async (page) => {
    await page.getByText('Starting\u2026').waitFor();
  }));

test('an unforeseen error is told in a bar that can be closed', async () => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(`${served.url}?scene=quiet`);
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
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.route('**/main.js', (route) => route.abort());
  await page.goto(served.url);
  await page.evaluate(() => {
    for (const animation of document.getAnimations()) animation.finish();
  });
  await page.getByText('error[R2W0792]').waitFor();
  await page.goto(pathToFileURL(join(folder, 'index.html')).href);
  await page.getByText('error[R2W0791]').waitFor();
  await page.getByText('ros2wasm serve FOLDER').waitFor();
  await context.close();
  const plain = await browser.newContext({ javaScriptEnabled: false });
  const page2 = await plain.newPage();
  await page2.goto(served.url);
  await page2.locator('noscript p').waitFor();
  assert.match(await page2.locator('noscript').innerText(), /needs JavaScript/);
  await plain.close();
});

test('no file of the page refers to another host', () => {
  for (const name of readdirSync(folder)) {
    const addresses = readFileSync(join(folder, name), 'utf8').match(/https?:\/\/[^"'`\s)]+/g) ?? [];
    assert.deepEqual(addresses.filter((address) => !address.startsWith('http://www.w3.org/')), [], name);
  }
});
