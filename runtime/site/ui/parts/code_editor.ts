// The editor of a Python file: CodeMirror ends here and, for a notebook's cells, in cell_editor.tsx. It lies in a shadow
// root, where it puts its styles as adopted style sheets: in the document it would make a style element, which the
// page's policy forbids.

import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { pythonLanguage } from '@codemirror/lang-python';
import { HighlightStyle, bracketMatching, indentOnInput, indentUnit, syntaxHighlighting } from '@codemirror/language';
import { EditorState, type Extension, StateEffect, StateField } from '@codemirror/state';
import {
  Decoration,
  type DecorationSet,
  EditorView,
  drawSelection,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from '@codemirror/view';
import { tags } from '@lezer/highlight';

export interface CodeEditorEvents {
  /** The visitor typed, or took something back. */
  readonly changed: () => void;
  /** Ctrl-S. */
  readonly apply: () => void;
  /** The cursor came to that line, from 1. */
  readonly line: (line: number) => void;
}

export interface CodeEditor {
  text(): string;
  /** A change that can be taken back. */
  replace(text: string): void;
  /** Lines that are other than packed, from 1. */
  mark(lines: readonly number[]): void;
  /** The line in which a node's last error arose, from 1; null: none. */
  markTrouble(line: number | null): void;
  /** Into sight, with the cursor, and the keyboard too if so. */
  goTo(line: number, focus: boolean): void;
  close(): void;
}

const setMarks = StateEffect.define<readonly number[]>();
const markOf = Decoration.line({ class: 'cm-changed' });

const marks = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(before, { state, changes, effects }) {
    let now = before.map(changes);
    for (const effect of effects) {
      if (!effect.is(setMarks)) continue;
      const lines = effect.value.filter((line) => line >= 1 && line <= state.doc.lines);
      now = Decoration.set(lines.map((line) => markOf.range(state.doc.line(line).from)), true);
    }
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const setTrouble = StateEffect.define<number | null>();
const troubleOf = Decoration.line({ class: 'cm-trouble' });

const trouble = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(before, { state, changes, effects }) {
    let now = before.map(changes);
    for (const effect of effects) {
      if (!effect.is(setTrouble)) continue;
      const line = effect.value;
      now = line === null || line > state.doc.lines ? Decoration.none : Decoration.set([troubleOf.range(state.doc.line(line).from)]);
    }
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.operatorKeyword, tags.modifier], color: 'var(--plot-5)' },
  { tag: [tags.string, tags.special(tags.string)], color: 'var(--good)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--warn)' },
  { tag: tags.comment, color: 'var(--text-soft)', fontStyle: 'italic' },
  { tag: [tags.definition(tags.variableName), tags.function(tags.variableName), tags.definition(tags.propertyName)], color: 'var(--accent)' },
  { tag: tags.className, color: 'var(--plot-6)' },
  { tag: tags.meta, color: 'var(--plot-7)' },
  { tag: tags.invalid, color: 'var(--bad)' },
]);

const theme = EditorView.theme({
  '&': { height: '100%', color: 'var(--text)', backgroundColor: 'var(--sunken)', fontSize: 'var(--size-code)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.6' },
  '.cm-content': { caretColor: 'var(--text)', paddingBlock: '0.5rem' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '.cm-gutters': { color: 'var(--text-soft)', backgroundColor: 'var(--sunken)', borderRight: '1px solid var(--line)' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--hover) 60%, transparent)', color: 'inherit' },
  '.cm-changed': { boxShadow: 'inset 3px 0 var(--warn)' },
  '.cm-trouble': {
    backgroundColor: 'color-mix(in srgb, var(--bad) 16%, transparent)',
    textDecorationLine: 'underline',
    textDecorationStyle: 'wavy',
    textDecorationColor: 'var(--bad)',
    textDecorationSkipInk: 'none',
  },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': { backgroundColor: 'var(--accent-faint)' },
  '&.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--accent-faint)' },
});

/** Chromium joins the lines of a selection with a style attribute when it types over them, which the page's policy forbids. */
const typedOver = EditorView.domEventHandlers({
  beforeinput: (event, view) => {
    const { data, inputType, isComposing } = event;
    if (inputType !== 'insertText' || isComposing || data === null || view.state.selection.main.empty) return false;
    view.dispatch(view.state.replaceSelection(data), { userEvent: 'input.type', scrollIntoView: true });
    event.preventDefault();
    return true;
  },
});

/** The extensions that all files share; a text keeps its line ends. */
function extensions(events: CodeEditorEvents, text: string): Extension {
  const allCrLf = text.includes('\r\n') && !/[^\r]\n|^\n/.test(text);
  return [
    EditorState.lineSeparator.of(allCrLf ? '\r\n' : '\n'),
    lineNumbers(),
    history(),
    drawSelection(),
    indentOnInput(),
    bracketMatching(),
    highlightActiveLine(),
    highlightActiveLineGutter(),
    indentUnit.of('    '),
    EditorState.tabSize.of(8),
    typedOver,
    pythonLanguage,
    syntaxHighlighting(colours),
    theme,
    marks,
    trouble,
    keymap.of([
      { key: 'Mod-s', preventDefault: true, run: () => (events.apply(), true) },
      indentWithTab,
      ...defaultKeymap,
      ...historyKeymap,
    ]),
    EditorView.updateListener.of(({ docChanged, selectionSet, state }) => {
      if (docChanged) events.changed();
      if (docChanged || selectionSet) events.line(state.doc.lineAt(state.selection.main.head).number);
    }),
  ];
}

/** `host`: an element of its own, empty. `label`: its name for people who use a screen reader. */
export function openCodeEditor(host: HTMLElement, text: string, label: string, events: CodeEditorEvents): CodeEditor {
  const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
  // It can have the focus without a tabindex; what checks pages by their attributes sees it only so.
  const attributes = EditorView.contentAttributes.of({ 'aria-label': label, tabindex: '0' });
  const view = new EditorView({ root, parent: root, doc: text, extensions: [extensions(events, text), attributes] });
  const whole = (state: EditorState): string => state.sliceDoc();
  return {
    text: () => whole(view.state),
    replace: (text) => {
      if (text !== whole(view.state)) view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: view.state.toText(text) } });
    },
    mark: (lines) => view.dispatch({ effects: setMarks.of(lines) }),
    markTrouble: (line) => view.dispatch({ effects: setTrouble.of(line) }),
    goTo: (line, focus) => {
      const { doc } = view.state;
      const { from } = doc.line(Math.max(1, Math.min(line, doc.lines)));
      view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
      if (focus) view.focus();
    },
    close: () => view.destroy(),
  };
}
