// Random input as the author of a lab or a page around a site could send it: notebooks, their HTML, lab sheets, robot models,
// meshes and commands. A reader ends soon, throws only the errors that it documents, and returns nothing that could run.
// A seed repeats each attack.

// Guarantee, hostile input: notebooks, their HTML, lab sheets, robot models, meshes and commands of an embedding page, changed and
// put together at random: an answer or a fault in bounded time, nothing that runs, nothing of the page changed

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readRequest, Refusal } from '../../../runtime/site/ui/model/embed_request.ts';
import { readHtml } from '../../../runtime/site/ui/model/html.ts';
import type { HtmlNode } from '../../../runtime/site/ui/model/html.ts';
import { readMarkdown } from '../../../runtime/site/ui/model/markdown.ts';
import { readNotebook, writeNotebook } from '../../../runtime/site/ui/model/notebook.ts';
import { readUrdf } from '../../../runtime/site/ui/model/urdf.ts';
import { parseMesh } from '../../../runtime/site/ui/scene/mesh_parsers.ts';
import { seededRandom } from '../../../runtime/site/contract/seeded_random.ts';
import { asciiStl, binaryStl, gltf, gltfNumbers, obj } from '../../support/wedge_meshes.ts';

const rounds = 400;
/** The longest time for one call, ms. A loop that trusts a random number would take minutes. */
const longestMs = 2000;

class Chance {
  private readonly fill: (bytes: Uint8Array) => void;
  private readonly word = new Uint32Array(1);

  constructor(name: string, seed: number) {
    this.fill = seededRandom(seed, name);
  }

  below(end: number): number {
    this.fill(new Uint8Array(this.word.buffer));
    return (this.word[0] ?? 0) % end;
  }

  of<T>(list: readonly T[]): T {
    return list[this.below(list.length)] as T;
  }
}

function each(name: string, act: (chance: Chance) => unknown): void {
  test(name, { timeout: 240_000 }, async () => {
    for (let seed = 0; seed < rounds; seed += 1) {
      const began = performance.now();
      try {
        await act(new Chance(name, seed));
      } catch (error) {
        throw new Error(`${name}, seed ${seed}`, { cause: error });
      }
      const took = performance.now() - began;
      assert.ok(took < longestMs, `seed ${seed} took ${took} ms`);
      assert.equal(Reflect.get({}, 'polluted'), undefined, `seed ${seed}`);
    }
  });
}

const markup = [
  '<script>',
  '</script>',
  '<img src=x onerror=alert(1)>',
  '<svg onload=alert(1)>',
  '</svg>',
  '<a href="javascript:alert(1)">',
  '<a href="java\nscript:alert(1)">',
  '<a href=" JaVaScRiPt:alert(1)">',
  '<a href="&#106;avascript:alert(1)">',
  '<a href="data:text/html,x">',
  '<a href="https://elsewhere.example/">',
  '</a>',
  '<iframe srcdoc="<script>alert(1)</script>">',
  '<object data=x>',
  '<embed src=x>',
  '<base href="//x/">',
  '<meta http-equiv=refresh content="0;url=//x">',
  '<link rel=stylesheet href=//x>',
  '<form action=//x>',
  '<input autofocus onfocus=alert(1)>',
  '<div style="position:fixed;top:0">',
  '<div style="background:url(//x)">',
  '<div style="width:expression(alert(1))">',
  '<div style="background:u\\72l(//x)">',
  '<div style="margin-left:-9999px">',
  '<div onclick=alert(1) class=page id=page>',
  '</div>',
  '<details open ontoggle=alert(1)>',
  '<table>',
  '<tr>',
  '<td colspan=99999999>',
  '</table>',
  '<math><mtext><mglyph><style><img src=x onerror=alert(1)>',
  '<noscript><p title="</noscript><img src=x onerror=alert(1)>">',
  '<!--',
  '-->',
  '<![CDATA[',
  '<?xml ?>',
  '<',
  '>',
  '"',
  "'",
  '`',
  '=',
  '/',
  '&lt;',
  '&#x3c;script&#x3e;',
  '\0',
  '\u2028',
  '\ud800',
  '<x-y z>',
  '<STYLE>*{}</STYLE>',
  '<img src="data:image/svg+xml,<svg onload=alert(1)>">',
  '<img src="data:text/html,x">',
  '<img srcset="//x 2x" src=data:image/png;base64,AA==>',
  '$x$',
  '$$y$$',
  '[a](javascript:alert(1))',
  '![a](//x "t")',
  '[a]: javascript:alert(1)',
  '`',
  '~~~',
  '# ',
  '* ',
  '> ',
  '|a|b|\n|-|-|\n',
  '\n',
  '\t',
  'word ',
  '__proto__',
  '\\',
];

function text(chance: Chance, most = 60): string {
  return Array.from({ length: chance.below(most) }, () => chance.of(markup).repeat(chance.below(20) === 0 ? 200 : 1)).join('');
}

/** Nothing of it runs, loads from elsewhere, or leaves its place. */
function expectHarmless(node: HtmlNode): void {
  if (typeof node === 'string') return;
  const { tag, attributes, style, children } = node;
  assert.doesNotMatch(tag, /^(script|style|iframe|object|embed|svg|math|form|input|base|meta|link|template)$/);
  for (const [name, value] of Object.entries(attributes)) {
    assert.match(name, /^(title|alt|open|colspan|rowspan|start|width|height|value|max|min|href|src|class)$/);
    if (name === 'href') assert.match(value, /^(https?|mailto):/i);
    if (name === 'src') assert.match(value, /^data:image\/(png|jpeg|gif|webp|svg\+xml)[;,]/i);
    if (name === 'class') assert.match(value, /^html-heading html-h[1-6]$/);
  }
  for (const [name, value] of Object.entries(style)) {
    assert.doesNotMatch(name, /position|inset|z-index|transform|animation|behavior|binding|content/);
    assert.doesNotMatch(value, /url|expression|\\|image|var\(|attr\(|javascript/i);
  }
  for (const child of children) expectHarmless(child);
}

each('the HTML of outputs', (chance) => {
  for (const node of readHtml(text(chance)) ?? []) expectHarmless(node);
});

each('lab sheets', (chance) => {
  const tokens = readMarkdown(text(chance));
  assert.ok(tokens === null || Array.isArray(tokens));
});

/** Any value that JSON, or a message between pages, can carry. */
function value(chance: Chance, depth = 0): unknown {
  const plain = [null, true, -1, 0, 1e308, 4, 5, 2 ** 53, '', 'code', 'markdown', 'stream', 'display_data', text(chance, 4), 'x'.repeat(chance.below(2000))];
  const kind = depth > 6 ? 0 : chance.below(4);
  if (kind < 2) return chance.of(plain);
  const members = chance.below(6);
  if (kind === 2) return Array.from({ length: members }, () => value(chance, depth + 1));
  const names = [
    'cells',
    'cell_type',
    'source',
    'outputs',
    'output_type',
    'data',
    'text/html',
    'text/plain',
    'image/png',
    'image/svg+xml',
    'metadata',
    'id',
    'execution_count',
    'traceback',
    'nbformat',
    'nbformat_minor',
    'ros2wasm',
    'do',
    'node',
    'topic',
    'type',
    'message',
    'request',
    'value',
    'name',
    'length',
    'toString',
    'constructor',
    'attachments',
  ];
  // JSON.parse makes a member of that name, which a literal does not.
  const made = chance.below(8) === 0 ? JSON.parse('{"__proto__": {"polluted": 1}}') as Record<string, unknown> : {};
  for (let i = 0; i < members; i += 1) made[chance.of(names)] = value(chance, depth + 1);
  return made;
}

each('notebooks', (chance) => {
  const whole = { nbformat: 4, nbformat_minor: chance.below(7), metadata: value(chance), cells: Array.from({ length: chance.below(8) }, () => value(chance)) };
  const json = JSON.stringify(chance.below(4) === 0 ? value(chance) : whole);
  const written = chance.below(3) === 0 ? json.slice(0, chance.below(json.length + 1)) : json;
  const found = readNotebook(written);
  if (found.kind === 'read') JSON.parse(writeNotebook(found.notebook));
  else assert.notEqual(found.reason, '');
});

each('commands of an embedding page', (chance) => {
  const order = ['hello', 'state', 'start', 'stop', 'publish', 'subscribe', 'call', 'set_parameter', 'height', 'checks', 'layout', '__proto__', 'constructor'];
  const sent = value(chance);
  const data = chance.below(4) === 0 || typeof sent !== 'object' || sent === null ? sent : { ...sent, ros2wasm: 1, id: chance.below(9), do: chance.of(order) };
  const read = readRequest(data);
  if (read === null) return;
  if (read.order instanceof Refusal) assert.match(read.order.code, /^R2W075\d$/);
  else assert.ok(order.includes(read.order.do));
});

/** Some bytes are others, some are gone, some come twice. */
function changed(bytes: Uint8Array, chance: Chance): Uint8Array<ArrayBuffer> {
  const parts = [...bytes];
  for (let i = 1 + chance.below(12); i > 0; i -= 1) {
    const at = chance.below(parts.length + 1);
    const act = chance.below(4);
    if (act === 0) parts[at] = chance.below(256);
    else if (act === 1) parts.splice(at, chance.below(40));
    else if (act === 2) parts.splice(at, 0, ...parts.slice(at, at + chance.below(200)));
    else parts.splice(at, 4, ...chance.of([[255, 255, 255, 255], [0, 0, 0, 128], [255, 255, 255, 127], [57, 57, 57, 57]]));
  }
  return Uint8Array.from(parts, (byte) => byte ?? 0);
}

const asBytes = (made: string | Uint8Array): Uint8Array => typeof made === 'string' ? new TextEncoder().encode(made) : made;

each('robot models', (chance) => {
  const robot =
    '<robot name="r"><material name="m"><color rgba="1 0 0 1"/></material><link name="a"><visual><origin xyz="0 0 1" rpy="0 0 0"/><geometry><box size="1 2 3"/></geometry>'
    + '<material name="m"/></visual></link><link name="b"/><joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="-1" upper="1"/><mimic joint="j"/></joint></robot>';
  const found = readUrdf(new TextDecoder().decode(changed(asBytes(robot), chance)));
  assert.ok(typeof found === 'string' || Array.isArray(found.links));
});

each('meshes', async (chance) => {
  const [kind, made] = chance.of([
    ['stl', asciiStl()],
    ['stl', binaryStl()],
    ['obj', obj()],
    ['gltf', gltf(`data:application/octet-stream;base64,${gltfNumbers().toString('base64')}`)],
    ['gltf', gltf('../../../../etc/passwd')],
  ] as const);
  const asked: string[] = [];
  const files = {
    size: (path: string) => {
      asked.push(path);
      return undefined;
    },
    read: () => assert.fail('no file is there'),
  };
  try {
    const { triangles } = await parseMesh(kind, 'share/m/mesh', changed(asBytes(made), chance).buffer, files);
    assert.ok(triangles > 0 && triangles < 1e7);
  } catch (error) {
    assert.ok(error instanceof Error && error.name !== 'AssertionError', String(error));
  }
  assert.ok(asked.every((path) => !path.startsWith('/') && !path.includes('..')), asked.join());
});
