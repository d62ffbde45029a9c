// A Jupyter notebook of the workspace: its cells run in a Python program of the site, on the same graph as the nodes.

import { fileName } from '../../contract/file_name.ts';
import { useEffect, useReducer, useState } from 'preact/hooks';
import { CellView } from '../parts/cell_view.tsx';
import { download } from '../parts/download.ts';
import { IconButton } from '../parts/button.tsx';
import { Icon } from '../parts/icon.tsx';
import { MenuButton } from '../parts/menu.tsx';
import { isUp, notebookStore } from '../parts/notebook_store.ts';
import type { NotebookStore, NotebookView } from '../parts/notebook_store.ts';
import { PanelFrame } from '../parts/panel.tsx';
import { readSiteText } from '../parts/site_text.ts';
import { MOST_NOTEBOOK } from '../model/notebook.ts';
import { texts } from '../texts.ts';
import { viewTexts } from '../texts_views.ts';
import type { PanelProps } from './panel_props.ts';

const words = viewTexts.notebook;

export function NotebookPanel({ session, instance, announce }: PanelProps) {
  const [store] = useState(() => notebookStore(session, (path) => readSiteText(path, MOST_NOTEBOOK)));
  const [, redraw] = useReducer<number, void>((n) => n + 1, 0);
  /** The cell that has the keyboard, or is to get it. */
  const [current, setCurrent] = useState<{ readonly key: string; readonly focus: boolean; } | null>(null);
  useEffect(() => store?.onChange(() => redraw()), [store]);

  if (store === null)
    return (
      <PanelFrame id="notebook" title={texts.panels.notebook} icon="notebook">
        <p class="hint">{words.none}</p>
      </PanelFrame>
    );
  const view = store.now();
  const cells = view.notebook?.cells ?? [];
  const goTo = (key: string | null | undefined): void => {
    if (key !== null && key !== undefined) setCurrent({ key, focus: true });
  };
  /** As Jupyter does: runs a cell, and goes on to the next one, which is made where there is none. */
  const run = (key: string, next: boolean): void => {
    store.run([key]);
    if (!next) return;
    const at = cells.findIndex((cell) => cell.key === key);
    goTo(cells[at + 1]?.key ?? store.add('code'));
  };
  const add = (kind: 'code' | 'markdown'): void => goTo(store.add(kind, current?.key));

  return (
    <PanelFrame id="notebook" title={texts.panels.notebook} icon="notebook" note={state(view)} tools={<Tools store={store} view={view} add={add} />}>
      {view.problem === '' ? null : <p class="hint">{view.problem}</p>}
      {view.problem === '' && view.notebook === null ? <p class="hint">{words.reading}</p> : null}
      {view.kernel.kind === 'crashed' ? <pre class="printed printed-error">{view.kernel.message}</pre> : null}
      <div class="notebook" role="group" aria-label={store.file} tabIndex={0}>
        {cells.map((cell, index) => (
          <CellView
            key={cell.key}
            cell={cell}
            number={index + 1}
            place={index === 0 ? (cells.length === 1 ? 'only' : 'first') : index === cells.length - 1 ? 'last' : 'middle'}
            state={view.running === cell.key ? 'running' : view.queued.has(cell.key) ? 'queued' : 'rest'}
            asks={view.asks?.cell === cell.key ? view.asks.prompt : null}
            current={current?.key === cell.key}
            focused={current?.key === cell.key && current.focus}
            instance={`${instance}-${cell.key}`}
            file={store.file}
            files={session.site.files}
            store={store}
            onFocus={() => setCurrent({ key: cell.key, focus: false })}
            onRun={(next) => run(cell.key, next)}
          />
        ))}
      </div>
      <Spoken view={view} announce={announce} />
    </PanelFrame>
  );
}

function state({ kernel, running, change }: NotebookView): string {
  const python = running !== null && kernel.kind === 'running' ? words.busy : words.kernels[kernel.kind];
  return `${python} \u00b7 ${words.changes[change]}`;
}

interface ToolsProps {
  readonly store: NotebookStore;
  readonly view: NotebookView;
  readonly add: (kind: 'code' | 'markdown') => void;
}

function Tools({ store, view, add }: ToolsProps) {
  const up = isUp(view.kernel);
  const save = (): void => download(fileName(store.file), new Blob([store.text()], { type: 'application/x-ipynb+json' }));
  const adds = (kind: 'code' | 'markdown') => (
    <button type="button" class="button" title={words.addLong[kind]} aria-label={words.addLong[kind]} onClick={() => add(kind)}>
      <Icon name="plus" />
      {words.add[kind]}
    </button>
  );
  return (
    <>
      <button type="button" class="button" onClick={() => store.runAll()}>
        <Icon name="play" />
        {words.runAll}
      </button>
      <IconButton icon="stop" label={words.interrupt} disabled={view.running === null} onClick={() => store.interrupt()} />
      <IconButton icon="restart" label={words.restartLong} disabled={!up} onClick={() => store.restart()} />
      {adds('code')}
      {adds('markdown')}
      <MenuButton
        icon="more"
        label={words.more}
        items={[
          { id: 'restart', words: words.restartAll, icon: 'restart', choose: () => (store.restart(), store.runAll()) },
          { id: 'clear', words: words.clear, icon: 'clear', choose: () => store.clearOutputs() },
          { id: 'download', words: words.download, icon: 'down', choose: save },
          { id: 'reset', words: words.reset, disabled: view.change === 'none', apart: true, choose: () => store.reset() },
        ]}
      />
    </>
  );
}

/** Tells who does not see it that a cell is over. */
function Spoken({ view, announce }: { readonly view: NotebookView; readonly announce: (text: string) => void; }) {
  const { running, notebook } = view;
  const [last, setLast] = useState<string | null>(null);
  useEffect(() => {
    if (last !== null && running !== last) {
      const at = notebook?.cells.findIndex((cell) => cell.key === last) ?? -1;
      const failed = notebook?.cells[at]?.outputs.some((output) => output['output_type'] === 'error') === true;
      if (at >= 0) announce(failed ? words.didNotRun(at + 1) : words.ran(at + 1));
    }
    setLast(running);
  }, [running]);
  return null;
}
