// The Tab key in the terminal.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { completeInput, expandTabs } from '../../../runtime/ui/model/terminal_input.ts';

test('one choice is taken, several as far as they agree, then they are shown', () => {
  assert.deepEqual(completeInput('ros2 to', { word: 'to', start: 5, choices: ['topic'] }), { kind: 'line', line: 'ros2 topic ' });
  assert.deepEqual(completeInput('echo /tu', { word: '/tu', start: 5, choices: ['/turtle1/cmd_vel', '/turtle1/pose'] }), { kind: 'line', line: 'echo /turtle1/' });
  assert.deepEqual(completeInput('echo /t', { word: '/t', start: 5, choices: ['/ta', '/tb'] }), { kind: 'choices', choices: ['/ta', '/tb'] });
  assert.deepEqual(completeInput('x', { word: 'x', start: 0, choices: [] }), { kind: 'nothing' });
});

test('tabs reach the next eighth column', () => {
  assert.equal(expandTabs('\tmin: 1\tmax'), '        min: 1  max');
  assert.equal(expandTabs('plain'), 'plain');
});
