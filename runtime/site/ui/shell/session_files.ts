// The files of a session as its terminals see them: the workspace's Python sources as they would run now, the shares of the
// packages, what nodes have written and what terminals have.

import { fetchOfSite } from '../../program/carried_files.ts';
import type { Session } from '../../contract/session.ts';
import { shellTexts } from '../texts_shell.ts';
import { FileTree } from './file_tree.ts';
import type { ShellFile } from './file_tree.ts';
import { MOST_TEXT_BYTES, OwnFiles } from './own_files.ts';
import { HOME, resolvePath, workspacePath } from './paths.ts';

const own = new WeakMap<Session, OwnFiles>();

export function ownFiles(session: Session): OwnFiles {
  const known = own.get(session) ?? new OwnFiles();
  own.set(session, known);
  return known;
}

const bytesOf = (text: string): number => new TextEncoder().encode(text).length;

function sourceFiles({ sources }: Session): readonly ShellFile[] {
  if (sources === undefined) return [];
  return sources.list().map(({ path, file, state }) => {
    const text = async (): Promise<string> => (state === 'changed' ? sources.changed(path) : undefined) ?? (await sources.packed(path));
    return { path: workspacePath(file), origin: 'source', source: file, text, size: async () => bytesOf(await text()) };
  });
}

function siteFiles({ site, prefix }: Session): readonly ShellFile[] {
  return site.files.filter(({ path }) => path.startsWith('share/')).map(({ path, size }) => ({
    path: `${prefix}/${path}`,
    origin: 'site',
    size: () => Promise.resolve(size),
    text: () => siteText(path, size),
  }));
}

async function siteText(path: string, size: number): Promise<string> {
  if (size > MOST_TEXT_BYTES) throw new Error(shellTexts.tooLarge(MOST_TEXT_BYTES));
  const response = await fetchOfSite(path);
  if (!response.ok) throw new Error(`HTTP ${response.status}`);
  return await response.text();
}

/** They come with the panel for bags, which keeps them. */
async function nodeFiles(session: Session): Promise<readonly ShellFile[]> {
  const { bagDesk } = await import('../parts/bag_desk.ts');
  const desk = bagDesk(session);
  const fileOf = (path: string, size: number, content: () => Promise<Blob>): ShellFile => ({
    path,
    origin: 'node',
    size: () => Promise.resolve(size),
    text: async () => {
      if (size > MOST_TEXT_BYTES) throw new Error(shellTexts.tooLarge(MOST_TEXT_BYTES));
      return await (await content()).text();
    },
  });
  return [
    ...desk.shelf.filter(({ origin }) => origin !== 'site').map(({ name, size, content }) => fileOf(resolvePath(HOME, name), size, content)),
    ...desk.files.map(({ path, content }) => fileOf(resolvePath(HOME, path), content.size, () => Promise.resolve(content))),
  ];
}

/** As they are now. */
export async function sessionTree(session: Session): Promise<FileTree> {
  const made = ownFiles(session);
  return new FileTree([...siteFiles(session), ...(await nodeFiles(session)), ...made.files, ...sourceFiles(session)], [session.prefix, ...made.folders]);
}

/** A text by its path, or a file of the site by its path there, with or without the folders that it begins with. */
export async function readText(session: Session, folder: string, name: string): Promise<string | undefined> {
  const path = resolvePath(folder, name);
  const written = ownFiles(session).text(path);
  if (written !== undefined) return written;
  const { files } = session.site;
  const below = path.startsWith(`${session.prefix}/`) ? path.slice(session.prefix.length + 1) : name;
  const found = files.find((file) => file.path === below) ?? files.find((file) => file.path.endsWith(`/${below}`));
  if (found !== undefined) return await siteText(found.path, found.size);
  return await (await sessionTree(session)).file(path)?.text();
}
