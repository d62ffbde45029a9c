// Files that programs have written and handed over (SPEC.md 3.4), bags and others: stored until the page takes them.

import type { Unsubscribe, WrittenFile, Written } from '../contract/session.ts';
import { homeFolder } from './site_files.ts';

/** Upper bound of the stored bytes; the oldest files are dropped first. */
const mostKeptBytes = 2 ** 30;

export class WrittenFiles implements Written {
  private kept: WrittenFile[] = [];
  private bytes = 0;
  private readonly most: number;
  private readonly listeners = new Set<() => void>();

  constructor(most = mostKeptBytes) {
    this.most = most;
  }

  add(file: WrittenFile): void {
    const { node, path } = file;
    const older = this.kept.find((one) => one.path === path && one.node === node);
    // A bag is written once; one of that name is another one.
    if (older !== undefined && !path.endsWith('.mcap')) {
      this.kept = this.kept.filter((one) => one !== older);
      this.bytes -= older.content.size;
    }
    this.kept.push(file);
    this.bytes += file.content.size;
    while (this.bytes > this.most) this.bytes -= this.kept.shift()!.content.size;
    for (const listener of [...this.listeners]) listener();
  }

  take(): readonly WrittenFile[] {
    const taken = this.kept;
    this.kept = [];
    this.bytes = 0;
    return taken;
  }

  onChange(listener: () => void): Unsubscribe {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}

/** The names of folders and of the file below one folder for all nodes. A program's path cannot lead outside of it. */
export function placeOf({ node, path }: Pick<WrittenFile, 'node' | 'path'>): readonly string[] {
  const below = path.startsWith(`${homeFolder}/`) ? path.slice(homeFolder.length) : path;
  return [node, ...below.split('/')]
    .filter((name) => name !== '' && name !== '.' && name !== '..')
    .map((name) => name.replace(/[\u0000-\u001f\u007f<>:"\\|?*]/g, '_'));
}
