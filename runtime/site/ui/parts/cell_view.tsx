// One cell of a notebook: its code or text, what it has shown, and what can be done with it.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { SiteFile } from '../../contract/session.ts';
import type { NotebookCell } from '../model/notebook.ts';
import { viewTexts } from '../texts_views.ts';
import { IconButton } from './button.tsx';
import { CellEditor } from './cell_editor.tsx';
import { MarkdownView } from './markdown_view.tsx';
import { MenuButton } from './menu.tsx';
import type { MenuItem } from './menu.tsx';
import type { NotebookStore } from './notebook_store.ts';
import { OutputView } from './output_view.tsx';

const words = viewTexts.notebook;

export interface CellProps {
  readonly cell: NotebookCell;
  /** In the notebook, from 1. */
  readonly number: number;
  readonly place: 'only' | 'first' | 'middle' | 'last';
  readonly state: 'rest' | 'queued' | 'running';
  /** The prompt of the cell that waits for standard input; null: it does not wait. */
  readonly asks: string | null;
  readonly current: boolean;
  /** It is to get the keyboard. */
  readonly focused: boolean;
  readonly instance: string;
  readonly file: string;
  readonly files: readonly SiteFile[];
  readonly store: NotebookStore;
  readonly onFocus: () => void;
  readonly onRun: (next: boolean) => void;
}

export function CellView(props: CellProps) {
  const { cell, number, state, asks, current, focused, instance, store, onRun } = props;
  const [editing, setEditing] = useState(false);
  const near = useNear(focused);
  const name = words.cell(number, words.kinds[cell.kind]);
  const isText = cell.kind === 'markdown';
  const reads = isText && !editing && !(focused && cell.source === '');
  const body = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (focused && isText && cell.source === '') setEditing(true);
    if (focused) body.current?.scrollIntoView({ block: 'nearest' });
    if (focused && reads) body.current?.focus();
  }, [focused]);
  const run = (next: boolean): void => {
    if (isText) setEditing(false);
    onRun(next);
  };
  return (
    <div class={`cell cell-${cell.kind} ${current ? 'cell-current' : ''}`} role="group" aria-label={name} onFocusIn={current ? undefined : props.onFocus}>
      <div class="cell-side">
        {cell.kind === 'code'
          ? (
            <>
              <IconButton icon="play" label={words.run} disabled={state !== 'rest'} onClick={() => run(false)} />
              <span class="cell-count">{state === 'rest' ? (cell.count === null ? '[ ]' : `[${cell.count}]`) : words.counts[state]}</span>
            </>
          )
          : null}
        {isText
          ? (
            <IconButton icon={reads ? 'edit' : 'check'} label={reads ? words.edit : words.done} onClick={() => setEditing(reads)} />
          )
          : null}
      </div>
      <div class="cell-body" ref={body} tabIndex={-1}>
        {reads
          ? (
            <CellText {...props} onEdit={() => setEditing(true)} />
          )
          : near.near || focused
          ? (
            <CellEditor
              source={cell.source}
              python={cell.kind === 'code'}
              label={name}
              focused={focused || editing}
              onChange={(source) => store.setSource(cell.key, source)}
              onRun={run}
              onFocus={props.onFocus}
            />
          )
          : (
            <pre class="cell-far" ref={near.ref}>
            {cell.source}
            </pre>
          )}
        {asks === null ? null : <Question prompt={asks} answer={(text) => store.answer(text)} />}
        {cell.outputs.length === 0 ? null : (
          <div class="outputs" role="group" aria-label={words.output(number)} tabIndex={0}>
            {cell.outputs.map((output, index) => (
              <OutputView key={index} output={output} instance={`${instance}-${index}`} />
            ))}
          </div>
        )}
      </div>
      <MenuButton icon="more" label={words.cellMenu(name)} class="cell-more" items={menu(props)} />
    </div>
  );
}

function menu({ cell, place, store }: CellProps): readonly MenuItem[] {
  return [
    { id: 'up', words: words.up, icon: 'up', disabled: place === 'first' || place === 'only', choose: () => store.move(cell.key, -1) },
    { id: 'down', words: words.down, icon: 'down', disabled: place === 'last' || place === 'only', choose: () => store.move(cell.key, 1) },
    cell.kind === 'code'
      ? { id: 'text', words: words.toMarkdown, icon: 'text', apart: true, choose: () => store.setKind(cell.key, 'markdown') }
      : { id: 'code', words: words.toCode, icon: 'console', apart: true, choose: () => store.setKind(cell.key, 'code') },
    { id: 'remove', words: words.remove, icon: 'clear', apart: true, choose: () => store.remove(cell.key) },
  ];
}

function CellText({ cell, instance, file, files, onEdit }: CellProps & { readonly onEdit: () => void; }) {
  const paths = useMemo(() => new Set(files.map(({ path }) => path)), [files]);
  return (
    <div class="text cell-text" onDblClick={onEdit}>
      {cell.source.trim() === ''
        ? (
          <p class="hint">{words.empty}</p>
        )
        : (
          <MarkdownView text={cell.source} file={file} files={paths} instance={instance} act={() => undefined} />
        )}
    </div>
  );
}

function Question({ prompt, answer }: { readonly prompt: string; readonly answer: (text: string) => void; }) {
  const [text, setText] = useState('');
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => field.current?.focus(), []);
  return (
    <form
      class="question"
      onSubmit={(event) => {
        event.preventDefault();
        answer(text);
      }}
    >
      <label>
        {prompt.trim() === '' ? words.asks : prompt}
        <input class="field" ref={field} value={text} onInput={(event) => setText(event.currentTarget.value)} />
      </label>
      <button type="submit" class="button">
        {words.answer}
      </button>
    </form>
  );
}

/** Whether an element has come near what is seen: editors are made then, since each costs something. */
function useNear(focused: boolean): { readonly near: boolean; readonly ref: (element: Element | null) => void; } {
  const [near, setNear] = useState(false);
  const [element, ref] = useState<Element | null>(null);
  // An editor that was made stays: the keyboard would go with it.
  useEffect(() => {
    if (focused) setNear(true);
  }, [focused]);
  useEffect(() => {
    if (element === null) return undefined;
    const watch = new IntersectionObserver((seen) => {
      if (seen.some(({ isIntersecting }) => isIntersecting)) setNear(true);
    }, { rootMargin: '400px' });
    watch.observe(element);
    return () => watch.disconnect();
  }, [element]);
  return { near, ref };
}
