// The terminal in Chromium, over messages that really pass a graph: commands, completion, history, Ctrl-C, hostile output.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { PageStage, expectAccessible, focused, phone } from '../support/page_stage.ts';

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

const SCENE = `signals#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', 'terminal'], sizes: [1, 3], shown: 'terminal' }))}`;
const SINE = { value: 0.5, other: 1, list: [1, 2], mode: 'idle', big: 7 };

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

const speak = (page: Page, value: unknown = SINE): Promise<void> => page.evaluate((message) => send('/sine', 'demo/msg/Sine', message), value);

test('commands run on the graph of the page, and Ctrl-C ends them', () =>
  stage.on(SCENE, {}, async (page) => {
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
    await type(page, 'ros2 topic pub --once -w 0 /words demo/msg/Sine \'{mode: "a word", list: [1]}\'');
    await output(page).getByText("publishing #1: demo.msg.Sine(value=0.0, other=0.0, list=[1.0], mode='a word', big=0)").waitFor();
    await type(page, 'ros2 topic ecko');
    await output(page).getByText(/invalid choice: 'ecko'/).waitFor();
    await type(page, 'ls "x');
    await output(page).getByText('a quotation mark is left open').waitFor();
    await type(page, 'less');
    await output(page).getByText('less: command not found; help says what there is').waitFor();
    await type(page, 'clear');
    await output(page).getByText('Commands of ros2 run here').waitFor();
  }));

test('what lab sheets write: sequences, grep, programs with windows, what needs nothing here', () =>
  stage.on(SCENE, {}, async (page) => {
    await speak(page);
    const whole = () => output(page).locator('.line').allInnerTexts();
    await type(page, 'source /opt/ros/jazzy/setup.bash && ros2 topic list | grep sin && echo "a && b" # a remark');
    await output(page).getByText('a && b', { exact: true }).waitFor();
    assert.deepEqual((await whole()).slice(1), ['nothing to source: every command here knows the packages of this site', '/sine', 'a && b']);
    await type(page, 'clear');
    await type(page, 'help | grep -v -E "gr.p|ros2|rviz2?" && echo more');
    await output(page).getByText('more', { exact: true }).waitFor();
    const left = (await whole()).slice(1);
    assert.ok(left.length === 6 && left.every((line) => !/grep|ros2|rviz/.test(line)), left.join('\n'));
    await type(page, 'clear');
    await type(page, 'ros2 topic list | grep nothing && echo found; less || echo no less');
    await output(page).getByText('no less', { exact: true }).waitFor();
    assert.deepEqual((await whole()).slice(1), ['less: command not found; help says what there is', 'no less']);
    await type(page, 'cd ~/ros2_ws; export ROS_DOMAIN_ID=3; colcon build --symlink-install; sudo apt install x');
    await output(page).getByText('nothing to install').waitFor();
    for (const words of ['ROS_DOMAIN_ID is set in this terminal', 'nothing to build']) await output(page).getByText(words).waitFor();
    await type(page, 'ros2 topic list | less');
    await output(page).getByText('less: cannot stand behind | here').waitFor();
    await type(page, 'clear');
    await type(page, 'ros2 topic echo /sine | head -n 2 && pwd');
    await page.waitForFunction(() => heard('/sine') > 0);
    await speak(page);
    await page.waitForFunction(() => heard('/sine') === 0);
    await output(page).getByText('/home/user/ros2_ws', { exact: true }).waitFor();
    assert.deepEqual((await whole()).slice(1), ['value: 0.5', 'other: 1.0', '/home/user/ros2_ws']);
    await type(page, 'clear');
    // A stream passes line by line; Ctrl-C ends all that was to follow.
    await type(page, 'ros2 topic echo /sine | grep mode && echo never');
    await page.waitForFunction(() => heard('/sine') > 0);
    await speak(page);
    await output(page).getByText('mode: idle').waitFor();
    await command(page).press('Control+c');
    await page.waitForFunction(() => heard('/sine') === 0);
    // A program with windows opens beside the terminal, which goes on with the keyboard.
    await type(page, 'rqt_graph');
    await page.locator('.panel-graph').waitFor();
    assert.ok(await command(page).isVisible());
    await page.keyboard.type('echo still here\n');
    await output(page).getByText('still here', { exact: true }).waitFor();
    await type(page, 'ros2 run rviz2 rviz2');
    await output(page).getByText('rviz2: the panel \u201c3D view\u201d of this page is open').waitFor();
    await page.locator('.panel-scene').waitFor();
    assert.ok(!(await whole()).includes('never'));
    assert.ok(!(await whole()).some((line) => line.includes('value: 0.5')));
    await page.screenshot({ path: fileURLToPath(new URL('../../output/terminal_shell.png', import.meta.url)) });
  }, /GL Driver Message/));

test('the terminal takes the keyboard when it opens, and after a click anywhere in it', () =>
  stage.on(SCENE, {}, async (page) => {
    await output(page).click();
    await page.keyboard.type('echo clicked\n');
    await output(page).getByText('clicked', { exact: true }).waitFor();
    // The output can be scrolled by keyboard; what is typed goes to the input all the same.
    await output(page).focus();
    await page.keyboard.type('echo typed\n');
    await output(page).getByText('typed', { exact: true }).waitFor();
    await page.getByRole('button', { name: 'Open a panel here' }).first().click();
    await page.getByRole('menuitem', { name: 'Terminal' }).click();
    await page.locator('#tab-panel-terminal-2 .terminal').waitFor();
    await page.waitForFunction(() => document.activeElement?.closest('#tab-panel-terminal-2 .terminal') !== null);
    await page.keyboard.type('echo second\n');
    await page.locator('#tab-panel-terminal-2').getByText('second', { exact: true }).waitFor();
  }));

test('two terminals are open at once, each with its folder and what was typed there', () =>
  stage.on(SCENE.replace('%22terminal%22', '%7B%22column%22%3A%5B%22terminal%22%2C%22terminal%22%5D%7D'), {}, async (page) => {
    const terminal = (key: string) => {
      const panel = page.locator(`#tab-panel-${key}`);
      const field = panel.getByRole('textbox', { name: 'Command' });
      const enter = async (line: string): Promise<void> => {
        await field.fill(line);
        await field.press('Enter');
        await panel.locator('.terminal-input input:not([readonly])').waitFor();
      };
      return { enter, field, panel, lines: () => panel.locator('.line').allInnerTexts() };
    };
    const [first, second] = [terminal('terminal'), terminal('terminal-2')];
    await first.enter('cd ros2_ws/src');
    await first.panel.locator('.terminal-prompt').getByText('~/ros2_ws/src$', { exact: true }).waitFor();
    await second.enter('mkdir own && cd own');
    await second.panel.locator('.terminal-prompt').getByText('~/own$', { exact: true }).waitFor();
    await first.enter('pwd');
    await second.enter('pwd');
    await first.panel.getByText('/home/user/ros2_ws/src', { exact: true }).waitFor();
    await second.panel.getByText('/home/user/own', { exact: true }).waitFor();
    await first.enter('ls ~ && history');
    await first.panel.getByText('own  ros2_ws').waitFor();
    await first.panel.getByText('3  ls ~ && history').waitFor();
    assert.ok(!(await first.lines()).some((line) => line.includes('mkdir')));
    await second.enter('history');
    await second.panel.getByText('3  history').waitFor();
    await second.field.press('ArrowUp');
    await second.field.press('ArrowUp');
    assert.equal(await second.field.inputValue(), 'pwd');
    // A command that goes on in one holds up nothing in the other.
    await speak(page);
    await first.field.fill('ros2 topic echo /sine');
    await first.field.press('Enter');
    await page.waitForFunction(() => heard('/sine') > 0);
    await second.enter('echo free');
    await second.panel.getByText('free', { exact: true }).waitFor();
    await first.field.press('Control+c');
    await page.waitForFunction(() => heard('/sine') === 0);
    // The next visit knows the lines of both.
    await page.reload();
    await first.enter('history');
    for (const line of ['mkdir own && cd own', 'cd ros2_ws/src']) await first.panel.locator('.line').getByText(line).waitFor();
    assert.equal(await first.panel.locator('.terminal-prompt').innerText(), '~$');
  }));

test('Tab completes and lets go, the arrow keys recall', () =>
  stage.on(SCENE, {}, async (page) => {
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
    await command(page).fill('ros2 topic pub /sine demo/msg/Sine ');
    await command(page).press('Tab');
    const begun = `ros2 topic pub /sine demo/msg/Sine "{value: 0.0, other: 0.0, list: [], mode: '', big: 0}" `;
    await page.waitForFunction((line) => document.querySelector<HTMLInputElement>('.terminal-input input')?.value === line, begun);
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
    // The history of typed lines is there when the page is opened again.
    await page.reload();
    await command(page).press('ArrowUp');
    assert.equal(await command(page).inputValue(), 'ros2 node list -a');
    await command(page).press('ArrowUp');
    assert.equal(await command(page).inputValue(), 'help');
  }));

test('a service is echoed by its events, and arrays stand in one line on request', () =>
  stage.on(SCENE, {}, async (page) => {
    const event = (): Promise<void> =>
      page.evaluate(() =>
        send('/add/_service_event', 'demo/srv/Add_Event', {
          info: { event_type: 1, stamp: { sec: 3, nanosec: 4 }, client_gid: new Uint8Array(16), sequence_number: 7n },
          request: [{ a: 2n, b: 3n }],
          response: [],
        })
      );
    await event();
    await type(page, 'ros2 service echo --flow-style /add demo/srv/Add');
    await page.waitForFunction(() => heard('/add/_service_event') > 0);
    await event();
    await output(page).getByText('response: []').waitFor();
    assert.deepEqual((await output(page).locator('.line').allInnerTexts()).slice(1), [
      'info:',
      '  event_type: REQUEST_RECEIVED',
      '  stamp:',
      '    sec: 3',
      '    nanosec: 4',
      `  client_gid: [${Array(16).fill('0').join(', ')}]`,
      '  sequence_number: 7',
      'request: [{a: 2, b: 3}]',
      'response: []',
      '---',
    ]);
    await command(page).press('Control+c');
    await type(page, 'ros2 service echo /nobody');
    await output(page).getByText('Could not determine the type for the passed service').waitFor();
  }));

test('what nodes say is text, whatever it is', () =>
  stage.on(SCENE, {}, async (page) => {
    await speak(page);
    await type(page, 'ros2 topic echo --field mode /sine');
    await page.waitForFunction(() => heard('/sine') > 0);
    await speak(page, { ...SINE, mode: '<img src=x onerror="document.title=1"> \u001b]0;owned\u0007 \u001b[2J <b>bold</b>' });
    await output(page).getByText('<b>bold</b>').waitFor();
    assert.equal(await page.locator('.terminal img, .terminal b').count(), 0);
  }));

test('a command ends with its panel', () =>
  stage.on(SCENE, {}, async (page) => {
    await speak(page);
    await type(page, 'ros2 topic hz /sine');
    await page.waitForFunction(() => heard('/sine') > 0);
    await page.getByRole('button', { name: /Move or close Terminal/ }).click();
    await page.getByRole('menuitem', { name: /^Close/ }).click();
    await page.waitForFunction(() => heard('/sine') === 0);
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the terminal, ${colorScheme}`, () =>
    stage.on(SCENE, { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await type(page, 'help');
      await type(page, 'less');
      await output(page).getByText('command not found').waitFor();
      await expectAccessible(page);
    }));
}

test('the terminal fits a phone', () =>
  stage.on(SCENE, { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await type(page, 'help');
    await output(page).getByText('Tab completes').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
  }));
