// Sessions over real programs under Node.js: states, consoles, input, threads, crashes, rules.

// Compatibility, works: exceptions and `std::thread` in one program; one compile, two links

// Compatibility, cannot: a program with threads on a page without cross-origin isolation ->
// refused with R2W0704: wasm threads need shared memory

import assert from 'node:assert/strict';
import { rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { mostConsoleLines } from '../../../runtime/site/program/console_log.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import type { NodeState, NodeView, Session, TopicView } from '../../../runtime/site/contract/session.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { makeFolder, prints, reaches, withSession } from './site_fixture.ts';

const watchdog = { timeout: 240_000 };

/** The topic `/chatter`, when it is as wanted. */
function seesTopic(session: Session, wanted: (topic: TopicView) => boolean): Promise<TopicView> {
  return new Promise((resolve) => {
    const off = session.onTopics((topics) => {
      const view = topics.find((topic) => topic.name === '/chatter' && wanted(topic));
      if (view === undefined) return;
      off();
      resolve(view);
    });
  });
}

for (const link of ['shared', 'port'] as const) {
  test(`${link}: talker and listener; topics, rates and the last message; stop`, watchdog, () =>
    withSession([{ program: 'talker.c' }, { program: 'listener.c' }], async (session) => {
      assert.equal(session.link, link);
      assert.deepEqual(session.nodes().map(({ state }) =>
        state.kind
      ), ['stopped', 'stopped']);
      session.startAll();
      await prints(session, 'listener-2', /I heard: \[Hello World: \d+\] after 1/);
      session.onTopics(() => undefined);
      const topic = await seesTopic(session, ({ rateHz, count }) => rateHz > 1 && count > 5);
      assert.equal(topic.type, 'std_msgs/msg/String');
      assert.deepEqual([topic.publishers, topic.subscriptions], [1, 1]);
      assert.deepEqual(topic.qos, [{ reliability: 'reliable', durability: 'volatile', history: 'keep_last', depth: 10 }]);
      assert.ok(topic.bytesPerSecond > topic.rateHz);
      const last = session.lastMessage('/chatter');
      assert.match(new TextDecoder().decode(last?.bytes), /Hello World: \d+\0$/);
      assert.ok(Math.abs((last?.receivedAt ?? 0) - Date.now()) < 30_000);
      assert.equal(session.lastMessage('/nothing'), undefined);
      assert.equal((await session.interfaces()).get('std_msgs/msg/String'), 'string data\n');
      session.stop('talker-1');
      const talker = await reaches(session, 'talker-1', 'exited');
      assert.deepEqual(talker.state, { kind: 'exited', code: 0 });
      await prints(session, 'talker-1', /^talker stops$/);
      const alone = await seesTopic(session, ({ publishers }) => publishers === 0);
      assert.deepEqual([alone.subscriptions, alone.rateHz, alone.type, alone.qos], [1, 0, topic.type, topic.qos]);
      assert.ok(alone.count >= topic.count);
      const kept = session.lastMessage('/chatter');
      assert.equal(kept?.count, alone.count);
      assert.ok(new TextDecoder().decode(kept?.bytes).endsWith(`Hello World: ${alone.count}\0`));
      session.stopAll();
      await reaches(session, 'listener-2', 'exited');
      const silent = await seesTopic(session, ({ subscriptions }) => subscriptions === 0);
      assert.deepEqual(silent, { ...alone, subscriptions: 0 });
      assert.deepEqual(session.lastMessage('/chatter'), kept);
      session.start('talker-1');
      await reaches(session, 'talker-1', 'running');
      const again = await seesTopic(session, ({ count, rateHz }) => count > alone.count + 2 && rateHz > 1);
      assert.ok(again.rateHz < 200, `${again.rateHz} Hz`);
      assert.match(new TextDecoder().decode(session.lastMessage('/chatter')?.bytes), /Hello World: \d+\0$/);
    }, link));

  test(`${link}: a worker gets its start and nothing more, however much it prints: a blocked one would keep it for ever`, watchdog, () =>
    withSession([{ program: 'talker.c' }, { program: 'listener.c' }], async (session, _folder, posted) => {
      session.startAll();
      await prints(session, 'listener-2', /I heard/);
      await prints(session, 'talker-1', /Hello World: 20'/);
      assert.deepEqual(posted.map(({ t }) => t), ['start', 'start']);
    }, link));

  test(`${link}: the session has settled when each node waits or is over`, watchdog, () =>
    withSession([{ program: 'talker.c' }, { program: 'traps.c' }, { program: 'spins.c' }], async (session) => {
      let settled = false;
      void session.settled.then(() => {
        settled = true;
      });
      session.startAll();
      await prints(session, 'talker-1', /Hello World: 2/);
      await prints(session, 'spins-3', /^spinning$/);
      await reaches(session, 'traps-2', 'crashed');
      assert.equal(settled, false);
      session.stop('spins-3');
      session.stop('spins-3');
      await session.settled;
      assert.deepEqual(session.nodes().map(({ state }) =>
        state.kind
      ), ['running', 'crashed', 'exited']);
    }, link));

  test(`${link}: arguments, environment and standard input; the exit code`, watchdog, () =>
    withSession([{ program: 'echo.c', arguments: ['--ros-args', '-r', 'a:=b'] }], async (session) => {
      session.startAll();
      await prints(session, 'echo-1', /^COLOUR=red$/);
      assert.deepEqual(session.console('echo-1').lines().slice(0, 4).map(({ text }) => text), ['argument 0: echo', 'argument 1: --ros-args', 'argument 2: -r',
        'argument 3: a:=b']);
      // A question is there before its answer, though it ends no line.
      await prints(session, 'echo-1', /^what\? $/);
      session.sendInput('echo-1', 'grüezi\n');
      await prints(session, 'echo-1', /^echo grüezi$/);
      session.sendInput('echo-1', 'one\ntwo\n');
      await prints(session, 'echo-1', /^echo two$/);
      session.sendInput('echo-1', 'quit\n');
      assert.deepEqual((await reaches(session, 'echo-1', 'exited')).state, { kind: 'exited', code: 7 });
      session.start('echo-1');
      await prints(session, 'echo-1', /^COLOUR=red$/);
      session.sendInput('echo-1', 'quit\n');
      await reaches(session, 'echo-1', 'exited');
    }, link));

  test(`${link}: Ctrl-C stops a node and shows, an empty text ends its input; all start anew when the last has ended`, watchdog, () =>
    withSession([{ program: 'echo.c' }, { program: 'echo.c' }], async (session) => {
      session.startAll();
      await prints(session, 'echo-1', /^COLOUR=red$/);
      await prints(session, 'echo-2', /^COLOUR=red$/);
      session.sendInput('echo-2', '');
      await reaches(session, 'echo-2', 'exited');
      session.interrupt('echo-2');
      session.interrupt('echo-1');
      await reaches(session, 'echo-1', 'exited');
      const signs = (id: string): number =>
        session.console(id).lines().filter(({ text }) => text === '^C').length;
      assert.deepEqual([signs('echo-1'), signs('echo-2')], [1, 0]);

      session.start('echo-1');
      await prints(session, 'echo-1', /^COLOUR=red$/);
      const views = (): readonly NodeView[] => session.nodes();
      const before = views()[0]!.startedAt;
      let early = false;
      const off = session.onNodes(([first, second]) => {
        early ||= first!.startedAt === before && second!.state.kind !== 'exited';
      });
      session.restartAll();
      while (!views().every(({ state }) => state.kind === 'running')) await new Promise((resolve) => setTimeout(resolve, 5));
      off();
      // The second one, which did not run, waited for the first to end.
      assert.ok(!early && views()[0]!.startedAt !== before);
      session.restartAll();
      session.stopAll();
      await reaches(session, 'echo-1', 'exited');
      await reaches(session, 'echo-2', 'exited');
      await new Promise((resolve) => setTimeout(resolve, 0));
      assert.deepEqual(session.nodes().map(({ state }) => state.kind), ['exited', 'exited']);
    }, link));

  test(`${link}: a program runs once more beside the nodes, with its own arguments and input, and is gone when it ends`, watchdog, () =>
    withSession([{ program: 'echo.c', arguments: ['--first'] }], async (session) => {
      session.startAll();
      await prints(session, 'echo-1', /^argument 1: --first$/);
      const heard: string[] = [];
      const run = (...given: string[]): Promise<NodeState> =>
        new Promise((ended) => {
          const id = session.run({
            package: session.site.nodes[0]!.package,
            executable: 'echo',
            arguments: given,
            onLines: (lines) => {
              heard.push(...lines.map(({ text }) =>
                text
              ));
              if (lines.some(({ text }) => text.startsWith('argument 0'))) session.sendInput(id, 'quit\n');
            },
            onEnd: ended,
          });
          assert.equal(id, 'echo-2');
          assert.deepEqual(session.nodes().map((node) => node.id), ['echo-1', 'echo-2']);
        });
      assert.deepEqual(await run('--second', 'x'), { kind: 'exited', code: 7 });
      assert.deepEqual(heard.slice(0, 3), ['argument 0: echo', 'argument 1: --second', 'argument 2: x']);
      assert.deepEqual(session.nodes().map((node) => node.id), ['echo-1']);
      // A panel that just showed the console may still read it.
      assert.ok(session.console('echo-2').lines().length > 0);
      assert.deepEqual(await run(), { kind: 'exited', code: 7 });
      assert.equal(session.nodes()[0]?.state.kind, 'running');
      assert.throws(() => session.run({ package: 'p', executable: 'none', arguments: [], onLines: () => undefined, onEnd: () => undefined }),
        /no program p\/none/);
    }, link));

  // Guarantee, hostile input: a program that traps, throws, aborts or imports unknown functions ends with an error code in its console; the other nodes go on
  test(`${link}: exit codes, traps, exceptions and unknown imports are told; the others go on`, watchdog, () =>
    withSession([
      { program: 'exits.c', arguments: ['--code', '3'] },
      { program: 'traps.c' },
      { program: 'throws.cpp' },
      { program: 'unknown.c' },
      { program: 'talker.c' },
      { program: 'aborts.cpp' },
      { program: 'aborts.cpp', arguments: ['at once'] },
    ], async (session) => {
      session.startAll();
      assert.deepEqual((await reaches(session, 'exits-1', 'exited')).state, { kind: 'exited', code: 3 });
      await prints(session, 'exits-1', /^ending with 3$/);
      const trap = (await reaches(session, 'traps-2', 'crashed')).state;
      assert.equal(trap.kind === 'crashed' && trap.code, 'R2W0701');
      assert.match(trap.kind === 'crashed' ? trap.message : '', /^divide by zero\n {2}at .*wasm-function/);
      await prints(session, 'traps-2', /^dividing$/);
      const thrown = (await reaches(session, 'throws-3', 'crashed')).state;
      assert.deepEqual(thrown, {
        kind: 'crashed',
        code: 'R2W0702',
        message: "terminate called after throwing an instance of 'std::runtime_error'\n  what():  the wheel came off",
      });
      const unknown = (await reaches(session, 'unknown-4', 'crashed')).state;
      assert.equal(unknown.kind === 'crashed' && unknown.code, 'R2W0703');
      assert.match(unknown.kind === 'crashed' ? unknown.message : '', /ros2wasm\.teleport/);
      assert.deepEqual(session.nodes()[3]?.source, { file: 'workspace.yaml', line: 6, column: 5 });
      await prints(session, 'talker-5', /Publishing/);
      for (const id of ['aborts-6', 'aborts-7']) {
        const aborted = (await reaches(session, id, 'crashed')).state;
        assert.equal(aborted.kind === 'crashed' && aborted.code, 'R2W0701');
        assert.match(aborted.kind === 'crashed' ? aborted.message : '', /^abort\(\) was called \(SIGABRT, exit code 134\)\n {2}at /);
      }
      assert.deepEqual(session.console('aborts-6').lines().map(({ text }) => text), [
        "terminate called after throwing an instance of 'std::runtime_error'",
        '  what():  the brake is stuck',
      ]);
    }, link));
}

test('a trap names the functions from the file of names; without it, their numbers', watchdog, async () => {
  for (const lost of [false, true]) {
    await withSession([{ program: 'traps.c', namesApart: true }], async (session, folder) => {
      if (lost) rmSync(join(folder, 'programs/traps.names'));
      session.startAll();
      const { state } = await reaches(session, 'traps-1', 'crashed');
      const message = state.kind === 'crashed' ? state.message : '';
      if (lost) assert.match(message, /^divide by zero\n {2}at \(?wasm-function\[\d+\]:0x[0-9a-f]+\)?/);
      else assert.match(message, /^divide by zero\n {2}at ratio \(0x[0-9a-f]+\)\n {2}at \S+ \(0x[0-9a-f]+\)/);
    });
  }
});

test('threads throw and catch at once; joined and detached ones end', watchdog,
  () =>
    withSession([{ program: 'threads.cpp', threads: true }], async (session) => {
      session.startAll();
      assert.deepEqual((await reaches(session, 'threads-1', 'exited')).state, { kind: 'exited', code: 0 });
      assert.deepEqual(session.console('threads-1').lines().map(({ text }) => text), ['async ok', '4000']);
    }));

test('a thread that exits or throws ends the program', watchdog, () =>
  withSession([
    { program: 'thread_exits.cpp', threads: true },
    { program: 'thread_exits.cpp', threads: true, arguments: ['throw'] },
  ], async (session) => {
    session.startAll();
    assert.deepEqual((await reaches(session, 'thread_exits-1', 'exited')).state, { kind: 'exited', code: 5 });
    const crash = (await reaches(session, 'thread_exits-2', 'crashed')).state;
    assert.match(crash.kind === 'crashed' ? crash.message : '', /what\(\): {2}from a thread/);
  }));

test('what a thread wrote last is there when the program is over, though it comes later than the news of that', watchdog, async () => {
  const folder = makeFolder([{ program: 'thread_says.cpp', threads: true }]);
  const real = nodePlatform(folder, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
  let workers = 0;
  const platform = {
    ...real,
    startWorker: (...[name, events]: Parameters<typeof real.startWorker>) => {
      workers += 1;
      if (workers === 1) return real.startWorker(name, events);
      return real.startWorker(name, { ...events, report: (report) => setTimeout(() => events.report(report), 300) });
    },
  };
  const session = new SiteSession({ site: readSite(await platform.json('site.json')), platform, broker: new SharedBroker({ ceiling: 64 << 20 }) });
  try {
    session.startAll();
    await reaches(session, 'thread_says-1', 'exited');
    assert.deepEqual(session.console('thread_says-1').lines().map(({ text }) => text), ['said by a thread']);
    assert.equal(workers, 2);
  } finally {
    session.close();
    platform.close();
    rmSync(folder, { recursive: true });
  }
});

test('a threaded program is refused on the port link', watchdog, () =>
  withSession([{ program: 'threads.cpp', threads: true }], async (session) => {
    session.startAll();
    const state = (await reaches(session, 'threads-1', 'crashed')).state;
    assert.equal(state.kind === 'crashed' && state.code, 'R2W0704');
  }, 'port'));

test('respawn starts a node again until it is stopped', watchdog, () =>
  withSession([{ program: 'exits.c', respawn: true }], async (session) => {
    let starts = 0;
    const twice = new Promise<void>((resolve) => {
      session.onNodes(([node]) => {
        if (node?.state.kind === 'starting') starts += 1;
        if (starts === 3) resolve();
      });
    });
    session.startAll();
    await twice;
    session.stop('exits-1');
    await reaches(session, 'exits-1', 'exited');
  }));

test('port: a node starts also when another one ends while its program is compiled', watchdog, async () => {
  const folder = makeFolder([{ program: 'exits.c' }, { program: 'talker.c' }]);
  const plain = nodePlatform(folder, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
  let letGo: () => void = () => undefined;
  const gate = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  const platform = {
    ...plain,
    compile: async (path: string): Promise<WebAssembly.Module> => {
      const module = await plain.compile(path);
      if (path.includes('talker')) await gate;
      return module;
    },
  };
  const session = new SiteSession({ site: readSite(await platform.json('site.json')), platform, broker: new PortBroker() });
  try {
    session.startAll();
    await reaches(session, 'exits-1', 'exited');
    // Until its ports are closed.
    await new Promise((resolve) => setTimeout(resolve, 300));
    letGo();
    await prints(session, 'talker-2', /Hello World/);
  } finally {
    session.close();
    platform.close();
    rmSync(folder, { recursive: true });
  }
});

test('a node that is stopped before it starts does not end by itself: no rule is followed', watchdog, () =>
  withSession([
    { program: 'exits.c', respawn: true, rules: { start_after: 1000 } },
    { program: 'echo.c', rules: { start_after: 1000, on_exit: 'shutdown' } },
    { program: 'talker.c' },
  ], async (session) => {
    session.startAll();
    await reaches(session, 'talker-3', 'running');
    session.stop('exits-1');
    session.stop('echo-2');
    // Longer than the least pause before a respawn.
    await new Promise((resolve) => setTimeout(resolve, 500));
    assert.deepEqual(session.nodes().map(({ state }) => state), [{ kind: 'exited', code: 137 }, { kind: 'exited', code: 137 }, { kind: 'running' }]);
  }));

test('a node that waits starts when another has started, or has ended by itself', watchdog, () =>
  withSession([
    { program: 'spins.c' },
    { program: 'spins.c', rules: { start_on: { node: 'spins-1', event: 'start' } } },
    { program: 'spins.c', rules: { start_on: { node: 'exits-4', event: 'exit' } } },
    { program: 'exits.c', rules: { start_on: { node: 'spins-2', event: 'start' } } },
    { program: 'exits.c', rules: { start_on: { node: 'spins-1', event: 'exit' } } },
  ], async (session) => {
    session.startAll();
    const kinds = (): string[] => session.nodes().map(({ state }) => state.kind);
    assert.deepEqual(kinds(), ['starting', 'waiting', 'waiting', 'waiting', 'waiting']);
    await reaches(session, 'spins-3', 'running');
    assert.deepEqual(kinds(), ['running', 'running', 'running', 'exited', 'waiting']);
    session.stop('spins-1');
    session.stop('spins-1');
    assert.equal(kinds()[4], 'waiting', 'it did not end by itself');
    session.stop('exits-5');
    assert.equal(kinds()[4], 'stopped');
  }));

test('while some nodes run, starting all starts the others, and what the launch says is not said again', watchdog, () =>
  withSession([
    { program: 'spins.c' },
    { program: 'exits.c', rules: { start_on: { node: 'spins-1', event: 'start' } } },
    { program: 'exits.c', rules: { start_on: { node: 'exits-2', event: 'exit' } } },
  ], async (session) => {
    const kinds = (): string[] => session.nodes().map(({ state }) => state.kind);
    const said = (): number => session.launchLog.lines().filter(({ text }) => text.endsWith('it begins')).length;
    session.startAll();
    await reaches(session, 'exits-3', 'exited');
    assert.deepEqual([kinds(), said()], [['running', 'exited', 'exited'], 1]);
    const since = session.nodes()[0]?.startedAt;
    session.startAll();
    assert.deepEqual([kinds(), said()], [['running', 'starting', 'waiting'], 1]);
    await reaches(session, 'exits-3', 'exited');
    assert.equal(session.nodes()[0]?.startedAt, since);
    session.stop('spins-1');
    session.stop('spins-1');
    session.startAll();
    assert.deepEqual([kinds(), said()], [['starting', 'waiting', 'waiting'], 2]);
  }, 'shared', { launch: { steps: [{ do: 'log', level: 'info', text: 'it begins' }] } }));

test('a managed node that is stopped gives up the transitions that were to be made', watchdog,
  () =>
    withSession([{ program: 'spins.c' }, { program: 'spins.c' }], async (session) => {
      session.startAll();
      await reaches(session, 'spins-1', 'running');
      session.stop('spins-1');
      session.stop('spins-1');
      await prints(session, 'launch', /^\[WARN\] \[launch\]: `\/a` ended before its transitions were made$/);
    }, 'shared', { launch: { steps: [{ do: 'transition', node: 'spins-1', name: '/a', transitions: [1] }] } }));

// Guarantee, hostile input: a program in an endless loop is ended by Stop, and can be started again
test('a node that hears nothing is killed at the second stop; restart starts it again', watchdog,
  () =>
    withSession([{ program: 'spins.c' }], async (session) => {
      session.startAll();
      await prints(session, 'spins-1', /^spinning$/);
      session.stop('spins-1');
      assert.equal(session.nodes()[0]?.state.kind, 'running');
      session.stop('spins-1');
      assert.deepEqual(session.nodes()[0]?.state, { kind: 'exited', code: 137 });
      session.start('spins-1');
      await reaches(session, 'spins-1', 'running');
      session.restart('spins-1');
      session.stop('spins-1');
      await reaches(session, 'spins-1', 'running');
    }));

// Guarantee, hostile input: a program that takes all the memory that it can have meets an end of it, and the others go on
test('a program that takes all memory', watchdog, () =>
  withSession([{ program: 'hoards.c' }, { program: 'talker.c' }], async (session) => {
    session.startAll();
    const line = await prints(session, 'hoards-1', /pieces and no more$/);
    assert.ok(Number(/^\d+/.exec(line)?.[0]) <= 64, line); // four gigabytes
    assert.deepEqual((await reaches(session, 'hoards-1', 'exited')).state, { kind: 'exited', code: 0 });
    await prints(session, 'talker-2', /Publishing/);
  }));

/** Name -> the sections of a module after its first eight bytes. */
const hostileModules = new Map<string, readonly number[]>([
  ['a table of 4,294,967,295 places', [4, 8, 1, 0x70, 0, 0xff, 0xff, 0xff, 0xff, 0x0f]],
  ['a memory of 65,537 pages', [5, 5, 1, 0, 0x81, 0x80, 0x04]],
  ['more functions than bytes', [1, 4, 1, 0x60, 0, 0, 3, 5, 0xff, 0xff, 0xff, 0xff, 0x0f]],
]);
for (const [what, sections] of hostileModules) {
  // Guarantee, hostile input: a WebAssembly module with a table, a memory or a count beyond all limits is refused with its
  // code, and the other nodes go on
  test(`a module with ${what}`, watchdog, () =>
    withSession([{ program: 'exits.c' }, { program: 'talker.c' }], async (session, folder) => {
      writeFileSync(join(folder, 'programs/exits.wasm'), Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, ...sections));
      session.startAll();
      const { state } = await reaches(session, 'exits-1', 'crashed');
      assert.match(state.kind === 'crashed' ? state.code : '', /^R2W07\d\d$/);
      await prints(session, 'talker-2', /Publishing/);
    }));
}

// Guarantee, hostile input: a module that loops for ever before its program begins is ended by Stop
test('a module whose start never ends', watchdog, () =>
  withSession([{ program: 'exits.c' }, { program: 'talker.c' }], async (session, folder) => {
    const start = [1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0, 8, 1, 0, 0x0a, 9, 1, 7, 0, 3, 0x40, 0x0c, 0, 0x0b, 0x0b];
    writeFileSync(join(folder, 'programs/exits.wasm'), Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, ...start));
    session.startAll();
    await prints(session, 'talker-2', /Publishing/);
    session.stop('exits-1');
    session.stop('exits-1');
    assert.deepEqual((await reaches(session, 'exits-1', 'exited')).state, { kind: 'exited', code: 137 });
  }));

// Guarantee, hostile input: a program that prints without end keeps its newest lines only, and the page answers
test('a node that prints without end keeps the newest lines, and the page alive', watchdog, () =>
  withSession([{ program: 'flood.c' }], async (session) => {
    session.startAll();
    await prints(session, 'flood-1', /^line [1-9]\d{4,}$/);
    const log = session.console('flood-1');
    const lines = log.lines();
    const printed = Number(lines.at(-1)?.text.slice('line '.length)) + 1;
    assert.ok(printed > 10_000 && lines.length <= mostConsoleLines);
    assert.ok(lines.length + log.dropped() >= printed, 'each line is there, or counted');
    log.clear();
    session.stop('flood-1');
    session.stop('flood-1');
  }));

test('a program that is not there is told', watchdog, async () => {
  const { unlinkSync } = await import('node:fs');
  const { makeFolder } = await import('./site_fixture.ts');
  const { nodePlatform } = await import('../../../runtime/site/session/node_platform.ts');
  const folder = makeFolder([{ program: 'exits.c' }]);
  unlinkSync(`${folder}/programs/exits.wasm`);
  const platform = nodePlatform(folder, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
  await assert.rejects(platform.compile('programs/exits.wasm'), { code: 'R2W0706' });
});

test('a program with other bytes than site.json says is not compiled', watchdog, async () => {
  const { createHash } = await import('node:crypto');
  const { readFileSync } = await import('node:fs');
  const { makeFolder } = await import('./site_fixture.ts');
  const { nodePlatform } = await import('../../../runtime/site/session/node_platform.ts');
  const folder = makeFolder([{ program: 'exits.c' }]);
  const path = 'programs/exits.wasm';
  const bytes = readFileSync(`${folder}/${path}`);
  const listed = (sha256: string) => [{ path, size: bytes.length, sha256, reason: 'test' }];
  const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);
  const whole = nodePlatform(folder, entry);
  whole.expect(listed(createHash('sha256').update(bytes).digest('hex')));
  assert.ok(await whole.compile(path) instanceof WebAssembly.Module);
  const other = nodePlatform(folder, entry);
  other.expect(listed('0'.repeat(64)));
  await assert.rejects(other.compile(path), { code: 'R2W0724' });
  await assert.rejects(other.bytes(path), { code: 'R2W0724' });
});
