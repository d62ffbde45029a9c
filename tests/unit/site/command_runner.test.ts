// Commands of ros2 as processes of a launch: states, lines, exit codes, Ctrl-C, the launch's rules. What runs them here says
// what it is told; the real ones are in tests/e2e/launch/launch_commands.test.ts.

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { test } from 'node:test';
import { PortBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import type { CommandLoader, RunningCommand } from '../../../runtime/site/contract/session.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { makeFolder, prints, reaches, withSession } from './site_fixture.ts';

const watchdog = { timeout: 60_000 };

function node(id: string, words: readonly string[], rules: Readonly<Record<string, unknown>> = {}): Readonly<Record<string, unknown>> {
  return { id, package: '', executable: 'ros2', label: `ros2 ${words.join(' ')}`, kind: 'command', arguments: words, ...rules };
}

/** `say TEXT`, `fail CODE`, `wait`: until Ctrl-C, `deaf`: for ever, `read PATH`: a file of the site, `break`: a mistake. */
async function run({ words: [verb = '', text = ''], print, warn, file, signal }: RunningCommand): Promise<number> {
  switch (verb) {
    case 'say':
      print(text);
      return 0;
    case 'fail':
      warn(`code ${text}`);
      return Number(text);
    case 'read':
      print(new TextDecoder().decode(await file(text)));
      return 0;
    case 'break':
      throw new Error('a mistake');
    default: {
      print('begun');
      await new Promise<void>((done) => {
        if (verb === 'wait') signal.addEventListener('abort', () => done());
      });
      print('interrupted');
      return 130;
    }
  }
}

const loader: CommandLoader = () => Promise.resolve(run);

function withCommands(nodes: readonly Readonly<Record<string, unknown>>[], use: Parameters<typeof withSession>[1], commands = loader,
  steps: readonly unknown[] = []): Promise<void>
{
  return withSession([], use, 'shared', { nodes, launch: { steps } }, commands);
}

test('one after the other, with lines on both streams and exit codes', watchdog, () =>
  withCommands([
    node('ros2-1', ['say', 'two\nlines'], { source: { file: 'a.launch.py', line: 3, column: 1 } }),
    node('ros2-2', ['fail', '3'], { start_on: { node: 'ros2-1', event: 'exit' } }),
    node('ros2-3', ['read', 'interfaces.json'], { start_on: { node: 'ros2-2', event: 'exit' }, start_after: 0.05 }),
    node('ros2-4', ['wait'], { start_on: { node: 'ros2-1', event: 'output', stream: 'stdout', tests: [{ how: 'is', text: 'lines' }] } }),
  ], async (session) => {
    assert.deepEqual(session.nodes()[0], {
      id: 'ros2-1',
      label: 'ros2 say two\nlines',
      package: '',
      executable: 'ros2',
      command: true,
      state: { kind: 'stopped' },
      source: { file: 'a.launch.py', line: 3, column: 1 },
    });
    session.startAll();
    await session.settled;
    assert.deepEqual((await reaches(session, 'ros2-2', 'exited')).state, { kind: 'exited', code: 3 });
    await prints(session, 'ros2-3', /std_msgs/);
    assert.ok((await reaches(session, 'ros2-4', 'running')).startedAt !== undefined);
    assert.deepEqual(session.console('ros2-1').lines().map(({ stream, text }) => [stream, text]), [['stdout', 'two'], ['stdout', 'lines']]);
    assert.deepEqual(session.console('ros2-2').lines().map(({ stream, text }) => [stream, text]), [['stderr', 'code 3']]);
    // Nobody reads what is typed.
    session.sendInput('ros2-4', 'text\n');
    session.interrupt('ros2-4');
    assert.deepEqual((await reaches(session, 'ros2-4', 'exited')).state, { kind: 'exited', code: 130 });
    assert.deepEqual(session.console('ros2-4').lines().map(({ text }) => text), ['begun', '^C', 'interrupted']);
  }, loader, [{ do: 'log', level: 'info', text: 'over', on: { node: 'ros2-2', event: 'exit' } }]));

test('it respawns, as often as the launch file says, and is started again by hand', watchdog,
  () =>
    withCommands([node('ros2-1', ['say', 'again'], { respawn: true, respawn_max_retries: 2 })], async (session) => {
      const count = (): number => session.console('ros2-1').lines().length;
      session.start('ros2-1');
      while (count() < 3 || session.respawns() || session.nodes()[0]?.state.kind !== 'exited')
        await new Promise((soon) => {
          setTimeout(soon, 10);
        });
      assert.equal(count(), 3);
      session.start('ros2-1');
      while (count() < 6)
        await new Promise((soon) => {
          setTimeout(soon, 10);
        });
    }));

test('one that does not listen is killed at the second Ctrl-C, and says nothing more', watchdog,
  () =>
    withCommands([node('ros2-1', ['deaf'])], async (session) => {
      session.startAll();
      await prints(session, 'ros2-1', /begun/);
      session.stop('ros2-1');
      assert.equal(session.nodes()[0]?.state.kind, 'running');
      session.stop('ros2-1');
      assert.deepEqual(session.nodes()[0]?.state, { kind: 'exited', code: 137 });
    }));

test('its end ends all, when the launch file says so; who is stopped starts nothing', watchdog, () =>
  withCommands([
    node('ros2-1', ['wait']),
    node('ros2-2', ['say', 'done'], { on_exit: 'shutdown' }),
    node('ros2-3', ['say', 'never'], { start_on: { node: 'ros2-1', event: 'exit' } }),
  ], async (session) => {
    session.startAll();
    await reaches(session, 'ros2-1', 'exited');
    assert.deepEqual(session.nodes().map(({ state }) => state), [{ kind: 'exited', code: 130 }, { kind: 'exited', code: 0 }, { kind: 'stopped' }]);
  }));

test('when none runs and none is to come, all has ended: idle', watchdog, () =>
  withCommands([
    node('ros2-1', ['say', 'first'], { respawn: true, respawn_max_retries: 1, respawn_delay: 0.05 }),
    node('ros2-2', ['say', 'second'], { start_on: { node: 'ros2-1', event: 'exit' }, start_after: 0.2 }),
  ], async (session) => {
    session.startAll();
    await reaches(session, 'ros2-2', 'exited');
    while (session.launchLog.lines().length === 0)
      await new Promise((soon) => {
        setTimeout(soon, 10);
      });
    assert.deepEqual(session.launchLog.lines().map(({ text }) => text), ['[INFO] [launch.user]: over: idle']);
    assert.equal(session.console('ros2-1').lines().length, 2);
  }, loader, [{ do: 'log', level: 'info', text: 'over: \u2039why all ends\u203a', on: { event: 'shutdown' } }]));

test('launched once more, one whose end ends all is told with its own code', watchdog,
  () =>
    withCommands([node('ros2-1', ['wait']), node('ros2-2', ['fail', '3'])], async (session) => {
      const told: unknown[] = [];
      await new Promise<void>((done) => {
        void session.launch({
          arguments: new Map(),
          onLines: () => undefined,
          onSaid: (text) => told.push(text),
          onEnd: done,
          onNode: ({ id }, state) => {
            if (state.kind === 'exited') told.push([id, state.code]);
          },
        });
      });
      assert.deepEqual(told, ['[INFO] [launch]: all nodes are stopped: it failed', ['ros2-4', 3], ['ros2-3', 130]]);
    }, loader, [{ do: 'shutdown', reason: 'it failed', on: { node: 'ros2-2', event: 'exit' } }]));

test('what cannot be loaded, and a mistake of the command, are told as crashes', watchdog, async () => {
  const late: CommandLoader = () => Promise.reject(new SiteError('R2W0706', 'no network'));
  await withCommands([node('ros2-1', ['say', 'a'])], async (session) => {
    session.startAll();
    assert.deepEqual((await reaches(session, 'ros2-1', 'crashed')).state, { kind: 'crashed', code: 'R2W0706', message: 'no network' });
  }, late);
  await withCommands([node('ros2-1', ['break'])], async (session) => {
    session.startAll();
    assert.deepEqual((await reaches(session, 'ros2-1', 'crashed')).state, { kind: 'crashed', code: 'R2W0708', message: 'a mistake' });
  });
});

test('a session that is not told how they are run refuses the site', watchdog, async () => {
  const folder = makeFolder([], { nodes: [node('ros2-1', ['say', 'a'])] });
  const platform = nodePlatform(folder, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
  const site = readSite(await platform.json('site.json'));
  assert.throws(() => new SiteSession({ site, platform, broker: new PortBroker() }), /nobody was told how ros2-1 is run/);
  platform.close();
  rmSync(folder, { recursive: true });
});
