// The tree of frames as rows: order, depth, what is wrong with it, rates; and that hostile trees end.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { frameRate, frameRows } from '../../../runtime/site/ui/model/frame_rows.ts';
import { formatAge } from '../../../runtime/site/ui/model/quantities.ts';
import { IDENTITY } from '../../../runtime/site/ui/model/transform.ts';
import { TransformTree } from '../../../runtime/site/ui/model/transform_tree.ts';

function treeOf(...pairs: readonly (readonly [parent: string, child: string])[]): TransformTree {
  const tree = new TransformTree();
  for (const [parent, child] of pairs) tree.add(parent, child, IDENTITY, 1, false);
  return tree;
}

const words = (tree: TransformTree): readonly string[] =>
  frameRows(tree).rows.map(({ frame, depth, looped }) => `${'.'.repeat(depth)}${frame.name}${looped ? ' loop' : ''}`);

test('each frame stands below its parent, siblings by name', () => {
  const tree = treeOf(['base', 'laser'], ['map', 'odom'], ['odom', 'base'], ['base', 'arm'], ['arm', 'hand']);
  assert.deepEqual(words(tree), ['map', '.odom', '..base', '...arm', '....hand', '...laser']);
  assert.deepEqual(frameRows(tree).roots, ['map']);
  assert.deepEqual(frameRows(tree).loops, []);
});

test('several trees and rings of parents are told, and every frame has its row', () => {
  const tree = treeOf(['map', 'a'], ['world', 'b'], ['y', 'x'], ['x', 'y'], ['x', 'under']);
  assert.deepEqual(words(tree), ['map', '.a', 'world', '.b', 'x loop', '.under', '.y loop']);
  assert.deepEqual(frameRows(tree).roots, ['map', 'world']);
  assert.deepEqual(frameRows(tree).loops, [['x', 'y']]);
});

test('a chain of thousands and names of objects are rows like others', () => {
  const tree = treeOf(...Array.from({ length: 4000 }, (_, index) => [`f${index}`, `f${index + 1}`] as const));
  assert.equal(frameRows(tree).rows.at(-1)?.depth, 4000);
  assert.deepEqual(words(treeOf(['__proto__', 'constructor'])), ['__proto__', '.constructor']);
});

test('a rate is that of what is kept, until nothing comes', () => {
  const tree = new TransformTree();
  for (let i = 0; i <= 20; i += 1) tree.add('map', 'odom', IDENTITY, 100 + i / 10, false);
  tree.add('odom', 'base', IDENTITY, 100, true);
  const [base, , odom] = tree.views();
  assert.ok(base !== undefined && odom !== undefined && odom.name === 'odom');
  assert.ok(Math.abs(frameRate(odom, 102.5) - 10) < 1e-9);
  assert.equal(frameRate(odom, 106), 0);
  assert.equal(frameRate(base, 100), 0);
});

test('ages', () => {
  assert.deepEqual([-1, 0.0124, 0.9999, 1.25, 9.99, 75, Number.NaN].map(formatAge), ['0 ms', '12 ms', '1.0 s', '1.3 s', '9 s', '1:15', '\u2013']);
});
