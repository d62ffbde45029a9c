// The Tab key in the terminal.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { completeInput, expandTabs, readHistory } from '../../../runtime/site/ui/model/terminal_input.ts';

test('one choice is taken, several as far as they agree, then they are shown', () => {
  assert.deepEqual(completeInput('ros2 to', { word: 'to', start: 5, choices: ['topic'] }), { kind: 'line', line: 'ros2 topic ' });
  assert.deepEqual(completeInput('echo /tu', { word: '/tu', start: 5, choices: ['/turtle1/cmd_vel', '/turtle1/pose'] }), {
    kind: 'line',
    line: 'echo /turtle1/',
  });
  assert.deepEqual(completeInput('echo /t', { word: '/t', start: 5, choices: ['/ta', '/tb'] }), { kind: 'choices', choices: ['/ta', '/tb'] });
  assert.deepEqual(completeInput('x', { word: 'x', start: 0, choices: [] }), { kind: 'nothing' });
});

test('tabs reach the next eighth column', () => {
  assert.equal(expandTabs('\tmin: 1\tmax'), '        min: 1  max');
  assert.equal(expandTabs('plain'), 'plain');
});

test('what was typed before is read with care', () => {
  assert.deepEqual(readHistory('["a","b","c"]', 2), ['b', 'c']);
  assert.deepEqual(readHistory('["ros2 \\u001b[31m topic", 5, {"x": 1}]', 9), ['ros2  [31m topic']);
  assert.equal(readHistory(JSON.stringify(['x'.repeat(9000)]), 9)[0]?.length, 4096);
  for (const kept of [null, '', '{', '5', 'null', '{"lines": 1}']) assert.deepEqual(readHistory(kept, 9), [], String(kept));
});
