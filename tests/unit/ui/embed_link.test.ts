// The page inside another one: what its address asks for, and the address of the whole page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { embeddedLayout, readEmbed, wholeAddress } from '../../../runtime/site/ui/model/embed_link.ts';
import { tabsOf } from '../../../runtime/site/ui/model/layout.ts';
import { parseLayout, writeLayout } from '../../../runtime/site/ui/model/layout_text.ts';
import type { ReadLayout } from '../../../runtime/site/ui/model/layout_text.ts';

const known = (panel: string): boolean => ['nodes', 'console', 'plot', 'graph'].includes(panel);
const nothing: ReadLayout = { layout: null, leftOut: [] };

function embedded(search: string, layout = ''): ReadLayout {
  const view = readEmbed(search) ?? assert.fail();
  return embeddedLayout(view, layout === '' ? nothing : parseLayout(layout, known), known);
}

test('only embed=1 asks for panels without the page around them', () => {
  assert.equal(readEmbed(''), null);
  assert.equal(readEmbed('?panel=plot'), null);
  assert.equal(readEmbed('?embed=yes&panel=plot'), null);
  assert.deepEqual(readEmbed('?embed=1'), { panels: [] });
  assert.deepEqual(readEmbed('?speed:=2&embed=1&panel=plot,graph&panel=nodes'), { panels: ['plot', 'graph', 'nodes'] });
  assert.equal(readEmbed(`?embed=1&panel=${'plot,'.repeat(1000)}`)?.panels.length, 12);
});

test('panels stand side by side, each once, and what is none is named', () => {
  const { layout, leftOut } = embedded('?embed=1&panel=plot,constructor,plot&panel=graph');
  assert.deepEqual(tabsOf((layout ?? assert.fail()).root).map((tab) => tab.key), ['plot', 'graph']);
  assert.deepEqual(leftOut, ['constructor']);
  assert.deepEqual(embedded('?embed=1&panel=nobody'), { layout: null, leftOut: ['nobody'] });
});

test('of a link with more panels those that are asked for stay, with their state and their place', () => {
  const link = '{"row":["nodes",{"column":[{"plot":{"paths":["/a.b"]}},{"plot":{"paths":["/c.d"]}},"console"]}],"shown":"console"}';
  const { layout } = embedded('?embed=1&panel=plot', link);
  const text = writeLayout(layout ?? assert.fail());
  assert.deepEqual(text, {
    column: [{ plot: { paths: ['/a.b'] } }, { plot: { paths: ['/c.d'] } }],
    sizes: [500, 500],
    shown: 'plot-2',
  });
  const more = embedded('?embed=1&panel=graph,plot', '{"plot":{"paths":["/a.b"]}}');
  assert.deepEqual(
    tabsOf((more.layout ?? assert.fail()).root).map(({ panel, state }) => [panel, state]),
    [['plot', { paths: ['/a.b'] }], ['graph', null]],
  );
  assert.deepEqual(tabsOf((embedded('?embed=1&panel=graph', '"nodes"').layout ?? assert.fail()).root).map(({ panel }) => panel), ['graph']);
  assert.deepEqual(tabsOf((embedded('?embed=1', '"nodes"').layout ?? assert.fail()).root).map(({ panel }) => panel), ['nodes']);
});

test('the whole page has the same arguments and the same view', () => {
  const address = 'https://a.org/site/?embed=1&speed:=2&panel=plot&panel=graph&seed=4#site=abc&layout=%22plot%22';
  assert.equal(wholeAddress(address, null), 'https://a.org/site/?speed:=2&seed=4#site=abc&layout=%22plot%22');
  assert.equal(wholeAddress(address, '"graph"'), 'https://a.org/site/?speed:=2&seed=4#site=abc&layout=%22graph%22');
  assert.equal(wholeAddress('https://a.org/?embed=1', null), 'https://a.org/');
});
