// Words of the page outside its files of texts are found, and a translation takes the place of those files.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { htmlInOtherWords, htmlSentences, inOtherWords, sentencesOf } from '../../../runtime/other_sentences.ts';
import { languageOf, otherTexts } from '../../../runtime/other_texts.ts';
import { sentencesIn, wordsIn } from '../../tools/page_texts.ts';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));

test('words in content and in attributes that are read are found, wherever they come from', () => {
  const told = (body: string): readonly string[] => wordsIn(`export const C = (props) => ${body};`);
  assert.deepEqual(told('<p>Start all</p>'), ['Start all']);
  assert.deepEqual(told('<p>{props.on ? "Pause" : `Go on, ${props.name}`}</p>'), ['Pause', 'Go on, ']);
  assert.deepEqual(told('<button aria-label="Close" title={"Close " + props.name}><Icon name="close" /></button>'), ['Close', 'Close ']);
  assert.deepEqual(told('<input placeholder={props.hint ?? "Filter lines"} class="field wide" type="text" />'), ['Filter lines']);
  assert.deepEqual(told('<IconButton icon="play" label="Run it" />'), ['Run it']);
  assert.deepEqual(told('<>{props.open && <p>Open <b>now</b></p>}</>'), ['Open ', 'now']);
  // Nothing of these is a word of a language.
  assert.deepEqual(told('<p title={texts.close}>{texts.of(3)} \u00b7 {props.x} m 1:1<input placeholder="/cmd_vel" /><i>std_msgs/msg/String</i></p>'), []);
});

test('sentences are found wherever they stand, but not in bugs and names', () => {
  assert.deepEqual(sentencesIn("export const f = (n) => n > 3 ? `there are ${n} too many of them` : 'no such node';"), [' too many of them', 'no such node']);
  assert.deepEqual(
    sentencesIn("throw new TypeError('a graph has one direction'); const keys = ['Min Color Value', 'button drive-button drive-at', 'page embedded'];"),
    [],
  );
});

test('a folder of another language takes the place of the texts that it has', async () => {
  const folder = join(mkdtempSync(join(tmpdir(), 'ros2wasm-texts-')), 'de');
  mkdirSync(folder);
  try {
    const type = (path: string): string => JSON.stringify(join(ROOT, 'runtime/site/ui', path));
    writeFileSync(join(folder, 'texts_embed.ts'), `import type { embedTexts as english } from ${type('texts_embed.ts')};
import type { Translation } from ${type('translation.ts')};
export const embedTexts: Translation<typeof english> = {
  whole: 'Ganze Seite', wholeLong: (title) => \`Die ganze Seite von \${title}\`, foot: 'Rahmen',
};
`);
    const code = async (plugins: Parameters<typeof build>[0]['plugins']): Promise<string> => {
      const { outputFiles } = await build({
        stdin: {
          contents: "export { embedTexts } from './texts_embed.ts'; export { texts } from './texts.ts';",
          resolveDir: join(ROOT, 'runtime/site/ui'),
        },
        bundle: true,
        write: false,
        format: 'esm',
        charset: 'utf8',
        plugins: plugins ?? [],
      });
      return outputFiles?.[0]?.text ?? '';
    };
    assert.doesNotMatch(await code([]), /Ganze Seite/);
    const german = await code([otherTexts(folder)]);
    assert.match(german, /Ganze Seite/);
    // Texts without a translation are still English.
    assert.match(german, /Stop all/);
    assert.equal(languageOf(`${folder}/`), 'de');
  } finally {
    rmSync(join(folder, '..'), { recursive: true });
  }
});

test('sentences of problems and checks are found where they are made, and told in other words', async () => {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-texts-'));
  try {
    const file = join(folder, 'asked.ts');
    writeFileSync(file, `class SiteError { constructor(code: string, readonly what: string, readonly more: object = {}) {} }
const state = { kind: 'it stays as it is', reason: 'nobody knows why' } as const;
export const f = (name: string, n: number): unknown =>
  [state, new SiteError('R2W0700', \`the node \\\`\${name}\\\` has \${n > 1 ? \`\${n} things\` : 'one thing'} too many\`, { why: ['so it is', name], place: 'not a word of it' })];
export const bug = (): never => { throw new TypeError('this is for us'); };
`);
    assert.deepEqual(sentencesOf(file), [
      'nobody knows why',
      'the node `{1}` has {2} too many',
      '{1} things',
      'one thing',
      'so it is',
      'not a word of it',
    ]);
    const other = inOtherWords(file, {
      'the node `{1}` has {2} too many': '{2} zu viel hat `{1}` für $5',
      '{1} things': '{1} Dinge',
      'nobody knows why': 'warum, ${weiß} \\ keiner',
      'one thing': '',
    }) ?? assert.fail();
    const { f } = await import(`data:text/javascript,${encodeURIComponent(other)}`) as {
      f: (name: string, n: number) => readonly { readonly what?: string; }[];
    };
    assert.deepEqual(f('a', 2).map((one) => ({ ...one })), [
      { kind: 'it stays as it is', reason: 'warum, ${weiß} \\ keiner' },
      { what: '2 Dinge zu viel hat `a` für $5', more: { why: ['so it is', 'a'], place: 'not a word of it' } },
    ]);
    assert.equal(f('a', 1)[1]?.what, 'one thing zu viel hat `a` für $5');
    assert.equal(inOtherWords(file, {}), undefined);
    assert.throws(() => inOtherWords(file, { 'one thing': '{1}' }), /nothing is put in at \{1\}/);
  } finally {
    rmSync(folder, { recursive: true });
  }
  const html = '<meta name="description" content="A page."><p class="x">Run <code>it</code> now</p><dl><dt>why</dt><dd>so</dd></dl>';
  assert.deepEqual(htmlSentences(html), ['Run <code>it</code> now', 'why', 'so', 'A page.']);
  assert.equal(htmlInOtherWords(html, { 'A page.': 'Eine Seite.', 'Run <code>it</code> now': 'Jetzt <code>it</code>', why: 'warum' }),
    '<meta name="description" content="Eine Seite."><p class="x">Jetzt <code>it</code></p><dl><dt>warum</dt><dd>so</dd></dl>');
});
