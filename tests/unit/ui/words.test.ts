// Quantities, hidden names, problems and preferences: small pure parts of the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isHiddenTopic } from '../../../runtime/site/ui/model/hidden_names.ts';
import { problemOf, problemText } from '../../../runtime/site/ui/model/problem.ts';
import { readText, readPreference, readTheme, writePreference } from '../../../runtime/site/ui/model/preferences.ts';
import { formatBandwidth, formatBytes, formatCount, formatDuration, formatRate } from '../../../runtime/site/ui/model/quantities.ts';

test('rates, bandwidths, sizes and durations', () => {
  assert.equal(formatRate(0), '\u2013');
  assert.equal(formatRate(2), '2.00 Hz');
  assert.equal(formatRate(29.97), '30.0 Hz');
  assert.equal(formatRate(1020.4), '1020 Hz');
  assert.equal(formatBandwidth(0), '\u2013');
  assert.equal(formatBandwidth(56), '56 B/s');
  assert.equal(formatBandwidth(1200), '1.20 kB/s');
  assert.equal(formatBytes(999.6), '1.00 kB');
  assert.equal(formatBytes(27_600_000), '27.6 MB');
  assert.equal(formatDuration(4200), '4 s');
  assert.equal(formatDuration(125_000), '2:05');
  assert.equal(formatDuration(3_723_000), '1:02:03');
  assert.equal(formatCount(1234567), '1\u202f234\u202f567');
});

test('hidden topics are those of ROS 2', () => {
  assert.deepEqual(
    [
      '/rosout',
      '/parameter_events',
      '/_hidden',
      '/fib/_action/feedback',
      '/topic',
      '/a_b',
      '/ns/rosout',
    ].map(isHiddenTopic),
    [true, true, true, true, false, false, false],
  );
});

test('whatever is thrown becomes a problem', () => {
  const error = Object.assign(new Error('no isolation'), {
    code: 'R2W0703',
    why: 'a frame',
    fix: ['open it alone'],
    place: 'workspace.yaml:3:1',
  });
  assert.equal(
    problemText(problemOf(error)),
    'error[R2W0703]: no isolation\n  --> workspace.yaml:3:1\n   = why: a frame\n   = fix: open it alone',
  );
  assert.equal(problemOf(new TypeError('x is undefined')).code, 'R2W0792');
  assert.equal(problemOf(undefined).what, 'undefined');
  assert.equal(problemOf({ code: '<img>', message: 'm' }).code, 'R2W0792');
  assert.equal(
    problemOf({ message: 'm', source: { file: 'a.yaml', line: 1, column: 2 } }).place,
    'a.yaml:1:2',
  );
});

test('preferences survive a store that refuses everything', () => {
  const refusing = {
    getItem: (): string => {
      throw new Error('refused');
    },
    setItem: (): void => {
      throw new Error('refused');
    },
  };
  assert.equal(readPreference(refusing, 'theme', ['light', 'dark'], 'light'), 'light');
  writePreference(refusing, 'theme', 'dark');
  const kept = new Map<string, string>();
  const store = {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  };
  writePreference(store, 'theme', 'dark');
  assert.equal(readPreference(store, 'theme', ['light', 'dark'], 'light'), 'dark');
  writePreference(store, 'layout./', '"nodes"');
  assert.equal(readText(store, 'layout./'), '"nodes"');
  assert.equal(readText(refusing, 'layout./'), null);
  assert.equal(readTheme(store, 'light'), 'dark');
  assert.equal(readTheme(null, 'light'), 'light');
  assert.equal(readTheme(null, 'auto'), 'system');
  assert.equal(readTheme(null, 7), 'system');
  assert.equal(readPreference(null, 'theme', ['light', 'dark'], 'light'), 'light');
});
