// Python nodes in a browser that shares memory and cannot suspend a program (no JavaScript Promise Integration), as
// WebKit is: here Chromium, in whose page and workers it is deleted.

// Compatibility, works: Python nodes in a browser without JavaScript Promise Integration, on a page with shared memory:
// topics, services, actions, `input()`, timers, rates, asyncio, waits with a timeout, calls within callbacks of a
// `MultiThreadedExecutor`; a stop ends each wait

// Compatibility, differs: `threading.Thread` in a browser without JavaScript Promise Integration -> `start` raises
// RuntimeError (R2W0714); a `MultiThreadedExecutor` has one thread there, in which callbacks of other groups run while
// one waits for a service or an action, not while one sleeps

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { stopGraceMs } from '../../../runtime/site/program/process_runner.ts';
import { serveFolder } from '../../support/static_server.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { msToStop, typeInto } from '../support/page_nodes.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
/** Upper bound for a stop on a busy machine; a node that ignores the stop is killed only after stopGraceMs. */
const soonMs = stopGraceMs * 0.6;
const ways = ['spin', 'sleep', 'ask', 'call', 'loop', 'event', 'get', 'compute'];

let folder = '';
let browser: Browser;

before(async () => {
  folder = makeSite([], {}, {}, {
    nodes: [
      { entry: 'chatter_py.count:main', executable: 'count' },
      { entry: 'chatter_py.hear:main', executable: 'hear', arguments: ['--ros-args', '-r', '__node:=ears'] },
      { entry: 'lib/chatter_py/alone', executable: 'alone' },
      ...ways.map((way) => ({ entry: 'lib/chatter_py/waits', executable: way, arguments: [way] })),
    ],
    packages: ownPackage('chatter_py'),
  });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser?.close();
  if (folder !== '') rmSync(folder, { recursive: true });
});

/** The output of tests/packages/chatter_py/scripts/alone, in this order. */
const refused = "refused: error[R2W0714]: can't start new thread: this browser cannot suspend a program. Give the work to a timer, to a "
  + 'callback group of a MultiThreadedExecutor, or to a node of its own';
const wanted = [
  'a callback calls 5',
  'whose service calls another 10',
  'a goal [0, 1, 2]',
  'a rate in a callback True',
  'other timers beat',
  refused,
  refused,
  "asyncio ['slept', 'in time']",
  'waits end in time [True, False, False, True]',
  'alone is done',
];

test('without promise integration Python nodes talk, read, call each other and stop', watchdog, async () => {
  const host = await serveFolder(folder, { isolated: true });
  const context = await browser.newContext({ serviceWorkers: 'block' });
  try {
    await context.addInitScript(() => {
      const names = ['Suspending', 'promising', 'SuspendError', 'Suspender', 'Function'];
      for (const name of names) Reflect.deleteProperty(WebAssembly, name);
      const without = `for (const name of ${JSON.stringify(names)}) delete WebAssembly[name];
console.log('a worker can suspend: ' + ('Suspending' in WebAssembly || 'promising' in WebAssembly));\n`;
      const { Blob: Plain } = globalThis;
      // Workers are started from blobs of their script.
      globalThis.Blob = class extends Plain {
        constructor(parts: readonly BlobPart[] = [], options?: BlobPropertyBag) {
          super(options?.type === 'text/javascript' ? [without, ...parts] : [...parts], options);
        }
      };
    });
    const page = await context.newPage();
    const told = new Set<string>();
    page.on('console', (message) => told.add(message.text()));
    await page.goto(host.url);
    /** The lines of a node. */
    const lines = (label: string): Promise<readonly string[]> =>
      page.evaluate((heading) => {
        const text = document.body.innerText;
        const console = text.slice(text.indexOf('Each node'));
        return console.slice(console.indexOf(`\n${heading}\n`)).split('\n').slice(3);
      }, label);
    const said = (text: string): Promise<unknown> => page.waitForFunction((words) => document.body.textContent.includes(words), text, { timeout: 120_000 });
    await page.waitForFunction(() => /\[ears\]: heard <Python counts \d+>/.test(document.body.textContent), null, { timeout: 120_000 });
    assert.equal(await page.evaluate(() => crossOriginIsolated), true);
    assert.deepEqual([...told].filter((text) => text.startsWith('a worker')), ['a worker can suspend: false']);
    await said('a line? ');
    await typeInto(page, 'ask', 'an answer');
    await said('asked and told: an answer');
    await page.getByRole('button', { name: 'Start /ask', exact: true }).click();
    await said('alone is done');
    assert.deepEqual((await lines('/alone')).slice(0, wanted.length), wanted);
    // The second run of /ask is the last to wait.
    await page.waitForFunction(
      (count) => document.body.textContent.split('waits for ever').length - 1 > count && document.body.textContent.split('a line? ').length === 3,
      ways.length,
      { timeout: 120_000 },
    );
    for (const way of [...ways, 'hear']) {
      const took = await msToStop(page, way);
      assert.ok(took < soonMs, `${way} ends after ${took} ms`);
    }
    const text = await page.textContent('body') ?? '';
    assert.doesNotMatch(text, /Exited with code 137/);
    for (const way of ways) assert.ok(text.includes(`stopped in ${way}`), way);
  } finally {
    await context.close();
    await host.close();
  }
});
