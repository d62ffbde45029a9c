// Draws the HTML of a notebook's output, as far as it is harmless (model/html.ts).

import { createElement } from 'preact';
import type { ComponentChildren } from 'preact';
import { useMemo } from 'preact/hooks';
import { readHtml } from '../model/html.ts';
import type { HtmlNode } from '../model/html.ts';
import { viewTexts } from '../texts_views.ts';

export function HtmlView({ html }: { readonly html: string; }) {
  const nodes = useMemo(() => readHtml(html), [html]);
  return nodes === null ? <p class="hint">{viewTexts.notebook.tooMuch}</p> : <div class="html">{nodes.map(drawn)}</div>;
}

function drawn(node: HtmlNode): ComponentChildren {
  if (typeof node === 'string') return node;
  const { tag, attributes, style, children } = node;
  const outside = tag === 'a' && attributes['href'] !== undefined ? { target: '_blank', rel: 'noopener noreferrer' } : {};
  const words = tag === 'img' ? { alt: '' } : {};
  return createElement(tag, { ...words, ...attributes, ...outside, style }, ...children.map(drawn));
}
