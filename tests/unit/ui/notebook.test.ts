// Notebooks as the page reads and writes them, what events make of outputs, and HTML that means harm.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { noOutputs, withEvent } from '../../../runtime/site/ui/model/cell_outputs.ts';
import { readHtml } from '../../../runtime/site/ui/model/html.ts';
import type { HtmlNode } from '../../../runtime/site/ui/model/html.ts';
import { newCell, readNotebook, writeNotebook } from '../../../runtime/site/ui/model/notebook.ts';
import type { Notebook } from '../../../runtime/site/ui/model/notebook.ts';
import { readEvent } from '../../../runtime/site/session/notebook_kernel.ts';
import { nbformatFaults } from '../../support/nbformat_rules.ts';

const file = {
  cells: [
    { cell_type: 'markdown', id: 'a', metadata: { tags: ['x'] }, source: ['# A\n', 'b'], attachments: { 'i.png': { 'image/png': 'AA==' } } },
    {
      cell_type: 'code',
      id: 'b',
      metadata: { collapsed: true },
      execution_count: 3,
      outputs: [{ output_type: 'stream', name: 'stdout', text: ['1\n'] }],
      source: 'print(1)',
    },
    { cell_type: 'raw', id: 'c', metadata: {}, source: '' },
  ],
  metadata: { kernelspec: { name: 'python3', display_name: 'Python 3' }, mine: { deep: [1] } },
  nbformat: 4,
  nbformat_minor: 5,
};

function read(value: unknown): Notebook {
  const found = readNotebook(JSON.stringify(value));
  assert.ok(found.kind === 'read', JSON.stringify(found));
  return found.notebook;
}

// Compatibility, works: notebooks: nbformat 4.0 to 4.5 in and out; metadata and what is not known of it stay as they were
test('a notebook is written as it was read', () => {
  const written = JSON.parse(writeNotebook(read(file))) as typeof file;
  assert.deepEqual(written, { ...file, cells: file.cells.map((cell) => ({ ...cell, source: cell.source === '' ? [] : [cell.source].flat() })) });
  const older = JSON.parse(writeNotebook(read({ ...file, nbformat_minor: 2, cells: [{ cell_type: 'code', source: [] }] }))) as typeof file;
  assert.deepEqual(older.cells, [{ cell_type: 'code', metadata: {}, execution_count: null, outputs: [], source: [] }]);
});

test('what is written is as the schema of nbformat asks, whatever was read', () => {
  const outputs = [
    { output_type: 'execute_result', execution_count: 2, data: { 'text/plain': ['4'], 'application/json': { deep: [1] } }, metadata: {} },
    { output_type: 'error', ename: 'E', evalue: 'e', traceback: ['a'] },
  ];
  for (const minor of [0, 2, 4, 5]) {
    const cells = [...file.cells, { cell_type: 'code', id: 'a', outputs, execution_count: 2 }, { cell_type: 'code', metadata: 3, source: 'x' }];
    const notebook = read({ ...file, nbformat_minor: minor, cells: minor < 5 ? cells.map(({ id: _, ...cell }) => cell) : cells });
    const written: unknown = JSON.parse(writeNotebook({ ...notebook, cells: [...notebook.cells, newCell('code'), newCell('raw')] }));
    assert.deepEqual(nbformatFaults(written).filter((fault) => minor > 0 || !fault.includes('.attachments')), [], `4.${minor}`);
  }
  const broken = {
    ...file,
    extra: 1,
    cells: [{ ...file.cells[1], outputs: [{ output_type: 'stream', text: 1 }] }, { cell_type: 'raw', id: 'b', metadata: {} }],
  };
  assert.deepEqual(nbformatFaults(broken), [
    '.cells[0].outputs[0].name is missing',
    '.cells[0].outputs[0].text is neither a text nor a list of lines',
    '.cells[1].source is missing',
    '.extra is unknown',
    'two cells have one id',
  ]);
});

test('cells that are added or have the same id get ids of their own', () => {
  const notebook = read({ ...file, cells: [{ cell_type: 'code', id: 'a' }, { cell_type: 'code', id: 'a' }, { cell_type: 'code', id: 'no id!' }] });
  const written = JSON.parse(writeNotebook({ ...notebook, cells: [...notebook.cells, newCell('markdown')] })) as {
    readonly cells: readonly { readonly id: string; }[];
  };
  const ids = written.cells.map(({ id }) => id);
  assert.equal(new Set(ids).size, 4);
  assert.ok(ids.every((id) => /^[a-zA-Z0-9_-]{1,64}$/.test(id)), ids.join());
});

// Guarantee, hostile input: a file that is not a notebook of nbformat 4 is refused by the page, whatever its size or depth
test('what is not a notebook is refused', () => {
  const refused = (text: string): string => {
    const found = readNotebook(text);
    return found.kind === 'failed' ? found.reason : 'read';
  };
  assert.equal(refused('{'), 'it is not JSON');
  assert.equal(refused('[]'), 'it is not a notebook');
  assert.equal(refused('{"nbformat": 3}'), 'it is not of nbformat 4');
  assert.equal(refused('{"nbformat": 4, "cells": 1}'), 'it has no cells');
  assert.equal(refused('{"nbformat": 4, "cells": []}'), 'it has no number nbformat_minor');
  assert.equal(refused(JSON.stringify({ nbformat: 4, nbformat_minor: 5, cells: Array(1001).fill({}) })), 'it has more than 1000 cells');
  assert.equal(refused(' '.repeat((8 << 20) + 1)), 'it is larger than 8 MiB');
  assert.ok(refused('['.repeat(100_000)) !== 'read');
  // Odd parts of a notebook are skipped, or read as text.
  const odd = read({ nbformat: 4, nbformat_minor: 99, metadata: 7, cells: [null, 5, { cell_type: 'strange', source: [1, 'a'], outputs: 'x' }] });
  assert.deepEqual(odd.cells.map(({ kind, source, outputs }) => [kind, source, outputs]), [['raw', 'a', []]]);
});

test('events make outputs as Jupyter does', () => {
  const cell = 'c';
  const shown = (['1', '2\n'] as const).reduce((before, text) => withEvent(before, { event: 'stream', cell, name: 'stdout', text }), noOutputs);
  assert.deepEqual(shown.outputs, [{ output_type: 'stream', name: 'stdout', text: '12\n' }]);
  const bar = withEvent(shown, { event: 'stream', cell, name: 'stdout', text: '10 %\r20 %\r' });
  const again = withEvent(bar, { event: 'stream', cell, name: 'stdout', text: '30 %\n' });
  assert.equal(again.outputs[0]?.['text'], '12\n30 %\n');
  const first = { event: 'display', cell, data: { 'text/plain': 'a' }, metadata: {}, display_id: 'd' } as const;
  const updated = withEvent(withEvent(shown, first), { ...first, event: 'update', data: { 'text/plain': 'b' } });
  assert.deepEqual(updated.outputs[1]?.['data'], { 'text/plain': 'b' });
  const waits = withEvent(updated, { event: 'clear', cell, wait: true });
  assert.equal(waits.outputs.length, 2);
  assert.equal(withEvent(waits, first).outputs.length, 1);
  assert.equal(withEvent(updated, { event: 'clear', cell, wait: false }).outputs.length, 0);
});

test('a kernel says nothing but events', () => {
  assert.equal(readEvent('{"event": "stream", "cell": "a", "name": "stdout", "text": 5}'), undefined);
  assert.equal(readEvent('{"event": "constructor", "cell": "a"}'), undefined);
  assert.equal(readEvent('{"event": "display", "cell": "a", "data": [], "metadata": {}}'), undefined);
  assert.equal(readEvent('null'), undefined);
  assert.equal(readEvent('{'), undefined);
  assert.equal(readEvent('['.repeat(1_000_000)), undefined);
  assert.deepEqual(readEvent('{"event": "end", "cell": "a", "good": true}'), { event: 'end', cell: 'a', good: true });
});

/** As text: what would be made of it. */
function shape(nodes: readonly HtmlNode[] | null): string {
  return (nodes ?? ['null']).map((node) => {
    if (typeof node === 'string') return node;
    const parts = [...Object.entries(node.attributes).map(([name, value]) => `${name}=${value}`),
      ...Object.entries(node.style).map(([name, value]) => `${name}:${value}`)];
    return `<${[node.tag, ...parts].join(' ')}>${shape(node.children)}</>`;
  }).join('');
}

test('HTML of outputs: tables, lists, colours', () => {
  assert.equal(
    shape(readHtml('<table border="1"><tr><th>a<td style="color: red; text-align:right">1 &lt; 2</table><ul><li>x<li>y</ul><p>p<p>q')),
    '<table><tr><th>a</><td color:red text-align:right>1 < 2</></></><ul><li>x</><li>y</></><p>p</><p>q</>',
  );
  assert.equal(shape(readHtml('<h2>A</h2> 1 < 2 &amp; <custom-tag><b>in</b></custom-tag>')), '<div class=html-heading html-h2>A</> 1 < 2 & <b>in</>');
});

// Guarantee, hostile input: HTML of a notebook's outputs keeps listed elements, attributes and styles only: no script, no address
// to load from, nothing that leaves its place
test('HTML that means harm', () => {
  const harmless = (html: string): string => shape(readHtml(html));
  assert.equal(harmless('a<script>alert(1)</script><style>*{}</style><iframe src=x></iframe>b'), 'ab');
  assert.equal(harmless('<img src=x onerror=alert(1) alt="no image">'), 'no image');
  assert.equal(harmless('<b onclick="x()" id=y class=z style="position:fixed;background:url(x);color:var(--a);width:10px;margin:-9px">t</b>'),
    '<b width:10px>t</>');
  const styled = (style: string): string => harmless(`<b style='${style}'>t</b>`);
  for (const value of ['image-set("x.png" 1x)', 'red\nurl(x)', 'cross-fade(red, blue)', 'url (x)']) assert.equal(styled(`background: ${value}`), '<b>t</>');
  for (const value of ['calc(500px/-1)', 'calc(500px * 2)', '0-500px', '10%-5px', '1px\n-5px', '1px/-5px']) assert.equal(styled(`margin: ${value}`), '<b>t</>');
  assert.equal(styled('color: rgba(1, 2, 3, 50%); background: hsl(10 20% 30%); font-family: sans-serif'),
    '<b color:rgba(1, 2, 3, 50%) background:hsl(10 20% 30%) font-family:sans-serif>t</>');
  assert.equal(harmless('<a href="javascript:x">a</a><a href=" https://web.example">b</a>'), '<a>a</><a href=https://web.example>b</>');
  assert.match(harmless('<svg onload="x()"><script>y</script></svg>'), /^<img src=data:image\/svg\+xml,%3Csvg[^<>]* alt=><\/>$/);
  assert.match(harmless('<svg>\ud800</svg>'), /%EF%BF%BD/);
  assert.equal(harmless('<scr<script>ipt>alert(1)</script>'), 'ipt>alert(1)');
  assert.equal(harmless('<b title="a>b">t'), '<b title=a>b>t</>');
  assert.equal(harmless('<b title="'), '<b title="');
  assert.equal(harmless('<'.repeat(5)), '<<<<<');
  assert.equal(readHtml('<br>'.repeat(60_000)), null);
  // Neither deep nesting nor tags without an end take long.
  for (const hostile of ['<div>'.repeat(40_000), '<a x="'.repeat(100_000), '<b ' + ' '.repeat(500_000), '<b ' + 'a '.repeat(200_000), '</p>'.repeat(200_000)]) {
    const begin = performance.now();
    readHtml(hostile);
    assert.ok(performance.now() - begin < 5000, hostile.slice(0, 20));
  }
});
