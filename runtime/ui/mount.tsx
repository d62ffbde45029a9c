// Puts the page into the document: first "starting", then the page of the session, or what went wrong.

import { render } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import type { Session } from '../wasm_js/session.ts';
import { browserStore } from './model/preferences.ts';
import type { Store } from './model/preferences.ts';
import { problemOf } from './model/problem.ts';
import type { Problem } from './model/problem.ts';
import { Page } from './page.tsx';
import { Boundary } from './parts/boundary.tsx';
import { Mark } from './parts/icon.tsx';
import { IconButton } from './parts/button.tsx';
import { ProblemView } from './parts/problem_view.tsx';
import { texts } from './texts.ts';

/** `kept` tells, some time later, whether the site is kept for visits without a network. */
export function mountPage(root: Element, starting: Promise<Session>, kept: Promise<boolean>): void {
  root.replaceChildren();
  render(<App starting={starting} kept={kept} store={browserStore()} />, root);
}

type Progress =
  | { readonly kind: 'starting' }
  | { readonly kind: 'running'; readonly session: Session }
  | { readonly kind: 'failed'; readonly problem: Problem };

interface AppProps {
  readonly starting: Promise<Session>;
  readonly kept: Promise<boolean>;
  readonly store: Store | null;
}

function App({ starting, kept, store }: AppProps) {
  const [offline, setOffline] = useState<boolean | null>(null);
  const [progress, setProgress] = useState<Progress>({ kind: 'starting' });
  const [mistake, setMistake] = useState<Problem | null>(null);

  useEffect(() => {
    starting.then(
      (session) => {
        document.title = `${session.site.title === '' ? session.site.name : session.site.title} \u2013 ${texts.product}`;
        setProgress({ kind: 'running', session });
      },
      (error: unknown) => setProgress({ kind: 'failed', problem: problemOf(error) }),
    );
  }, [starting]);

  useEffect(() => {
    void kept.then(setOffline);
  }, [kept]);

  useEffect(() => {
    const onError = (event: ErrorEvent): void =>
      setMistake(problemOf(event.error ?? event.message));
    const onRejection = (event: PromiseRejectionEvent): void => setMistake(problemOf(event.reason));
    addEventListener('error', onError);
    addEventListener('unhandledrejection', onRejection);
    return () => {
      removeEventListener('error', onError);
      removeEventListener('unhandledrejection', onRejection);
    };
  }, []);

  if (progress.kind === 'failed') return <FailurePage problem={progress.problem} />;
  return (
    <>
      {mistake === null ? null : <MistakeBar problem={mistake} onClose={() => setMistake(null)} />}
      {progress.kind === 'starting' ? (
        <main class="lone">
          <Mark />
          <p class="lone-title">{texts.starting}</p>
          <p class="hint">{texts.startingHint}</p>
        </main>
      ) : (
        <Boundary title={texts.product} announce={ignore}>
          <Page session={progress.session} store={store} offline={offline} />
        </Boundary>
      )}
    </>
  );
}

function FailurePage({ problem }: { readonly problem: Problem }) {
  return (
    <main class="lone lone-failure">
      <Mark />
      <h1 class="lone-title">{texts.problem.startTitle}</h1>
      <ProblemView problem={problem} announce={ignore}>
        <button type="button" class="button button-main" onClick={() => location.reload()}>
          {texts.problem.reload}
        </button>
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
