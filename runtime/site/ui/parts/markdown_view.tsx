// Draws Markdown: tokens become elements, text becomes text. HTML in it is shown as it is written; links lead to the
// web in a tab of their own, to a heading, or do what they say (model/page_action.ts); images are files of the site.

import { createElement } from 'preact';
import type { ComponentChildren } from 'preact';
import type { Tokens } from 'marked';
import { useEffect, useState } from 'preact/hooks';
import { addressBeside, addressOfSite } from '../../program/carried_files.ts';
import { headingId, readMarkdown, sitePath } from '../model/markdown.ts';
import type { MarkdownToken } from '../model/markdown.ts';
import { isPageAction, readPageAction } from '../model/page_action.ts';
import type { PageAction } from '../model/page_action.ts';
import { panelTexts } from '../texts_panels.ts';
import { MathView } from './math_view.tsx';

export interface MarkdownProps {
  readonly text: string;
  /** Its path in the site. */
  readonly file: string;
  /** Paths of the site's files. */
  readonly files: ReadonlySet<string>;
  /** Begins the ids of headings. */
  readonly instance: string;
  readonly act: (action: PageAction) => void;
}

type Context = Omit<MarkdownProps, 'text'>;

const MOST_DEPTH = 60;

export function MarkdownView({ text, ...context }: MarkdownProps) {
  const tokens = readMarkdown(text);
  if (tokens === null) return <pre>{text}</pre>;
  return <>{blocks(tokens, context, 0)}</>;
}

function blocks(
  tokens: readonly MarkdownToken[] | undefined,
  context: Context,
  depth: number,
): ComponentChildren {
  if (depth > MOST_DEPTH) return null;
  return (tokens ?? []).map((token) => element(token as Tokens.Generic, context, depth + 1));
}

function element(token: Tokens.Generic, context: Context, depth: number): ComponentChildren {
  const inside = (): ComponentChildren => blocks(token.tokens, context, depth);
  switch (token.type) {
    case 'space':
    case 'def':
      return null;
    case 'heading':
      return heading(token as Tokens.Heading, context, inside());
    case 'paragraph':
      return <p>{inside()}</p>;
    case 'blockquote':
      return <blockquote>{inside()}</blockquote>;
    case 'list':
      return list(token as Tokens.List, context, depth);
    case 'code':
      return <pre tabIndex={0}>{plain(token['text'])}</pre>;
    case 'hr':
      return <hr />;
    case 'table':
      return table(token as Tokens.Table, context, depth);
    case 'strong':
      return <strong>{inside()}</strong>;
    case 'em':
      return <em>{inside()}</em>;
    case 'del':
      return <del>{inside()}</del>;
    case 'codespan':
      return <code>{plain(token['text'])}</code>;
    case 'br':
      return <br />;
    case 'link':
      return link(plain(token['href']), inside(), context);
    case 'image':
      return image(token as Tokens.Image, context);
    case 'inline_math':
    case 'block_math':
      return <MathView tex={plain(token['text'])} block={token.type === 'block_math'} />;
    case 'text':
      return token.tokens === undefined ? unescaped(token) : inside();
    case 'checkbox':
      return null;
    default:
      // HTML, and whatever else there may be: as it is written.
      return token.raw;
  }
}

/** A heading below the page's own (h1) and the panel's (h2). */
function heading(token: Tokens.Heading, context: Context, inside: ComponentChildren): ComponentChildren {
  const level = Math.min(6, token.depth + 2);
  return createElement(
    `h${level}`,
    { id: anchor(context, headingId(token.text)), class: `text-h${token.depth}`, tabIndex: -1 },
    inside,
  );
}

function anchor(context: Context, id: string): string {
  return `text-${context.instance}-${id}`;
}

function list(token: Tokens.List, context: Context, depth: number): ComponentChildren {
  const items = token.items.map((item) => (
    <li class={item.task ? 'text-task' : ''}>
      {item.task
        ? (
          <span>
            <span aria-hidden="true">{item.checked === true ? '\u2611 ' : '\u2610 '}</span>
            <span class="visually-hidden">
              {item.checked === true ? panelTexts.text.done : panelTexts.text.open}
            </span>
          </span>
        )
        : null}
      {blocks(item.tokens, context, depth)}
    </li>
  ));
  const start = typeof token.start === 'number' ? token.start : 1;
  return token.ordered ? <ol start={start}>{items}</ol> : <ul>{items}</ul>;
}

function table(token: Tokens.Table, context: Context, depth: number): ComponentChildren {
  const cells = (row: readonly Tokens.TableCell[], tag: 'th' | 'td'): ComponentChildren =>
    row.map((cell) =>
      createElement(
        tag,
        { class: cell.align === null ? '' : `text-${cell.align}` },
        blocks(cell.tokens, context, depth),
      )
    );
  return (
    <div class="text-table" role="group" aria-label={panelTexts.text.table} tabIndex={0}>
      <table>
        <thead>
          <tr>{cells(token.header, 'th')}</tr>
        </thead>
        <tbody>
          {token.rows.map((row) => (
            <tr>{cells(row, 'td')}</tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Files that a browser would open as pages of the site, with their scripts. */
const DOCUMENT = /\.(?:x?html?|xht|svgz?|xml|xsl)$/i;

function link(href: string, words: ComponentChildren, context: Context): ComponentChildren {
  if (isPageAction(href)) {
    const action = readPageAction(href);
    return (
      <button
        type="button"
        class="text-action"
        aria-disabled={action === null ? 'true' : undefined}
        title={action === null ? panelTexts.text.noAction : undefined}
        onClick={() => {
          if (action !== null) context.act(action);
        }}
      >
        {words}
      </button>
    );
  }
  if (href.startsWith('#')) {
    const id = anchor(context, headingId(decoded(href.slice(1))));
    const go = (event: Event): void => {
      // The address keeps what it has: a layout may stand in it.
      event.preventDefault();
      const target = document.getElementById(id);
      target?.scrollIntoView();
      target?.focus();
    };
    return (
      <a href={`#${id}`} onClick={go}>
        {words}
      </a>
    );
  }
  if (/^(https?|mailto):/i.test(href)) {
    return (
      <a href={href} target="_blank" rel="noopener noreferrer">
        {words}
      </a>
    );
  }
  const path = sitePath(context.file, href);
  return path !== null && context.files.has(path)
    ? (
      <a href={encodeURI(path)} target="_blank" rel="noopener" download={DOCUMENT.test(path)}>
        {words}
      </a>
    )
    : (
      <span title={href}>{words}</span>
    );
}

function image(token: Tokens.Image, context: Context): ComponentChildren {
  const path = sitePath(context.file, token.href);
  if (path === null || !context.files.has(path))
    return <span class="text-missing">{token.text === '' ? panelTexts.text.image : token.text}</span>;
  return <SiteImage key={path} path={path} words={token.text} />;
}

/** At once where the file lies beside the page. */
function SiteImage({ path, words }: { readonly path: string; readonly words: string; }) {
  const [address, setAddress] = useState(addressBeside(path));
  useEffect(() => {
    // One that cannot be had leaves its words.
    if (address === undefined) void addressOfSite(path).then(setAddress, () => undefined);
  }, [path, address]);
  return <img src={address} alt={words} loading="lazy" />;
}

/** The lexer keeps `\*` as an escape token, and leaves entities such as `&amp;` for a browser to read. */
function unescaped(token: Tokens.Generic): string {
  return plain(token['text']).replace(/&(?:amp|lt|gt|quot|#39);/g, (entity) => ENTITIES[entity] ?? entity);
}

const ENTITIES: Readonly<Record<string, string>> = {
  '&amp;': '&',
  '&lt;': '<',
  '&gt;': '>',
  '&quot;': '"',
  '&#39;': "'",
};

function plain(value: unknown): string {
  return typeof value === 'string' ? value : '';
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
