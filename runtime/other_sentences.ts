// The door for another language, for what visitors read that is in no file of texts: what problems say, why, and the way
// out; the words of checks; and what stands in index.html before the page's program runs. Each such sentence is found
// where it is made and replaced there when the page is built, so that the page itself carries one language.
// A table has English -> other. `{1}`, `{2}` stand for what is put in, in the English order; HTML keeps its tags.

import { readFileSync } from 'node:fs';
import { parse } from 'acorn';
import { type Plugin, transformSync } from 'esbuild';

export type Sentences = Readonly<Record<string, string>>;

type Tree = Readonly<Record<string, unknown>> & { readonly start: number; readonly end: number; };

/** Files whose words are all read by visitors. */
const wordsOfChecks = /\/check_(words|looks)\.ts$/;
/** Property names of an object that describes a problem. */
const tellingNames = new Set(['what', 'why', 'fix', 'reason']);
/** The files that have such sentences, besides those in runtime/site/ui. */
const sentenceFiles = /\/runtime\/site\/(contract|bus|program|python|workers|launch|page|checks|session|bag|decode)\/\w+\.ts$/;
/** Patterns for index.html: paragraphs and rows with their tags, and the description that search engines show. */
const htmlTexts = [/(<(p|dt|dd)\b[^>]*>)([^]*?)(?=<\/\2>)/g, /(<(meta) name="description" content=")([^"]*)/g];

const isTree = (value: unknown): value is Tree => typeof value === 'object' && value !== null && 'type' in value;
const trees = (value: unknown): readonly Tree[] => (Array.isArray(value) ? value : [value]).filter(isTree);
const isSentence = (text: string): boolean => /\p{L}{2}/u.test(text) && text.includes(' ');

/** One that stands empty in the table is not translated yet. */
const has = (table: Sentences, text: string): boolean => Object.hasOwn(table, text) && table[text] !== '';

/** As a table has it. */
function english(node: Tree): string | undefined {
  if (node['type'] === 'Literal') return typeof node['value'] === 'string' ? node['value'] : undefined;
  if (node['type'] !== 'TemplateLiteral') return undefined;
  return trees(node['quasis']).map(({ value }, i) => `${i === 0 ? '' : `{${i}}`}${(value as { cooked: string; }).cooked}`).join('');
}

/** The literals that visitors read, outer ones before those that are put into them. */
function literals(code: string, path: string): readonly Tree[] {
  const found: Tree[] = [];
  const visit = (node: Tree, read: boolean): void => {
    if (read && (node['type'] === 'Literal' || node['type'] === 'TemplateLiteral') && isSentence(english(node) ?? '')) found.push(node);
    const isError = node['type'] === 'NewExpression' && trees(node['callee']).some(({ name }) => name === 'SiteError');
    // A TypeError is for whoever mends the bug.
    const isBug = node['type'] === 'NewExpression' && trees(node['callee']).some(({ name }) => name === 'TypeError' || name === 'RegExp');
    const tells = node['type'] === 'Property' && trees(node['key']).some(({ name }) => tellingNames.has(String(name)));
    if (isBug) return;
    for (const [name, part] of Object.entries(node)) {
      for (const one of trees(part)) visit(one, read || (isError && name === 'arguments') || (tells && name === 'value'));
    }
  };
  for (const tree of trees(parse(code, { ecmaVersion: 'latest', sourceType: 'module' }))) visit(tree, wordsOfChecks.test(path));
  return found;
}

function script(path: string): string {
  return transformSync(readFileSync(path, 'utf8'), { loader: 'ts', format: 'esm', charset: 'utf8' }).code;
}

export function sentencesOf(path: string): readonly string[] {
  const code = script(path);
  return literals(code, path).map((node) => english(node) ?? '');
}

export function htmlSentences(html: string): readonly string[] {
  return htmlTexts.flatMap((pattern) => [...html.matchAll(pattern)].map(([, , , text]) => text ?? '')).filter((text) => /\p{L}{2}/u.test(text));
}

/** The file as JavaScript with the sentences that the table has; undefined: it has none of this file. */
export function inOtherWords(path: string, table: Sentences): string | undefined {
  const code = script(path);
  const found = literals(code, path).filter((node) => has(table, english(node) ?? ''));
  if (found.length === 0) return undefined;
  const between = (start: number, end: number): string => {
    let text = '';
    let at = start;
    for (const node of found) {
      if (node.start < at || node.end > end) continue;
      text += code.slice(at, node.start) + told(node);
      at = node.end;
    }
    return text + code.slice(at, end);
  };
  const told = (node: Tree): string => {
    const given = trees(node['expressions']);
    const words = table[english(node) ?? ''] ?? '';
    const parts = words.split(/\{(\d+)\}/).map((part, i) => {
      if (i % 2 === 0) return part.replace(/[`\\]|\$(?=\{)/g, '\\$&');
      const expression = given[Number(part) - 1];
      if (expression === undefined) throw new Error(`nothing is put in at {${part}} of: ${words}`);
      return `\${${between(expression.start, expression.end)}}`;
    });
    return `\`${parts.join('')}\``;
  };
  return between(0, code.length);
}

export function htmlInOtherWords(html: string, table: Sentences): string {
  const put = (before: string, pattern: RegExp): string =>
    before.replace(pattern, (whole: string, head: string, _tag: string, text: string) => (has(table, text) ? head + (table[text] ?? '') : whole));
  return htmlTexts.reduce(put, html);
}

/** A plugin of esbuild. Adds to `seen` the sentences of the files that it builds. */
export function otherSentences(table: Sentences, seen: Set<string>): Plugin {
  return {
    name: 'other-sentences',
    setup(esbuild) {
      esbuild.onLoad({ filter: sentenceFiles }, ({ path }) => {
        for (const sentence of sentencesOf(path)) seen.add(sentence);
        const contents = inOtherWords(path, table);
        return contents === undefined ? undefined : { contents, loader: 'js' };
      });
    },
  };
}
