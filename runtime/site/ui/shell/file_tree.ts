// The files that a terminal sees: a tree over their paths. Pure.

import { fileName } from '../../contract/file_name.ts';
import { HOME, WORKSPACE, parentOf } from './paths.ts';

export interface ShellFile {
  /** Absolute. */
  readonly path: string;
  /** The origin of the file: the workspace's sources, other files of the site, the terminals of this page, or a node. */
  readonly origin: 'source' | 'site' | 'own' | 'node';
  /** In bytes. */
  readonly size: () => Promise<number>;
  readonly text: () => Promise<string>;
  /** The name that the panel Source has for it; only a source has one. */
  readonly source?: string;
}

export interface FolderEntry {
  readonly name: string;
  /** undefined: a folder. */
  readonly file: ShellFile | undefined;
}

export class FileTree {
  private readonly files = new Map<string, ShellFile>();
  private readonly folders = new Map<string, Set<string>>([['/', new Set()]]);

  /** A later file takes the place of an earlier one of its path. */
  constructor(files: readonly ShellFile[], folders: readonly string[]) {
    for (const folder of [HOME, `${WORKSPACE}/src`, ...folders]) this.addFolder(folder);
    for (const file of files) {
      // A name that is a folder already stays one.
      if (this.folders.has(file.path)) continue;
      this.addFolder(parentOf(file.path));
      this.files.set(file.path, file);
      this.folders.get(parentOf(file.path))?.add(fileName(file.path));
    }
  }

  private addFolder(path: string): void {
    if (this.folders.has(path) || this.files.has(path)) return;
    this.folders.set(path, new Set());
    this.addFolder(parentOf(path));
    this.folders.get(parentOf(path))?.add(fileName(path));
  }

  file(path: string): ShellFile | undefined {
    return this.files.get(path);
  }

  isFolder(path: string): boolean {
    return this.folders.has(path);
  }

  /** Sorted; undefined: it is not a folder. */
  entries(path: string): readonly FolderEntry[] | undefined {
    const names = this.folders.get(path);
    if (names === undefined) return undefined;
    const base = path === '/' ? '' : path;
    return [...names].sort().map((name) => ({ name, file: this.files.get(`${base}/${name}`) }));
  }

  /** All files in a folder and below it, in order. */
  below(path: string): readonly ShellFile[] {
    const base = path === '/' ? '' : path;
    return (this.entries(path) ?? []).flatMap(({ name, file }) => (file === undefined ? this.below(`${base}/${name}`) : [file]));
  }
}
