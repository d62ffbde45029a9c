// The log begins with what consoles have: lines of ROS 2's form, in order; what /rosout tells once more is the same line.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { KnownLines, loggedBefore } from '../../../runtime/ui/model/log_history.ts';
import type { ConsoleLine } from '../../../runtime/wasm_js/session.ts';

const said = (time: number, text: string, level?: ConsoleLine['level']): ConsoleLine =>
  ({ time, stream: 'stderr', text, ...(level === undefined ? {} : { level }) });

test('lines of two consoles, in the order of their times, without what is printed only', () => {
  const entries = loggedBefore([
    [said(1, '[INFO] [1.000000001] [talker]: begin', 'INFO'), said(2, 'printed'), said(4, '[WARN] [4.0] [robot.arm]: late', 'WARN')],
    [said(3, '[INFO] [3.000000000] [listener]: heard', 'INFO'), said(5, 'INFO of another form', 'INFO')],
  ]);
  assert.deepEqual(entries.map(({ node, line }) => [node, line.time]), [['talker', 1], ['listener', 3], ['robot.arm', 4]]);
  const long = Array.from({ length: 5000 }, (_, i) => said(i, `[INFO] [${i}.0] [n]: x`, 'INFO'));
  assert.deepEqual([loggedBefore([long]).length, loggedBefore([long])[0]?.line.time], [2000, 3000]);
});

test('a message that a console had is known, once, by its first line', () => {
  const before = loggedBefore([[said(1, '[INFO] [1.0] [a]: one', 'INFO'), said(2, '[INFO] [2.0] [a]: two', 'INFO')]]);
  const known = new KnownLines(before);
  const message = (text: string) => ({ node: 'a', place: 'File "a.cpp", line 1', line: said(9, text) });
  assert.equal(known.take(message('[INFO] [2.0] [a]: two\nand more')), before[1]);
  assert.equal(known.take(message('[INFO] [2.0] [a]: two\nand more')), undefined);
  assert.equal(known.take(message('[INFO] [3.0] [a]: three')), undefined);
});
