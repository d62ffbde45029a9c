// The tree of rows, columns and tab groups, and its text form, which may come from anyone.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  addTab,
  closeTab,
  findTab,
  freshKey,
  groupOf,
  groupsOf,
  MOST_PANELS,
  moveTab,
  numberOf,
  placeBeside,
  resizePair,
  reveal,
  setPanelState,
  tabsOf,
  wouldCover,
  zoneAt,
} from '../../../runtime/site/ui/model/layout.ts';
import type { Layout } from '../../../runtime/site/ui/model/layout.ts';
import { parseLayout, readLayout, writeLayout } from '../../../runtime/site/ui/model/layout_text.ts';
import { changedFragment, readFragment } from '../../../runtime/site/ui/model/link.ts';
import { readJson } from '../../../runtime/site/ui/model/json.ts';

const isKnown = (panel: string): boolean => ['nodes', 'console', 'topics', 'plot'].includes(panel);

function layoutOf(value: unknown): Layout {
  return readLayout(value, isKnown).layout ?? assert.fail('no layout');
}

const usual = { row: ['nodes', 'console', 'topics'], sizes: [1, 2, 1], shown: 'console' };

const target = (layout: Layout, key: string, zone: 'into' | 'left' | 'below', index?: number) => ({
  group: groupOf(layout, key)?.key ?? assert.fail(`no ${key}`),
  zone,
  ...(index === undefined ? {} : { index }),
});

test('a layout is read and written in one form', () => {
  assert.deepEqual(writeLayout(layoutOf(usual)), {
    row: ['nodes', 'console', 'topics'],
    sizes: [250, 500, 250],
    shown: 'console',
  });
  assert.equal(writeLayout(layoutOf('plot')), 'plot');
  assert.deepEqual(writeLayout(layoutOf({ plot: { paths: ['/a.b'] } })), { plot: { paths: ['/a.b'] } });
  const nested = {
    column: [{ tabs: ['nodes', { plot: { x: 1 } }, 'plot'], front: 3 }, { row: ['console', 'topics'], sizes: [500, 500] }],
    sizes: [500, 500],
    shown: 'plot-2',
  };
  assert.deepEqual(writeLayout(layoutOf(nested)), nested);
  assert.deepEqual(writeLayout(layoutOf(writeLayout(layoutOf(nested)))), nested);
});

test('moving, splitting and closing keep the tree free of empty parts', () => {
  let layout = layoutOf(usual);
  layout = moveTab(layout, 'topics', target(layout, 'nodes', 'below'));
  assert.deepEqual(writeLayout(layout), {
    row: [{ column: ['nodes', 'topics'], sizes: [500, 500] }, 'console'],
    sizes: [333, 667],
    shown: 'topics',
  });
  layout = moveTab(layout, 'topics', target(layout, 'console', 'into', 0));
  assert.deepEqual(writeLayout(layout), {
    row: ['nodes', { tabs: ['topics', 'console'] }],
    sizes: [333, 667],
    shown: 'topics',
  });
  // Beside the others of its own group, in a row: no row within the row.
  layout = moveTab(layout, 'console', target(layout, 'console', 'left'));
  assert.deepEqual(writeLayout(layout), {
    row: ['nodes', 'console', 'topics'],
    sizes: [333, 333, 333],
    shown: 'console',
  });
  assert.equal(moveTab(layout, 'console', target(layout, 'console', 'left')), layout);
  assert.equal(moveTab(layout, 'nobody', target(layout, 'console', 'into')), layout);
  assert.equal(moveTab(layout, 'nodes', { group: 'nowhere', zone: 'into' }), layout);
  for (const key of ['nodes', 'console', 'topics']) layout = closeTab(layout, key);
  assert.deepEqual(tabsOf(layout.root), []);
  assert.equal(groupsOf(layout.root).length, 1);
  assert.equal(layout.front, '');
  layout = addTab(
    layout,
    { key: 'plot', panel: 'plot', state: null },
    { group: groupsOf(layout.root)[0]?.key ?? '', zone: 'below' },
  );
  assert.equal(writeLayout(layout), 'plot');
});

test('tabs change places within their group', () => {
  let layout = layoutOf({ tabs: ['nodes', 'console', 'topics'] });
  const order = (): string => tabsOf(layout.root).map((tab) => tab.key).join(' ');
  layout = moveTab(layout, 'nodes', target(layout, 'nodes', 'into', 2));
  assert.equal(order(), 'console nodes topics');
  layout = moveTab(layout, 'topics', target(layout, 'nodes', 'into', 0));
  assert.equal(order(), 'topics console nodes');
  assert.equal(layout.front, 'topics');
  layout = closeTab(layout, 'topics');
  assert.equal(layout.front, 'console');
  assert.equal(groupsOf(layout.root)[0]?.front, 'console');
});

test('keys, numbers, states and room', () => {
  let layout = layoutOf(usual);
  const center = target(layout, 'console', 'into');
  for (const state of [1, 2]) {
    const key = freshKey(layout, 'plot');
    layout = addTab(layout, { key, panel: 'plot', state }, center);
  }
  assert.deepEqual(tabsOf(layout.root).map((tab) => tab.key), ['nodes', 'console', 'plot', 'plot-2', 'topics']);
  assert.equal(numberOf(findTab(layout, 'plot-2') ?? assert.fail()), 2);
  layout = setPanelState(layout, 'plot-2', { far: true });
  assert.deepEqual(findTab(layout, 'plot-2')?.state, { far: true });
  assert.equal(findTab(layout, 'plot')?.state, 1);
  assert.equal(reveal(layout, 'nobody'), layout);
  const seen = reveal(layout, 'console');
  assert.equal(groupOf(seen, 'console')?.front, 'console');
  assert.equal(reveal(seen, 'console').root, seen.root);
  assert.deepEqual(placeBeside(layout, null, () => true), { group: center.group, zone: 'into' });
  assert.notEqual(placeBeside(layout, 'plot', () => true)?.group, center.group);
  const wider = resizePair(layout, layout.root.key, 0, 0.5);
  assert.deepEqual(wider.root.kind === 'row' ? wider.root.sizes : [], [0.375, 0.375, 0.25]);
  for (let i = 0; i < 2 * MOST_PANELS; i += 1)
    layout = addTab(layout, { key: freshKey(layout, 'plot'), panel: 'plot', state: null }, center);
  assert.equal(tabsOf(layout.root).length, MOST_PANELS);
});

test('a point near an edge means the half beside it', () => {
  const box = { left: 100, top: 100, width: 400, height: 200 };
  assert.equal(zoneAt(box, 300, 200), 'into');
  assert.equal(zoneAt(box, 110, 200), 'left');
  assert.equal(zoneAt(box, 490, 200), 'right');
  assert.equal(zoneAt(box, 300, 105), 'above');
  assert.equal(zoneAt(box, 300, 295), 'below');
});

test('unknown panels are skipped, and told', () => {
  const read = readLayout({ row: ['nodes', 'games', { column: ['films'] }, { tabs: ['console', 7] }] }, isKnown);
  assert.deepEqual(read.leftOut, ['games', 'films', '?']);
  assert.deepEqual(writeLayout(read.layout ?? assert.fail()), {
    row: ['nodes', 'console'],
    sizes: [500, 500],
    shown: 'nodes',
  });
});

// Guarantee, hostile input: layouts in links and storage are bounded in depth and number, and none throws
test('hostile layouts are bounded, and never throw', () => {
  let deep: unknown = 'nodes';
  for (let i = 0; i < 5000; i += 1) deep = { row: [deep, 'console'] };
  const read = readLayout(deep, isKnown);
  assert.ok(tabsOf((read.layout ?? assert.fail()).root).length < 12);
  const many = readLayout({ tabs: Array.from({ length: 9999 }, () => 'plot') }, isKnown);
  assert.equal(tabsOf((many.layout ?? assert.fail()).root).length, MOST_PANELS);
  let odd: unknown = 1;
  for (let i = 0; i < 5000; i += 1) odd = [odd];
  for (
    const value of [
      null,
      3,
      '',
      [],
      {},
      { row: [] },
      { row: 'nodes' },
      { tabs: {} },
      { plot: odd },
      { plot: 'x'.repeat(20_000) },
      { row: Array.from({ length: 1000 }, () => 'plot') },
      { toString: null },
      { constructor: 1 },
      { __proto__: { row: ['nodes'] } },
      JSON.parse('{"__proto__": {"row": ["nodes"]}}'),
    ]
  )
    assert.equal(readLayout(value, isKnown).layout, null);
  for (const text of ['', '{', `"${'x'.repeat(100_000)}"`, '[[[[', 'undefined'])
    assert.equal(parseLayout(text, isKnown).layout, null);
  const sizes = layoutOf({ row: ['nodes', 'console'], sizes: [-5, 1e300] });
  assert.deepEqual(sizes.root.kind === 'row' ? sizes.root.sizes : [], [0.5, 0.5]);
  assert.equal(readJson({ a: () => 1 }, 100), undefined);
  assert.equal(readJson(Number.NaN, 100), undefined);
  assert.deepEqual(readJson({ a: [1, 'b', null] }, 100), { a: [1, 'b', null] });
});

test('a fragment keeps the fields of others', () => {
  const fragment = changedFragment('#args=a%20b&layout=old', { layout: '"nodes"', site: 'abc' });
  assert.equal(readFragment(fragment).get('args'), 'a b');
  assert.equal(readFragment(fragment).get('layout'), '"nodes"');
  assert.equal(changedFragment('#layout=1', { layout: null }), '');
  assert.equal(readFragment(`#layout=${'x'.repeat(200_000)}`).get('layout'), null);
});

test('a panel that is asked for covers neither its caller nor what a visitor looks at', () => {
  const known = ['text', 'turtlesim', 'plot', 'nodes', 'graph'];
  const panes = { row: ['text', { tabs: ['turtlesim', 'plot'] }, { tabs: ['nodes', 'graph'] }], sizes: [2, 5, 1] };
  const layout = readLayout(panes, (panel) => known.includes(panel)).layout ?? assert.fail('no layout');
  const groupKey = (key: string): string => groupOf(layout, key)?.key ?? assert.fail(key);
  const isList = (tab: { readonly panel: string; }): boolean => ['nodes', 'graph'].includes(tab.panel);
  assert.deepEqual(placeBeside(layout, 'text', isList), { group: groupKey('nodes'), zone: 'into' });
  // The only group that may be covered is the caller's own: the largest other one gives room.
  assert.deepEqual(placeBeside(layout, 'nodes', isList), { group: groupKey('turtlesim'), zone: 'below' });
  assert.equal(wouldCover(layout, 'plot', 'text', isList), true);
  assert.equal(wouldCover(layout, 'graph', 'text', isList), false);
  assert.equal(wouldCover(layout, 'graph', 'nodes', isList), true);
  assert.equal(wouldCover(layout, 'turtlesim', 'text', isList), false);
});
