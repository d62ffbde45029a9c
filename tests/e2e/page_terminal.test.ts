// The terminal in Chromium, over messages that really pass a graph: commands, completion, history, Ctrl-C, hostile output.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, focused, phone } from './page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "signals".
  var send: (topic: string, type: string, value: unknown) => void;
  var heard: (topic: string) => number;
}

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

const kScene = `signals#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', 'terminal'], sizes: [1, 3], shown: 'terminal' }))}`;
const kSine = { value: 0.5, other: 1, list: [1, 2], mode: 'idle', big: 7 };

function command(page: Page) {
  return page.getByRole('textbox', { name: 'Command' });
}

async function type(page: Page, line: string): Promise<void> {
  // It takes nothing while another one runs.
  await page.waitForSelector('.terminal-input input:not([readonly])');
  await command(page).fill(line);
  await command(page).press('Enter');
}

function output(page: Page) {
  return page.getByRole('log', { name: 'Output of the commands' });
}

const speak = (page: Page, value: unknown = kSine): Promise<void> => page.evaluate((message) => send('/sine', 'demo/msg/Sine', message), value);

test('commands run on the graph of the page, and Ctrl-C ends them', () =>
  stage.on(kScene, {}, async (page) => {
    await speak(page);
    await type(page, 'ros2 topic list -t');
    await output(page).getByText('/sine [demo/msg/Sine]').waitFor();
    await type(page, 'ros2 topic echo /sine');
    await page.waitForFunction(() => heard('/sine') > 0);
    await speak(page);
    await output(page).getByText('value: 0.5').waitFor();
    await output(page).getByText('mode: idle').waitFor();
    await page.getByRole('button', { name: 'Stop the command (Ctrl-C)' }).waitFor();
    await command(page).press('Control+c');
    await output(page).getByText('^C').waitFor();
    await page.waitForFunction(() => heard('/sine') === 0);
    await type(page, "ros2 topic pub --once -w 0 /words demo/msg/Sine '{mode: \"a word\", list: [1]}'");
    await output(page).getByText("publishing #1: demo.msg.Sine(value=0.0, other=0.0, list=[1.0], mode='a word', big=0)").waitFor();
    await type(page, 'ros2 topic ecko');
    await output(page).getByText(/invalid choice: 'ecko'/).waitFor();
    await type(page, 'ls "x');
    await output(page).getByText('a quotation mark is left open').waitFor();
    await type(page, 'ls');
    await output(page).getByText('ls: command not found; help says what there is').waitFor();
    await type(page, 'clear');
    await output(page).getByText('Commands of ros2 run here').waitFor();
  }));

test('Tab completes and lets go, the arrow keys recall', () =>
  stage.on(kScene, {}, async (page) => {
    await speak(page);
    await command(page).fill('ros2 topic ec');
    await command(page).press('Tab');
    assert.equal(await command(page).inputValue(), 'ros2 topic echo ');
    await command(page).press('Tab');
    assert.equal(await command(page).inputValue(), 'ros2 topic echo /sine ');
    await command(page).fill('ros2 topic ');
    await command(page).press('Tab');
    await output(page).getByText(/bw {2}delay {2}echo {2}find {2}hz/).waitFor();
    assert.equal(await focused(page), 'Command');
    await command(page).fill('nothing like that');
    await command(page).press('Tab');
    assert.notEqual(await focused(page), 'Command');
    await type(page, 'help');
    await type(page, 'ros2 node list -a');
    await output(page).getByText('/_ros2wasm_page').waitFor();
    await page.waitForSelector('.terminal-input input:not([readonly])');
    await command(page).press('ArrowUp');
    assert.equal(await command(page).inputValue(), 'ros2 node list -a');
    await command(page).press('ArrowUp');
    assert.equal(await command(page).inputValue(), 'help');
    await command(page).press('ArrowDown');
    await command(page).press('ArrowDown');
    assert.equal(await command(page).inputValue(), '');
  }));

test('what nodes say is text, whatever it is', () =>
  stage.on(kScene, {}, async (page) => {
    await speak(page);
    await type(page, 'ros2 topic echo --field mode /sine');
    await page.waitForFunction(() => heard('/sine') > 0);
    await speak(page, { ...kSine, mode: '<img src=x onerror="document.title=1"> \u001b]0;owned\u0007 \u001b[2J <b>bold</b>' });
    await output(page).getByText('<b>bold</b>').waitFor();
    assert.equal(await page.locator('.terminal img, .terminal b').count(), 0);
  }));

test('a command ends with its panel', () =>
  stage.on(kScene, {}, async (page) => {
    await speak(page);
    await type(page, 'ros2 topic hz /sine');
    await page.waitForFunction(() => heard('/sine') > 0);
    await page.getByRole('button', { name: /Move or close Terminal/ }).click();
    await page.getByRole('menuitem', { name: /^Close/ }).click();
    await page.waitForFunction(() => heard('/sine') === 0);
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the terminal, ${colorScheme}`, () =>
    stage.on(kScene, { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await type(page, 'help');
      await type(page, 'ls');
      await output(page).getByText('command not found').waitFor();
      await expectAccessible(page);
    }));
}

test('the terminal fits a phone', () =>
  stage.on(kScene, { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await type(page, 'help');
    await output(page).getByText('Tab completes').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
  }));
