// Files and folders that the terminals of a page have written, for as long as the page is open.

import type { ShellFile } from './file_tree.ts';
import { kHome } from './paths.ts';

/** The longest file, in characters. */
export const kMostTextBytes = 1 << 20;
/** Files of all terminals together; as many folders. */
const kMostFiles = 2000;

export class OwnFiles {
  private readonly texts = new Map<string, string>();
  private readonly made = new Set<string>();

  get folders(): readonly string[] {
    return [...this.made];
  }

  get files(): readonly ShellFile[] {
    return [...this.texts].map(([path, text]) => ({
      path, origin: 'own', size: () => Promise.resolve(new TextEncoder().encode(text).length), text: () => Promise.resolve(text),
    }));
  }

  text(path: string): string | undefined {
    return this.texts.get(path);
  }

  /** False: there is no more room. */
  write(path: string, text: string): boolean {
    if (text.length > kMostTextBytes || (!this.texts.has(path) && this.texts.size >= kMostFiles)) return false;
    this.texts.set(path, text);
    return true;
  }

  makeFolder(path: string): boolean {
    if (this.made.size >= kMostFiles) return false;
    this.made.add(path);
    return true;
  }

  /** Removes what is there, and all below it. */
  remove(path: string): void {
    for (const all of [this.texts, this.made])
      for (const one of [...all.keys()]) if (one === path || one.startsWith(`${path}/`)) all.delete(one);
  }
}

/** Only there a user may write. */
export function mayWrite(path: string): boolean {
  return path.startsWith(`${kHome}/`);
}
