// ANSI escape sequences in console text: turns one line into spans of plain text with a style.
// Only colours and weights (SGR) are kept. Every other sequence, and every control character, is
// dropped: what a program prints can never move, hide or rewrite anything outside its own line.

/** Colours are the 16 of a terminal; the style sheet owns what they look like in each theme. */
export interface AnsiStyle {
  readonly foreground: number | null;
  readonly background: number | null;
  readonly bold: boolean;
  readonly dim: boolean;
  readonly italic: boolean;
  readonly underline: boolean;
  readonly strike: boolean;
  readonly inverse: boolean;
}

export interface Span {
  readonly text: string;
  readonly style: AnsiStyle;
}

export const PLAIN: AnsiStyle = {
  foreground: null,
  background: null,
  bold: false,
  dim: false,
  italic: false,
  underline: false,
  strike: false,
  inverse: false,
};

const ESCAPE = 0x1b;
const BELL = 0x07;
const CSI = 0x9b;

/** The usual RGB values of the 16 colours: only used to find the nearest one to a richer colour. */
const PALETTE: readonly (readonly [number, number, number])[] = [
  [0, 0, 0],
  [205, 0, 0],
  [0, 205, 0],
  [205, 205, 0],
  [0, 0, 238],
  [205, 0, 205],
  [0, 205, 205],
  [229, 229, 229],
  [127, 127, 127],
  [255, 0, 0],
  [0, 255, 0],
  [255, 255, 0],
  [92, 92, 255],
  [255, 0, 255],
  [0, 255, 255],
  [255, 255, 255],
];

/** Splits one line into styled spans. Runs in time linear in the text, whatever it holds. */
export function parseAnsi(text: string): readonly Span[] {
  if (!hasControl(text)) {
    return [{ text, style: PLAIN }];
  }
  const spans: Span[] = [];
  let style = PLAIN;
  let pending = '';
  const flush = (): void => {
    if (pending !== '') {
      spans.push({ text: pending, style });
      pending = '';
    }
  };
  let at = 0;
  while (at < text.length) {
    const code = text.charCodeAt(at);
    if (code === ESCAPE || code === CSI) {
      const sequence = readSequence(text, at);
      if (sequence.parameters !== null) {
        const next = applySgr(style, sequence.parameters);
        if (next !== style) {
          flush();
          style = next;
        }
      }
      at = sequence.end;
    } else if (code === 0x09) {
      pending += '\t';
      at += 1;
    } else {
      if (!isControl(code)) {
        pending += text[at] ?? '';
      }
      at += 1;
    }
  }
  flush();
  return spans.length === 0 ? [{ text: '', style: PLAIN }] : spans;
}

/** The text without any sequence or control character. */
export function stripAnsi(text: string): string {
  return hasControl(text)
    ? parseAnsi(text)
      .map((span) => span.text)
      .join('')
    : text;
}

/** Class names for a style; an empty string for plain text. */
export function styleClasses(style: AnsiStyle): string {
  const names: string[] = [];
  const front = style.inverse ? style.background : style.foreground;
  const back = style.inverse ? style.foreground : style.background;
  if (front !== null) names.push(`ansi-fg-${front}`);
  if (back !== null) names.push(`ansi-bg-${back}`);
  if (style.inverse && style.foreground === null && style.background === null)
    names.push('ansi-inverse');
  if (style.bold) names.push('ansi-bold');
  if (style.dim) names.push('ansi-dim');
  if (style.italic) names.push('ansi-italic');
  if (style.underline) names.push('ansi-underline');
  if (style.strike) names.push('ansi-strike');
  return names.join(' ');
}

function isControl(code: number): boolean {
  return code < 0x20 || (code >= 0x7f && code <= 0x9f);
}

function hasControl(text: string): boolean {
  for (let i = 0; i < text.length; i += 1) {
    if (isControl(text.charCodeAt(i)) && text.charCodeAt(i) !== 0x09) {
      return true;
    }
  }
  return false;
}

interface Sequence {
  readonly end: number;
  /** The parameters of an SGR sequence, or null for any other sequence. */
  readonly parameters: string | null;
}

function readSequence(text: string, start: number): Sequence {
  let at = start + 1;
  if (text.charCodeAt(start) === ESCAPE) {
    const kind = text[at];
    if (kind === ']' || kind === 'P' || kind === '_' || kind === '^' || kind === 'X') {
      return { end: endOfString(text, at + 1), parameters: null };
    }
    if (kind !== '[') {
      // Two-character sequence, with intermediates such as "ESC ( B" before its final character.
      while (at < text.length && text.charCodeAt(at) >= 0x20 && text.charCodeAt(at) <= 0x2f)
        at += 1;
      return { end: Math.min(at + 1, text.length), parameters: null };
    }
    at += 1;
  }
  const from = at;
  while (at < text.length && text.charCodeAt(at) >= 0x20 && text.charCodeAt(at) <= 0x3f) at += 1;
  const final = text[at];
  const parameters = text.slice(from, at);
  const isSgr = final === 'm' && /^[0-9;:]*$/.test(parameters) && parameters.length <= 64;
  return { end: Math.min(at + 1, text.length), parameters: isSgr ? parameters : null };
}

/** End of an OSC, DCS, APC, PM or SOS string: after BEL or "ESC \\"; the end of the line at the latest. */
function endOfString(text: string, from: number): number {
  for (let at = from; at < text.length; at += 1) {
    const code = text.charCodeAt(at);
    if (code === BELL || code === 0x9c) return at + 1;
    if (code === ESCAPE && text[at + 1] === '\\') return at + 2;
  }
  return text.length;
}

function applySgr(before: AnsiStyle, parameters: string): AnsiStyle {
  const numbers = parameters === ''
    ? [0]
    : parameters.split(/[;:]/).map((part) => (part === '' ? 0 : Number(part)));
  let style = before;
  for (let i = 0; i < numbers.length; i += 1) {
    const n = numbers[i] ?? 0;
    if (n === 0) style = PLAIN;
    else if (n === 1) style = { ...style, bold: true };
    else if (n === 2) style = { ...style, dim: true };
    else if (n === 3) style = { ...style, italic: true };
    else if (n === 4) style = { ...style, underline: true };
    else if (n === 7) style = { ...style, inverse: true };
    else if (n === 9) style = { ...style, strike: true };
    else if (n === 21 || n === 22) style = { ...style, bold: false, dim: false };
    else if (n === 23) style = { ...style, italic: false };
    else if (n === 24) style = { ...style, underline: false };
    else if (n === 27) style = { ...style, inverse: false };
    else if (n === 29) style = { ...style, strike: false };
    else if (n >= 30 && n <= 37) style = { ...style, foreground: n - 30 };
    else if (n >= 90 && n <= 97) style = { ...style, foreground: n - 90 + 8 };
    else if (n === 39) style = { ...style, foreground: null };
    else if (n >= 40 && n <= 47) style = { ...style, background: n - 40 };
    else if (n >= 100 && n <= 107) style = { ...style, background: n - 100 + 8 };
    else if (n === 49) style = { ...style, background: null };
    else if (n === 38 || n === 48) {
      const rich = readRichColor(numbers, i + 1);
      if (rich.color !== null) {
        style = n === 38 ? { ...style, foreground: rich.color } : { ...style, background: rich.color };
      }
      i = rich.last;
    }
    // Every other number changes nothing here.
  }
  return style;
}

/** "5;n" (256 colours) and "2;r;g;b" become the nearest of the 16, so that contrast stays ours. */
function readRichColor(
  numbers: readonly number[],
  at: number,
): { color: number | null; last: number; } {
  if (numbers[at] === 5) {
    const n = numbers[at + 1];
    return { color: n === undefined || n > 255 ? null : fromCube(n), last: at + 1 };
  }
  if (numbers[at] === 2) {
    const [r, g, b] = [numbers[at + 1], numbers[at + 2], numbers[at + 3]];
    const known = r !== undefined && g !== undefined && b !== undefined;
    return { color: known ? nearest(r, g, b) : null, last: at + 3 };
  }
  return { color: null, last: at };
}

function fromCube(n: number): number {
  if (n < 16) return n;
  if (n >= 232) {
    const grey = 8 + (n - 232) * 10;
    return nearest(grey, grey, grey);
  }
  const level = (step: number): number => (step === 0 ? 0 : 55 + step * 40);
  const index = n - 16;
  return nearest(level(Math.floor(index / 36)), level(Math.floor(index / 6) % 6), level(index % 6));
}

function nearest(r: number, g: number, b: number): number {
  let best = 0;
  let bestDistance = Infinity;
  PALETTE.forEach(([pr, pg, pb], index) => {
    const distance = (pr - r) ** 2 + (pg - g) ** 2 + (pb - b) ** 2;
    if (distance < bestDistance) {
      best = index;
      bestDistance = distance;
    }
  });
  return best;
}
