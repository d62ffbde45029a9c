// The page's hand on a stepped run: who gets a turn, and when time stands.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { BusParticipant } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker, steppedBus } from '../../../runtime/site/bus/broker.ts';
import { SteppedTime } from '../../../runtime/site/bus/stepped_time.ts';

const beginNs = 1e9;
const ms = 1e6;

function steppedRun() {
  const broker = new SharedBroker({ ...steppedBus(3), ceiling: 64 << 20 });
  const { conductor, bus } = broker;
  const participant = broker.admit()?.participant;
  assert.ok(conductor !== undefined && participant !== undefined);
  return {
    broker,
    conductor,
    participant,
    rest: (untilNs: number): void => broker.rests(participant, { untilNs, token: undefined, stops: 0 }),
    turns: (): number => Atomics.load(bus.i32, bus.participantWord(participant) + BusParticipant.turn),
    now: (): number => broker.link.clock.steadyNs() - beginNs,
  };
}

test('a stepped run ends with its time though every node waits for ever', () => {
  const { broker, conductor, rest, now } = steppedRun();
  let ended = 0;
  conductor.runUntil(5000 * ms, () => {
    ended += 1;
  });
  assert.equal(ended, 0);
  rest(Infinity);
  assert.equal(ended, 1);
  assert.equal(now(), 5000 * ms);
  broker.close();
});

test('time of a stepped run passes when nobody is left, too', () => {
  const { broker, conductor, participant, now } = steppedRun();
  let ended = 0;
  conductor.runUntil(20 * ms, () => {
    ended += 1;
  });
  assert.equal(ended, 0);
  broker.end(participant);
  assert.deepEqual([ended, now()], [1, 20 * ms]);
  const time = new SteppedTime(broker, conductor);
  time.step(30 * ms);
  assert.deepEqual([now(), time.view().state], [30 * ms, 'paused']);
  time.close();
  broker.close();
});

test('what is to be done after a time of a stepped run is done at that time, before anybody goes on', () => {
  const { broker, conductor, participant, rest, turns, now } = steppedRun();
  const begun: number[] = [];
  let place: number | undefined;
  broker.after(10, () => {
    begun.push(now());
    place = broker.admit()?.participant;
  });
  broker.after(5, () => assert.fail('it was taken back'))();
  conductor.runUntil(20 * ms, () => undefined);
  rest(beginNs + 10 * ms);
  assert.deepEqual([begun, turns(), now()], [[10 * ms], 0, 10 * ms]);
  assert.ok(place !== undefined && place !== participant);
  broker.rests(place, { untilNs: Infinity, token: undefined, stops: 0 });
  assert.deepEqual([begun, turns()], [[10 * ms], 1]);
  broker.close();
});

test('time of a stepped page is held at first, and goes in steps that end when all rest', () => {
  const { broker, conductor, rest, turns, now } = steppedRun();
  const time = new SteppedTime(broker, conductor);
  const told: string[] = [];
  time.onChange(({ state }) => told.push(state));
  rest(beginNs + 30 * ms);
  assert.equal(time.view().state, 'paused');
  time.step(20 * ms);
  assert.deepEqual([turns(), now()], [0, 20 * ms]);
  time.step(20 * ms);
  assert.deepEqual([turns(), now(), time.view().state], [1, 30 * ms, 'stepping']);
  rest(beginNs + 70 * ms);
  assert.deepEqual([turns(), now(), time.view().state], [1, 40 * ms, 'paused']);
  // Steps that are asked for while one is under way add up.
  time.step(30 * ms);
  time.step(10 * ms);
  rest(Infinity);
  assert.deepEqual([turns(), now(), time.view().state], [2, 80 * ms, 'paused']);
  assert.equal(told.at(-1), 'paused');
  assert.throws(() => time.step(0), RangeError);
  assert.throws(() => time.setRate(0), RangeError);
  time.close();
  broker.close();
});

test('time of a stepped page runs until it is held again', async () => {
  const { broker, conductor, rest, turns } = steppedRun();
  const time = new SteppedTime(broker, conductor);
  rest(beginNs + 30 * ms);
  time.setRate(10);
  time.resume();
  assert.equal(time.view().state, 'running');
  while (turns() === 0) await new Promise((resolve) => void setImmediate(resolve));
  time.pause();
  rest(Infinity);
  assert.equal(time.view().state, 'paused');
  time.close();
  broker.close();
});
