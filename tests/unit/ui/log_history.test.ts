// The log begins with what consoles have: lines of ROS 2's form, in order, read piece by piece; what /rosout tells once more
// is the same line. It holds its newest lines.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { type LogEntry, LogHistory } from '../../../runtime/site/ui/model/log_history.ts';
import type { ConsoleLine } from '../../../runtime/site/contract/session.ts';

const said = (time: number, text: string, level?: ConsoleLine['level']): ConsoleLine => ({
  time,
  stream: 'stderr',
  text,
  ...(level === undefined ? {} : { level }),
});
const logged = (time: number, node = 'n', text = 'x'): ConsoleLine => said(time, `[INFO] [${time}.0] [${node}]: ${text}`, 'INFO');
const message = (time: number, text: string): LogEntry => ({ node: 'a', place: 'File "a.cpp", line 1', line: said(time, text) });
const times = (entries: readonly LogEntry[]): readonly number[] => entries.map(({ line }) => line.time);

test('lines of two consoles, in the order of their times, without what is printed only', () => {
  const log = new LogHistory(100, [
    [said(1, '[INFO] [1.000000001] [talker]: begin', 'INFO'), said(2, 'printed'), said(4, '[WARN] [4.0] [robot.arm]: late', 'WARN')],
    [said(3, '[INFO] [3.000000000] [listener]: heard', 'INFO'), said(5, 'INFO of another form', 'INFO')],
  ]);
  log.older(100);
  assert.deepEqual(log.entries.map(({ node, line }) => [node, line.time]), [['talker', 1], ['listener', 3], ['robot.arm', 4]]);
  assert.equal(log.done, true);
});

test('what was logged is read from its end on, each line once, until so much is there', () => {
  const consoles = [0, 1, 2].map((k) => Array.from({ length: 1000 }, (_, i) => logged(3 * i + k)));
  const log = new LogHistory(2500, consoles);
  assert.deepEqual(times(log.older(4)), [2996, 2997, 2998, 2999]);
  assert.equal(log.done, false);
  let pieces = 1;
  for (; !log.done; pieces += 1) log.older(400);
  assert.equal(pieces, 1 + Math.ceil(2496 / 400));
  assert.deepEqual(times(log.entries), Array.from({ length: 2500 }, (_, i) => 500 + i));
  assert.deepEqual(log.older(400), []);
});

test('a message that a console had is known, once, by its first line', () => {
  const log = new LogHistory(100, [[said(1, '[INFO] [1.0] [a]: one', 'INFO'), said(2, '[INFO] [2.0] [a]: two', 'INFO')]]);
  log.older(100);
  assert.equal(log.take(message(9, '[INFO] [1.0] [a]: one')), 'placed');
  assert.equal(log.take(message(9, '[INFO] [2.0] [a]: two\nand more')), 'longer');
  assert.deepEqual(log.entries.map(({ place, line }) => [place, line.text]), [
    ['File "a.cpp", line 1', '[INFO] [1.0] [a]: one'],
    ['File "a.cpp", line 1', '[INFO] [2.0] [a]: two\nand more'],
  ]);
  assert.equal(log.take(message(9, '[INFO] [2.0] [a]: two\nand more')), 'new');
  assert.equal(log.take(message(9, '[INFO] [3.0] [a]: three')), 'new');
  assert.equal(log.count, 4);
});

test('what /rosout repeats before its console is read stands at its time, once, whether a console has it or none', () => {
  const log = new LogHistory(100, [Array.from({ length: 10 }, (_, i) => logged(i))]);
  log.older(3);
  assert.equal(log.take(message(5, '[INFO] [5.0] [n]: x')), 'held');
  assert.equal(log.take(message(3.5, '[INFO] [3.5] [far]: of another tab')), 'held');
  assert.equal(log.take(message(-1, '[INFO] [0.5] [far]: first of all')), 'held');
  assert.deepEqual(times(log.entries), [7, 8, 9]);
  log.older(4);
  assert.deepEqual(times(log.entries), [3, 3.5, 4, 5, 6, 7, 8, 9]);
  log.older(100);
  assert.deepEqual(times(log.entries), [-1, 0, 1, 2, 3, 3.5, 4, 5, 6, 7, 8, 9]);
  assert.equal(log.entries.filter(({ place }) => place !== '').length, 3);
});

test('what is cleared does not come back, neither from the consoles nor by /rosout', () => {
  const log = new LogHistory(100, [[logged(1), logged(2), logged(3)]]);
  log.older(2);
  log.take(message(1, '[INFO] [1.5] [n]: held'));
  log.clear();
  assert.equal(log.done, true);
  assert.deepEqual(log.older(100), []);
  assert.equal(log.take(message(3, '[INFO] [3.0] [n]: x')), 'placed');
  assert.equal(log.count, 0);
  assert.equal(log.take(message(4, '[INFO] [4.0] [n]: x')), 'new');
  assert.deepEqual(times(log.entries), [4]);
});

test('the newest hundred thousand stay, and each line moves seldom', () => {
  const log = new LogHistory(100_000, [[logged(0)]]);
  log.older(10);
  for (let i = 1; i <= 350_000; i += 1) log.take(message(i, `[INFO] [${i}.0] [n]: x`));
  const kept = log.entries;
  assert.deepEqual([kept.length, kept[0]?.line.time, kept.at(-1)?.line.time], [100_000, 250_001, 350_000]);
  assert.equal(log.take(message(0, '[INFO] [0.0] [n]: x')), 'new', 'what has fallen off is forgotten');
});
