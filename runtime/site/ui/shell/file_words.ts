// ls, cd, pwd, mkdir, touch and rm, and the editors, which are the panel Source.

import { shellTexts } from '../texts_shell.ts';
import type { FileTree, FolderEntry, ShellFile } from './file_tree.ts';
import { mayWrite } from './own_files.ts';
import type { OwnFiles } from './own_files.ts';
import { fileName } from '../../contract/file_name.ts';
import { HOME, parentOf, resolvePath } from './paths.ts';

export interface FileCall {
  readonly tree: FileTree;
  readonly own: OwnFiles;
  readonly folder: string;
  /** The output stands in a terminal: names stand beside each other. */
  readonly isSeen: boolean;
  readonly out: (text: string) => void;
  readonly warn: (text: string) => void;
  /** `line`: 0 for none. */
  readonly edit: (source: string, line: number) => boolean;
}

/** Gives the exit code. */
type Word = (rest: readonly string[], call: FileCall) => Promise<number> | number;

/** Flags, each letter alone, and the other words. */
function split(rest: readonly string[]): { readonly flags: ReadonlySet<string>; readonly names: readonly string[]; } {
  const isFlag = (word: string): boolean => /^-[A-Za-z]+$/.test(word);
  return { flags: new Set(rest.filter(isFlag).flatMap((word) => [...word.slice(1)])), names: rest.filter((word) => !isFlag(word)) };
}

/** The first flag that is none of these. */
function unknownFlag(flags: ReadonlySet<string>, known: string): string | undefined {
  return [...flags].find((flag) => !known.includes(flag));
}

async function row({ name, file }: FolderEntry): Promise<string> {
  const mode = file === undefined ? 'drwxr-xr-x' : file.origin === 'source' || file.origin === 'own' ? '-rw-r--r--' : '-r--r--r--';
  return `${mode} user user ${String(file === undefined ? 0 : await file.size()).padStart(8)} ${name}`;
}

const ls: Word = async (rest, { tree, folder, isSeen, out, warn }) => {
  const { flags, names } = split(rest);
  const wrong = unknownFlag(flags, 'lahA1RF');
  if (wrong !== undefined) {
    warn(shellTexts.badOption('ls', wrong));
    return 2;
  }
  let code = 0;
  let isFirst = true;
  const list = async (entries: readonly FolderEntry[]): Promise<void> => {
    const seen = entries.filter(({ name }) => flags.has('a') || flags.has('A') || !name.startsWith('.'));
    if (flags.has('l')) {
      for (const line of await Promise.all(seen.map(row))) out(line);
    } else if (seen.length > 0) {
      const words = seen.map(({ name, file }) => (file === undefined && flags.has('F') ? `${name}/` : name));
      out(words.join(flags.has('1') || !isSeen ? '\n' : '  '));
    }
  };
  const walk = async (path: string, shown: string, titled: boolean): Promise<void> => {
    if (titled && !isFirst) out('');
    if (titled) out(`${shown}:`);
    isFirst = false;
    const entries = tree.entries(path) ?? [];
    await list(flags.has('a') ? [{ name: '.', file: undefined }, { name: '..', file: undefined }, ...entries] : entries);
    if (!flags.has('R')) return;
    for (const { name, file } of entries) {
      if (file !== undefined) continue;
      await walk(path === '/' ? `/${name}` : `${path}/${name}`, `${shown}/${name}`, true);
    }
  };
  const wanted = names.length === 0 ? ['.'] : names;
  const files = wanted.flatMap((name): readonly FolderEntry[] => {
    const file = tree.file(resolvePath(folder, name));
    return file === undefined ? [] : [{ name, file }];
  });
  for (const name of wanted) {
    const path = resolvePath(folder, name);
    if (tree.file(path) !== undefined || tree.isFolder(path)) continue;
    warn(shellTexts.cannotAccess('ls', name));
    code = 2;
  }
  await list(files);
  isFirst = files.length === 0;
  for (const name of wanted) {
    const path = resolvePath(folder, name);
    if (tree.isFolder(path)) await walk(path, name, wanted.length > 1 || flags.has('R'));
  }
  return code;
};

const mkdir: Word = (rest, { tree, own, folder, warn }) => {
  const { flags, names } = split(rest);
  const wrong = unknownFlag(flags, 'pv');
  if (wrong !== undefined || names.length === 0) {
    warn(wrong === undefined ? shellTexts.missingOperand('mkdir') : shellTexts.badOption('mkdir', wrong));
    return 1;
  }
  let code = 0;
  const fail = (text: string): void => {
    warn(text);
    code = 1;
  };
  for (const name of names) {
    const path = resolvePath(folder, name);
    const exists = tree.isFolder(path);
    if (exists && flags.has('p')) continue;
    if (exists || tree.file(path) !== undefined) fail(shellTexts.exists('mkdir', name));
    else if (!mayWrite(path)) fail(shellTexts.notAllowed('mkdir', name));
    else if (!flags.has('p') && !tree.isFolder(parentOf(path))) fail(shellTexts.cannotCreate('mkdir', name));
    else if (!own.makeFolder(path)) fail(shellTexts.full('mkdir'));
  }
  return code;
};

const touch: Word = (rest, { tree, own, folder, warn }) => {
  const { names } = split(rest);
  if (names.length === 0) warn(shellTexts.missingOperand('touch'));
  let code = names.length === 0 ? 1 : 0;
  for (const name of names) {
    const path = resolvePath(folder, name);
    if (tree.file(path) !== undefined || tree.isFolder(path)) continue;
    const trouble = !tree.isFolder(parentOf(path))
      ? shellTexts.cannotCreate('touch', name)
      : !mayWrite(path)
      ? shellTexts.notAllowed('touch', name)
      : own.write(path, '')
      ? ''
      : shellTexts.full('touch');
    if (trouble === '') continue;
    warn(trouble);
    code = 1;
  }
  return code;
};

const rm: Word = (rest, { tree, own, folder, warn }) => {
  const { flags, names } = split(rest);
  const all = flags.has('r') || flags.has('R');
  let code = 0;
  const fail = (text: string): void => {
    warn(text);
    code = 1;
  };
  if (names.length === 0 && !flags.has('f')) fail(shellTexts.missingOperand('rm'));
  for (const name of names) {
    const path = resolvePath(folder, name);
    const inside: readonly ShellFile[] = tree.isFolder(path) ? tree.below(path) : [];
    const files = [...inside, ...[tree.file(path)].filter((file) => file !== undefined)];
    if (!tree.isFolder(path) && files.length === 0) {
      if (!flags.has('f')) fail(shellTexts.cannotRemove(name));
    } else if (tree.isFolder(path) && !all) {
      fail(shellTexts.isFolder('rm', name));
    } else if (!mayWrite(path) || files.some(({ origin }) => origin !== 'own')) {
      fail(shellTexts.kept(name));
    } else {
      own.remove(path);
    }
  }
  return code;
};

const edit: Word = (rest, { tree, folder, out, warn, edit: open }) => {
  const names = rest.filter((word) => !/^[-+]/.test(word));
  const line = Number(/^\+(\d+)$/.exec(rest.find((word) => word.startsWith('+')) ?? '')?.[1] ?? 0);
  const name = names[0] ?? '.';
  const file = tree.file(resolvePath(folder, name));
  if (file?.source !== undefined && open(file.source, line)) {
    out(shellTexts.editing(file.source));
    return 0;
  }
  const first = tree.isFolder(resolvePath(folder, name)) ? tree.below(resolvePath(folder, name)).find(({ source }) => source !== undefined) : undefined;
  if (first?.source !== undefined && open(first.source, 0)) {
    out(shellTexts.editing(first.source));
    return 0;
  }
  warn(shellTexts.notEditable(name));
  return 1;
};

export const fileWords: ReadonlyMap<string, Word> = new Map<string, Word>([
  ['ls', ls],
  ['ll', (rest, call) => ls(['-l', ...rest], call)],
  ['mkdir', mkdir],
  ['touch', touch],
  ['rm', rm],
  ...['nano', 'code', 'vim', 'vi', 'gedit', 'emacs'].map((name) => [name, edit] as const),
]);

/** Where `cd` leads; a text says why it leads nowhere. */
export function changedFolder(rest: readonly string[], tree: FileTree, folder: string, before: string): { readonly folder: string; } | string {
  if (rest.length > 1) return shellTexts.tooMany('cd');
  const [name = HOME] = rest;
  const path = name === '-' ? before : resolvePath(folder, name);
  if (tree.isFolder(path)) return { folder: path };
  return tree.file(path) === undefined ? shellTexts.noSuch('cd', name) : shellTexts.notFolder('cd', name);
}

/** Completes a name at the caret: names in its folder, folders with a slash behind. */
export function completeName(tree: FileTree, folder: string, word: string): readonly string[] {
  const cut = word.lastIndexOf('/') + 1;
  const base = word.slice(0, cut);
  const entries = tree.entries(resolvePath(folder, base === '' ? '.' : base)) ?? [];
  return entries
    .filter(({ name }) => name.startsWith(word.slice(cut)) && (!name.startsWith('.') || fileName(word).startsWith('.')))
    .map(({ name, file }) => `${base}${name}${file === undefined ? '/' : ''}`);
}
