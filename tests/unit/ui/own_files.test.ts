// The files that terminals of a page write: their limits, and the room that comes back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { MOST_TEXT_BYTES, mayWrite, OwnFiles } from '../../../runtime/site/ui/shell/own_files.ts';
import { HOME } from '../../../runtime/site/ui/shell/paths.ts';

test('files have a limit each and all together, and one that is removed makes room', () => {
  const files = new OwnFiles();
  const whole = 'x'.repeat(MOST_TEXT_BYTES);
  assert.equal(files.write(`${HOME}/a`, `${whole}x`), false);
  const written = Array.from({ length: 100 }, (_, i) => files.write(`${HOME}/d/${i}`, whole));
  assert.equal(written.filter(Boolean).length, 32);
  assert.equal(files.write(`${HOME}/d/0`, whole), true, 'a file takes its own place again');
  files.remove(`${HOME}/d/0`);
  assert.equal(files.write(`${HOME}/e`, whole), true);
  files.remove(`${HOME}/d`);
  assert.deepEqual(files.files.map(({ path }) => path), [`${HOME}/e`]);
});

test('a user may write below the home folder only', () => {
  assert.deepEqual([`${HOME}/a`, HOME, '/etc/passwd', `${HOME}x/a`].map(mayWrite), [true, false, false, false]);
});
