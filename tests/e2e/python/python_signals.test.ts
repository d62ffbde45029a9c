// Signals in Python programs and in loops of asyncio, and standard input in these loops, on both links.

// Compatibility, works: `signal.signal` with handlers, SIG_DFL and SIG_IGN, `signal.pause`, `os._exit`; of loops of asyncio
// `add_signal_handler`, `add_reader` and `connect_read_pipe` for standard input, with rclpy in a task, a thread or `run_in_executor`

// Compatibility, differs: `signal.alarm` and `signal.setitimer` -> NotImplementedError that says why

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { prints, reaches } from '../../unit/site/site_fixture.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
const interrupted = -2;
const killed = 137;
const late = "signals that come after a time cannot be had here, as the program is none of an operating system's: use a timer of rclpy, or threading.Timer";

/** A way of tests/packages/chatter_py/scripts/signals: what it has printed at its end, and its exit code. */
const ways: Readonly<Record<string, readonly [lines: readonly string[], code: number]>> = {
  default: [['waits'], interrupted],
  default_computes: [['waits'], interrupted],
  handled: [['waits', 'handled 2 True'], 0],
  ignored: [['waits'], killed],
  paused: [[`signal.alarm: ${late}`, `signal.setitimer: ${late}`, 'waits', 'signals 2'], 0],
  left: [[], 3],
  cancelled: [['waits', 'cancelled True', 'goes on'], 0],
  loops: [[
    'waits for a line',
    "read 'one\\n' True False",
    'waits for a line',
    "streamed b'two\\n'",
    'add_reader: a program of a page waits for standard input only, not for file 7',
    'add_writer: a program of a page writes to nothing that would keep it waiting',
    'a program of a page cannot start another one',
    'heard by a thread',
    'heard by run_in_executor',
    'waits',
    'goes on True True False',
  ], 0],
};
const idOf = (way: string): string => `${way}-${Object.keys(ways).indexOf(way) + 1}`;

let folder = '';

before(() => {
  folder = makeSite([], {}, {}, {
    nodes: Object.keys(ways).map((way) => ({ entry: 'lib/chatter_py/signals', executable: way, arguments: [way] })),
    packages: ownPackage('chatter_py'),
  });
});

after(() => rmSync(folder, { recursive: true }));

for (const link of played('port', 'shared')) {
  test(`${link}: a stop is to a program what it has made of SIGINT`, watchdog, async () => {
    const { session, close } = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    try {
      for (const [way, [lines, code]] of Object.entries(ways)) {
        // Nothing reaches a worker that computes without sharing memory.
        if (way === 'default_computes' && link === 'port') continue;
        const id = idOf(way);
        session.start(id);
        for (const [i, line] of ['one', 'two'].entries()) {
          if (way !== 'loops') continue;
          await prints(session, id, i === 0 ? /^waits for a line$/ : /^read /);
          session.sendInput(id, `${line}\n`);
        }
        if (way !== 'left') {
          await prints(session, id, /^waits$/);
          session.stop(id);
        }
        const { state } = await reaches(session, id, 'exited');
        assert.deepEqual([session.console(id).lines().map(({ text }) => text), (state as { code: number; }).code], [lines, code], way);
      }
    } finally {
      session.close();
      close();
    }
  });
}
