// Field paths, samples, states and drawings: what the plot and the timeline are made of.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { asNumber, asState, parseFieldPath, pathsOf, valueAt } from '../../../runtime/site/ui/model/field_path.ts';
import { extentOf, plotSvg, ticks } from '../../../runtime/site/ui/model/plot_svg.ts';
import { Samples, aligned, toCsv } from '../../../runtime/site/ui/model/samples.ts';
import { StateTrack } from '../../../runtime/site/ui/model/state_track.ts';
import { createTypes } from '../../../runtime/site/decode/types.ts';

test('paths are read strictly', () => {
  assert.deepEqual(parseFieldPath(' /a/b.c[12].d_2 '), { topic: '/a/b', steps: ['c', 12, 'd_2'] });
  for (const text of ['', '/a', 'a.b', '/a.', '/a.b[', '/a.b[-1]', '/a.b[x]', '/a..b', '/a.b c', `/a${'.b'.repeat(300)}`, '/a.b\n.c'])
    assert.equal(parseFieldPath(text), null, text);
});

test('values are taken from messages, and nothing else', () => {
  const message = { pose: { x: 1.5 }, list: Float32Array.of(1, 2), on: true, big: 9n, stamp: { sec: 2, nanosec: 5e8 }, name: 'go' };
  const at = (text: string): unknown => valueAt(message, parseFieldPath(`/t${text}`)?.steps ?? assert.fail(text));
  assert.equal(asNumber(at('.pose.x')), 1.5);
  assert.equal(asNumber(at('.list[1]')), 2);
  assert.equal(asNumber(at('.on')), 1);
  assert.equal(asNumber(at('.big')), 9);
  assert.equal(asNumber(at('.stamp')), 2.5);
  assert.ok(Number.isNaN(asNumber(at('.name'))));
  assert.equal(asState(at('.name')), 'go');
  assert.equal(asState(at('.pose')), undefined);
  for (const text of ['.pose.y', '.list[2]', '.pose.constructor', '.__proto__', '.list.length', '.name.length'])
    assert.equal(at(text), undefined, text);
});

test('the paths that a type offers', () => {
  const types = createTypes(new Map([
    ['a/msg/Pose', 'float64 x\nstring frame\na/Inner[] inner\n'],
    ['a/msg/Inner', 'int8[3] codes\nbool ok\n'],
  ]));
  const type = types.get('a/msg/Pose');
  assert.ok(typeof type !== 'string');
  assert.deepEqual(pathsOf('/p', type.shape, 'number'), ['/p.x', '/p.inner[0].codes[0]', '/p.inner[0].ok']);
  assert.deepEqual(pathsOf('/p', type.shape, 'state', 2), ['/p.x', '/p.frame']);
});

test('samples keep the newest, in order, and begin anew when time goes back', () => {
  const samples = new Samples(3000);
  for (let i = 0; i < 5000; i += 1) samples.add(i, 2 * i);
  assert.equal(samples.length, 3000);
  assert.equal(samples.time(0), 2000);
  assert.equal(samples.value(2999), 9998);
  assert.equal(samples.from(2500.5), 501);
  assert.equal(samples.valueAt(2500.5), 5000);
  assert.ok(Number.isNaN(samples.valueAt(1)));
  samples.add(1, 7);
  assert.equal(samples.length, 1);
});

test('of several samples at one moment all are told, and the last one holds', () => {
  const samples = new Samples(10);
  for (const [time, value] of [[1, 5], [2, 6], [2, 7], [2, 8], [3, 9]] as const) samples.add(time, value);
  assert.deepEqual(samples.valuesAt(2), [6, 7, 8]);
  assert.equal(samples.valueAt(2), 8);
  assert.deepEqual([0, 1, 1.5, 2.5, 9].map((time) => samples.valuesAt(time)), [[], [5], [5], [8], [9]]);
});

test('series of different times are put beside each other', () => {
  const [a, b] = [new Samples(10), new Samples(10)];
  a.add(1, 10);
  a.add(2, 20);
  b.add(1.5, Number.NaN);
  b.add(2, 5);
  const series = [{ name: '/a.x', samples: a }, { name: '/b."y"', samples: b }];
  const { times, columns } = aligned(series, 1.2);
  assert.deepEqual([...times], [1.5, 2]);
  assert.deepEqual(columns, [[null, 20], [null, 5]]);
  assert.equal(toCsv(series), 'time,"/a.x","/b.""y"""\n1.000000000,10,\n1.500000000,,\n2.000000000,20,5\n');
});

test('the drawing is well formed, whatever the names', () => {
  const svg = plotSvg([{ name: '</text><script>"&\u0001', color: '#123456', points: [[0, 0], [1, Number.NaN], [2, 4], [3, 1e9]] }], 's & t');
  assert.equal(svg.includes('<script'), false);
  assert.match(svg, /&lt;\/text&gt;&lt;script&gt;&quot;&amp;</);
  assert.match(svg, /d="M70 [\d.]+M[\d.]+ [\d.]+L704 [\d.]+"/);
  assert.match(plotSvg([], 'none'), /^<svg .*<\/svg>\n$/s);
  assert.deepEqual(extentOf([Number.NaN, Infinity]), { least: 0, most: 1 });
  assert.deepEqual(ticks({ least: -1, most: 9 }, 5), [0, 2, 4, 6, 8].map((tick) => tick - 0));
  assert.deepEqual(ticks({ least: 5, most: 5 }, 5), []);
});

test('states last until the next one', () => {
  const track = new StateTrack();
  for (const [time, text] of [[1, 'idle'], [2, 'idle'], [3, 'go'], [5, 'idle']] as const) track.add(time, text);
  assert.equal(track.last, 'idle');
  assert.deepEqual(track.spans(2, 6), [
    { from: 2, to: 3, text: 'idle', color: 1 },
    { from: 3, to: 5, text: 'go', color: 2 },
    { from: 5, to: 6, text: 'idle', color: 1 },
  ]);
  assert.deepEqual(track.spans(-5, 0), []);
  for (let i = 0; i < 20_000; i += 1) track.add(10 + i, String(i % 7));
  assert.ok(track.spans(0, 1e9).length <= 400);
  track.add(0, 'anew');
  assert.deepEqual(track.spans(-1, 1), [{ from: 0, to: 1, text: 'anew', color: track.spans(-1, 1)[0]?.color ?? 0 }]);
});
