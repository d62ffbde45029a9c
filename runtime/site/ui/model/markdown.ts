// Markdown to a tree of tokens: GitHub's dialect, with math between $...$ and $$...$$. Nothing is made to markup here
// or later: parts/markdown_view.tsx turns tokens into elements, and HTML in the text stays text.

import { Marked } from 'marked';
import type { Token, TokenizerAndRendererExtension } from 'marked';

export type MarkdownToken = Token;

/** A longer text is shown as its source. */
const MOST_TEXT = 1 << 20;

const BLOCK_MATH: TokenizerAndRendererExtension = {
  name: 'block_math',
  level: 'block',
  start: (source) => source.match(/^\$\$/m)?.index,
  tokenizer(source) {
    const match = /^\$\$([^$]{1,5000})\$\$[ \t]*(?:\n|$)/.exec(source);
    return match === null ? undefined : { type: 'block_math', raw: match[0], text: (match[1] ?? '').trim() };
  },
};

const INLINE_MATH: TokenizerAndRendererExtension = {
  name: 'inline_math',
  level: 'inline',
  start: (source) => source.match(/\$/)?.index,
  tokenizer(source) {
    // As in other tools: no space inside the signs, no digit behind, so that "5 $ or 6 $" is money.
    const match = /^\$(?!\s)([^$\n]{1,1000}?)(?<!\s)\$(?!\d)/.exec(source);
    return match === null ? undefined : { type: 'inline_math', raw: match[0], text: match[1] ?? '' };
  },
};

const READER = new Marked({ gfm: true, extensions: [BLOCK_MATH, INLINE_MATH] });

/** null when the text cannot be read: too long, or nested too deep. */
export function readMarkdown(text: string): readonly MarkdownToken[] | null {
  if (text.length > MOST_TEXT) return null;
  try {
    return READER.lexer(text);
  } catch {
    return null;
  }
}

/** The id of a heading, as GitHub makes it. */
export function headingId(text: string): string {
  return text
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, '')
    .trim()
    .replace(/\s/g, '-');
}

/** A path in the text, as a path of the site; null when it leads out of the text's folders, or is an address. */
export function sitePath(textFile: string, path: string): string | null {
  if (/^[a-z][a-z0-9+.-]*:/i.test(path) || path.startsWith('/') || path.startsWith('#')) return null;
  let plain: string;
  try {
    plain = decodeURIComponent(path.replace(/[?#].*$/, ''));
  } catch {
    return null;
  }
  const parts = textFile.split('/').slice(0, -1);
  const root = 1;
  for (const part of plain.split('/')) {
    if (part === '' || part === '.') continue;
    if (part !== '..') parts.push(part);
    else if (parts.length > root) parts.pop();
    else return null;
  }
  return parts.join('/');
}
