// Files and folders that the terminals of a page have written, for as long as the page is open.

import type { ShellFile } from './file_tree.ts';
import { HOME } from './paths.ts';

/** The longest file, in characters. */
export const MOST_TEXT_BYTES = 1 << 20;
/** Files of all terminals together; as many folders. */
const MOST_FILES = 2000;
/** All files together, in characters. */
const MOST_HELD = 32 << 20;

export class OwnFiles {
  private readonly texts = new Map<string, string>();
  private readonly made = new Set<string>();
  private held = 0;

  get folders(): readonly string[] {
    return [...this.made];
  }

  get files(): readonly ShellFile[] {
    return [...this.texts].map(([path, text]) => ({
      path,
      origin: 'own',
      size: () => Promise.resolve(new TextEncoder().encode(text).length),
      text: () => Promise.resolve(text),
    }));
  }

  text(path: string): string | undefined {
    return this.texts.get(path);
  }

  /** False: there is not enough room. */
  write(path: string, text: string): boolean {
    const held = this.held + text.length - (this.texts.get(path)?.length ?? 0);
    if (text.length > MOST_TEXT_BYTES || held > MOST_HELD || (!this.texts.has(path) && this.texts.size >= MOST_FILES)) return false;
    this.texts.set(path, text);
    this.held = held;
    return true;
  }

  makeFolder(path: string): boolean {
    if (this.made.size >= MOST_FILES) return false;
    this.made.add(path);
    return true;
  }

  /** Removes what is there, and all below it. */
  remove(path: string): void {
    const isThere = (one: string): boolean => one === path || one.startsWith(`${path}/`);
    for (const [one, text] of [...this.texts]) {
      if (!isThere(one)) continue;
      this.texts.delete(one);
      this.held -= text.length;
    }
    for (const one of [...this.made]) if (isThere(one)) this.made.delete(one);
  }
}

/** Only there a user may write. */
export function mayWrite(path: string): boolean {
  return path.startsWith(`${HOME}/`);
}
