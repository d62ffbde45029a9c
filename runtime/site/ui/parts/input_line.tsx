// The line for a node's standard input: lines, or each key at once while the node reads keys.

import { useState } from 'preact/hooks';
import type { KeyMode } from '../../contract/session.ts';
import { runTexts } from '../texts_run.ts';
import { Icon } from './icon.tsx';
import { keyFieldProps } from './key_input.ts';

export interface InputLineProps {
  readonly label: string;
  /** undefined: it reads lines. */
  readonly mode: KeyMode | undefined;
  /** When it appears. */
  readonly focused: boolean;
  readonly send: (text: string) => void;
  readonly interrupt: () => void;
}

export function InputLine({ label, mode, focused, send, interrupt }: InputLineProps) {
  const [text, setText] = useState('');
  const keys = mode === undefined ? undefined : keyFieldProps({ mode, send, interrupt });
  const onKey = (event: KeyboardEvent & { readonly currentTarget: HTMLInputElement; }): void => {
    const { selectionStart, selectionEnd } = event.currentTarget;
    if (!event.ctrlKey || event.altKey || event.metaKey || event.shiftKey) return;
    const key = event.key.toLowerCase();
    if (key === 'c' && selectionStart === selectionEnd) interrupt();
    // As in a terminal: what is typed goes without a line's end; nothing is the end of all.
    else if (key === 'd') send(text);
    else return;
    event.preventDefault();
    setText('');
  };
  return (
    <form
      class="input-line"
      onSubmit={(event) => {
        event.preventDefault();
        if (mode === undefined) send(`${text}\n`);
        setText('');
      }}
    >
      <span class="input-sign" aria-hidden="true">
        {mode === undefined ? '>' : <Icon name="input" />}
      </span>
      <input
        type="text"
        class="input-text"
        value={mode === undefined ? text : ''}
        onInput={(event) => setText(event.currentTarget.value)}
        onKeyDown={onKey}
        {...keys}
        aria-label={runTexts.input.label(label)}
        placeholder={mode === undefined ? runTexts.input.hint : runTexts.input.keys}
        aria-description={mode === undefined ? undefined : runTexts.input.keys}
        autocomplete="off"
        autocapitalize="off"
        spellcheck={false}
        ref={(element) => {
          if (focused && element !== null && element.dataset['met'] === undefined) {
            element.dataset['met'] = '';
            element.focus();
          }
        }}
      />
      {mode === undefined
        ? (
          <button type="submit" class="button">
            {runTexts.input.send}
          </button>
        )
        : null}
    </form>
  );
}
