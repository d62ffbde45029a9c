// The tree of frames: where one frame is in another, now and then, and trees that are none.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compose, fromRollPitchYaw, inverse, IDENTITY, readPose, readQuaternion, rotate, toRollPitchYaw } from '../../../runtime/site/ui/model/transform.ts';
import type { Transform, Vector } from '../../../runtime/site/ui/model/transform.ts';
import { TransformTree } from '../../../runtime/site/ui/model/transform_tree.ts';

const quarter = fromRollPitchYaw(0, 0, Math.PI / 2);
const by = (x: number, y = 0, z = 0, rotation = IDENTITY.rotation): Transform => ({ translation: [x, y, z], rotation });

function near(found: Vector, wanted: Vector): void {
  for (const [index, part] of wanted.entries())
    assert.ok(Math.abs((found[index] ?? NaN) - part) < 1e-9, `${found.join()} is not ${wanted.join()}`);
}

function place(tree: TransformTree, target: string, source: string, stamp?: number): Vector {
  const found = tree.lookup(target, source, stamp);
  return found.kind === 'found' ? found.transform.translation : assert.fail(found.kind);
}

function message(parent: string, child: string, x: number, sec = 1, w = 1): unknown {
  return {
    transforms: [{
      header: { stamp: { sec, nanosec: 0 }, frame_id: parent },
      child_frame_id: child,
      transform: { translation: { x, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w } },
    }],
  };
}

test('rotations turn points, and there and back is nothing', () => {
  near(rotate(quarter, [1, 0, 0]), [0, 1, 0]);
  const pose = by(1, 2, 3, fromRollPitchYaw(0.3, -0.7, 2));
  near(compose(pose, inverse(pose)).translation, [0, 0, 0]);
  near(toRollPitchYaw(pose.rotation), [0.3, -0.7, 2]);
});

test('a frame is found through its parents, up and down', () => {
  const tree = new TransformTree();
  tree.add('map', 'odom', by(10), 1, false);
  tree.add('odom', 'base', by(1, 0, 0, quarter), 1, false);
  tree.add('base', 'laser', by(0.5), 0, true);
  near(place(tree, 'map', 'laser'), [11, 0.5, 0]);
  near(place(tree, 'laser', 'map'), [-0.5, 11, 0]);
  near(place(tree, 'laser', 'laser'), [0, 0, 0]);
  tree.add('odom', 'camera', by(0, 3), 1, false);
  near(place(tree, 'camera', 'laser'), [1, -2.5, 0]);
  const places = tree.places('camera');
  assert.deepEqual([...places.keys()].sort(), ['base', 'camera', 'laser', 'map', 'odom']);
  near(places.get('laser')?.translation ?? assert.fail(), [1, -2.5, 0]);
  assert.deepEqual(tree.roots(), ['map']);
  assert.deepEqual(tree.views().map(({ name, parent, isStatic }) => [name, parent, isStatic]), [
    ['base', 'odom', false],
    ['camera', 'odom', false],
    ['laser', 'base', true],
    ['map', null, true],
    ['odom', 'map', false],
  ]);
});

test('at a time, a frame is between the transforms around it', () => {
  const tree = new TransformTree();
  tree.add('odom', 'base', by(0), 100, false);
  tree.add('odom', 'base', by(4, 0, 0, quarter), 102, false);
  tree.add('odom', 'base', by(1), 101, false); // late
  near(place(tree, 'odom', 'base', 100.5), [0.5, 0, 0]);
  near(place(tree, 'odom', 'base', 101.5), [2.5, 0, 0]);
  near(place(tree, 'odom', 'base', 50), [0, 0, 0]);
  near(place(tree, 'odom', 'base', 500), [4, 0, 0]);
  near(place(tree, 'odom', 'base'), [4, 0, 0]);
  const found = tree.lookup('odom', 'base', 101.5);
  near(toRollPitchYaw(found.kind === 'found' ? found.transform.rotation : assert.fail()), [0, 0, Math.PI / 4]);
});

test('only what moves is told, the past is bounded, and a clock set back begins anew', () => {
  const tree = new TransformTree();
  assert.equal(tree.addMessage(message('odom', '/base', 1), false), true);
  assert.equal(tree.addMessage(message('/odom', 'base', 1, 2), false), false);
  assert.equal(tree.addMessage(message('odom', 'base', 2, 3), false), true);
  for (let i = 0; i < 5000; i += 1) tree.add('odom', 'base', by(i), 4 + i * 0.01, false);
  const [base] = tree.views();
  assert.ok(base !== undefined && base.count <= 1064 + 64 && base.count >= 900, String(base?.count));
  assert.equal(tree.newest, 4 + 49.99);
  tree.add('odom', 'base', by(7), 5, false);
  assert.equal(tree.views()[0]?.count, 1);
  assert.equal(tree.newest, 5);
  tree.clear();
  assert.deepEqual(tree.views(), []);
});

test('loops, trees apart and frames that nobody knows are told', () => {
  const tree = new TransformTree();
  tree.add('c', 'b', by(1), 1, false);
  tree.add('a', 'c', by(1), 1, false);
  tree.add('b', 'a', by(1), 1, false);
  tree.add('a', 'hand', by(1), 1, false);
  assert.deepEqual(tree.lookup('a', 'hand'), { kind: 'loop', frame: 'hand' });
  assert.deepEqual(tree.loops(), [['a', 'b', 'c']]);
  assert.equal(tree.places('hand').size, 0);
  assert.deepEqual(tree.roots(), []);
  tree.add('map', 'odom', by(1), 1, false);
  tree.add('world', 'wall', by(1), 1, false);
  assert.deepEqual(tree.lookup('map', 'wall'), { kind: 'apart', roots: ['map', 'world'] });
  assert.deepEqual(tree.lookup('map', 'nobody'), { kind: 'unknown', frame: 'nobody' });
  assert.deepEqual(tree.lookup('nobody', 'nobody'), { kind: 'unknown', frame: 'nobody' });
  // A frame that goes to another parent leaves no root behind that nothing hangs on.
  tree.add('map', 'wall', by(1), 2, false);
  assert.deepEqual(tree.roots(), ['map']);
  assert.equal(tree.lookup('map', 'wall').kind, 'found');
  tree.add('map', 'a', by(1), 2, false);
  assert.deepEqual(tree.loops(), []);
});

test('what is not a transform is refused', () => {
  const tree = new TransformTree();
  const refused: readonly unknown[] = [
    message('odom', 'base', NaN),
    message('odom', 'base', Infinity),
    message('odom', 'base', 1, 1, 0),
    message('', 'base', 1),
    message('odom', '', 1),
    message('base', '/base', 1),
    message('odom', 'x'.repeat(300), 1),
    { transforms: [null] },
    { transforms: [{}] },
  ];
  for (const one of refused) assert.equal(tree.addMessage(one, false), false);
  assert.equal(tree.refused, refused.length);
  for (const one of [null, undefined, 7, {}, { transforms: 'no' }]) assert.equal(tree.addMessage(one, true), false);
  assert.deepEqual(tree.views(), []);
  for (let i = 0; i < 6000; i += 1) tree.add(`f${i}`, `f${i + 1}`, by(1), 1, false);
  assert.ok(tree.views().length <= 5001);
  near(place(tree, 'f0', 'f5000'), [5000, 0, 0]);
  assert.deepEqual(tree.loops(), []);
  near(tree.places('f5000').get('f0')?.translation ?? assert.fail(), [-5000, 0, 0]);
});

test('poses that nobody turned are upright', () => {
  const zero = { x: 0, y: 0, z: 0, w: 0 };
  assert.deepEqual(readPose({ position: { x: 1, y: 2, z: 3 }, orientation: zero }), by(1, 2, 3));
  assert.deepEqual(readQuaternion({ x: 0, y: 0, z: 0, w: 2 }, null), [0, 0, 0, 1]);
  assert.equal(readQuaternion({ x: 0, y: 0, z: 0, w: NaN }, IDENTITY.rotation), null);
  assert.equal(readPose({ position: { x: 1 }, orientation: zero }), null);
});
