// Puts the page of the session into the document, or what went wrong. Until then index.html says "Starting".

import { render } from 'preact';
import { useEffect, useMemo, useState } from 'preact/hooks';
import type { CommandLoader, Session } from '../contract/session.ts';
import { addressOfSite, isElsewhere } from '../program/carried_files.ts';
import { browserStore } from './model/preferences.ts';
import type { Store } from './model/preferences.ts';
import { readEmbed, wholeAddress } from './model/embed_link.ts';
import { problemOf } from './model/problem.ts';
import type { Problem } from './model/problem.ts';
import { Page } from './page.tsx';
import { Boundary } from './parts/boundary.tsx';
import { WholePageLink } from './parts/embed_foot.tsx';
import { Mark } from './parts/icon.tsx';
import { IconButton } from './parts/button.tsx';
import { ProblemView } from './parts/problem_view.tsx';
import { texts } from './texts.ts';

/** `kept` tells, some time later, whether the site is kept for visits without a network. */
export function mountPage(
  root: Element,
  started: PromiseSettledResult<Session>,
  kept: Promise<boolean>,
): void {
  root.replaceChildren();
  if (started.status === 'rejected') {
    if (readEmbed(location.search) !== null && window.parent !== window) {
      const { code, what } = problemOf(started.reason);
      void import('./parts/embed_host.ts').then(({ tellFailure }) => tellFailure(code, what));
    }
    render(<FailurePage problem={problemOf(started.reason)} />, root);
    return;
  }
  const { site } = started.value;
  document.title = `${site.title === '' ? site.name : site.title} \u2013 ${texts.product}`;
  render(<App session={started.value} kept={kept} store={browserStore()} />, root);
  if (site.files.some(({ path }) => isElsewhere(path)))
    void import('./parts/file_links.ts').then(({ followFileLinks }) => followFileLinks({ has: isElsewhere, address: addressOfSite }));
}

/** Loads the code that runs the commands of a launch file. */
export async function loadCommands(): Promise<CommandLoader> {
  return (await import('./parts/launched_commands.ts')).pageCommands;
}

interface AppProps {
  readonly session: Session;
  readonly kept: Promise<boolean>;
  readonly store: Store | null;
}

function App({ session, kept, store }: AppProps) {
  const embed = useMemo(() => readEmbed(location.search), []);
  const [offline, setOffline] = useState<boolean | null>(null);
  const [mistake, setMistake] = useState<Problem | null>(null);

  useEffect(() => {
    void kept.then(setOffline);
  }, [kept]);

  useEffect(() => {
    const onError = (event: ErrorEvent): void => setMistake(problemOf(event.error ?? event.message));
    const onRejection = (event: PromiseRejectionEvent): void => setMistake(problemOf(event.reason));
    addEventListener('error', onError);
    addEventListener('unhandledrejection', onRejection);
    return () => {
      removeEventListener('error', onError);
      removeEventListener('unhandledrejection', onRejection);
    };
  }, []);

  return (
    <>
      {mistake === null ? null : <MistakeBar problem={mistake} onClose={() => setMistake(null)} />}
      <Boundary title={texts.product} announce={ignore}>
        <Page session={session} store={store} offline={offline} embed={embed} />
      </Boundary>
    </>
  );
}

function FailurePage({ problem }: { readonly problem: Problem; }) {
  return (
    <main class="lone lone-failure">
      <Mark />
      <h1 class="lone-title">{texts.problem.startTitle}</h1>
      <ProblemView problem={problem} announce={ignore}>
        <button type="button" class="button button-main" onClick={() => location.reload()}>
          {texts.problem.reload}
        </button>
        {readEmbed(location.search) === null ? null : (
          <WholePageLink address={() => wholeAddress(location.href, null)} />
        )}
      </ProblemView>
    </main>
  );
}

/** A mistake outside any panel: told, not hidden, while the nodes go on. */
function MistakeBar({
  problem,
  onClose,
}: {
  readonly problem: Problem;
  readonly onClose: () => void;
}) {
  return (
    <div class="mistake" role="alert">
      <ProblemView
        problem={{ ...problem, what: `${texts.problem.pageTitle}: ${problem.what}` }}
        announce={ignore}
      />
      <IconButton icon="close" label={texts.problem.dismiss} onClick={onClose} />
    </div>
  );
}

function ignore(): void {
  // There is no announcer outside the page; the tick on the button tells.
}
