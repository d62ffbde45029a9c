// A terminal for the commands of ros2: input with history and completion, output as text, Ctrl-C. A command that runs
// goes on while another tab is in front, and ends with the panel.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { BagPlace } from '../../ros2cli/command.ts';
import { complete } from '../../ros2cli/complete.ts';
import { programsOf } from '../../ros2cli/programs.ts';
import { splitLine } from '../../ros2cli/parse.ts';
import { runCommand } from '../../ros2cli/run.ts';
import { fetchOfSite } from '../../wasm_js/carried_files.ts';
import type { ConsoleLine, KeyMode, Session } from '../../wasm_js/session.ts';
import { completeInput, expandTabs, withoutTarget } from '../model/terminal_input.ts';
import { LineList } from '../model/line_list.ts';
import { IconButton } from '../parts/button.tsx';
import { keyFieldProps } from '../parts/key_input.ts';
import { LineScroller } from '../parts/line_scroller.tsx';
import { PanelFrame } from '../parts/panel.tsx';
import { texts } from '../texts.ts';
import { panelTexts } from '../texts_panels.ts';
import type { PanelProps } from './panel_props.ts';

const kMostLines = 20_000;
const kMostHistory = 200;
/** What a flood may leave undrawn; the oldest of it is left out. */
const kMostWaiting = 5000;
/** Of a file that is read or written. */
const kMostTextBytes = 1 << 20;

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

/** The shelf of the panel for bags, which comes with the first command that needs it. */
function bagsOf(session: Session): BagPlace {
  const place = async (): Promise<BagPlace> => (await import('../parts/bag_desk.ts')).bagDesk(session).place;
  return {
    open: async (name) => (await place()).open(name),
    create: async (name) => (await place()).create(name),
  };
}

/** What was written with `>`, by name; as long as the page is open. */
const written = new Map<string, string>();

/** A text that was written here, or a file of the site by its path, with or without the folders that it begins with. */
async function readText(session: Session, name: string): Promise<string | undefined> {
  const own = written.get(name);
  if (own !== undefined) return own;
  const prefix = `${session.prefix}/`;
  const path = name.startsWith(prefix) ? name.slice(prefix.length) : name;
  const { files } = session.site;
  const found = files.find((file) => file.path === path) ?? files.find((file) => file.path.endsWith(`/${path}`));
  if (found === undefined || found.size > kMostTextBytes) return undefined;
  const response = await fetchOfSite(found.path);
  if (!response.ok) throw new Error(`HTTP ${response.status}`);
  return await response.text();
}

export function TerminalPanel({ session, announce }: PanelProps) {
  const [version, setVersion] = useState(0);
  const screen = useRef<Screen | null>(null);
  screen.current ??= new Screen(session, () => setVersion((before) => before + 1));
  const { list } = screen.current;
  const [line, setLine] = useState('');
  const [running, setRunning] = useState<AbortController | null>(null);
  const current = useRef<AbortController | null>(null);
  const history = useRef<{ readonly lines: string[]; at: number }>({ lines: [], at: 0 });
  const interfaces = useRef<readonly string[]>([]);
  const input = useRef<HTMLInputElement>(null);
  /** Of the command that runs, when it reads what is typed. */
  const taker = useRef<((text: string) => void) | undefined>(undefined);
  const [taking, setTaking] = useState(false);
  /** The command reads each key at once. */
  const [keys, setKeys] = useState<KeyMode | undefined>(undefined);

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

  const run = async (typed: string): Promise<void> => {
    print(`$ ${typed}`);
    const split = splitLine(typed);
    if (split === undefined) {
      warn(panelTexts.terminal.openQuote);
      return;
    }
    const { words, target } = withoutTarget(split);
    const [program, ...rest] = words;
    if (program === undefined) return;
    if (program === 'clear') {
      screen.current?.clear();
      return;
    }
    if (program === 'help') {
      print(panelTexts.terminal.help);
      return;
    }
    if (program !== 'ros2') {
      warn(panelTexts.terminal.notFound(program));
      return;
    }
    const abort = new AbortController();
    current.current = abort;
    setRunning(abort);
    let text = '';
    const keep = (line: string): void => {
      if (text.length + line.length < kMostTextBytes) {
        text += `${line}\n`;
      } else {
        warn(panelTexts.terminal.tooLong(kMostTextBytes));
        abort.abort();
      }
    };
    await runCommand(session, rest, {
      signal: abort.signal,
      bags: bagsOf(session),
      readText: (name) => readText(session, name),
      takeInput: (to, mode) => {
        taker.current = to;
        setTaking(to !== undefined);
        setKeys(mode);
      },
      print: target === undefined ? print : keep,
      warn,
    });
    if (target !== undefined) written.set(target, text);
    current.current = null;
    taker.current = undefined;
    setTaking(false);
    setKeys(undefined);
    setRunning(null);
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
    const { lines } = history.current;
    if (lines.at(-1) !== typed) lines.push(typed);
    if (lines.length > kMostHistory) lines.shift();
    history.current.at = lines.length;
    void run(typed);
  };

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
    const { lines, at } = history.current;
    const to = Math.max(0, Math.min(lines.length, at + step));
    history.current.at = to;
    setLine(lines[to] ?? '');
  };

  const field = keys === undefined ? undefined : keyFieldProps({ mode: keys, send: (text) => taker.current?.(text), interrupt: stop });

  const onKey = (event: KeyboardEvent): void => {
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
      const done = completeInput(line, complete(line, { graph: session.graph(), interfaces: interfaces.current, programs: programsOf(session.site), launches: session.site }));
      // Nothing to complete: the key moves on, so that nobody is caught here.
      if (done.kind === 'nothing') return;
      event.preventDefault();
      if (done.kind === 'line') {
        setLine(done.line);
      } else {
        print(`$ ${line}\n${done.choices.join('  ')}`);
        announce(panelTexts.terminal.choices(done.choices.length));
      }
    }
  };

  const tools = (
    <>
      {running === null ? null : <IconButton icon="stop" label={panelTexts.terminal.stop} onClick={stop} />}
      <IconButton icon="clear" label={texts.clear} onClick={() => screen.current?.clear()} />
    </>
  );
  return (
    <PanelFrame id="terminal" title={texts.panels.terminal} icon="console" tools={tools}>
      <div class="terminal" onKeyDown={onKey}>
        <LineScroller list={list} version={version} label={panelTexts.terminal.output} empty={panelTexts.terminal.empty} />
        <label class="terminal-input">
          <span aria-hidden="true">$</span>
          <input
            ref={input}
            type="text"
            value={field === undefined ? line : ''}
            readOnly={running !== null && !taking}
            aria-label={panelTexts.terminal.input}
            placeholder={running === null ? panelTexts.terminal.placeholder : keys !== undefined ? texts.console.keysHint : taking ? panelTexts.terminal.taking : panelTexts.terminal.running}
            autocomplete="off"
            autocapitalize="off"
            autocorrect="off"
            spellcheck={false}
            enterkeyhint="go"
            onInput={(event) => setLine(event.currentTarget.value)}
            aria-description={keys === undefined ? undefined : texts.console.keysHint}
            {...field}
          />
        </label>
      </div>
    </PanelFrame>
  );
}
