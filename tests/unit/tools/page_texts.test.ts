// Words of the page outside its files of texts are found, and a translation takes the place of those files.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { languageOf, otherTexts } from '../../../runtime/other_texts.ts';
import { sentencesIn, wordsIn } from '../../tools/page_texts.ts';

const kRoot = fileURLToPath(new URL('../../..', import.meta.url));

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
  assert.deepEqual(sentencesIn("throw new TypeError('a graph has one direction'); const keys = ['Min Color Value', 'button drive-button drive-at', 'page embedded'];"), []);
});

test('a folder of another language takes the place of the texts that it has', async () => {
  const folder = join(mkdtempSync(join(tmpdir(), 'ros2wasm-texts-')), 'de');
  mkdirSync(folder);
  try {
    const type = (path: string): string => JSON.stringify(join(kRoot, 'runtime/ui', path));
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
          resolveDir: join(kRoot, 'runtime/ui'),
        },
        bundle: true, write: false, format: 'esm', charset: 'utf8', plugins: plugins ?? [],
      });
      return outputFiles?.[0]?.text ?? '';
    };
    assert.doesNotMatch(await code([]), /Ganze Seite/);
    const german = await code([otherTexts(folder)]);
    assert.match(german, /Ganze Seite/);
    // What it has not is English still.
    assert.match(german, /Stop all/);
    assert.equal(languageOf(`${folder}/`), 'de');
  } finally {
    rmSync(join(folder, '..'), { recursive: true });
  }
});
