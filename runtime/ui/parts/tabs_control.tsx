// Joins the graph of other tabs of this site, and then says which tab this is and opens another one.

import { useState } from 'preact/hooks';
import type { Session } from '../../wasm_js/session.ts';
import { problemOf } from '../model/problem.ts';
import { texts } from '../texts.ts';
import { IconButton } from './button.tsx';
import { useNodes } from './watch.ts';

/** The graph's name when nobody gave one. */
const kGraph = 'main';

export function TabsControl({ session }: { readonly session: Session }) {
  useNodes(session);
  const [problem, setProblem] = useState('');
  const tab = session.tab();
  if (tab === undefined) {
    const join = (): void => {
      session.joinTabs(kGraph).then(
        // A reload joins again.
        () => history.replaceState(null, '', `?graph=${kGraph}`),
        (error: unknown) => setProblem(problemOf(error).what),
      );
    };
    return (
      <>
        {problem === '' ? null : (
          <span class="head-tab" role="alert">
            {problem}
          </span>
        )}
        <IconButton icon="tabs" label={texts.tabs.join} onClick={join} />
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
