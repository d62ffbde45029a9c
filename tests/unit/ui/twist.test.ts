// Driving by hand: what keys, a round pad and a gamepad mean, the messages, and whom the graph offers to be driven.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { driveTopics, isRest, keyStick, REST, padStick, pointStick, sumOf, twistOf } from '../../../runtime/site/ui/model/twist.ts';
import type { GraphEndpointView, GraphNodeView } from '../../../runtime/site/contract/session.ts';

test('what is held is added up, within the maximum', () => {
  assert.deepEqual(sumOf([keyStick('KeyW'), keyStick('ArrowUp'), keyStick('ArrowRight')].map((stick) => stick ?? REST)), { ahead: 1, turn: -1 });
  assert.ok(isRest(sumOf([{ ahead: 1, turn: 0 }, { ahead: -1, turn: 0 }])));
  assert.ok(isRest(sumOf([])));
  assert.equal(keyStick('KeyX'), undefined);
});

test('a pad is round, and still in its middle', () => {
  assert.deepEqual(pointStick(0.05, -0.05), REST);
  assert.deepEqual(pointStick(0, -0.5), { ahead: 0.5, turn: 0 });
  assert.deepEqual(pointStick(-3, 0), { ahead: 0, turn: 1 });
  const { ahead, turn } = pointStick(3, 4);
  assert.ok(Math.abs(ahead + 0.8) < 1e-9 && Math.abs(turn + 0.6) < 1e-9);
  assert.deepEqual(pointStick(NaN, 0), REST);
});

test('a gamepad: both sticks and the cross, and a stick that does not quite come to rest', () => {
  const none = { pressed: false };
  const buttons = (...down: readonly number[]) => Array.from({ length: 17 }, (_, index) => ({ pressed: down.includes(index) }));
  assert.deepEqual(padStick({ axes: [0.1, -0.14, 0.1, 0], buttons: buttons() }), REST);
  assert.deepEqual(padStick({ axes: [0, -1, -1, 0], buttons: buttons() }), { ahead: 1, turn: 1 });
  assert.deepEqual(padStick({ axes: [1, 0, 1], buttons: [none] }), { ahead: 0, turn: -1 });
  assert.deepEqual(padStick({ axes: [], buttons: buttons(13, 15) }), { ahead: -1, turn: -1 });
  assert.deepEqual(padStick({ axes: [], buttons: [] }), REST);
});

test('the message has the limits, and a stamp when it is asked for', () => {
  const limits = { linear: 2, angular: 3 };
  const twist = { linear: { x: 1, y: 0, z: 0 }, angular: { x: 0, y: 0, z: -3 } };
  assert.deepEqual(twistOf({ ahead: 0.5, turn: -1 }, limits), twist);
  assert.deepEqual(twistOf({ ahead: 0.5, turn: -1 }, limits, { nowMs: 1500, frame: 'base' }), {
    header: { stamp: { sec: 1, nanosec: 500_000_000 }, frame_id: 'base' },
    twist,
  });
});

test('cmd_vel comes first; what only the page and hidden nodes hear is not offered', () => {
  const heard = (name: string, type = 'geometry_msgs/msg/Twist'): GraphEndpointView => ({
    name,
    type,
    hash: '',
    gid: '',
    qos: {
      reliability: 'reliable',
      durability: 'volatile',
      history: 'keep_last',
      depth: 10,
      liveliness: 'automatic',
      deadlineNs: 0,
      lifespanNs: 0,
      leaseNs: 0,
    },
  });
  const node = (name: string, ...subscriptions: readonly GraphEndpointView[]): GraphNodeView => ({
    name,
    process: undefined,
    publishers: [],
    subscriptions,
    services: [],
    clients: [],
    actionServers: [],
    actionClients: [],
  });
  const nodes = [
    node('/_ros2wasm_page', heard('/a/cmd_vel')),
    node('/one', heard('/a/twist'), heard('/_hidden/cmd_vel'), heard('/words', 'std_msgs/msg/String')),
    node('/two', heard('/z/cmd_vel', 'geometry_msgs/msg/TwistStamped'), heard('/a/twist')),
  ];
  assert.deepEqual(driveTopics({ nodes }), [{ name: '/z/cmd_vel', stamped: true }, { name: '/a/twist', stamped: false }]);
});
