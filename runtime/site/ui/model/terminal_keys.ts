// The bytes that a terminal sends for keys without text. Pure.

export interface Key {
  readonly key: string;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
}

const kEscape = '\u001b';

const kSequences: ReadonlyMap<string, string> = new Map([
  // A line's end: who sets the terminal so gets a carriage return.
  ['Enter', '\n'],
  ['Backspace', '\u007f'],
  ['Escape', kEscape],
  ['ArrowUp', `${kEscape}[A`],
  ['ArrowDown', `${kEscape}[B`],
  ['ArrowRight', `${kEscape}[C`],
  ['ArrowLeft', `${kEscape}[D`],
  ['Home', `${kEscape}[H`],
  ['End', `${kEscape}[F`],
  ['Insert', `${kEscape}[2~`],
  ['Delete', `${kEscape}[3~`],
  ['PageUp', `${kEscape}[5~`],
  ['PageDown', `${kEscape}[6~`],
]);

/** undefined: text, which comes as such, or a key that is the page's: Tab leads on. */
export function keyText({ key, ctrlKey, altKey, metaKey }: Key): string | undefined {
  if (altKey || metaKey) return undefined;
  if (!ctrlKey) return kSequences.get(key);
  return /^[a-z]$/i.test(key) ? String.fromCharCode(key.toLowerCase().charCodeAt(0) & 0x1f) : undefined;
}
