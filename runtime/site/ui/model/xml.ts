// Elements and attributes of a small XML text, without the browser's parser: that is a door which Trusted Types close.
// Words between elements are skipped; a text with a document type of its own (entities) is refused. Pure.

export interface XmlElement {
  /** Without its prefix. */
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: readonly XmlElement[];
}

const DEEPEST = 200;
const MOST_ELEMENTS = 200_000;

interface Open {
  readonly tag: string;
  readonly element: XmlElement & { readonly children: XmlElement[]; };
}

/** The root; null: it is not an XML, or too large. */
export function readXml(text: string): XmlElement | null {
  const open: Open[] = [];
  let root: XmlElement | null = null;
  let count = 0;
  for (let at = text.indexOf('<'); at !== -1; at = text.indexOf('<', at)) {
    const skipped = skip(text, at);
    if (skipped === null) return null;
    if (skipped > at) {
      at = skipped;
      continue;
    }
    if (text.startsWith('</', at)) {
      const end = matchAt(/<\/([^\s<>]+)\s*>/y, text, at);
      if (end === null || open.pop()?.tag !== end[1]) return null;
      at += end[0].length;
      continue;
    }
    const start = readTag(text, at);
    count += 1;
    if (start === null || count > MOST_ELEMENTS || open.length >= DEEPEST) return null;
    const element = { name: start.tag.slice(start.tag.indexOf(':') + 1), attributes: start.attributes, children: [] };
    const parent = open.at(-1);
    if (parent !== undefined) parent.element.children.push(element);
    else if (root === null) root = element;
    else return null; // a second root
    if (!start.isEmpty) open.push({ tag: start.tag, element });
    at = start.end;
  }
  return open.length === 0 ? root : null;
}

/** Behind a comment, an instruction, CDATA or a plain document type; `at` when none begins there; null: it has no end. */
function skip(text: string, at: number): number | null {
  for (const [begin, end] of [['<!--', '-->'], ['<?', '?>'], ['<![CDATA[', ']]>'], ['<!DOCTYPE', '>']] as const) {
    if (!text.startsWith(begin, at)) continue;
    const last = text.indexOf(end, at + begin.length);
    if (last === -1 || (begin === '<!DOCTYPE' && text.slice(at, last).includes('['))) return null;
    return last + end.length;
  }
  return at;
}

interface Tag {
  readonly tag: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly isEmpty: boolean;
  readonly end: number;
}

function readTag(text: string, start: number): Tag | null {
  const name = matchAt(/<([^\s"'<>/=&!?]+)/y, text, start);
  if (name === null) return null;
  let at = start + name[0].length;
  const attributes = new Map<string, string>();
  for (;;) {
    const found = matchAt(/\s+([^\s"'<>/=&]+)\s*=\s*(?:"([^"<]*)"|'([^'<]*)')/y, text, at);
    if (found === null) break;
    attributes.set(found[1] ?? '', decoded(found[2] ?? found[3] ?? ''));
    at += found[0].length;
  }
  const end = matchAt(/\s*(\/?)>/y, text, at);
  return end === null ? null : { tag: name[1] ?? '', attributes, isEmpty: end[1] === '/', end: at + end[0].length };
}

function matchAt(pattern: RegExp, text: string, at: number): RegExpExecArray | null {
  pattern.lastIndex = at;
  return pattern.exec(text);
}

const ENTITIES: ReadonlyMap<string, string> = new Map([['lt', '<'], ['gt', '>'], ['amp', '&'], ['quot', '"'], ['apos', "'"]]);

/** An entity that nobody knows stays as it is written. */
function decoded(value: string): string {
  return value.replace(/&(?:#x([0-9a-fA-F]{1,6})|#(\d{1,7})|([a-z]{2,4}));/g, (whole, hex?: string, decimal?: string, name?: string) => {
    if (name !== undefined) return ENTITIES.get(name) ?? whole;
    const code = hex === undefined ? Number(decimal) : parseInt(hex, 16);
    return code > 0 && code <= 0x10ffff ? String.fromCodePoint(code) : whole;
  });
}
