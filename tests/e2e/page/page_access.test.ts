// The page for everyone: axe-core in both themes, keyboard, narrow screens, zoom, motion, theme.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, focused, phone } from '../support/page_stage.ts';

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

for (const colorScheme of ['light', 'dark'] as const) {
  for (const scene of ['talker', 'crowd', 'failure', 'empty', 'broken']) {
    test(`axe finds nothing: ${scene}, ${colorScheme}`, () =>
      stage.on(scene, { colorScheme, reducedMotion: 'reduce' }, async (page) => {
        const topic = page.locator('.topic-head').nth(scene === 'crowd' ? 3 : 0);
        if (scene === 'talker' || scene === 'crowd') {
          await topic.click();
          await page.locator('.tree').waitFor();
          await page
            .getByRole('button', { name: /^Type into/ })
            .first()
            .click();
          await page.locator('.node-name').first().click();
        }
        await expectAccessible(page);
      }));
  }
  test(`axe finds nothing: every tab of a phone and the dialog, ${colorScheme}`, () =>
    stage.on('crowd', { ...phone, colorScheme, reducedMotion: 'reduce' }, async (page) => {
      for (const name of ['Nodes', 'Consoles', 'Topics']) {
        await page.getByRole('tab', { name }).click();
        await page.locator(`section:has(h2:text("${name}"))`).waitFor();
        await expectAccessible(page);
      }
      await page.getByRole('button', { name: 'Menu of the page' }).click();
      await expectAccessible(page);
      await page.getByRole('menuitem', { name: 'About this page', exact: true }).click();
      await page.getByRole('dialog').waitFor();
      await expectAccessible(page);
    }));
}

test('the keyboard reaches and works everything', () =>
  stage.on('quiet', {}, async (page) => {
    await page.keyboard.press('Tab');
    assert.equal(await focused(page), 'Skip to the consoles');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement?.id === 'panel-console');
    // Round the whole page: every control is met, and each shows a ring.
    const met = new Set<string>();
    await page.evaluate(() => (document.activeElement as HTMLElement).blur());
    for (let i = 0; i < 80; i += 1) {
      await page.keyboard.press('Tab');
      const name = await focused(page);
      const ring = await page.evaluate(() => {
        const element = document.activeElement?.closest('.search') ?? document.activeElement;
        return (
          element === null
          || element === document.body
          || getComputedStyle(element).outlineStyle !== 'none'
        );
      });
      assert.ok(ring, `no focus ring on ${name}`);
      met.add(name);
    }
    for (
      const wanted of [
        'Start all',
        'Stop all',
        'Theme: as the system. Switch to light',
        'About this page',
        '/talker',
        'Stop /talker',
        'Restart /listener',
        'Border between Nodes and Consoles',
        'Each node',
        'Merged',
        'Lowest level shown',
        'Filter lines',
        'Type into /talker',
        'Clear the console of /talker',
        'Console of /talker',
        'Border between Consoles and Topics',
        'Open a panel here',
        'Move or close Topics',
        'Layout of the page',
        'Show hidden topics',
      ]
    ) {
      assert.ok(met.has(wanted), `${wanted} is not reached; met: ${[...met].join(' | ')}`);
    }
    await page.getByRole('button', { name: 'Stop /talker' }).focus();
    await page.keyboard.press('Space');
    await page.getByText('1 of 2 running').waitFor();
  }));

test('tabs of the phone layout follow the arrow keys, and a chosen node opens its console', () =>
  stage.on('crowd', phone, async (page) => {
    await page.getByRole('tab', { name: 'Consoles' }).focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await focused(page), 'tab-topics');
    await page.locator('.panel-topics').waitFor();
    await page.keyboard.press('Home');
    await page.locator('.panel-nodes').waitFor();
    await page.locator('.node-name').nth(1).click();
    await page.locator('.tile-title').getByText('/robot/laser').waitFor();
    assert.equal(
      await page.getByRole('tab', { name: 'Consoles' }).getAttribute('aria-selected'),
      'true',
    );
  }));

test('nothing is cut off at 320 and 360 px, nor at 200 % zoom', async () => {
  for (
    const [width, height] of [
      [320, 568],
      [360, 740],
      [640, 400],
      [720, 450],
    ] as const
  ) {
    for (const scene of ['crowd', 'hostile']) {
      await stage.on(scene, { viewport: { width, height } }, async (page) => {
        for (const tab of await page.getByRole('tab').all()) {
          await tab.click();
          const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          assert.ok(over <= 0, `${scene} at ${width} px is ${over} px too wide`);
        }
      });
    }
  }
});

test('on a phone no button of the head is an icon alone', async () => {
  for (const width of [320, 390]) {
    await stage.on('crowd', { viewport: { width, height: 844 } }, async (page) => {
      const words = await page.locator('.head button:visible, .head a:visible').allInnerTexts();
      assert.ok(words.length >= 6 && words.every((text) => text.trim() !== ''), words.join('|'));
      await page.getByRole('button', { name: 'Menu of the page' }).click();
      for (const name of ['About this page', /^Theme: as the system/, /^Join other tabs/, 'Copy a link to this view', 'Usual layout'])
        assert.ok(await page.getByRole('menuitem', { name }).isVisible(), String(name));
      assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= width);
      await page.getByRole('menuitem', { name: /^Theme: as the system/ }).click();
      await page.getByRole('button', { name: 'Menu of the page' }).click();
      await page.getByRole('menuitem', { name: /^Theme: light/ }).waitFor();
    });
  }
});

test('targets of touch are at least 24 px', () =>
  stage.on('crowd', phone, async (page) => {
    for (const name of ['Nodes', 'Consoles', 'Topics']) {
      await page.getByRole('tab', { name }).click();
      const small = await page.evaluate(() =>
        [
          ...document.querySelectorAll(
            'button, select, label.search, label.check, input:not(label input), summary',
          ),
        ]
          .map((element) => ({
            name: element.getAttribute('aria-label') ?? element.textContent,
            box: element.getBoundingClientRect(),
          }))
          .filter(({ box }) => box.width > 0 && (box.width < 24 || box.height < 24))
          .map(({ name }) => name)
      );
      assert.deepEqual(small, []);
    }
  }));

test('reduced motion stops every animation and transition, without it some run', async () => {
  /** Animations that go on, and the elements that slid into their place while a topic was opened. */
  const moving = async (page: Page): Promise<{ turning: number; slid: string[]; }> => {
    await page.evaluate(() => {
      const slid: string[] = [];
      document.addEventListener('transitionrun', ({ target }) => {
        if (target instanceof Element) slid.push(target.getAttribute('class') ?? '');
      });
      Object.assign(globalThis, { slid });
    });
    await page.locator('.topic-head').nth(3).click();
    await page.locator('.tree').waitFor();
    return page.evaluate(async () => {
      // A transition begins with the first picture after the change.
      for (let picture = 0; picture < 3; picture += 1) await new Promise((done) => requestAnimationFrame(done));
      const turning = document.getAnimations().filter(({ playState, effect }) =>
        playState === 'running' && effect?.getComputedTiming().iterations === Infinity
      );
      return { turning: turning.length, slid: (globalThis as unknown as { slid: string[]; }).slid };
    });
  };
  await stage.on('crowd', { reducedMotion: 'no-preference' }, async (page) => {
    const { turning, slid } = await moving(page);
    assert.ok(turning > 0, 'what is starting turns');
    assert.ok(slid.some((name) => name.includes('topic-turn')), `slid: ${slid.join(', ')}`);
  });
  await stage.on('crowd', { reducedMotion: 'reduce' }, async (page) => {
    assert.deepEqual(await moving(page), { turning: 0, slid: [] });
    await page.waitForFunction(() => document.getAnimations().every(({ playState }) => playState !== 'running'));
  });
});

test('the theme is chosen, kept, and set before anything is drawn', () =>
  stage.on(
    'quiet',
    { colorScheme: 'light' },
    async (page) => {
      const ground = (): Promise<string> => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const light = await ground();
      await page.getByRole('button', { name: /^Theme: as the system/ }).click();
      await page.getByRole('button', { name: /^Theme: light/ }).click();
      assert.equal(await page.evaluate(() => document.documentElement.dataset['theme']), 'dark');
      assert.notEqual(await ground(), light);
      await page.route('**/start.js', (route) => route.abort());
      await page.goto(`${stage.served.url}?scene=quiet`, { waitUntil: 'commit' });
      await page.locator('.lone-title').waitFor();
      assert.notEqual(await ground(), light);
      await page.unroute('**/start.js');
      await page.goto(`${stage.served.url}?scene=quiet`);
      await page.getByRole('button', { name: /^Theme: dark/ }).click();
      assert.equal(await ground(), light);
    },
    /ERR_FAILED/,
  ));
