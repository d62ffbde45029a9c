// Python nodes in Firefox, on both links: what is typed reaches input(), threads run side by side, a stop ends each wait, a
// node starts again, and on a second visit interpreters begin with the image that was kept.

// Compatibility, works: Firefox (Debian's), on both links: `input()`, threads and stops of Python nodes, a start after a stop, and
// the kept image of an interpreter on a second visit

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { stopGraceMs } from '../../../runtime/site/program/process_runner.ts';
import { Firefox } from '../../support/firefox.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { serveFolder } from '../../support/static_server.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 300_000 };
const patienceMs = 100_000;
/** Upper bound for a stop on a busy machine; a node that ignores the stop is killed only after stopGraceMs. */
const soonMs = stopGraceMs * 0.6;
const ways = ['spin', 'sleep', 'ask'];

let folder = '';
before(() => {
  folder = makeSite([], {}, {}, {
    nodes: [
      ...ways.map((way) => ({ entry: 'lib/chatter_py/waits', executable: way, arguments: [way] })),
      { entry: 'lib/chatter_py/threads', executable: 'threads' },
      { entry: 'lib/chatter_py/fresh', executable: 'fresh', arguments: ['one'] },
    ],
    packages: ownPackage('chatter_py'),
  });
});
after(() => rmSync(folder, { recursive: true }));

/** In the page: until an expression holds. */
const until = (expression: string): string =>
  `new Promise((resolve) => {
  const look = () => (${expression}) ? resolve(true) : setTimeout(look, 20);
  look();
})`;
const button = (label: string): string => `document.querySelector('button[aria-label="${label}"]')`;
const textbox = `document.querySelector('[aria-label="Standard input of /ask"]')`;

async function press(firefox: Firefox, label: string): Promise<void> {
  await firefox.evaluate(until(`${button(label)} !== null`));
  await firefox.evaluate(`${button(label)}.click()`);
}

for (const [link, isolated] of played(['shared', true], ['port', false])) {
  test(`Firefox, ${link}: Python nodes read, have threads, stop, start again, and begin with a kept image`, watchdog, async () => {
    const host = await serveFolder(folder, { isolated });
    const firefox = await Firefox.launch({ serviceWorkers: false });
    try {
      await firefox.goto(host.url);
      assert.equal(await firefox.evaluate('crossOriginIsolated'), isolated);
      await firefox.seen(/slept side by side True True[^]*both compute True[^]*the last thread ends the program/, patienceMs);

      await firefox.seen(/a line\? /, patienceMs);
      await press(firefox, 'Type into /ask');
      await firefox.evaluate(until(`${textbox} !== null`));
      await firefox.evaluate(`${textbox}.value = 'an answer', ${textbox}.dispatchEvent(new Event('input', { bubbles: true }))`);
      // The page takes the typed text at its next drawing.
      await firefox.evaluate(`new Promise((resolve) => setTimeout(resolve)).then(() => ${textbox}.form.requestSubmit())`);
      await firefox.seen(/asked and told: an answer/, patienceMs);
      await press(firefox, 'Start /ask');
      await firefox.seen(/asked and told: an answer[^]*a line\? /, patienceMs);

      await firefox.seen(new RegExp(ways.map(() => 'waits for ever').join('[^]*')), patienceMs);
      for (const way of ways) {
        const took = Number(await firefox.evaluate(`(async () => {
          const begun = performance.now();
          ${button(`Stop /${way}`)}.click();
          await ${until(`${button(`Start /${way}`)} !== null`)};
          return performance.now() - begun;
        })()`));
        assert.ok(took < soonMs, `${way} ends after ${took} ms`);
      }
      await firefox.seen(/stopped in spin[^]*stopped in sleep[^]*stopped in ask/, patienceMs);
      await press(firefox, 'Start /sleep');
      await firefox.seen(/stopped in sleep[^]*waits for ever/, patienceMs);

      // The image is kept as soon as it is made.
      await firefox.evaluate(`(async () => {
        while ((await (await caches.open('ros2wasm-kept')).keys()).length === 0) await new Promise((resolve) => setTimeout(resolve, 50));
      })()`);
      await firefox.goto(`${host.url}?again`);
      await firefox.seen(/fresh \{"image": true/, patienceMs);
      // Bytes that are not those of the image that was kept are dropped, and the image is made anew.
      await firefox.evaluate(`(async () => {
        const cache = await caches.open('ros2wasm-kept');
        for (const key of await cache.keys()) await cache.put(key, new Response('broken'));
      })()`);
      await firefox.goto(`${host.url}?broken`);
      await firefox.seen(/fresh \{"image": true/, patienceMs);
      await firefox.evaluate(`(async () => {
        const cache = await caches.open('ros2wasm-kept');
        const sizes = async () => Promise.all((await cache.keys()).map(async (key) => (await (await cache.match(key)).blob()).size));
        while (!(await sizes()).some((size) => size > 1e6)) await new Promise((resolve) => setTimeout(resolve, 50));
      })()`);
    } finally {
      await firefox.close();
      await host.close();
    }
  });
}
