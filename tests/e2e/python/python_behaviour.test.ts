// Parts of rclpy that few nodes use, on both links, in Node.js and in Chromium: rates, options of loggers, information about messages,
// jumps of time, the graph, type descriptions, overridden QoS, calls within callbacks, guard conditions, waitables, queued goals.

// Compatibility, works: rates, options of loggers, callbacks with message info, jump callbacks, the graph's queries, type
// descriptions, overridden QoS, `Client.call` in a callback, guard conditions, own waitables and queued goals of rclpy

// Compatibility, works: `asyncio` in Python nodes: tasks and groups of them, queues, timeouts, `to_thread`, `run_in_executor` and
// `call_soon_threadsafe`, in turns with rclpy and beside threads that spin

// Compatibility, differs: sockets and child processes of `asyncio` -> NotImplementedError or OSError, as browsers have none; its loop
// waits for what a node waits for

// Compatibility, differs: a `MultiThreadedExecutor` without a number of threads -> has four, whatever processor the visitor has

import assert from 'node:assert/strict';
import { readFileSync, rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { serveFolder } from '../../support/static_server.ts';
import { prints, reaches } from '../../unit/site/site_fixture.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
let folder = '';

before(() => {
  folder = makeSite([], {}, {}, {
    nodes: [{ entry: 'lib/chatter_py/behaviour', executable: 'behaviour' }],
    packages: ownPackage('chatter_py'),
  });
});

after(() => rmSync(folder, { recursive: true }));

/** The output of tests/packages/chatter_py/scripts/behaviour, in this order. */
const wanted = [
  'ten beats at 50 Hz True',
  'a destroyed rate: Rate cannot sleep because it has been destroyed',
  'once [True, False, False]',
  'skip_first [False, True, True]',
  'throttled [True, False, False]',
  'throttled for a moment [True, True, True]',
  'no such option: parameter "colour" is not supported',
  "infos [(7, 1), (8, 2)] ['publication_sequence_number', 'received_timestamp', 'reception_sequence_number', 'source_timestamp']",
  'in order of time True',
  'a step is not a jump []',
  "jumps ['before', ('ROS_TIME_NO_CHANGE', 8), 'before', ('ROS_TIME_NO_CHANGE', -60)]",
  'told no more 4',
  'waits True True False',
  'nodes True True True',
  "topics [('/lab/words', ['std_msgs/msg/String'])]",
  "services [('/lab/add', ['example_interfaces/srv/AddTwoInts'])]",
  'counts 1 1 0 1 1',
  'publisher graphs /lab std_msgs/msg/String PUBLISHER BEST_EFFORT TRANSIENT_LOCAL 16',
  'subscription SUBSCRIPTION BEST_EFFORT',
  "by node ['/lab/words'] [('/lab/add', ['example_interfaces/srv/AddTwoInts'])]",
  'of a node that is not there: NodeNameNonExistentError',
  "described True std_msgs/msg/String ['data'] True",
  'a bad hash: Failed to parse type hash',
  'overridden 7 BEST_EFFORT keep_last',
  'a call in the main thread 42',
  'a call in a callback [3]',
  "a guard condition ['called']",
  "a waitable [] ['data'] NumberOfEntities(0, 1, 2, 0, 0, 0)",
  "queued goals [('begin', 3), ('end', 3), ('begin', 1), ('end', 1), ('begin', 2), ('end', 2)] [[3], [1], [2]]",
  'callbacks at once 4',
  'asyncio a word asyncio_0 3 [0, 1, 2]',
  'in time',
  'no sockets, no processes NotImplementedError OSError',
  'that is all',
];

function check(texts: readonly string[], end: unknown): void {
  const logged = texts.filter((text) => text.startsWith('['));
  assert.deepEqual(texts.filter((text) => !logged.includes(text)), wanted, JSON.stringify(end));
  const times = (text: string): number => logged.filter((line) => line.endsWith(`[logs]: ${text}`)).length;
  assert.deepEqual(
    ['tells once', 'skips the first', 'is throttled', 'is throttled for a moment'].map(times),
    [1, 2, 1, 3],
  );
}

for (const link of played('shared', 'port')) {
  test(`${link}: seldom used parts of rclpy do what they do natively`, watchdog, async () => {
    const { session, close } = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    try {
      session.start('behaviour-1');
      const end = await Promise.race([prints(session, 'behaviour-1', /^that is all$/), reaches(session, 'behaviour-1', 'exited')]);
      check(session.console('behaviour-1').lines().map(({ text }) => text), end);
    } finally {
      session.close();
      close();
    }
  });
}

test('and so they do in Chromium, on both links', watchdog, async () => {
  const browser = await chromium.launch(chromiumOptions());
  try {
    for (const isolated of [true, false]) {
      const host = await serveFolder(folder, { isolated });
      const context = await browser.newContext({ serviceWorkers: 'block' });
      try {
        const page = await context.newPage();
        await page.goto(host.url);
        assert.equal(await page.evaluate(() => crossOriginIsolated), isolated);
        const end = await page.getByText(/^(Finished, code|Exited with code|Crashed)/).first().innerText({ timeout: 120_000 });
        const [saved] = await Promise.all([
          page.waitForEvent('download'),
          page.getByRole('button', { name: 'Save the console of /behaviour', exact: true }).click(),
        ]);
        check(readFileSync(await saved.path(), 'utf8').trimEnd().split('\n'), [isolated, end]);
      } finally {
        await context.close();
        await host.close();
      }
    }
  } finally {
    await browser.close();
  }
});
