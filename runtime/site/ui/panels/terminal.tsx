// A terminal: input with history and completion, output as text, Ctrl-C; shell/ runs the lines, in each terminal in a
// folder of its own. A command that runs goes on while another tab is in front, and ends with the panel. State: {line},
// which stands there at first.

import { useEffect, useRef, useState } from 'preact/hooks';
import { wanted } from '../../ros2cli/complete.ts';
import { programsOf } from '../../ros2cli/programs.ts';
import { tellWanted } from '../../ros2cli/completion_sources.ts';
import type { ConsoleLine, KeyMode, Session } from '../../contract/session.ts';
import { textMember } from '../model/json.ts';
import { readText as keptText, writePreference } from '../model/preferences.ts';
import { completeInput, expandTabs, readHistory } from '../model/terminal_input.ts';
import { LineList } from '../model/line_list.ts';
import { IconButton } from '../parts/button.tsx';
import { keyFieldProps } from '../parts/key_input.ts';
import { LineScroller } from '../parts/line_scroller.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { takeLines } from '../parts/terminal_line.ts';
import { Shell } from '../shell/shell.ts';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import { runTexts } from '../texts_run.ts';
import type { PanelProps } from './panel_props.ts';

const kMostLines = 20_000;
const kMostHistory = 200;
/** Upper bound of the lines that wait to be drawn; the oldest of them are dropped. */
const kMostWaiting = 5000;

/** The lines of one terminal, drawn once per animation frame. */
class Screen {
  readonly list = new LineList(kMostLines);
  private waiting: ConsoleLine[] = [];
  private frame = 0;
  private readonly session: Session;
  private readonly drawn: () => void;

  constructor(session: Session, drawn: () => void) {
    this.session = session;
    this.drawn = drawn;
  }

  write(text: string, stream: ConsoleLine['stream']): void {
    const time = this.session.time.view().now;
    // One item, so that a flood of long outputs is bounded too.
    for (const line of text.split('\n')) this.waiting.push({ time, stream, text: expandTabs(line) });
    if (this.waiting.length > 2 * kMostWaiting) this.waiting = this.waiting.slice(-kMostWaiting);
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.flush());
  }

  clear(): void {
    this.waiting = [];
    this.list.clear();
    this.drawn();
  }

  private flush(): void {
    this.frame = 0;
    this.list.append(this.waiting.splice(0), '');
    this.drawn();
  }

  close(): void {
    cancelAnimationFrame(this.frame);
  }
}

export function TerminalPanel({ session, announce, open, state, store, justAdded }: PanelProps) {
  const [version, setVersion] = useState(0);
  const screen = useRef<Screen | null>(null);
  screen.current ??= new Screen(session, () => setVersion((before) => before + 1));
  const { list } = screen.current;
  const [line, setLine] = useState('');
  // A line that a link brings is written, not run.
  const brought = textMember(state, 'line');
  useEffect(() => {
    if (brought !== '') setLine(brought.replace(/\p{Cc}/gu, ' '));
  }, [brought]);
  const [running, setRunning] = useState<AbortController | null>(null);
  const current = useRef<AbortController | null>(null);
  // The name has the path of this site: other sites may be on the same host.
  const historyName = `terminal.${new URL('.', document.baseURI).pathname}`;
  const history = useRef<{ readonly lines: string[]; at: number } | null>(null);
  if (history.current === null) {
    const lines = readHistory(keptText(store, historyName), kMostHistory);
    history.current = { lines, at: lines.length };
  }
  const interfaces = useRef<readonly string[]>([]);
  const input = useRef<HTMLInputElement>(null);
  /** The function of the running command that takes typed text, when it reads any. */
  const taker = useRef<((text: string) => void) | undefined>(undefined);
  const [taking, setTaking] = useState(false);
  /** The command reads each key at once. */
  const [keys, setKeys] = useState<KeyMode | undefined>(undefined);

  useEffect(() => {
    if (justAdded) input.current?.focus();
  }, []);

  useEffect(() => {
    session.interfaces().then(
      (known) => {
        interfaces.current = [...known.keys()];
      },
      () => undefined,
    );
    return () => {
      current.current?.abort();
      screen.current?.close();
    };
  }, [session]);

  const print = (text: string): void => screen.current?.write(text, 'stdout');
  const warn = (text: string): void => screen.current?.write(text, 'stderr');

  const shell = useRef<Shell | null>(null);
  const opened = useRef(open);
  opened.current = open;
  shell.current ??= new Shell({
    session, print, warn,
    clear: () => screen.current?.clear(),
    takeInput: (to, mode) => {
      taker.current = to;
      setTaking(to !== undefined);
      setKeys(mode);
    },
    open: (panel, wantedState) => opened.current(panel, wantedState),
    history: () => history.current?.lines ?? [],
    forgetHistory: () => {
      history.current = { lines: [], at: 0 };
      writePreference(store, historyName, '[]');
    },
  });
  const { prompt } = shell.current;
  useEffect(() => void shell.current?.look().catch(() => undefined), []);

  const run = async (typed: string): Promise<void> => {
    session.tasks?.acted();
    const abort = new AbortController();
    print(`${prompt} ${typed}`);
    current.current = abort;
    setRunning(abort);
    await shell.current?.run(typed, abort);
    current.current = null;
    setRunning(null);
  };

  /** In this terminal, and for the ones that are opened later: other terminals may have typed meanwhile. */
  const remember = (typed: string): void => {
    const add = (lines: string[]): string[] => {
      if (lines.at(-1) !== typed) lines.push(typed);
      return lines.slice(-kMostHistory);
    };
    const lines = add(history.current?.lines ?? []);
    history.current = { lines, at: lines.length };
    writePreference(store, historyName, JSON.stringify(add(readHistory(keptText(store, historyName), kMostHistory))));
  };

  const submit = (): void => {
    if (taker.current !== undefined) {
      print(line);
      taker.current(`${line}\n`);
      setLine('');
      return;
    }
    const typed = line.trim();
    if (running !== null) return;
    setLine('');
    if (typed === '') return;
    remember(typed);
    void run(typed);
  };

  const runNow = useRef(run);
  runNow.current = run;
  // A link of the lab sheet asks for a line.
  useEffect(
    () =>
      takeLines((asked) => {
        if (current.current !== null) return false;
        void runNow.current(asked);
        return true;
      }),
    [],
  );

  const stop = (): void => {
    if (current.current === null) {
      setLine('');
      return;
    }
    print('^C');
    announce(panelTexts.terminal.stopped);
    current.current.abort();
  };

  const recall = (step: -1 | 1): void => {
    if (history.current === null) return;
    const { lines, at } = history.current;
    const to = Math.max(0, Math.min(lines.length, at + step));
    history.current.at = to;
    setLine(lines[to] ?? '');
  };

  const field = keys === undefined ? undefined : keyFieldProps({ mode: keys, send: (text) => taker.current?.(text), interrupt: stop });

  /** A click anywhere gives the input the keyboard, unless it selected text or pressed something. */
  const onClick = (event: MouseEvent): void => {
    const pressed = event.target instanceof Element && event.target.closest('button, a, input') !== null;
    if (!pressed && document.getSelection()?.isCollapsed !== false) input.current?.focus();
  };

  const onKey = (event: KeyboardEvent): void => {
    // The output has the keyboard after text was selected in it: what is typed goes to the input, as in any terminal.
    const types = event.key.length === 1 && event.key !== ' ' && !event.ctrlKey && !event.altKey && !event.metaKey;
    if (types && event.target !== input.current) input.current?.focus();
    // The field has sent it.
    if (field !== undefined && event.target === input.current) return;
    const control = event.ctrlKey && !event.altKey && !event.metaKey;
    const selected = input.current !== null && input.current.selectionStart !== input.current.selectionEnd;
    if (control && event.key === 'c' && !selected && document.getSelection()?.isCollapsed !== false) {
      event.preventDefault();
      stop();
    } else if (control && event.key === 'l') {
      event.preventDefault();
      screen.current?.clear();
    } else if (event.target !== input.current) {
      return;
    } else if (event.key === 'Enter') {
      event.preventDefault();
      submit();
    } else if (taker.current !== undefined) {
      // As in a terminal: what is typed goes without a line's end; nothing is the end of all.
      if (!control || event.key !== 'd') return;
      event.preventDefault();
      taker.current(line);
      setLine('');
    } else if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      event.preventDefault();
      recall(event.key === 'ArrowUp' ? -1 : 1);
    } else if (event.key === 'Tab' && !event.shiftKey && line !== '') {
      const ask = wanted(line);
      if (ask !== undefined) {
        event.preventDefault();
        void tellWanted(session, ask).then((told) => {
          // Unless more was typed meanwhile.
          if (input.current?.value === line) offer(told);
        });
      } else if (offer([])) {
        event.preventDefault();
      }
    }
  };

  /** Completes the line, or shows what there is. False: nothing to complete, the key moves on, so that nobody is caught here. */
  const offer = (told: readonly string[]): boolean => {
    const known = { graph: session.graph(), interfaces: interfaces.current, programs: programsOf(session.site), launches: session.site, told };
    const done = shell.current === null ? { kind: 'nothing' } as const : completeInput(line, shell.current.offer(line, known));
    if (done.kind === 'nothing') return false;
    if (done.kind === 'line') {
      setLine(done.line);
    } else {
      print(`${prompt} ${line}\n${done.choices.join('  ')}`);
      announce(panelTexts.terminal.choices(done.choices.length));
    }
    return true;
  };

  const tools = (
    <>
      {running === null ? null : <IconButton icon="stop" label={panelTexts.terminal.stop} onClick={stop} />}
      <IconButton icon="clear" label={texts.clear} onClick={() => screen.current?.clear()} />
    </>
  );
  return (
    <PanelFrame id="terminal" title={texts.panels.terminal} icon="console" tools={tools}>
      <div class="terminal" onKeyDown={onKey} onClick={onClick}>
        <LineScroller list={list} version={version} label={panelTexts.terminal.output} empty={panelTexts.terminal.empty} />
        <label class="terminal-input">
          <span class="terminal-prompt" aria-hidden="true">{prompt}</span>
          <input
            ref={input}
            type="text"
            value={field === undefined ? line : ''}
            readOnly={running !== null && !taking}
            aria-label={panelTexts.terminal.input}
            placeholder={running === null ? panelTexts.terminal.placeholder : keys !== undefined ? runTexts.input.keys : taking ? panelTexts.terminal.taking : panelTexts.terminal.running}
            autocomplete="off"
            autocapitalize="off"
            autocorrect="off"
            spellcheck={false}
            enterkeyhint="go"
            onInput={(event) => setLine(event.currentTarget.value)}
            aria-description={keys === undefined ? panelTexts.terminal.folder(prompt.slice(0, -1)) : runTexts.input.keys}
            {...field}
          />
        </label>
      </div>
    </PanelFrame>
  );
}
