// The editor of one cell: CodeMirror, as high as its text. It lies in a shadow root, where it puts its styles as adopted
// style sheets: in the document it would make a style element, which the page's policy forbids.

import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { pythonLanguage } from '@codemirror/lang-python';
import { bracketMatching, indentOnInput, indentUnit } from '@codemirror/language';
import { EditorState, Prec } from '@codemirror/state';
import type { Extension } from '@codemirror/state';
import { EditorView, drawSelection, keymap } from '@codemirror/view';
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import { codeLook } from './code_look.ts';

export interface CellEditorProps {
  readonly source: string;
  readonly python: boolean;
  readonly label: string;
  readonly focused: boolean;
  readonly onChange: (source: string) => void;
  /** `next`: and go on to the next cell. */
  readonly onRun: (next: boolean) => void;
  readonly onFocus: () => void;
}

export function CellEditor(props: CellEditorProps) {
  const host = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const latest = useRef(props);
  latest.current = props;
  const { source, python, label, focused } = props;

  useEffect(() => {
    if (host.current === null) return undefined;
    const root = host.current.shadowRoot ?? host.current.attachShadow({ mode: 'open' });
    const made = new EditorView({
      root,
      parent: root,
      state: EditorState.create({ doc: latest.current.source, extensions: extensions(python, label, () => latest.current) }),
    });
    view.current = made;
    return () => {
      made.destroy();
      view.current = null;
    };
  }, [python, label]);

  // A change from elsewhere: the packed notebook again. Right after drawing, when `source` is the text that the store has now:
  // later, text that was typed in the meantime would be taken for older, and replaced.
  useLayoutEffect(() => {
    const open = view.current;
    if (open !== null && open.state.sliceDoc() !== source)
      open.dispatch({ changes: { from: 0, to: open.state.doc.length, insert: source } });
  }, [source]);

  useEffect(() => {
    if (focused) view.current?.focus();
  }, [focused]);

  return <div class="cell-editor" ref={host} />;
}

function extensions(python: boolean, label: string, props: () => CellEditorProps): Extension {
  const run = (next: boolean) => (): boolean => {
    props().onRun(next);
    return true;
  };
  return [
    Prec.highest(keymap.of([{ key: 'Shift-Enter', run: run(true) }, { key: 'Mod-Enter', run: run(false) }])),
    history(),
    drawSelection(),
    indentOnInput(),
    bracketMatching(),
    indentUnit.of('    '),
    EditorView.lineWrapping,
    python ? pythonLanguage : [],
    codeLook,
    EditorView.contentAttributes.of({ 'aria-label': label, spellcheck: python ? 'false' : 'true' }),
    keymap.of([indentWithTab, ...defaultKeymap, ...historyKeymap]),
    EditorView.updateListener.of(({ docChanged, focusChanged, state, view }) => {
      if (docChanged) props().onChange(state.sliceDoc());
      if (focusChanged && view.hasFocus) props().onFocus();
    }),
  ];
}
