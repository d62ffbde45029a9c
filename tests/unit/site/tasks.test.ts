// The tasks of a site: nothing passes before the student acts, what an act is, and that everything is seen anew from then on.

// Compatibility, works: `tasks:` of a manifest: checks that pass only after the student's first act, hints and solutions

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { actingSession } from '../../../runtime/site/checks/acting_session.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import type { SiteTasks, TaskView } from '../../../runtime/site/contract/site_tasks.ts';
import { runTasks } from '../../../runtime/site/checks/task_run.ts';
import { withSession } from './site_fixture.ts';

const watchdog = { timeout: 240_000 };
/** A std_msgs/msg/String that says "hi", in CDR. */
const hi = Uint8Array.of(0, 1, 0, 0, 3, 0, 0, 0, 104, 105, 0);

const tasks = [
  {
    title: 'Listen',
    text: 'To **it**.',
    hint: 'Wait.',
    checks: [
      { kind: 'rate', topic: '/chatter' },
      { kind: 'state', node: 'talker-1', state: 'running' },
    ],
  },
  { title: 'Speak', solution: '`ros2`', checks: [{ kind: 'message', topic: '/student', field: 'data', equals: 'hi', title: 'You are heard' }] },
];

function until(run: SiteTasks, done: (views: readonly TaskView[]) => boolean): Promise<void> {
  return new Promise((resolve) => {
    if (done(run.views())) {
      resolve();
      return;
    }
    const off = run.onChange((views) => {
      if (!done(views)) return;
      off();
      resolve();
    });
  });
}

const states = (run: SiteTasks): string[][] => run.views().map(({ checks }) => checks.map(({ state }) => state));

for (const link of ['shared', 'port'] as const) {
  test(`${link}: what holds by itself is not passed until the student acts, and is then seen anew`, watchdog, () =>
    withSession([{ program: 'talker.c' }], async (session) => {
      const run = await runTasks(session);
      session.useTasks(run);
      const acting = actingSession(session);
      session.startAll();
      await until(run, ([listen]) =>
        listen?.checks.every(({ state }) => state === 'already') === true);
      assert.deepEqual(states(run), [['already', 'already'], ['open']]);
      assert.deepEqual(run.views().map(({ done }) => done), [false, false]);
      // Looking is not an act.
      acting.node().subscription('/chatter', '', {}, () => undefined);
      acting.node().timer(1000, () => undefined);
      acting.nodes();
      acting.topics();
      acting.time.setRate(1);
      await acting.interfaces();
      const asked = acting.node().client('/nobody/get_parameters', 'rcl_interfaces/srv/GetParameters');
      asked.call(new Uint8Array(4), { timeoutMs: 1 }).catch(() => undefined);
      assert.equal(run.begun(), false);
      const publisher = acting.node().publisher('/student', 'std_msgs/msg/String', { durability: 'transient_local' });
      assert.equal(run.begun(), false, 'an endpoint that says nothing');
      const told = new Promise<void>((resolve) => run.onChange(() => resolve()));
      assert.equal(publisher.publish(hi), undefined);
      assert.equal(run.begun(), true);
      assert.deepEqual(states(run), [['open', 'open'], ['open']], 'all is looked for anew');
      await told;
      await until(run, ([listen]) => listen?.done === true);
      // The message of that moment may have been missed, so the student publishes again and again.
      const again = session.node().timer(100, () => void publisher.publish(hi));
      await until(run, (views) => views.every(({ done }) => done));
      again.close();
      assert.equal(run.views()[1]?.checks[0]?.title, 'You are heard');
      assert.match(run.views()[1]?.checks[0]?.seen ?? '', /hi/);
    }, link, { tasks }));
}

test('each act on the site counts, and what goes on unattended does not', watchdog, () =>
  withSession([{ program: 'talker.c' }], async (session) => {
    const count = { acts: 0 };
    session.useTasks({
      views: () => [],
      begun: () => count.acts > 0,
      onChange: () => () => undefined,
      close: () => undefined,
      acted: () => {
        count.acts += 1;
      },
    });
    const acting = actingSession(session);
    const counts = (act: () => unknown): number => {
      const before = count.acts;
      act();
      return count.acts - before;
    };
    for (const name of ['start', 'restart', 'interrupt', 'stop'] as const) assert.equal(counts(() => acting[name]('talker-1')), 1, name);
    for (const name of ['startAll', 'restartAll', 'stopAll'] as const) assert.equal(counts(() => acting[name]()), 1, name);
    assert.equal(counts(() => acting.sendInput('talker-1', 'x\n')), 1);
    assert.equal(counts(() =>
      acting.run({
        package: 'test',
        executable: 'talker',
        arguments: [],
        onLines: () => undefined,
        onEnd: () => undefined,
      })
    ), 1);
    const client = acting.node().client('/s', 'std_srvs/srv/Empty');
    assert.equal(counts(() => client.call(new Uint8Array(4), { timeoutMs: 1 }).catch(() => undefined)), 1);
    const goals = acting.node().actionClient('/a', 'example_interfaces/action/Fibonacci');
    assert.equal(counts(() => {
      const goal = goals.sendGoal(new Uint8Array(8), { timeoutMs: 1 });
      goal.accepted.catch(() => undefined);
      goal.result.catch(() => undefined);
    }), 1);
    const free = acting.unattended ?? acting;
    assert.equal(counts(() => free.node().publisher('/student', 'std_msgs/msg/String').publish(hi)), 0);
    assert.equal(counts(() => session.start('talker-1')), 0, 'the launch itself');
    assert.equal(acting.start, acting.start, 'the same function each time');
    assert.equal(acting.nodes, acting.nodes);
    assert.equal(acting.node().name, session.node().name);
  }, 'shared', { tasks }));

test('site.json: a task has checks of known nodes and a title', () => {
  const site = (change: object): unknown => ({
    schema: 1,
    protocol: 1,
    name: 'a',
    nodes: [],
    files: [],
    ui: {},
    tasks: [{ title: 'Listen', checks: [{ kind: 'rate', topic: '/a' }], ...change }],
  });
  assert.deepEqual(readSite(site({})).tasks, [
    { title: 'Listen', text: '', hint: '', solution: '', checks: [{ title: '', aim: { kind: 'rate', topic: '/a' } }] },
  ]);
  assert.throws(() => readSite(site({ checks: [] })), /site\.tasks\[0\] has no checks/);
  assert.throws(() => readSite(site({ title: 7 })), /site\.tasks\[0\]\.title is not a text/);
  assert.throws(() => readSite(site({ text: [] })), /site\.tasks\[0\]\.text is not a text/);
  assert.throws(() => readSite(site({ checks: [{ kind: 'state', node: 'x', state: 'running' }] })), /which is none of the site/);
});
