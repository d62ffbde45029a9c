// A soak is flat only when every stream went on.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gather, judge, type SoakReport, type SoakSample, type StreamSample } from '../../bench/soak_verdict.ts';

const streams = [{ soak: '/small', due: 1000 }, { soak: '/large', due: 20 }];

/** Sixty samples of a site that goes on as it should, but for `except`. */
function soak(except: (stream: StreamSample, minute: number) => StreamSample = (stream) => stream): SoakSample[] {
  return Array.from({ length: 60 }, (_, minute) => ({
    minute,
    heap_kb: 1000,
    processes_kb: 9000,
    bus_used_kb: 100,
    streams: streams.map(({ soak: name, due }) => except({ soak: name, published: due, sent: due, came: due, p50_us: 100, p99_us: 300 }, minute)),
  }));
}

test('a soak whose streams all go on is flat', () => {
  const { flat, streams_in_second_half: judged } = judge(soak(), streams);
  assert.equal(flat, true);
  assert.deepEqual(judged['/large'], { delivered: 1, least_rate: 1, p50_us: [100, 100] });
});

test('a stream of which nothing comes any more is not flat', () => {
  const dead = soak((stream, minute) => stream.soak === '/large' && minute >= 31 ? { ...stream, sent: 0, came: 0, p50_us: 0, p99_us: 0 } : stream);
  assert.equal(judge(dead, streams).flat, false);
  assert.equal(judge(dead, streams).streams_in_second_half['/large']?.least_rate, 0);
});

test('a stream that falls short of its rate in one sample, at either end, is not flat', () => {
  for (const short of ['published', 'came'] as const) {
    const slow = soak((stream, minute) =>
      stream.soak === '/small' && minute === 50 ? { ...stream, [short]: 700, ...(short === 'came' ? { sent: 700 } : {}) } : stream
    );
    assert.equal(judge(slow, streams).flat, false, short);
  }
});

test('what gets lost, late or larger is not flat', () => {
  assert.equal(judge(soak((stream) => ({ ...stream, came: stream.came * 0.99 })), streams).flat, false);
  assert.equal(judge(soak((stream, minute) => ({ ...stream, p50_us: minute > 45 ? 1000 : 100 })), streams).flat, false);
  assert.equal(judge(soak().map((sample) => ({ ...sample, heap_kb: 1000 + 50 * sample.minute })), streams).flat, false);
});

test('two periods in one sample count as their mean, a missing one as nothing', () => {
  const taken: SoakReport = { soak: '/large', sent: 20, came: 20, p50_us: 5, p99_us: 9 };
  const [small, large] = gather([taken, taken, { soak: '/large', published: 21 }], streams);
  assert.deepEqual([large?.published, large?.came, large?.p99_us], [21, 20, 9]);
  assert.deepEqual([small?.published, small?.came], [0, 0]);
});
