// The HTML of a notebook's outputs as a tree of what is harmless: listed elements, attributes and styles. It is read here and
// not by the browser, which Trusted Types guard; nothing in it runs, loads, or stands outside of its place.

export interface HtmlElement {
  readonly tag: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly style: Readonly<Record<string, string>>;
  readonly children: readonly HtmlNode[];
}

export type HtmlNode = string | HtmlElement;

interface OpenElement extends HtmlElement {
  readonly children: HtmlNode[];
  /** As it is written: several become a `div`. */
  readonly name: string;
}

const MOST_TEXT = 4 << 20;
const MOST_NODES = 50_000;
const MOST_DEPTH = 60;

const AS_WRITTEN: ReadonlySet<string> = new Set([
  'a',
  'abbr',
  'b',
  'blockquote',
  'br',
  'caption',
  'code',
  'col',
  'colgroup',
  'dd',
  'del',
  'details',
  'div',
  'dl',
  'dt',
  'em',
  'figcaption',
  'figure',
  'hr',
  'i',
  'img',
  'ins',
  'kbd',
  'li',
  'mark',
  'meter',
  'ol',
  'p',
  'pre',
  'progress',
  'q',
  's',
  'samp',
  'small',
  'span',
  'strong',
  'sub',
  'summary',
  'sup',
  'table',
  'tbody',
  'td',
  'tfoot',
  'th',
  'thead',
  'tr',
  'u',
  'ul',
  'var',
]);
/** An output is not part of the page's outline. */
const HEADINGS: ReadonlySet<string> = new Set(['h1', 'h2', 'h3', 'h4', 'h5', 'h6']);
const BLOCKS: ReadonlySet<string> = new Set(['article', 'aside', 'center', 'footer', 'header', 'main', 'nav', 'section']);
const EMPTY: ReadonlySet<string> = new Set(['br', 'col', 'hr', 'img']);
/** With all that is in them. `svg` becomes an image. */
const DROPPED: ReadonlySet<string> = new Set([
  'script',
  'style',
  'iframe',
  'object',
  'embed',
  'template',
  'noscript',
  'noembed',
  'noframes',
  'textarea',
  'select',
  'title',
  'xmp',
  'math',
  'svg',
  'video',
  'audio',
  'canvas',
  'applet',
  'frameset',
  'plaintext',
]);
/** For each element: the open elements that it closes, and the ones at which that ends, since they contain both. */
const ENDS: Readonly<Record<string, readonly [ends: readonly string[], within: readonly string[]]>> = {
  li: [['li'], ['ul', 'ol']],
  dt: [['dt', 'dd'], ['dl']],
  dd: [['dt', 'dd'], ['dl']],
  tr: [['tr', 'td', 'th'], ['table', 'thead', 'tbody', 'tfoot']],
  td: [['td', 'th'], ['tr']],
  th: [['td', 'th'], ['tr']],
  thead: [['thead', 'tbody', 'tfoot', 'tr', 'td', 'th'], ['table']],
  tbody: [['thead', 'tbody', 'tfoot', 'tr', 'td', 'th'], ['table']],
  tfoot: [['thead', 'tbody', 'tfoot', 'tr', 'td', 'th'], ['table']],
  p: [['p'], ['div', 'td', 'th', 'li', 'blockquote', 'details']],
};

const STYLES: ReadonlySet<string> = new Set([
  'background',
  'background-color',
  'border',
  'border-bottom',
  'border-collapse',
  'border-color',
  'border-left',
  'border-radius',
  'border-right',
  'border-spacing',
  'border-style',
  'border-top',
  'border-width',
  'color',
  'display',
  'font-family',
  'font-size',
  'font-style',
  'font-variant',
  'font-weight',
  'gap',
  'height',
  'letter-spacing',
  'line-height',
  'list-style',
  'margin',
  'margin-bottom',
  'margin-left',
  'margin-right',
  'margin-top',
  'max-width',
  'min-width',
  'opacity',
  'padding',
  'padding-bottom',
  'padding-left',
  'padding-right',
  'padding-top',
  'text-align',
  'text-decoration',
  'text-transform',
  'vertical-align',
  'white-space',
  'width',
]);
/** No function but colours, nothing that moves out of its place: a sign of minus stands only within a word. */
const STYLE_VALUE = /^(?!.*(?<!\b(?:rgb|hsl)a?)\()(?!.*(?<![a-z])-)[\w\s#.,%()'"/+-]{1,200}$/is;

const ENTITIES: Readonly<Record<string, string>> = {
  amp: '&',
  lt: '<',
  gt: '>',
  quot: '"',
  apos: "'",
  nbsp: '\u00a0',
  middot: '\u00b7',
  times: '\u00d7',
  deg: '\u00b0',
  micro: '\u00b5',
  ndash: '\u2013',
  mdash: '\u2014',
  hellip: '\u2026',
  larr: '\u2190',
  rarr: '\u2192',
  uarr: '\u2191',
  darr: '\u2193',
  plusmn: '\u00b1',
  le: '\u2264',
  ge: '\u2265',
  ne: '\u2260',
  alpha: '\u03b1',
  beta: '\u03b2',
  theta: '\u03b8',
  omega: '\u03c9',
  pi: '\u03c0',
  copy: '\u00a9',
};

export function decodeEntities(text: string): string {
  return text.replace(/&(?:#(\d{1,7})|#x([0-9a-f]{1,6})|([a-z]{2,8}));/gi, (whole, decimal, hex, name) => {
    if (name !== undefined) return Object.hasOwn(ENTITIES, name) ? (ENTITIES[name] ?? whole) : whole;
    const code = decimal === undefined ? Number.parseInt(hex, 16) : Number(decimal);
    return code > 0 && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) ? String.fromCodePoint(code) : '\ufffd';
  });
}

/** null: too long, or too much of it. */
export function readHtml(text: string): readonly HtmlNode[] | null {
  return text.length > MOST_TEXT ? null : new Reader(text).read();
}

const TAG = /<(\/?)([a-z][a-z0-9-]*)/iy;
const ATTRIBUTE = /([^\s=>"'/]+)(?:\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s"'>]+)))?/g;

class Reader {
  private readonly text: string;
  private readonly root: OpenElement = { name: '', tag: 'div', attributes: {}, style: {}, children: [] };
  private readonly open: OpenElement[] = [this.root];
  private nodes = 0;
  private unclosed = false;

  constructor(text: string) {
    this.text = text;
  }

  read(): readonly HtmlNode[] | null {
    const { text } = this;
    const lower = text.toLowerCase();
    let at = 0;
    while (at < text.length && this.nodes <= MOST_NODES) {
      const next = text.indexOf('<', at);
      if (next < 0) {
        this.add(decodeEntities(text.slice(at)));
        break;
      }
      if (next > at) this.add(decodeEntities(text.slice(at, next)));
      at = this.markup(lower, next);
    }
    return this.nodes > MOST_NODES ? null : this.root.children;
  }

  /** Reads the markup that begins with "<" at `at`; returns where it ends. */
  private markup(lower: string, at: number): number {
    const { text } = this;
    const after = (mark: string, from: number): number => {
      const end = lower.indexOf(mark, from);
      return end < 0 ? text.length : end + mark.length;
    };
    if (text.startsWith('<!--', at)) return after('-->', at + 4);
    if (text.startsWith('<!', at) || text.startsWith('<?', at)) return after('>', at);
    TAG.lastIndex = at;
    const tag = TAG.exec(text);
    if (tag === null) {
      this.add('<');
      return at + 1;
    }
    const [begin, slash = '', written = ''] = tag;
    const name = written.toLowerCase();
    const end = this.endOfTag(at + begin.length);
    if (end === null) {
      this.add('<');
      return at + 1;
    }
    const attributes = text.slice(at + begin.length, end - 1);
    if (slash !== '') {
      this.end(name);
      return end;
    }
    if (DROPPED.has(name)) {
      const over = attributes.endsWith('/') && name === 'svg' ? end : after(`</${name}>`, end);
      if (name === 'svg') this.add(drawing(text.slice(at, over)));
      return over;
    }
    this.begin(name, attributes);
    return end;
  }

  /** Behind its ">", which may stand in a value too. null: there is none. */
  private endOfTag(from: number): number | null {
    const { text } = this;
    let quote = '';
    for (let at = from; at < text.length && !this.unclosed; at += 1) {
      const sign = text.charAt(at);
      if (quote !== '') quote = sign === quote ? '' : quote;
      else if (sign === '>') return at + 1;
      else if ((sign === '"' || sign === "'") && /=\s{0,9}$/.test(text.slice(Math.max(from, at - 10), at))) quote = sign;
    }
    // Nor is there one for what follows: nobody looks to the end again.
    this.unclosed = true;
    return null;
  }

  private add(node: HtmlNode): void {
    if (node === '') return;
    this.nodes += 1;
    this.open.at(-1)?.children.push(node);
  }

  private begin(name: string, attributes: string): void {
    const rule = Object.hasOwn(ENDS, name) ? ENDS[name] : undefined;
    if (rule !== undefined) this.endWithin(...rule);
    const heading = HEADINGS.has(name);
    if (!AS_WRITTEN.has(name) && !heading && !BLOCKS.has(name)) return;
    const element: OpenElement = {
      name,
      tag: heading || BLOCKS.has(name) ? 'div' : name,
      ...readAttributes(name, attributes),
      children: [],
    };
    if (heading) (element.attributes as Record<string, string>)['class'] = `html-heading html-${name}`;
    if (name === 'img' && element.attributes['src'] === undefined) {
      this.add(element.attributes['alt'] ?? '');
      return;
    }
    this.add(element);
    // Deeper ones lie beside each other.
    if (!EMPTY.has(name) && this.open.length < MOST_DEPTH) this.open.push(element);
  }

  /** Closes these down to the innermost that holds them. */
  private endWithin(ends: readonly string[], within: readonly string[]): void {
    for (let at = this.open.length - 1; at > 0; at -= 1) {
      const name = this.open[at]?.name ?? '';
      if (within.includes(name)) return;
      if (ends.includes(name)) this.open.length = at;
    }
  }

  private end(name: string): void {
    for (let at = this.open.length - 1; at > 0; at -= 1) {
      if (this.open[at]?.name === name) {
        this.open.length = at;
        return;
      }
    }
  }
}

/** For an image, in which no script runs and nothing is loaded. A half of a surrogate pair has no such form. */
export function svgAddress(svg: string): string {
  return `data:image/svg+xml,${encodeURIComponent(svg.toWellFormed())}`;
}

function drawing(svg: string): HtmlElement {
  const named = /\sxmlns\s*=/.test(svg) ? svg : svg.replace(/^<svg/i, '<svg xmlns="http://www.w3.org/2000/svg"');
  return { tag: 'img', attributes: { src: svgAddress(named), alt: '' }, style: {}, children: [] };
}

function readAttributes(name: string, text: string): Pick<HtmlElement, 'attributes' | 'style'> {
  const attributes: Record<string, string> = {};
  let style: Record<string, string> = {};
  for (const [, written = '', double, single, bare] of text.matchAll(ATTRIBUTE)) {
    const value = decodeEntities(double ?? single ?? bare ?? '');
    const key = written.toLowerCase();
    if (key === 'style') style = { ...style, ...readStyle(value) };
    else if (isHarmless(name, key, value)) attributes[key] = value.trim();
    if (key === 'align' && /^(left|right|center)$/i.test(value)) style['text-align'] ??= value.toLowerCase();
  }
  return { attributes, style };
}

function isHarmless(name: string, key: string, value: string): boolean {
  switch (key) {
    case 'title':
    case 'alt':
      return value.length <= 1000;
    case 'open':
      return name === 'details';
    case 'colspan':
    case 'rowspan':
      return (name === 'td' || name === 'th') && /^[1-9]\d{0,2}$/.test(value);
    case 'start':
      return name === 'ol' && /^\d{1,6}$/.test(value);
    case 'width':
    case 'height':
      return name === 'img' && /^\d{1,4}$/.test(value);
    case 'value':
    case 'max':
    case 'min':
      return (name === 'progress' || name === 'meter') && /^-?\d{1,9}(\.\d{1,9})?$/.test(value);
    case 'href':
      return name === 'a' && /^\s*(https?|mailto):/i.test(value);
    case 'src':
      return name === 'img' && /^\s*data:image\/(png|jpeg|gif|webp|svg\+xml)[;,]/i.test(value);
    default:
      return false;
  }
}

function readStyle(text: string): Record<string, string> {
  const found: Record<string, string> = {};
  for (const rule of text.split(';').slice(0, 50)) {
    const colon = rule.indexOf(':');
    const name = rule.slice(0, colon).trim().toLowerCase();
    const value = rule.slice(colon + 1).trim();
    if (colon > 0 && STYLES.has(name) && STYLE_VALUE.test(value)) found[name] = value;
  }
  return found;
}
