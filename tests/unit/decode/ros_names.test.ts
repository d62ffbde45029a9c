// Names of ROS 2: what is a full name, what relative names mean, which names are hidden.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { checkFullName, expandName, fullTypeName, isHiddenName, splitNodeName } from '../../../runtime/site/decode/ros_names.ts';

test('full names are checked in the words of ROS 2', () => {
  for (const good of ['/chatter', '/a/b_1/C', '/_hidden', '/turtle1/cmd_vel']) assert.equal(checkFullName(good), undefined, good);
  const problems: readonly (readonly [string, RegExp, number])[] = [
    ['', /must not be empty/, 0],
    ['chatter', /must lead with a '\/'/, 0],
    ['/chatter/', /must not end with/, 8],
    ['/a b', /other than alphanumerics/, 2],
    ['/a//b', /repeated '\/'/, 3],
    ['/a/1b', /starts with a number/, 3],
    [`/${'a'.repeat(247)}`, /should not exceed '247'/, 247],
  ];
  for (const [name, what, place] of problems) {
    const problem = checkFullName(name);
    assert.match(problem?.what ?? '', what, name);
    assert.equal(problem?.place, place, name);
  }
});

test('relative and private names', () => {
  assert.equal(expandName('chatter', 'page'), '/chatter');
  assert.equal(expandName('/chatter', 'page', '/lab'), '/chatter');
  assert.equal(expandName('chatter', 'page', '/lab'), '/lab/chatter');
  assert.equal(expandName('~/chatter', 'page', '/lab'), '/lab/page/chatter');
  assert.equal(expandName('~', 'page'), '/page');
  assert.deepEqual(splitNodeName('/lab/a/node'), { namespace: '/lab/a', name: 'node' });
  assert.deepEqual(splitNodeName('/node'), { namespace: '/', name: 'node' });
});

test('hidden names', () => {
  assert.equal(isHiddenName('/fibonacci/_action/feedback'), true);
  assert.equal(isHiddenName('/_ros2cli_1'), true);
  assert.equal(isHiddenName('/a_b/c'), false);
});

test('names of types', () => {
  assert.equal(fullTypeName('std_msgs/String'), 'std_msgs/msg/String');
  assert.equal(fullTypeName('std_msgs/msg/String'), 'std_msgs/msg/String');
  assert.equal(fullTypeName('example_interfaces/AddTwoInts', 'srv'), 'example_interfaces/srv/AddTwoInts');
  for (const wrong of ['String', 'a/b/c/d', 'std_msgs/foo/String', 'std-msgs/String', '', '/']) assert.equal(fullTypeName(wrong), undefined, wrong);
});
