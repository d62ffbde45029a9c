// A stop ends a Python node wherever it waits, long before it would be killed, and it can be started again: on both links,
// in Node.js and in Chromium.

// Compatibility, works: a stop of a Python node in `rclpy.spin`, `spin_until_future_complete`, `wait_for_message`, `time.sleep`,
// `input`, `Rate.sleep`, `Client.call`, `wait_for_service`, `asyncio.run`, a publish that waits for a slow reader, `Event.wait`,
// `Thread.join`, `Queue.get`, or while it computes on the shared link

// Compatibility, differs: a Python node that computes without end, in a page without shared memory -> a stop is not heard:
// it is killed after five seconds

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { type Browser, chromium } from 'playwright-core';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import { stopGraceMs } from '../../../runtime/site/program/process_runner.ts';
import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { prints, reaches } from '../../unit/site/site_fixture.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { msToStop, typeInto } from '../support/page_nodes.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 300_000 };
/** Upper bound for a stop on a busy machine; a node that ignores the stop is killed only after stopGraceMs. */
const soonMs = stopGraceMs * 0.6;
const killed = 137;
const blockedMs = 1000;

/** Ways to wait of tests/packages/chatter_py/scripts/waits; the first, `deaf`, is the node that `publish` waits for. */
const ways = ['deaf', 'spin', 'sleep', 'ask', 'rate', 'call', 'loop', 'publish', 'event', 'join', 'get', 'service', 'future', 'message', 'compute'];
const idOf = (way: string): string => `${way}-${ways.indexOf(way) + 1}`;
const waiting = /^waits for ever$/;

/** The node that another one waits for is stopped last. Nothing reaches a worker that computes without shared memory: it is killed. */
const stoppable = (link: 'shared' | 'port'): readonly string[] => [...ways.slice(1), 'deaf'].filter((way) => way !== 'compute' || link === 'shared');

let folder = '';
let browser: Browser;

before(async () => {
  folder = makeSite([], {}, {}, {
    nodes: ways.map((way) => ({ entry: 'lib/chatter_py/waits', executable: way, arguments: [way] })),
    packages: ownPackage('chatter_py'),
  });
  browser = await chromium.launch(chromiumOptions());
});

after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

for (const link of played('port', 'shared')) {
  test(`${link}, Node.js: a stop ends each wait, and the node starts again`, watchdog, async () => {
    const { session, close } = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    try {
      /** A publish waits once nothing more is said for a while. */
      const blocked = async (): Promise<void> => {
        await prints(session, idOf('publish'), /^sent \d+$/);
        for (let seen = -1;;) {
          const { length } = session.console(idOf('publish')).lines();
          if (length === seen) return;
          seen = length;
          await new Promise((resolve) => setTimeout(resolve, blockedMs));
        }
      };
      const waits = async (way: string): Promise<void> => way === 'publish' ? blocked() : void await prints(session, idOf(way), waiting);
      for (const way of ways) {
        session.start(idOf(way));
        await waits(way);
      }
      for (const way of stoppable(link)) {
        const begun = performance.now();
        session.stop(idOf(way));
        const { state } = await reaches(session, idOf(way), 'exited');
        const took = performance.now() - begun;
        assert.ok(took < soonMs, `${way} ends after ${took} ms`);
        assert.notEqual((state as { code: number; }).code, killed, `${way} is killed`);
      }
      session.console(idOf('ask')).clear();
      session.start(idOf('ask'));
      // The question is there before its answer, though it ends no line.
      await prints(session, idOf('ask'), /^a line\? $/);
      session.sendInput(idOf('ask'), 'an answer\n');
      await prints(session, idOf('ask'), /^asked and told: an answer$/);
      assert.equal(((await reaches(session, idOf('ask'), 'exited')).state as { code: number; }).code, 0);
    } finally {
      session.close();
      close();
    }
  });
}

for (const [link, isolated] of played(['shared', true], ['port', false])) {
  test(`${link}, Chromium: input() is answered from the page, and a stop ends each wait`, watchdog, async () => {
    const host = await serveFolder(folder, { isolated });
    const context = await browser.newContext({ serviceWorkers: 'block' });
    try {
      const page = await context.newPage();
      await page.goto(host.url);
      const running = (label: string) => page.getByRole('button', { name: `Stop /${label}`, exact: true });
      const said = (text: string): Promise<unknown> => page.waitForFunction((wanted) => document.body.textContent.includes(wanted), text, { timeout: 120_000 });
      await said('a line? ');
      await typeInto(page, 'ask', 'an answer');
      await said('asked and told: an answer');
      await page.getByRole('button', { name: 'Start /ask', exact: true }).click();
      assert.equal(await page.evaluate(() => crossOriginIsolated), isolated);
      // `publish` prints nothing when its wait begins: it waits once no more of its "sent" lines come.
      await page.waitForFunction(
        (count) => document.body.textContent.split('waits for ever').length - 1 >= count,
        ways.length,
        { timeout: 120_000 },
      );
      await said('sent ');
      for (let seen = '';;) {
        // The last that was sent.
        const text = await page.evaluate(() => document.body.textContent.match(/sent \d+/g)?.at(-1) ?? '');
        if (text === seen) break;
        seen = text;
        await page.waitForTimeout(blockedMs);
      }
      for (const way of stoppable(link)) {
        const took = await msToStop(page, way);
        assert.ok(took < soonMs, `${way} ends after ${took} ms`);
      }
      assert.doesNotMatch(await page.textContent('body') ?? '', /Exited with code 137/);
      await page.getByRole('button', { name: 'Start /sleep', exact: true }).click();
      await running('sleep').waitFor();
    } finally {
      await context.close();
      await host.close();
    }
  });
}
