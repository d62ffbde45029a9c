// The files that terminals of a page write: their limits, and the room that comes back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kMostTextBytes, mayWrite, OwnFiles } from '../../../runtime/site/ui/shell/own_files.ts';
import { kHome } from '../../../runtime/site/ui/shell/paths.ts';

test('files have a limit each and all together, and one that is removed makes room', () => {
  const files = new OwnFiles();
  const whole = 'x'.repeat(kMostTextBytes);
  assert.equal(files.write(`${kHome}/a`, `${whole}x`), false);
  const written = Array.from({ length: 100 }, (_, i) => files.write(`${kHome}/d/${i}`, whole));
  assert.equal(written.filter(Boolean).length, 32);
  assert.equal(files.write(`${kHome}/d/0`, whole), true, 'a file takes its own place again');
  files.remove(`${kHome}/d/0`);
  assert.equal(files.write(`${kHome}/e`, whole), true);
  files.remove(`${kHome}/d`);
  assert.deepEqual(files.files.map(({ path }) => path), [`${kHome}/e`]);
});

test('a user may write below the home folder only', () => {
  assert.deepEqual([`${kHome}/a`, kHome, '/etc/passwd', `${kHome}x/a`].map(mayWrite), [true, false, false, false]);
});
