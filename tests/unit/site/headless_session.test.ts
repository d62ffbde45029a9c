// The end of a program for Node.js: not before what it printed has gone out.

import assert from 'node:assert/strict';
import { Writable } from 'node:stream';
import { test } from 'node:test';
import { exitWhenPrinted } from '../../../runtime/site/session/headless_session.ts';

test('it ends once each stream has taken what was printed, and not before', async () => {
  const seen: string[] = [];
  const held: (() => void)[] = [];
  const slow = new Writable({
    write(bytes: Buffer, _, taken) {
      held.push(() => {
        if (bytes.length > 0) seen.push(bytes.toString());
        taken();
      });
    },
  });
  const quick = new Writable({ write: (_bytes, _, taken) => taken() });
  slow.write('one');
  slow.write('two');
  const ended = exitWhenPrinted(3, [quick, slow], (code) => void seen.push(`exit ${code}`));
  while (held.length > 0) {
    // If exitWhenPrinted did not wait for the slow stream, it would exit here.
    await new Promise((resolve) => {
      setImmediate(resolve);
    });
    held.shift()?.();
  }
  await ended;
  assert.deepEqual(seen, ['one', 'two', 'exit 3']);
});

test('a stream that nobody reads any more keeps it from nothing', async () => {
  const gone = new Writable({ write: (_bytes, _, taken) => taken(new Error('EPIPE')) });
  gone.on('error', () => undefined);
  gone.write('lost');
  const seen: number[] = [];
  await exitWhenPrinted(0, [gone], (code) => void seen.push(code));
  assert.deepEqual(seen, [0]);
});
