// Statuses of /diagnostics: the newest of each name, stale by the site's time; values that are not a status do no harm.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { countLevels, Diagnostics } from '../../../runtime/site/ui/model/diagnostics.ts';

const words = (board: Diagnostics, now: number): readonly string[] => board.rows(now).map(({ name, level, told }) => `${name} ${level} ${told}`);

test('the newest status of each name, the worst first, stale after 5 s', () => {
  const board = new Diagnostics();
  board.add({ status: [{ level: 0, name: 'b' }, { level: 2, name: 'c' }, { level: 3, name: 'd' }] }, 100);
  board.add({ status: [{ level: 1, name: 'a' }, { level: 1, name: 'b' }] }, 104);
  assert.deepEqual(words(board, 105), ['c error error', 'a warn warn', 'b warn warn', 'd stale stale']);
  assert.deepEqual(words(board, 105.1), ['a warn warn', 'b warn warn', 'c stale error', 'd stale stale']);
  assert.deepEqual(countLevels(board.rows(105.1)), { error: 0, warn: 2, stale: 2, ok: 0 });
  // A clock that was set back makes nothing stale.
  assert.equal(board.rows(3)[0]?.level, 'error');
});

test('what is no status does no harm', () => {
  const board = new Diagnostics();
  for (const message of [null, 7, {}, { status: 'x' }, { status: [null, 7, { name: 5, level: 'x', values: [null, { key: {} }] }] }]) board.add(message, 1);
  assert.deepEqual(words(board, 1), [' error error']);
  board.add({ status: [{ name: '__proto__', level: 200, message: 'x'.repeat(10_000), values: Array.from({ length: 500 }, () => ({ key: 'k', value: 'v' })) }] },
    1);
  const [, last] = board.rows(1);
  assert.equal(last?.told, 'error');
  assert.equal(last?.message.length, 2000);
  assert.equal(last?.values.length, 200);
  assert.equal(last?.more, 300);
  for (let i = 0; i < 3000; i += 1) board.add({ status: [{ name: `n${i}`, level: 0 }] }, 1);
  assert.equal(board.rows(1).length, 2000);
  assert.equal(board.leftOut, 1002);
});
