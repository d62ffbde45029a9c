// Lines of all sources that have a text.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { searchSources } from '../../../runtime/site/ui/model/source_search.ts';

const files = [
  { file: 'a.py', text: 'import rclpy\r\n  node = rclpy.create_node("Robot")\n' },
  { file: 'b.py', text: 'robot = 1\nprint(robot, robot)\n' },
];
const told = (wanted: string): readonly string[] =>
  searchSources(files, wanted).hits.map(({ file, line, before, found, after }) => `${file}:${line} ${before}[${found}]${after}`);

test('every line that has it, once, in the order of the files', () => {
  assert.deepEqual(told('rclpy'), ['a.py:1 import [rclpy]', 'a.py:2 node = [rclpy].create_node("Robot")']);
  assert.deepEqual(told('robot'), ['a.py:2 node = rclpy.create_node("[Robot]")', 'b.py:1 [robot] = 1', 'b.py:2 print([robot], robot)']);
  assert.deepEqual(told('Robot'), ['a.py:2 node = rclpy.create_node("[Robot]")']);
  // Not an expression, and nothing that is not there.
  assert.deepEqual(told('r.clpy'), []);
  assert.deepEqual(told('  '), []);
});

test('long lines are cut around what is found, and long lists end', () => {
  const long = searchSources([{ file: 'c.py', text: `${'x'.repeat(500)}needle${'y'.repeat(500)}` }], 'needle').hits[0];
  assert.deepEqual([long?.before.length, long?.found, long?.after.length], [41, 'needle', 121]);
  const many = searchSources([{ file: 'd.py', text: 'a\n'.repeat(1000) }], 'a');
  assert.deepEqual([many.hits.length, many.more], [200, true]);
  // A letter that has two when it is small.
  assert.deepEqual(searchSources([{ file: 'e.py', text: '\u0130 = needle' }], 'needle').hits.map(({ line, after }) => [line, after]), [[1, '\u0130 = needle']]);
});
