// The page in Chromium with a fake session: what it shows and what its controls do.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { eventually } from '../../support/eventually.ts';
import { PageStage, expectAccessible, focused } from '../support/page_stage.ts';

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

test('the first view shows nodes, consoles in the ROS 2 format, and topics', () =>
  stage.on('talker', {}, async (page) => {
    assert.equal(await page.textContent('h1'), 'Talker and listener');
    assert.equal(await page.title(), 'Talker and listener \u2013 ros2wasm');
    assert.match(
      (await page.textContent('.panel-nodes')) ?? '',
      /\/talker.*Running.*tutorial_talker.*workspace\.yaml:13:5/s,
    );
    const line = await page.locator('[aria-label="Console of /talker"] .line').first().innerText();
    assert.match(line, /^\[INFO\] \[\d+\.\d{9}\] \[talker\]: Publishing: 'Hello, world! \d+'$/);
    assert.match(
      (await page.textContent('.panel-topics')) ?? '',
      /\/topic.*std_msgs\/msg\/String.*2\.00 Hz/s,
    );
    assert.equal(await page.getByText('/rosout').count(), 0);
    await page.getByRole('checkbox', { name: 'Show hidden topics' }).check();
    await page.getByText('/rosout').waitFor();
  }));

test('the decoder comes only when a topic is opened', () =>
  stage.on('talker', {}, async (page) => {
    const loaded = (): Promise<string[]> => page.evaluate(() => performance.getEntriesByType('resource').map((entry) => entry.name.split('/').at(-1) ?? ''));
    const first = await loaded();
    assert.equal(
      first.some((name) => name.startsWith('codec')),
      false,
    );
    await page.getByRole('button', { name: /^\/topic/ }).click();
    await page
      .locator('.tree')
      .getByText(/Hello, world! \d+/)
      .waitFor();
    assert.equal(
      (await loaded()).some((name) => name.startsWith('codec')),
      true,
    );
  }));

test('run control asks the session, for one node and for all', () =>
  stage.on('quiet', {}, async (page) => {
    await page.getByRole('button', { name: 'Stop /talker' }).click();
    await page.getByRole('button', { name: 'Start /talker', exact: true }).click();
    await page.getByRole('button', { name: 'Restart /listener' }).click();
    await page.getByRole('button', { name: 'Stop all' }).click();
    await page.getByText('0 of 2 running').waitFor();
    await page.getByRole('button', { name: 'Start all', exact: true }).click();
    await page.getByText('2 of 2 running').waitFor();
    await page.getByRole('button', { name: 'Restart all' }).click();
    assert.deepEqual(await page.evaluate(() => fake.asked), [
      'stop talker-1',
      'start talker-1',
      'restart listener-2',
      'stop talker-1',
      'stop listener-2',
      'start talker-1',
      'start listener-2',
      'restart talker-1',
      'restart listener-2',
    ]);
  }));

test('a seed opens the page anew, beside what stands in the address', () =>
  stage.on('quiet', {}, async (page) => {
    await page.evaluate(() => history.replaceState(null, '', `${location.search}&rate:=2.0&seed=3#layout=x`));
    await page.getByText('Repeatable run').click();
    const seed = page.getByRole('textbox', { name: 'Seed' });
    await seed.fill('seven');
    await page.getByText('A seed is a whole number').waitFor();
    await page.keyboard.press('Enter');
    await seed.fill('12');
    await page.getByRole('button', { name: 'Restart with this seed' }).click();
    await page.waitForURL((url) => url.search === '?scene=quiet&rate:=2.0&seed=12');
    await page.waitForSelector('.page');
  }));

test('states are words: starting, exited with code, crashed with code, message and place', () =>
  stage.on('crowd', {}, async (page) => {
    const nodes = (await page.textContent('.panel-nodes')) ?? '';
    assert.match(
      nodes,
      /\/planner.*Crashed.*error\[R2W0702\].*vector::_M_range_check.*--> workspace\.yaml:17:5/s,
    );
    assert.match(nodes, /\/safety.*Exited with code 1.*\/logger.*Starting/s);
    await page.evaluate(() =>
      fake.setState('laser-2', {
        kind: 'crashed',
        code: 'R2W0701',
        message: 'unreachable\n  at scan(int) (0x1f)\n  at main (0x2)',
      })
    );
    await page.getByRole('status').getByText('/robot/laser crashed: unreachable', { exact: true }).waitFor();
    const stack = page.locator('.problem-detail').getByText('at scan(int)');
    assert.equal(await stack.innerText(), '  at scan(int) (0x1f)\n  at main (0x2)');
    await page.evaluate(() => fake.setState('diff_drive-1', { kind: 'exited', code: 0 }));
    await page.locator('.panel-nodes').getByText('Finished, code 0').waitFor();
  }));

test('levels have colours, and colours of the program are kept as classes', () =>
  stage.on('crowd', {}, async (page) => {
    for (const level of ['DEBUG', 'WARN', 'ERROR', 'FATAL']) {
      assert.equal(
        await page.locator(`.line.level-${level}`).first().locator('.line-level').innerText(),
        `[${level}]`,
      );
    }
    assert.equal(await page.locator('.ansi-fg-2').innerText(), 'scan');
    assert.equal(await page.locator('[style*="color"]').count(), 0);
  }));

test('a hundred thousand lines: few in the document, follows the end, keeps a reader\u2019s place', () =>
  stage.on('quiet', {}, async (page) => {
    await page.evaluate(() => {
      for (let batch = 0; batch < 100; batch += 1) {
        fake.print(
          'talker-1',
          ...Array.from({ length: 1000 }, (_, i) => `line ${batch * 1000 + i}`),
        );
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
  stage.on('quiet', {}, async (page) => {
    await page.evaluate(() => {
      fake.print(
        'talker-1',
        ...Array.from(
          { length: 300 },
          (_, i) => `${i} ${'some words-with/other signs, and '.repeat(i % 9)}${i % 3 === 0 ? '日本語 \u00e4\u{1f600}'.repeat(9) : ''}`,
        ),
      );
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
  stage.on('quiet', {}, async (page) => {
    await page.evaluate(() => {
      fake.log('talker-1', 'INFO', 'apple');
      fake.log('listener-2', 'WARN', 'pear');
    });
    await page.getByRole('button', { name: 'Merged' }).click();
    const merged = page.locator('[aria-label="Console of all nodes"]').first();
    assert.match(
      await merged.locator('.line').nth(0).innerText(),
      /^\[talker-1\] \[INFO\] \[.*\] \[talker\]: apple$/,
    );
    assert.match(
      await merged.locator('.line').nth(1).innerText(),
      /^\[listener-2\] \[WARN\] \[.*\] \[listener\]: pear$/,
    );
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('WARN');
    await merged.getByText('apple').waitFor({ state: 'detached' });
    await page.getByRole('searchbox', { name: 'Filter lines' }).fill('APPLE');
    await merged.getByText('None of 2 lines match the filter.').waitFor();
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('');
    await merged.getByText('apple').waitFor();
    await page.getByRole('searchbox', { name: 'Filter lines' }).fill('');
    await page
      .getByRole('button', { name: 'Show only the console of /listener' })
      .or(page.locator('.node-name').nth(1))
      .first()
      .click();
    await page.locator('.tile-title').getByText('/listener').waitFor();
    assert.equal(await page.locator('.tile').count(), 1);
    await page.getByRole('button', { name: 'Clear the console of /listener' }).click();
    await page.getByText('Nothing printed yet.').waitFor();
    await page.getByRole('button', { name: 'Show all nodes' }).click();
    await merged.getByText('apple').waitFor();
  }));

test('switching views leaves no listener behind', () =>
  stage.on('quiet', {}, async (page) => {
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
  stage.on('talker', { permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    const clipboard = (): Promise<string> => page.evaluate(() => navigator.clipboard.readText());
    await page.getByRole('button', { name: 'Copy the console of /listener' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    assert.match(
      await clipboard(),
      /^\[INFO\] \[\d+\.\d{9}\] \[listener\]: I heard: 'Hello, world! 0'\n/,
    );
    await page.getByRole('button', { name: /^\/topic/ }).click();
    await page.getByRole('button', { name: 'Copy the last message of /topic as YAML' }).click();
    await eventually('the message is copied', async () => /^data: Hello, world! \d+\n$/.test(await clipboard()));
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    await page.getByRole('button', { name: 'Copy a report' }).click();
    await eventually('the report is copied', async () => /^site: talker_listener 1\.0\.0 .*\nlink: shared/.test(await clipboard()));
  }));

test('a report says of each node how it is, and how one that crashed ended', () =>
  stage.on('crowd', { permissions: ['clipboard-read', 'clipboard-write'] }, async (page) => {
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    await page.getByRole('button', { name: 'Copy a report' }).click();
    await page.getByRole('status').getByText('Copied').waitFor();
    const report = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(report, /^ {2}planner-3 \S+ .*: crashed R2W0702: terminate called after throwing an instance of 'std::out_of_range'\n {2}what\(\):/m);
    assert.match(report, /^ {2}safety-4 .*: exited 1$/m);
    assert.match(report, /^ {2}diff_drive-1 .*: running$/m);
    // Neither lines of consoles nor messages.
    assert.doesNotMatch(report, /Wheel separation|Giving up/);
  }));

test('save gives the shown lines as a file', () =>
  stage.on('quiet', {}, async (page) => {
    await page.evaluate(() => {
      fake.log('talker-1', 'INFO', 'apple');
      fake.log('talker-1', 'WARN', 'pear');
    });
    await page.getByRole('combobox', { name: 'Lowest level shown' }).selectOption('WARN');
    const [saved] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Save the console of /talker' }).click(),
    ]);
    assert.equal(saved.suggestedFilename(), 'talker-1.log');
    assert.match(readFileSync(await saved.path(), 'utf8'), /^\[WARN\] \[\d+\.\d{9}\] \[talker\]: pear\n$/);
  }));

test('standard input', () =>
  stage.on('quiet', {}, async (page) => {
    await page.getByRole('button', { name: 'Type into /talker' }).click();
    await page.getByRole('textbox', { name: 'Standard input of /talker' }).waitFor();
    assert.equal(await focused(page), 'Standard input of /talker');
    await page.keyboard.type('hello <b>');
    await page.keyboard.press('Enter');
    assert.deepEqual(await page.evaluate(() => fake.asked), ['input talker-1 hello <b>\n']);
    assert.equal(
      await page.getByRole('textbox', { name: 'Standard input of /talker' }).inputValue(),
      '',
    );
    // Ctrl-C copies a selection; without one it is the signal. Ctrl-D sends the typed text, or the end of input.
    await page.keyboard.type('part');
    await page.keyboard.press('Control+a');
    await page.keyboard.press('Control+c');
    await page.keyboard.press('End');
    await page.keyboard.press('Control+d');
    await page.keyboard.press('Control+d');
    await page.keyboard.press('Control+c');
    await page.getByRole('log', { name: 'Console of /talker' }).getByText('^C', { exact: true }).waitFor();
    assert.deepEqual(await page.evaluate(() => fake.asked.slice(1)), ['input talker-1 part', 'input talker-1 ', 'stop talker-1']);
  }));

test('a node that reads keys gets each at once; Tab leads on', () =>
  stage.on('quiet', {}, async (page) => {
    // Shown without being asked for, and without taking the focus.
    await page.evaluate(() => fake.setTerminal('talker-1', 'cbreak'));
    const field = page.getByRole('textbox', { name: 'Standard input of /talker' });
    await page.getByPlaceholder('Keys go to the node at once').waitFor();
    assert.notEqual(await focused(page), 'Standard input of /talker');
    await field.focus();
    for (const key of ['a', 'Shift+B', 'ArrowUp', 'Enter', 'Escape', 'Backspace', 'Control+d']) await page.keyboard.press(key);
    await page.keyboard.insertText('\u00e4\u00f6');
    assert.equal(await field.inputValue(), '');
    await page.keyboard.press('Control+c');
    const sent = ['a', 'B', '\u001b[A', '\n', '\u001b', '\u007f', '\u0004', '\u00e4\u00f6'].map((text) => `input talker-1 ${text}`);
    assert.deepEqual(await page.evaluate(() => fake.asked), [...sent, 'stop talker-1']);
    // Where Ctrl-C is a key too, the node gets it.
    await page.evaluate(() => fake.setTerminal('talker-1', 'raw'));
    await page.keyboard.press('Control+c');
    assert.equal(await page.evaluate(() => fake.asked.at(-1)), 'input talker-1 \u0003');
    await expectAccessible(page);
    await field.focus();
    await page.keyboard.press('Tab');
    assert.notEqual(await focused(page), 'Standard input of /talker');
    await field.focus();
    await page.keyboard.press('Shift+Tab');
    assert.equal(await focused(page), 'Console of /talker');
    await page.evaluate(() => fake.setTerminal('talker-1', undefined));
    await page.getByPlaceholder('Type a line').waitFor();
    await page.getByRole('button', { name: 'Type into /talker' }).click();
    await field.waitFor({ state: 'detached' });
    await page.evaluate(() => fake.setTerminal('talker-1', 'raw'));
    assert.equal(await field.count(), 0);
  }));

test('messages are trees; long arrays are folded and cut', () =>
  stage.on('crowd', {}, async (page) => {
    await page.getByRole('button', { name: /^\/scan/ }).click();
    const tree = page.locator('.tree');
    await tree.getByText('frame_id:').waitFor();
    assert.match(await tree.innerText(), /stamp:\s+sec: 1700000000\s+nanosec: 250000000/);
    await tree.getByText('360 \u00d7 float32').click();
    await tree.getByText('the first 128 of 360').waitFor();
    const words = await page.locator('.message-words').boundingBox();
    const copy = await page.getByRole('button', { name: /^Copy the last message/ }).boundingBox();
    assert.ok(words !== null && copy !== null && copy.x >= words.x + words.width);
    await page.getByRole('button', { name: /^\/map/ }).click();
    await page.getByText('No message has been published yet.').waitFor();
  }));

test('age and size of the last message stand in one line, in two columns too', () =>
  stage.on('talker', { viewport: { width: 800, height: 720 } }, async (page) => {
    await page.getByRole('button', { name: /^\/topic/ }).click();
    const facts = page.locator('.message-facts');
    await facts.waitFor();
    const lines = (): Promise<number> =>
      facts.evaluate((element) =>
        new Set([...Array(element.textContent.length).keys()].map((i) => {
          const range = document.createRange();
          range.setStart(element.firstChild!, i);
          range.setEnd(element.firstChild!, i + 1);
          return Math.round(range.getBoundingClientRect().top);
        })).size
      );
    assert.equal(await lines(), 1);
  }));

test('a message that was not kept is not said to be none', () =>
  stage.on('quiet', {}, async (page) => {
    await page.evaluate(() => fake.setTopics([{ name: '/map', type: 'nav_msgs/msg/OccupancyGrid', publishers: 0, count: 3 }]));
    await page.getByRole('button', { name: /^\/map/ }).click();
    await page.getByText('The last message was large').waitFor();
    await page.evaluate(() => fake.setTopics([{ name: '/map', type: 'nav_msgs/msg/OccupancyGrid', count: 3 }]));
    await page.getByText('Fetching the last message').waitFor();
  }));

test('the link is told in plain words, with the way to a faster one', () =>
  stage.on('port', {}, async (page) => {
    await page.getByRole('button', { name: /^Link between the nodes: Message ports/ }).click();
    const dialog = page.getByRole('dialog');
    await dialog.getByText('Cross-Origin-Opener-Policy: same-origin').waitFor();
    await dialog.getByText('Nodes that start threads cannot run here').waitFor();
    await dialog.getByText('opens again without a network').waitFor();
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
    await page.getByRole('button', { name: 'About this page', exact: true }).click();
    await dialog.waitFor();
  }));

test('time is held, stepped by the chosen length, and run at another speed', () =>
  stage.on('talker', {}, async (page) => {
    const asked = (): Promise<readonly string[]> => page.evaluate(() => window.fake.time.asked);
    const group = page.getByRole('group', { name: 'Time of the site' });
    await group.getByRole('button', { name: 'Pause the time of all nodes' }).click();
    assert.equal(await group.getByRole('status').innerText(), 'Paused');
    await group.getByRole('combobox', { name: 'Length of a step' }).selectOption({ label: '10\u00a0ms' });
    await group.getByRole('button', { name: 'Let time run for 10\u00a0ms' }).click();
    await group.getByRole('combobox', { name: 'Speed of time' }).selectOption({ label: '0.5\u00d7' });
    await group.getByRole('button', { name: 'Resume the time of all nodes' }).click();
    assert.equal(await group.getByRole('status').innerText(), '');
    assert.deepEqual(await asked(), ['pause', 'step 10000000', 'rate 0.5', 'resume']);
  }));
