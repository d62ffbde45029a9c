// The last error of a node in one file, from what it printed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { nodeTrouble } from '../../../runtime/site/ui/model/node_trouble.ts';

const path = 'lib/lab_py/talk.py';
const frame = (line: number, file = path): string => `  File "/ros/${file}", line ${line}, in main`;

test('the innermost line in the file and the words of the exception', () => {
  const lines = [
    'Traceback (most recent call last):',
    frame(12),
    '    greet()',
    frame(5),
    '    return name',
    '           ^^^^',
    frame(90, 'lib/rclpy/node.py'),
    '    x()',
    "NameError: name 'name' is not defined",
    '[INFO] [1.0] [talk]: after it',
  ];
  assert.deepEqual(nodeTrouble(lines, path), { line: 5, words: "NameError: name 'name' is not defined" });
  assert.equal(nodeTrouble(lines, 'lib/lab_py/other.py'), null);
});

test('a syntax error has no frames, and a bare exception has no words', () => {
  assert.deepEqual(nodeTrouble(['  File "/ros/lib/lab_py/talk.py", line 3', '    def broken(:', '               ^', 'SyntaxError: invalid syntax'], path), {
    line: 3,
    words: 'SyntaxError: invalid syntax',
  });
  assert.deepEqual(nodeTrouble(['Traceback (most recent call last):', frame(2), '    raise Odd', 'lab_py.errors.Odd'], path), {
    line: 2,
    words: 'lab_py.errors.Odd',
  });
});

test('a traceback that is cut short, and other lines, are no error', () => {
  assert.equal(nodeTrouble(['Traceback (most recent call last):', frame(2)], path), null);
  assert.equal(nodeTrouble(['I heard: [Hello World: 1]', 'ValueError: printed without a traceback'], path), null);
  assert.equal(nodeTrouble([frame(2), 'the file is fine, as it says itself'], path), null);
});
