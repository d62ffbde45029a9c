// The state of one terminal: its lines, its shell, the command that runs, and what the keys of its input do.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { KeyMode, Session } from '../../contract/session.ts';
import { wanted } from '../../ros2cli/complete.ts';
import { tellWanted } from '../../ros2cli/completion_sources.ts';
import { programsOf } from '../../ros2cli/programs.ts';
import { completeInput } from '../model/terminal_input.ts';
import type { LineList } from '../model/line_list.ts';
import type { PanelProps } from '../panels/panel_props.ts';
import { Shell } from '../shell/shell.ts';
import { panelTexts } from '../texts_panels.ts';
import { takeLines } from './terminal_line.ts';
import { TerminalScreen } from './terminal_screen.ts';
import { useTerminalHistory } from './use_terminal_history.ts';

/** How the running command reads what is typed. */
export type Reading = 'nothing' | 'lines' | KeyMode;

export interface Terminal {
  readonly list: LineList;
  /** Changes when there is more to draw. */
  readonly version: number;
  readonly prompt: string;
  readonly isRunning: boolean;
  readonly reading: Reading;
  /** The text of the input. */
  readonly line: string;
  setLine(line: string): void;
  /** Enter: the line goes to the command that reads, or runs. */
  submit(): void;
  /** Ctrl-C: ends the command, or empties the line. */
  stop(): void;
  /** Ctrl-D: what is typed goes to the command that reads, without a line's end. */
  endInput(): void;
  /** Passes a text to the command that reads. */
  send(text: string): void;
  recall(step: -1 | 1): void;
  clear(): void;
  /** Completes the line, or shows what there is. False: there is nothing, so the key moves on and nobody is caught. */
  complete(): boolean;
}

function useScreen(session: Session): { readonly screen: TerminalScreen; readonly version: number; } {
  const [version, setVersion] = useState(0);
  const screen = useRef<TerminalScreen | null>(null);
  screen.current ??= new TerminalScreen(session, () => setVersion((before) => before + 1));
  return { screen: screen.current, version };
}

/** The names of all interfaces, for completion; none until they are there. */
function useInterfaceNames(session: Session): { readonly current: readonly string[]; } {
  const names = useRef<readonly string[]>([]);
  useEffect(() => {
    session.interfaces().then(
      (known) => {
        names.current = [...known.keys()];
      },
      () => undefined,
    );
  }, [session]);
  return names;
}

/** `brought`: a line that a link brings, which is written and not run. */
export function useTerminal({ session, announce, open, store }: PanelProps, brought: string): Terminal {
  const { screen, version } = useScreen(session);
  const history = useTerminalHistory(store);
  const interfaces = useInterfaceNames(session);
  const [line, setLine] = useState('');
  const typed = useRef(line);
  typed.current = line;
  const [isRunning, setRunning] = useState(false);
  const command = useRef<AbortController | null>(null);
  /** The function of the running command that takes typed text, when it reads any. */
  const taker = useRef<((text: string) => void) | undefined>(undefined);
  const [reading, setReading] = useState<Reading>('nothing');

  useEffect(() => {
    if (brought !== '') setLine(brought.replace(/\p{Cc}/gu, ' '));
  }, [brought]);
  useEffect(
    () => () => {
      command.current?.abort();
      screen.close();
    },
    [session],
  );

  const print = (text: string): void => screen.write(text, 'stdout');
  const opened = useRef(open);
  opened.current = open;
  const made = useRef<Shell | null>(null);
  made.current ??= new Shell({
    session,
    print,
    warn: (text) => screen.write(text, 'stderr'),
    clear: () => screen.clear(),
    takeInput: (to, mode) => {
      taker.current = to;
      setReading(to === undefined ? 'nothing' : mode ?? 'lines');
    },
    open: (panel, wantedState) => opened.current(panel, wantedState),
    history: () => history.lines(),
    forgetHistory: () => history.forget(),
  });
  const shell = made.current;
  useEffect(() => void shell.look().catch(() => undefined), []);
  const { prompt } = shell;

  const run = async (text: string): Promise<void> => {
    session.tasks?.acted();
    const abort = new AbortController();
    print(`${prompt} ${text}`);
    command.current = abort;
    setRunning(true);
    await shell.run(text, abort);
    command.current = null;
    setRunning(false);
  };
  const runNow = useRef(run);
  runNow.current = run;
  // A link of the lab sheet asks for a line.
  useEffect(
    () =>
      takeLines((asked) => {
        if (command.current !== null) return false;
        void runNow.current(asked);
        return true;
      }),
    [],
  );

  const submit = (): void => {
    if (taker.current !== undefined) {
      print(line);
      taker.current(`${line}\n`);
      setLine('');
      return;
    }
    if (isRunning) return;
    setLine('');
    const text = line.trim();
    if (text === '') return;
    history.add(text);
    void run(text);
  };
  const stop = (): void => {
    if (command.current === null) {
      setLine('');
      return;
    }
    print('^C');
    announce(panelTexts.terminal.stopped);
    command.current.abort();
  };
  const offer = (found: readonly string[]): boolean => {
    const known = { graph: session.graph(), interfaces: interfaces.current, programs: programsOf(session.site), launches: session.site, told: found };
    const done = completeInput(line, shell.offer(line, known));
    if (done.kind === 'nothing') return false;
    if (done.kind === 'line') {
      setLine(done.line);
    } else {
      print(`${prompt} ${line}\n${done.choices.join('  ')}`);
      announce(panelTexts.terminal.choices(done.choices.length));
    }
    return true;
  };
  const complete = (): boolean => {
    const ask = wanted(line);
    if (ask === undefined) return offer([]);
    void tellWanted(session, ask).then((found) => {
      // Unless more was typed meanwhile.
      if (typed.current === line) offer(found);
    });
    return true;
  };

  return {
    list: screen.list,
    version,
    prompt,
    isRunning,
    reading,
    line,
    setLine,
    submit,
    stop,
    complete,
    endInput: () => {
      taker.current?.(line);
      setLine('');
    },
    send: (text) => taker.current?.(text),
    recall: (step) => setLine(history.recall(step)),
    clear: () => screen.clear(),
  };
}
