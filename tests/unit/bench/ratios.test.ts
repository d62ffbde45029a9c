// The recorded ratios to a peer: the newest landing must not be slower than those before it, or must say why.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { type RatioEntry, regressions } from '../../bench/ratios.ts';

const trip = (median: number) => ({ line: 'round trip, Node.js, shared link, 8 B, beside nothing else', median, worst: 2 * median });
const flood = (median: number) => ({ line: 'throughput, Node.js, shared link, 8 B, beside nothing else', median, worst: median / 2 });
const entry = (title: string, ...ratios: RatioEntry['ratios'][number][]): RatioEntry => ({ date: '2026-11-28', title, ratios });

test('a slower landing is found, whether less or more is better', () => {
  const before = entry('before', trip(0.4), flood(1.6));
  assert.deepEqual(regressions([before, entry('same', trip(0.45), flood(1.4))]), []);
  const slower = regressions([before, entry('better', trip(0.3), flood(2)), entry('slower', trip(0.6), flood(1.2))]);
  assert.equal(slower.length, 4);
  assert.match(slower[0] ?? '', /^round trip.*: 0\.6 of the peer's, after 0\.4 in "before"$/);
  const excused = { ...entry('slower', trip(0.6), flood(1.6)), excused: { [trip(1).line]: 'checks every message now' } };
  assert.deepEqual(regressions([before, excused]), []);
});

test('the newest recorded landing has not regressed', () => {
  const entries = JSON.parse(readFileSync(new URL('../../bench/ratios.json', import.meta.url), 'utf8')) as RatioEntry[];
  assert.ok((entries.at(-1)?.ratios.length ?? 0) > 0, 'the newest landing has ratios');
  assert.deepEqual(regressions(entries), []);
});
