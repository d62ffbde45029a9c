// The joints of a robot description that can be set, where they are at first, and those that mimic others.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { jointPositions, readJoints, readJointState } from '../../../runtime/site/ui/model/joints.ts';

test('joints have their limits, zeros and those that they mimic', () => {
  const joints = readJoints(`<robot name="r">
    <joint name="turn" type="revolute"><limit lower="-1" upper="2"/></joint>
    <joint name="up" type="prismatic"><limit lower="0.2" upper="0.6"/></joint>
    <joint name="wheel" type="continuous"/><joint name="still" type="fixed"/><joint name="free" type="floating"/>
    <joint name="soft" type="revolute"><limit lower="-3" upper="3"/><safety_controller soft_lower_limit="-1.5" soft_upper_limit="1"/></joint>
    <joint name="finger" type="prismatic"><limit upper="1"/><mimic joint="up" multiplier="-2" offset="0.1"/></joint>
    <joint name="tip" type="prismatic"><limit upper="1"/><mimic joint="finger"/></joint>
    <joint name="wrong" type="revolute"><limit lower="2" upper="1"/></joint><joint type="revolute"/></robot>`) ?? assert.fail();
  assert.deepEqual(joints.map(({ name, least, most, zero }) => [name, least, most, zero]), [
    ['turn', -1, 2, 0],
    ['up', 0.2, 0.6, 0.4],
    ['wheel', -Math.PI, Math.PI, 0],
    ['soft', -1.5, 1, 0],
    ['finger', 0, 1, 0],
    ['tip', 0, 1, 0],
  ]);
  const rounded = (values: readonly number[]): readonly number[] => values.map((value) => Number(value.toFixed(6)) + 0);
  assert.deepEqual(rounded(jointPositions(joints, new Map())), [0, 0.4, 0, 0, -0.7, -0.7]);
  assert.deepEqual(rounded(jointPositions(joints, new Map([['up', 0.5], ['tip', 9], ['turn', 1]]))), [1, 0.5, 0, 0, -0.9, -0.9]);
});

test('what is not a robot has no joints, and mimics in a ring come to an end', () => {
  for (const wrong of ['', 'words', '<html/>', '<robot>', ' '.repeat(20_000_000)]) assert.equal(readJoints(wrong), null);
  const many = readJoints(`<robot>${Array.from({ length: 900 }, (_, i) => `<joint name="j${i}" type="continuous"/>`).join('')}</robot>`);
  assert.equal(many?.length, 500);
  const ring = readJoints(
    '<robot><joint name="a" type="continuous"><mimic joint="b"/></joint><joint name="b" type="continuous"><mimic joint="a" multiplier="1e300"/></joint></robot>',
  );
  assert.ok(jointPositions(ring ?? [], new Map([['a', 1]])).every(Number.isFinite));
});

test('positions are read from a joint state, whatever it lacks', () => {
  assert.deepEqual(readJointState({ name: ['a', 'b'], position: new Float64Array([1, -2]) }), [['a', 1], ['b', -2]]);
  assert.deepEqual(readJointState({ name: ['a', 'b', 'c'], position: [1, Number.NaN] }), [['a', 1]]);
  for (const wrong of [null, {}, { name: ['a'], position: [] }, { name: 'a', position: [1] }, { name: [7], position: [1] }, { name: ['a'] }])
    assert.deepEqual(readJointState(wrong), []);
});
