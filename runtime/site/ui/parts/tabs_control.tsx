// Joins the graph of other tabs of this site, and then says which tab this is and opens another one.

import { useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { problemOf } from '../model/problem.ts';
import { texts } from '../texts.ts';
import { IconButton } from './button.tsx';
import { useNodes } from './watch.ts';

/** The graph's name when nobody gave one. */
const GRAPH = 'main';

export interface TabsControlProps {
  readonly session: Session;
  /** The way to join stands elsewhere, with `join`. */
  readonly bare: boolean;
  readonly problem: string;
  readonly join: () => void;
}

/** Joins the other tabs, and says why that failed. */
export function useJoin(session: Session): Pick<TabsControlProps, 'problem' | 'join'> {
  const [problem, setProblem] = useState('');
  const join = (): void => {
    session.joinTabs(GRAPH).then(
      // A reload joins again.
      () => history.replaceState(null, '', `?graph=${GRAPH}`),
      (error: unknown) => setProblem(problemOf(error).what),
    );
  };
  return { problem, join };
}

export function TabsControl({ session, bare, problem, join }: TabsControlProps) {
  useNodes(session);
  const tab = session.tab();
  if (tab === undefined) {
    return (
      <>
        {problem === '' ? null : (
          <span class="head-tab" role="alert">
            {problem}
          </span>
        )}
        {bare ? null : <IconButton icon="tabs" label={texts.tabs.join} onClick={join} />}
      </>
    );
  }
  return (
    <a
      class="head-tab link-chip"
      href={`?graph=${encodeURIComponent(tab.graph)}`}
      target="_blank"
      rel="noopener"
      title={texts.tabs.open(tab.graph)}
    >
      {texts.tabs.place(tab.number, tab.count)}
    </a>
  );
}
