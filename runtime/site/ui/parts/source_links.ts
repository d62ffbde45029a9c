// How parts of the page open the panel of a source: known to all of them by a context.

import { createContext } from 'preact';
import type { Session } from '../../contract/session.ts';
import type { PanelProps } from '../panels/panel_props.ts';

export interface SourceLinks {
  /** The file of the workspace that is installed there; undefined: none that the page can show. */
  readonly fileOf: (path: string) => string | undefined;
  /** `file`: of the workspace; `line`: from 1. */
  readonly open: (file: string, line?: number) => void;
}

export const SourceLinksContext = createContext<SourceLinks | null>(null);

export function sourceLinks(session: Session, open: PanelProps['open']): SourceLinks | null {
  if (session.sources === undefined) return null;
  const files = new Map(session.site.sources?.files.map(({ path, file }) => [path, file]));
  return {
    fileOf: (path) => files.get(path),
    open: (file, line) => void open('source', line === undefined ? { file } : { file, line }),
  };
}

/** Files of the workspace that the visitor has changed, so that nodes get them so. */
export function changedFiles(session: Session): readonly string[] {
  return (session.sources?.list() ?? []).filter(({ state }) => state === 'changed').map(({ file }) => file);
}
