// A terminal: input with history and completion, output as text, Ctrl-C; shell/ runs the lines, in each terminal in a
// folder of its own. A command that runs goes on while another tab is in front, and ends with the panel. State: {line},
// which stands there at first.

import { useEffect, useRef } from 'preact/hooks';
import { textMember } from '../model/json.ts';
import { IconButton } from '../parts/button.tsx';
import { keyFieldProps } from '../parts/key_input.ts';
import { LineScroller } from '../parts/line_scroller.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { useTerminal } from '../parts/use_terminal.ts';
import type { Terminal } from '../parts/use_terminal.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import { runTexts } from '../texts_run.ts';
import type { PanelProps } from './panel_props.ts';

function placeholderOf({ isRunning, reading }: Terminal): string {
  const { terminal } = panelTexts;
  if (!isRunning) return terminal.placeholder;
  if (reading === 'nothing') return terminal.running;
  return reading === 'lines' ? terminal.taking : runTexts.input.keys;
}

const hasSelection = (): boolean => document.getSelection()?.isCollapsed === false;

export function TerminalPanel(props: PanelProps) {
  const terminal = useTerminal(props, textMember(props.state, 'line'));
  const { reading, prompt, line } = terminal;
  const input = useRef<HTMLInputElement>(null);
  useEffect(() => {
    if (props.justAdded) input.current?.focus();
  }, []);
  const field = reading === 'nothing' || reading === 'lines'
    ? undefined
    : keyFieldProps({ mode: reading, send: terminal.send, interrupt: terminal.stop });

  /** A click anywhere gives the input the keyboard, unless it selected text or pressed something. */
  const onClick = (event: MouseEvent): void => {
    const pressed = event.target instanceof Element && event.target.closest('button, a, input') !== null;
    if (!pressed && !hasSelection()) input.current?.focus();
  };

  /** Whether the key did something, so that the browser must not use it. */
  const typed = (event: KeyboardEvent, control: boolean): boolean => {
    if (event.key === 'Enter') terminal.submit();
    // As in a terminal: nothing is the end of all.
    else if (reading !== 'nothing') return control && event.key === 'd' && (terminal.endInput(), true);
    else if (event.key === 'ArrowUp') terminal.recall(-1);
    else if (event.key === 'ArrowDown') terminal.recall(1);
    else return event.key === 'Tab' && !event.shiftKey && line !== '' && terminal.complete();
    return true;
  };

  const onKey = (event: KeyboardEvent): void => {
    const box = input.current;
    // The output has the keyboard after text was selected in it: what is typed goes to the input, as in any terminal.
    const types = event.key.length === 1 && event.key !== ' ' && !event.ctrlKey && !event.altKey && !event.metaKey;
    if (types && event.target !== box) box?.focus();
    // The field has sent it.
    if (field !== undefined && event.target === box) return;
    const control = event.ctrlKey && !event.altKey && !event.metaKey;
    const isSelected = box !== null && box.selectionStart !== box.selectionEnd;
    let isUsed = true;
    if (control && event.key === 'c' && !isSelected && !hasSelection()) terminal.stop();
    else if (control && event.key === 'l') terminal.clear();
    else isUsed = event.target === box && typed(event, control);
    if (isUsed) event.preventDefault();
  };

  const tools = (
    <>
      {terminal.isRunning ? <IconButton icon="stop" label={panelTexts.terminal.stop} onClick={terminal.stop} /> : null}
      <IconButton icon="clear" label={texts.clear} onClick={terminal.clear} />
    </>
  );
  return (
    <PanelFrame id="terminal" title={texts.panels.terminal} icon="console" tools={tools}>
      <div class="terminal" onKeyDown={onKey} onClick={onClick}>
        <LineScroller list={terminal.list} version={terminal.version} label={panelTexts.terminal.output} empty={panelTexts.terminal.empty} />
        <label class="terminal-input">
          <span class="terminal-prompt" aria-hidden="true">{prompt}</span>
          <input
            ref={input}
            type="text"
            value={field === undefined ? line : ''}
            readOnly={terminal.isRunning && reading === 'nothing'}
            aria-label={panelTexts.terminal.input}
            placeholder={placeholderOf(terminal)}
            autocomplete="off"
            autocapitalize="off"
            autocorrect="off"
            spellcheck={false}
            enterkeyhint="go"
            onInput={(event) => terminal.setLine(event.currentTarget.value)}
            aria-description={field === undefined ? panelTexts.terminal.folder(prompt.slice(0, -1)) : runTexts.input.keys}
            {...field}
          />
        </label>
      </div>
    </PanelFrame>
  );
}
