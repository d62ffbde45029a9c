// Deadlines and leases as functions of time.

// Compatibility, works: QoS on both links: every offer against every request, lifespan, deadlines,
// liveliness (automatic, manual by topic, lease; a node that dies is noticed at once), lost
// messages, with counts on both sides

// Compatibility, differs: a deadline that a subscription asks for -> counted for the topic, not
// for each publisher; on a page without shared memory a message counts when the node waits, so a
// long callback misses deadlines

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EndpointKind, StatusKind } from '../../../runtime/protocol/generated/constants.ts';
import type { EndpointRecord } from '../../../runtime/site/bus/graph.ts';
import { defaultQos, type EndpointQos, incompatiblePolicy } from '../../../runtime/site/contract/qos.ts';
import { LocalCells, Timing } from '../../../runtime/site/bus/timing.ts';
import { qosCombinations } from '../../conformance/links/qos_table.ts';

const never = Infinity;

function record(kind: EndpointKind, qos: Partial<EndpointQos>, key = 1): EndpointRecord {
  return {
    key,
    participant: 1,
    nodeKey: 1,
    kind,
    name: '/a',
    type: 'p/msg/T',
    hash: '',
    qos: { ...defaultQos, ...qos },
    flags: 0,
    gid: new Int32Array(4),
  };
}

test('every combination of policies fits or is blamed as the table says', () => {
  let count = 0;
  for (const { offer, ask, blamed } of qosCombinations()) {
    assert.equal(incompatiblePolicy({ ...defaultQos, ...offer }, { ...defaultQos, ...ask }), blamed);
    count += 1;
  }
  assert.equal(count, 4 * 4 * 9 * 4 * 9);
});

test('a deadline is missed once for every whole period since the last sample', () => {
  const timing = new Timing(record(EndpointKind.publisher, { deadline: 10n }), new LocalCells(100));
  assert.equal(timing.deadlinesMissed(1000), 0);
  timing.wrote(1000);
  assert.deepEqual([1009, 1010, 1019, 1020, 1055].map((now) => timing.deadlinesMissed(now)), [0, 1, 1, 2, 5]);
  timing.wrote(1055);
  assert.deepEqual([1055, 1064, 1065].map((now) => timing.deadlinesMissed(now)), [5, 5, 6]);
});

test('a subscription without writers misses nothing until the next sample', () => {
  const timing = new Timing(record(EndpointKind.subscription, { deadline: 10n }), new LocalCells(100));
  timing.received(1000);
  timing.unmatch(5);
  assert.equal(timing.deadlinesMissed(1020), 2);
  timing.pause(1025);
  assert.equal(timing.deadlinesMissed(5000), 2);
  timing.received(6000);
  assert.equal(timing.deadlinesMissed(6010), 3);
});

test('a deadline runs on from the sample of a writer that came after the last one had gone', () => {
  const timing = new Timing(record(EndpointKind.subscription, { deadline: 10n }), new LocalCells(100));
  timing.received(1030);
  timing.pause(1025);
  assert.deepEqual([1039, 1040, 1055].map((now) => timing.deadlinesMissed(now)), [0, 1, 2]);
});

test('a writer loses its liveliness once until it asserts it', () => {
  const timing = new Timing(record(EndpointKind.publisher, { liveliness: 3, lease: 10n }), new LocalCells(100));
  assert.deepEqual([109, 110, 500].map((now) => timing.livelinessLost(now)), [0, 1, 1]);
  assert.equal(timing.assert(500), true);
  assert.equal(timing.assert(505), false);
  assert.deepEqual([514, 515].map((now) => timing.livelinessLost(now)), [1, 2]);
  const automatic = new Timing(record(EndpointKind.publisher, { lease: 10n }), new LocalCells(100));
  assert.equal(automatic.livelinessLost(1e9), 0);
  assert.equal(automatic.ticks, false);
});

test('time wakes only for a status that somebody reads', () => {
  const cells = new LocalCells(100);
  const timing = new Timing(record(EndpointKind.publisher, { deadline: 10n, liveliness: 3, lease: 25n }), cells);
  timing.wrote(1000);
  assert.equal(timing.nextChange(1000), never);
  assert.equal(timing.changed(2000), false);
  timing.watch(StatusKind.offeredDeadlineMissed);
  assert.deepEqual([1000, 1009, 1010, 1011].map((now) => timing.nextChange(now)), [1010, 1010, 1020, 1020]);
  timing.watch(StatusKind.livelinessLost);
  assert.deepEqual([1020, 1025].map((now) => timing.nextChange(now)), [1025, 1030]);
  assert.deepEqual([1025, 1026, 1030].map((now) => timing.changed(now)), [true, false, true]);
});

test('a subscription looks after the leases of its writers', () => {
  const timing = new Timing(record(EndpointKind.subscription, {}), new LocalCells(0));
  timing.watch(StatusKind.livelinessChanged);
  assert.equal(timing.ticks, false);
  const life = new LocalCells(100);
  timing.match(record(EndpointKind.publisher, { liveliness: 3, lease: 10n }, 7), life);
  timing.match(record(EndpointKind.publisher, { lease: 10n }, 8), new LocalCells(100));
  assert.equal(timing.ticks, true);
  assert.deepEqual([timing.nextChange(100), timing.lapsedWriters(109), timing.lapsedWriters(110)], [110, 0, 1]);
  assert.equal(timing.nextChange(110), never);
  life.exchangeAsserted(200);
  assert.equal(timing.lapsedWriters(205), 0);
  timing.unmatch(7);
  assert.equal(timing.ticks, false);
});
