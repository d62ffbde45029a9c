// Site time in compiled programs: every way to wait lasts while time is held, and ends with the step that reaches it.

// Compatibility, works: time of the whole site held, stepped and run at another speed: clocks,
// wall and ROS timers, `sleep_for`, `usleep`, `nanosleep`, rates, deadlines, lifespans, leases;
// condition variables, futures and timed mutexes, of threads too

// Compatibility, works: stepped runs (`ros2wasm run --stepped --seed N --trace FILE`, and a page
// opened with `?seed=N`): every run of a seed sends the same messages at the same times, with the
// same random numbers

// Compatibility, differs: held time on a page without shared memory -> a node learns of it when it
// next waits

// Compatibility, differs: stepped runs -> on the shared link, without programs that use threads
// (R2W0711); what comes from outside (typed input, a stop) comes when it comes; a respawn
// waits in site time. A program that only reads clocks and never waits holds time

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const name = 'site_time_checks';
const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);
const waitMs = 100;
const lateMs = 4;
const ways = {
  waits: [
    'sleep_for',
    'sleep_until',
    'usleep',
    'nanosleep',
    'rclcpp::sleep_for',
    'Clock::sleep_for',
    'Rate',
    'condition_variable',
    'future',
    'wall timer',
    'ROS timer',
    'spin_until_future_complete',
    'wait_for_service',
    'deadline',
    'lifespan',
  ],
  threaded_waits: [
    "thread's sleep_for",
    'condition_variable',
    "thread's condition_variable",
    'three at once',
    'timed mutex',
    'future of a thread',
  ],
};

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.copyPackages(name);
  const dice = (parameters: string): string => `  - package: ${name}\n    executable: dice\n${parameters}`;
  const hosts = '    parameters:\n      - host: true\n';
  for (const program of [...Object.keys(ways), 'dice']) {
    const nodes = program === 'dice'
      ? `${dice(hosts)}${dice('')}${dice('')}`
      : `  - package: ${name}\n    executable: ${program}\n`;
    workspace.write(`${program}.yaml`, `schema: 1
name: checks
title: Checks
version: 1.0.0
license: Apache-2.0
distro: jazzy
packages:
  - src/*
launch:
${nodes}`);
    const packed = await workspace.run(['pack', `${program}.yaml`, '--output', program]);
    assert.equal(packed.code, 0, packed.stderr);
  }
}, { timeout: 600_000 });
after(() => workspace.close());

/** Lets real time pass, which must not end any wait. */
function realTime(milliseconds: number): Promise<void> {
  return new Promise((done) => {
    setTimeout(done, milliseconds);
  });
}

async function holdAndStep(program: keyof typeof ways, broker: SharedBroker | PortBroker): Promise<void> {
  const platform = nodePlatform(join(workspace.root, program), entry);
  const said: string[] = [];
  let heard: () => void = () => undefined;
  const session = new SiteSession({
    site: readSite(await platform.json('site.json')),
    platform,
    broker,
    onLines: (_, lines) => {
      for (const [, , text] of lines) said.push(text);
      heard();
    },
  });
  session.onNodes(() => heard());
  const until = async (line: RegExp): Promise<string> => {
    for (;;) {
      const found = said.find((text) => line.test(text));
      if (found !== undefined) return found;
      const state = session.nodes()[0]?.state;
      assert.ok(state?.kind !== 'crashed' && state?.kind !== 'exited', `${String(line)} in ${JSON.stringify([state, said])}`);
      // It gives up before the test's own limit, as the session would not be closed then, and the file would not end.
      let limit: NodeJS.Timeout | undefined;
      await new Promise<void>((resolveHeard, reject) => {
        heard = resolveHeard;
        limit = setTimeout(() => reject(new Error(`${String(line)} was not said within a minute: ${JSON.stringify([state, said])}`)), 60_000);
      });
      clearTimeout(limit);
    }
  };
  try {
    session.time.pause();
    session.startAll();
    // How far the time goes on after the end of a wait, in ms.
    let ahead = 0;
    for (const way of ways[program]) {
      await until(new RegExp(`^${way} begins`));
      await realTime(1.5 * waitMs);
      session.time.step((0.5 * waitMs - ahead) * 1e6);
      await realTime(1.5 * waitMs);
      assert.deepEqual(said.filter((text) => text.startsWith(`${way} ends`)), [], 'too early');
      // The C library rounds the end of a wait, so that it may come a few milliseconds later. The rest counts for the next wait.
      session.time.step((0.5 * waitMs + lateMs) * 1e6);
      const passed = Number(/([\d.]+) ms$/.exec(await until(new RegExp(`^${way} ends after`)))?.[1]);
      assert.ok(passed >= waitMs && passed <= waitMs + 2 * lateMs, `${way} took ${passed} ms`);
      ahead = waitMs + lateMs - passed;
    }
    assert.deepEqual(said.filter((text) => !/ (begins|ends after [\d.]+ ms)$/.test(text)), []);
  } finally {
    session.close();
    platform.close();
  }
}

/** A stepped run of 5 s of site time: its messages and their hash. */
async function steppedRun(seed: number): Promise<{ sent: string; hash: string; }> {
  const file = join(workspace.root, `sent_${seed}.jsonl`);
  const ran = await workspace.run(['run', 'dice', '--stepped', '--seed', String(seed), '--for', '5s', '--trace', file]);
  assert.equal(ran.code, 0, ran.stderr);
  const hash = /^trace: (\d+ messages, sha256 [0-9a-f]{64})$/m.exec(ran.stderr)?.[1] ?? ran.stderr;
  return { sent: readFileSync(file, 'utf8'), hash };
}

const watchdog = { timeout: 240_000 };

test('every wait of a program without threads follows held time on the shared link', watchdog,
  () => holdAndStep('waits', new SharedBroker({ ceiling: 256 << 20 })));
test('every wait of a program without threads follows held time on the port link', watchdog, () => holdAndStep('waits', new PortBroker()));
test('every wait of threads follows held time', watchdog, () => holdAndStep('threaded_waits', new SharedBroker({ ceiling: 256 << 20 })));

test('two stepped runs of a seed send the same messages, another seed others', watchdog, async () => {
  const [first, again, other] = [await steppedRun(7), await steppedRun(7), await steppedRun(8)];
  assert.equal(again.sent, first.sent);
  assert.equal(again.hash, first.hash);
  assert.notEqual(other.hash, first.hash);
  // The site did what it is there for: three nodes threw some hundred times, and each throw was summed by each.
  const messages = first.sent.trimEnd().split('\n').map((line) => JSON.parse(line) as { node: string; name: string; stamp: string; });
  const thrown = messages.filter((message) => message.name === '/thrown');
  assert.equal(new Set(thrown.map(({ node }) => node)).size, 3);
  assert.ok(thrown.length > 300, `${thrown.length} throws`);
  const sums = messages.filter((message) => message.name === '/sums').length;
  assert.ok(Math.abs(sums - 3 * thrown.length) < 10, `${sums} sums of ${thrown.length} throws`);
  const last = Number(BigInt(messages.at(-1)?.stamp ?? 0) - BigInt(messages[0]?.stamp ?? 0)) / 1e9;
  assert.ok(last > 4.8 && last <= 5, `${last} s`);
});

test('a page with a seed goes in steps, and has then sent what a headless run sends', watchdog, async () => {
  const { hash } = await steppedRun(7);
  const expected = hash.replace(/^.* /, '');
  const server = await serveFolder(join(workspace.root, 'dice'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    await page.goto(server.url);
    await page.getByText('Repeatable run').click();
    await page.getByRole('textbox', { name: 'Seed' }).fill('7');
    await page.getByRole('button', { name: 'Restart with this seed' }).click();
    await page.waitForURL((url) => url.search === '?seed=7');
    await page.selectOption('select[aria-label="Length of a step"]', '1000');
    const held = page.locator('.time[data-state=paused]');
    for (let second = 0; second < 5; second += 1) {
      await held.waitFor();
      await page.click('button[aria-label^="Let time run for"]');
    }
    await held.waitFor();
    const seen = page.locator('.time [data-sha256]');
    await page.waitForFunction((wanted) => document.querySelector('.time [data-sha256]')?.getAttribute('data-sha256') === wanted, expected)
      .catch(async () => assert.equal(await seen.getAttribute('data-sha256'), expected));
    assert.match(await seen.innerText(), /^Seed 7: \d+ messages, sha256 [0-9a-f]{8}…$/);

    await page.goto(`${server.url}?seed=seven`);
    await page.getByText('R2W0711').first().waitFor();
  } finally {
    await browser.close();
    await server.close();
  }
});

test('a program with threads is refused in a stepped run', watchdog, async () => {
  const ran = await workspace.run(['run', 'threaded_waits', '--stepped']);
  assert.equal(ran.code, 1);
  assert.match(ran.stderr, /error\[R2W0711\]: the program uses threads/);
});
