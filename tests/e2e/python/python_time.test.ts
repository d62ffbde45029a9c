// Site time in Python programs: every way to wait lasts while time is held, ends with the step that reaches its time,
// and is over sooner when time goes faster.

// Compatibility, works: time of the site held, stepped and run at another speed in Python nodes: clocks of `time`,
// `datetime` and rclpy, `time.sleep`, timers, rates, `Event.wait`, `Condition.wait`, `Lock.acquire` and `Queue.get` with a
// timeout, `select`, `asyncio`, deadlines, waits for services, servers and messages, sleeps of threads

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { type HeadlessSite, openHeadless } from '../../../runtime/site/session/headless_session.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { prints, reaches } from '../../unit/site/site_fixture.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
const waitMs = 100;
const longS = 100;
/** Duration of a callback of the script `answers`. */
const answerMs = 20;
/** How much faster time goes for the long ones. */
const speed = 1000;
/** In the order of tests/packages/chatter_py/scripts/passes. */
const ways = [
  'time.sleep',
  'Event.wait',
  'Condition.wait',
  'Lock.acquire',
  'Queue.get',
  'select',
  'Clock.sleep_for',
  'Clock.sleep_until',
  'timer',
  'spin_until_future_complete',
  'deadline',
  'wait_for_service',
  'wait_for_server',
  'wait_for_message',
  'asyncio.sleep',
  'asyncio.wait_for',
  'call_later',
  "thread's sleep",
  "thread's Event.wait",
  'three at once',
  'threading.Timer',
  'future of a pool',
  'timer of several threads',
  'rate beside a spinning thread',
];

let folder = '';
before(() => {
  const entry = 'lib/chatter_py/passes';
  folder = makeSite([], {}, {}, {
    nodes: [{ entry, executable: 'passes' }, { entry, executable: 'long', arguments: [String(longS)] }, {
      entry: 'lib/chatter_py/answers',
      executable: 'serve',
      arguments: ['serve'],
    }, { entry: 'lib/chatter_py/answers', executable: 'ask', arguments: ['ask'] }],
    packages: ownPackage('chatter_py'),
  });
});
after(() => rmSync(folder, { recursive: true }));

/** Milliseconds of real time, more than a node takes to report its end. */
const lateMs = 3000;

/** Lets real time pass, which must not end any wait. */
function realTime(milliseconds: number): Promise<void> {
  return new Promise((done) => {
    setTimeout(done, milliseconds);
  });
}

const starting = (text: string): RegExp => new RegExp(`^${text.replaceAll('.', '\\.')}`);

/** Waits for a line; the node's end without it is an error with all that it said. */
function line({ session }: HeadlessSite, id: string, text: string): Promise<string> {
  const ended = async (): Promise<string> => {
    const { state } = await Promise.race([reaches(session, id, 'exited'), reaches(session, id, 'crashed')]);
    const texts = session.console(id).lines().map((each) => each.text);
    // Its last lines come with its end.
    const found = texts.find((each) => starting(text).test(each));
    if (found === undefined) throw new Error(`no "${text}": ${JSON.stringify([state, texts])}`);
    return found;
  };
  return Promise.race([prints(session, id, starting(text)), ended()]);
}

/** As many answers have come. */
function answered({ session }: HeadlessSite): number {
  return session.console('ask-4').lines().filter(({ text }) => text.endsWith(' answered')).length;
}

const only = / (begins|ends after [\d.]+ ms)$|^passed$/;

for (const link of played('shared', 'port')) {
  test(`${link}: every wait of a Python program follows held time`, watchdog, async () => {
    const site = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    const { session } = site;
    const texts = (): readonly string[] => session.console('passes-1').lines().map(({ text }) => text);
    try {
      session.time.pause();
      session.start('passes-1');
      for (const way of ways) {
        await line(site, 'passes-1', `${way} begins`);
        await realTime(1.5 * waitMs);
        session.time.step(0.5 * waitMs * 1e6);
        await realTime(1.5 * waitMs);
        assert.deepEqual(texts().filter((text) => text.startsWith(`${way} ends`)), [], 'too early');
        // Time that is stepped beyond the end of this wait counts for the next one: it must stay below the first half.
        session.time.step((0.5 * waitMs + 1) * 1e6);
        const end = line(site, 'passes-1', `${way} ends after`);
        // On a busy machine a node may begin to wait after the first step: it waits that much longer.
        while (await Promise.race([end.then(() => false), realTime(lateMs).then(() => true)])) session.time.step(0.05 * waitMs * 1e6);
        const passed = Number(/([\d.]+) ms$/.exec(await end)?.[1]);
        assert.ok(passed >= waitMs && passed <= 1.1 * waitMs, `${way} took ${passed} ms`);
      }
      await line(site, 'passes-1', 'passed');
      assert.deepEqual(texts().filter((text) => !only.test(text)), []);
    } finally {
      site.close();
    }
  });

  test(`${link}: long waits are over in a moment when time goes a thousand times as fast`, watchdog, async () => {
    const site = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    const { session } = site;
    try {
      session.start('long-2');
      await line(site, 'long-2', 'time.sleep begins');
      // It sleeps by now, at the usual speed: over in time only if it learns of the change.
      session.time.setRate(speed);
      await line(site, 'long-2', 'passed');
      for (const way of ways) {
        const passed = Number(/([\d.]+) ms$/.exec(await line(site, 'long-2', `${way} ends after`))?.[1]);
        // A moment of this machine is many seconds: how much longer it takes says nothing.
        assert.ok(passed >= longS * 1000, `${way} took ${passed} ms`);
      }
    } finally {
      site.close();
    }
  });

  test(`${link}: requests that are in flight while time is held, goes in steps and runs again get one answer each`, watchdog, async () => {
    const site = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    const { session } = site;
    try {
      session.start('serve-3');
      session.start('ask-4');
      await line(site, 'ask-4', '3 answered');
      session.time.pause();
      // One more may have been ready. The others wait in the server, whose callback sleeps by held time.
      await realTime(10 * answerMs);
      const held = answered(site);
      await realTime(10 * answerMs);
      assert.equal(answered(site), held, 'no request is answered while time is held');
      for (let step = 0; step < 20; step += 1) {
        session.time.step(0.5 * answerMs * 1e6);
        if (step % 5 === 0) {
          session.time.resume();
          session.time.pause();
        }
        await realTime(answerMs);
      }
      const stepped = answered(site);
      assert.ok(stepped > held && stepped < 60, `${stepped} answers after steps, ${held} before`);
      session.time.setRate(10);
      session.time.resume();
      await line(site, 'ask-4', 'each once');
    } finally {
      site.close();
    }
  });
}
