// A text field whose keys go to a node at once, for nodes that read keys and not lines. Text comes by the field's own
// events, so that phones and input methods work; Tab leads on, so that nobody is caught.

import type { TargetedCompositionEvent, TargetedInputEvent, TargetedKeyboardEvent } from 'preact';
import type { KeyMode } from '../../contract/session.ts';
import { keyText } from '../model/terminal_keys.ts';

export interface KeyTaker {
  readonly mode: KeyMode;
  readonly send: (text: string) => void;
  /** Ctrl-C, where it is a signal. */
  readonly interrupt: () => void;
}

interface FieldProps {
  readonly onInput: (event: TargetedInputEvent<HTMLInputElement>) => void;
  readonly onCompositionEnd: (event: TargetedCompositionEvent<HTMLInputElement>) => void;
  readonly onKeyDown: (event: TargetedKeyboardEvent<HTMLInputElement>) => void;
}

export function keyFieldProps({ mode, send, interrupt }: KeyTaker): FieldProps {
  const take = (field: HTMLInputElement): void => {
    if (field.value !== '') send(field.value);
    field.value = '';
  };
  return {
    onInput: (event) => {
      if (!event.isComposing) take(event.currentTarget);
    },
    onCompositionEnd: (event) => take(event.currentTarget),
    onKeyDown: (event) => {
      if (event.isComposing) return;
      const text = keyText(event);
      // With a selection elsewhere, Ctrl-C copies it.
      const copies = text === '\u0003' && document.getSelection()?.isCollapsed === false;
      if (text === undefined || copies) return;
      event.preventDefault();
      if (text === '\u0003' && mode === 'cbreak') interrupt();
      else send(text);
    },
  };
}
