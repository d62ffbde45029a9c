// Unchanged Python nodes in a site, beside each other and beside compiled ones: on both links, in Node.js and in
// Chromium under the page's policy.

// Compatibility, works: threads of Python nodes on both links: `threading` with locks, conditions, events, local data and timers,
// `queue`, pools of `concurrent.futures`, beside executors that spin; a program ends with its last thread

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { rmSync } from 'node:fs';
import { createInterface } from 'node:readline';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { makeSite } from '../support/runtime_site.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { serveFolder } from '../../support/static_server.ts';

const watchdog = { timeout: 240_000 };
const headless = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
let folder = '';
let browser: Browser | undefined;

before(async () => {
  // Compiled: talker-1, listener-2; Python: count-3, hear-4, threads-5, errands-6, life-7, cloud-8, busy-9, drive-10.
  const share = {
    'share/test_share/words.txt': 'words of a package',
    'share/ament_index/resource_index/packages/test_share': '',
  };
  folder = makeSite([{ program: 'talker.c' }, { program: 'listener.c' }], share, {}, {
    nodes: [
      { entry: 'chatter_py.count:main', executable: 'count' },
      { entry: 'chatter_py.hear:main', executable: 'hear', arguments: ['--ros-args', '-r', '__node:=ears'] },
      { entry: 'lib/chatter_py/threads', executable: 'threads' },
      { entry: 'chatter_py.errands:main', executable: 'errands' },
      { entry: 'chatter_py.life:main', executable: 'life' },
      { entry: 'lib/chatter_py/cloud', executable: 'cloud', numpy: true },
      { entry: 'chatter_py.busy:main', executable: 'busy' },
      { entry: 'chatter_py.drive:main', executable: 'drive' },
    ],
    packages: ownPackage('chatter_py'),
  });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser?.close();
  if (folder !== '') rmSync(folder, { recursive: true });
});

/** Lines that must come, whatever comes between them. */
const wanted: Readonly<Record<string, RegExp>> = {
  'Python hears Python': /^\[hear-4\] \[INFO\] \[\d+\.\d{9}\] \[ears\]: heard <Python counts \d+>$/,
  'Python hears the compiled one': /^\[hear-4\] .*heard <Hello World: \d+>$/,
  'threads sleep side by side': /^\[threads-5\] slept side by side True True$/,
  'threads wait for each other': /^\[threads-5\] a queue hands over \[\('taker', 1\), \('taker', 2\), \('taker', 3\)\]$/,
  'threads that only compute let each other go on': /^\[threads-5\] both compute True$/,
  'a pool of threads': /^\[threads-5\] a pool maps \[0, 1, 4, 9, 16\]$/,
  'conditions, and data of one thread': /^\[threads-5\] a condition is told True \[False\]$/,
  'a traceback of a thread': /^\[threads-5\] LookupError: nothing here$/,
  'a script sleeps and reads the clocks': /^\[threads-5\] slept True True$/,
  'the program ends with its last thread': /^\[threads-5\] the last thread ends the program$/,
  'a goal is rejected': /^\[errands-6\] rejected True$/,
  'a goal is deferred, tells how far it is, and succeeds': /^\[errands-6\] done 4 \[0, 1, 1, 2, 3\] \[3, 4, 5\]$/,
  'a goal is cancelled while it sleeps': /^\[errands-6\] cancelled 1 5$/,
  'a node is configured, activated, deactivated, and its error handled':
    /^\[life-7\] managed \[True, False, True, True, False\] \['shines'\] \['white', 'red'\]$/,
  'its transitions are published': /^\[life-7\] states configuring inactive activating active deactivating inactive cleaningup errorprocessing unconfigured$/,
  'calls of a service are told': /^\[life-7\] calls \[\(0, 1\), \(3, 0\)\]$/,
  'messages become bytes and come back': /^\[life-7\] bytes bytes$/,
  'one message is waited for': /^\[life-7\] waited True$/,
  'a message does not come': /^\[life-7\] nothing \(False, None\)$/,
  'asyncio and rclpy take turns': /^\[life-7\] asyncio slept spun$/,
  'share files of the site': /^\[life-7\] share words of a package$/,
  'the index knows what there is, and a home': /^\[life-7\] index package 'no_such_package' not found \/home\/user$/,
  'point clouds are arrays, and arrays point clouds':
    /^\[cloud-8\] 2 x 1, step 12; \[0\.0, 4\.0\]; Point\(x=np\.float32\(3\.0\), .*\); \[\[1\.0\], \[4\.0\]\]$/,
  'a cloud may be of no points': /^\[cloud-8\] no points 0 1 12 \(0,\)$/,
  'messages come while a thread computes': /^\[busy-9\] heard True while a thread computes True$/,
  'messages come while a loop of asyncio never rests': /^\[busy-9\] awaited True in a loop that never rests$/,
  'an executor and its threads end': /^\[errands-6\] errands are done$/,
  'the compiled one hears Python': /^\[listener-2\] I heard: \[Python counts \d+\]/,
};

/** These end by themselves; the others run until they are stopped. */
const ending = ['threads-5', 'errands-6', 'life-7', 'cloud-8'];

for (const link of played('port', 'shared')) {
  test(`${link}, Node.js: Python and compiled nodes hear each other, and a stop ends them`, watchdog, async () => {
    const child = spawn(process.execPath, [headless, folder, '--link', link], { stdio: ['ignore', 'pipe', 'pipe'] });
    const missing = new Set([...Object.keys(wanted), ...ending.map((node) => `the end of ${node}`)]);
    const said: string[] = [];
    let err = '';
    const found = (what: string): void => {
      if (missing.delete(what) && missing.size === 0) child.kill('SIGINT');
    };
    child.stderr.on('data', (bytes: Buffer) => {
      err += bytes.toString();
      for (const node of ending) if (err.includes(`[${node}] process has`)) found(`the end of ${node}`);
    });
    createInterface({ input: child.stdout }).on('line', (line) => {
      if (line.startsWith('[hear-4]')) said.push(line);
      for (const what of missing) if (wanted[what]?.test(line) === true) found(what);
    });
    // Before the watchdog, which would not say what is missing.
    const late = setTimeout(() => child.kill('SIGKILL'), watchdog.timeout - 20_000);
    const code = await new Promise((resolve) => child.on('close', resolve));
    clearTimeout(late);
    assert.deepEqual([...missing], [], err);
    assert.equal(code, 130, err);
    // As natively: KeyboardInterrupt comes out of spin, and who caught it ends well.
    assert.equal(said.at(-1), '[hear-4] stopped by hand, something heard', said.slice(-30).join('\n'));
    for (const node of ['count-3', 'hear-4', 'busy-9', ...ending]) assert.match(err, new RegExp(`\\[${node}\\] process has finished cleanly`));
  });
}

for (const [link, isolated] of played(['shared', true], ['port', false])) {
  test(`${link}, Chromium: Python nodes run under the page's policy`, watchdog, async () => {
    assert.ok(browser);
    const host = await serveFolder(folder, { isolated });
    const context = await browser.newContext({ serviceWorkers: 'block' });
    try {
      const page = await context.newPage();
      await page.goto(host.url);
      await page.waitForFunction(
        () => /\[ears\]: heard <Python counts \d+>/.test(document.body?.textContent ?? ''),
        null,
        { timeout: 200_000 },
      );
      assert.equal(await page.evaluate(() => crossOriginIsolated), isolated);
      // Threads suspend each other here too.
      await page.waitForFunction(
        () => ['the last thread ends the program', 'errands are done'].every((line) => document.body?.textContent?.includes(line)),
        null,
        { timeout: 200_000 },
      );
      const field = page.getByRole('textbox', { name: 'Standard input of /drive' });
      const takes = (what: string) =>
        page.waitForFunction((hint) => document.querySelector<HTMLInputElement>('[aria-label="Standard input of /drive"]')?.placeholder.startsWith(hint), what,
          { timeout: 200_000 });
      // The node reads keys: each goes at once.
      await takes('Keys go to the node');
      for (
        const [key, answer] of [['i', 'drives 1.0 0.0'], ['x', "stands for 'x'"], ['Enter', "stands for '\\r'"], ['ArrowLeft', "stands for 'D'"], ['Control+c',
          "stands for '\\x03'"], ['j', 'drives 0.0 1.0']] as const
      ) {
        await field.press(key);
        await page.waitForFunction((said) => document.body?.textContent?.includes(said), answer, { timeout: 200_000 });
      }
      await field.press('q');
      // And then a line.
      await takes('Type a line');
      await field.fill('home');
      await field.press('Enter');
      await page.waitForFunction(() => document.body?.textContent?.includes('driven home'), null, { timeout: 200_000 });
      // Compiled once by the page: no worker asks for it again.
      assert.equal(host.requests.filter((path) => path.endsWith('pyodide.asm.wasm')).length, 1);
    } finally {
      await context.close();
      await host.close();
    }
  });
}
