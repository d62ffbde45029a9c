// Words that visitors of a page read stand in runtime/site/ui/texts*.ts alone: finds them in its components, as text content
// and in attributes that are read, and sentences in everything else. Symbols and names of ROS and of files are the same
// in every language: only text with two letters in a row that is no such name counts.

import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parse } from 'acorn';
import { transformSync } from 'esbuild';

const ROOT = 'runtime/site/ui';
/** Attributes that are seen or heard, and props of our own parts that become such. */
const READ = new Set(['children', 'aria-label', 'aria-description', 'aria-roledescription', 'aria-valuetext', 'title', 'placeholder', 'alt', 'label', 'words',
  'note']);
/** `/cmd_vel`, `geometry_msgs/msg/Twist`, `CITATION.cff`, and what stands before a code in a terminal: `error[`. */
const NAME = /^\/?[a-z]\w*(\/\w+)+$|^\/\w+$|^\w+\.\w+$|^error\[$/;

function isWords(text: string): boolean {
  return /\p{L}{2}/u.test(text) && !NAME.test(text.trim());
}

/** Three words one after the other that are no names, as keys of RViz's files are: `Min Color Value`. */
const SENTENCE = /(?<![\p{L}\p{N}-])\p{L}{2,} \p{Ll}{2,} \p{Ll}{2,}(?![\p{L}\p{N}-])/u;
/** Texts that are not from ros2wasm: one that `patch` must read, one that Python prints. */
const NOT_OURS = new Set(['\\ No newline at end of file', 'Traceback (most recent call last)']);

type Tree = Readonly<Record<string, unknown>>;

function isTree(value: unknown): value is Tree {
  return typeof value === 'object' && value !== null;
}

function trees(value: unknown): readonly Tree[] {
  return (Array.isArray(value) ? value : [value]).filter(isTree);
}

/** The literal texts that an expression can give: in both arms of conditions, in templates and lists. */
function literals(node: unknown): readonly string[] {
  if (!isTree(node)) return [];
  switch (node['type']) {
    case 'Literal':
      return typeof node['value'] === 'string' ? [node['value']] : [];
    case 'TemplateLiteral':
      return trees(node['quasis']).flatMap(({ value }) => trees(value).map(({ cooked }) => String(cooked)));
    case 'ConditionalExpression':
      return [...literals(node['consequent']), ...literals(node['alternate'])];
    case 'BinaryExpression':
      return node['operator'] === '+' ? [...literals(node['left']), ...literals(node['right'])] : [];
    case 'LogicalExpression':
      return [...literals(node['left']), ...literals(node['right'])];
    case 'ArrayExpression':
      return trees(node['elements']).flatMap(literals);
    default:
      return [];
  }
}

function parsed(text: string): readonly Tree[] {
  const { code } = transformSync(text, { loader: 'tsx', format: 'esm', jsx: 'automatic', jsxImportSource: 'preact' });
  return trees(parse(code, { ecmaVersion: 'latest', sourceType: 'module' }));
}

/** Sentences that stand anywhere in a program. What a TypeError says is for whoever mends the bug. */
export function sentencesIn(text: string): readonly string[] {
  const found: string[] = [];
  const visit = (node: Tree): void => {
    if (node['type'] === 'NewExpression' && trees(node['callee']).some(({ name }) => name === 'TypeError')) return;
    if (node['type'] === 'Literal' || node['type'] === 'TemplateLiteral')
      found.push(...literals(node).filter((one) => SENTENCE.test(one) && !NOT_OURS.has(one)));
    for (const part of Object.values(node)) trees(part).forEach(visit);
  };
  parsed(text).forEach(visit);
  return found;
}

/** The words that stand in a component's text. */
export function wordsIn(text: string): readonly string[] {
  const found: string[] = [];
  const visit = (node: Tree): void => {
    // A JSX element after esbuild has transformed it.
    if (node['type'] === 'CallExpression' && trees(node['callee']).some(({ name }) => name === 'jsx' || name === 'jsxs')) {
      for (const { key, value } of trees(trees(node['arguments'])[1]?.['properties']))
        if (trees(key).some(({ name, value: quoted }) => READ.has(String(name ?? quoted)))) found.push(...literals(value).filter(isWords));
    }
    for (const part of Object.values(node)) trees(part).forEach(visit);
  };
  parsed(text).forEach(visit);
  return found;
}

if (process.argv[1]?.endsWith('page_texts.ts') === true) {
  for (const name of readdirSync(ROOT, { recursive: true, encoding: 'utf8' }).filter((one) => /(?<!^texts\w*)\.tsx?$/.test(one))) {
    const text = readFileSync(join(ROOT, name), 'utf8');
    for (const words of new Set([...wordsIn(text), ...sentencesIn(text)])) {
      console.log(`${join(ROOT, name)}: \u201c${words.trim()}\u201d belongs into runtime/site/ui/texts*.ts`);
      process.exitCode = 1;
    }
  }
}
