// The bytes that a terminal sends for keys without text. Pure.

export interface Key {
  readonly key: string;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
}

const ESCAPE = '\u001b';

const SEQUENCES: ReadonlyMap<string, string> = new Map([
  // A line's end: who sets the terminal so gets a carriage return.
  ['Enter', '\n'],
  ['Backspace', '\u007f'],
  ['Escape', ESCAPE],
  ['ArrowUp', `${ESCAPE}[A`],
  ['ArrowDown', `${ESCAPE}[B`],
  ['ArrowRight', `${ESCAPE}[C`],
  ['ArrowLeft', `${ESCAPE}[D`],
  ['Home', `${ESCAPE}[H`],
  ['End', `${ESCAPE}[F`],
  ['Insert', `${ESCAPE}[2~`],
  ['Delete', `${ESCAPE}[3~`],
  ['PageUp', `${ESCAPE}[5~`],
  ['PageDown', `${ESCAPE}[6~`],
]);

/** undefined: text, which comes as such, or a key that is the page's: Tab leads on. */
export function keyText({ key, ctrlKey, altKey, metaKey }: Key): string | undefined {
  if (altKey || metaKey) return undefined;
  if (!ctrlKey) return SEQUENCES.get(key);
  return /^[a-z]$/i.test(key) ? String.fromCharCode(key.toLowerCase().charCodeAt(0) & 0x1f) : undefined;
}
