// The shell of one terminal: its folder, its variables, and what runs a line. Commands print through the port.

import { complete } from '../../ros2cli/complete.ts';
import type { Known } from '../../ros2cli/complete.ts';
import type { NewFiles } from '../../ros2cli/command.ts';
import { programsOf } from '../../ros2cli/programs.ts';
import { runCommand } from '../../ros2cli/run.ts';
import type { KeyMode, Session } from '../../contract/session.ts';
import { desktopPanel, needless } from '../model/desktop_programs.ts';
import type { Json } from '../model/json.ts';
import { problemOf } from '../model/problem.ts';
import { shellSteps } from '../model/shell_line.ts';
import type { ShellStep } from '../model/shell_line.ts';
import type { Offered } from '../model/terminal_input.ts';
import { bagsOf } from '../parts/terminal_files.ts';
import { texts } from '../texts.ts';
import { shellTexts } from '../texts_shell.ts';
import { changedFolder, completeName, fileWords } from './file_words.ts';
import { FileTree } from './file_tree.ts';
import { MOST_TEXT_BYTES, mayWrite } from './own_files.ts';
import { HOME, parentOf, resolvePath, shortPath } from './paths.ts';
import { openPipe } from './pipe.ts';
import { ownFiles, readText, sessionTree } from './session_files.ts';
import { textTool, textToolNames } from './text_tools.ts';
import type { TextTool } from './text_tools.ts';
import { readTfEcho, runTfEcho } from './tf_echo.ts';
import { assignment, isName, Variables } from './variables.ts';

/** Exit codes of a shell. */
const WRONG_LINE = 2;
const NOT_FOUND = 127;
const INTERRUPTED = 130;

const OWN_WORDS = ['cd', 'clear', 'echo', 'export', 'help', 'history', 'printenv', 'pwd', 'ros2', 'unset'];

export interface ShellPort {
  readonly session: Session;
  readonly print: (text: string) => void;
  readonly warn: (text: string) => void;
  readonly clear: () => void;
  readonly takeInput: (to: ((text: string) => void) | undefined, mode?: KeyMode) => void;
  /** As PanelProps.open. */
  readonly open: (panel: string, state?: Json) => boolean;
  /** The lines that were typed in this terminal, oldest first. */
  readonly history: () => readonly string[];
  readonly forgetHistory: () => void;
}

interface ProgramPorts {
  readonly out: (text: string) => void;
  readonly signal: AbortSignal;
  /** The output stands in the terminal, and goes nowhere else. */
  readonly isSeen: boolean;
}

export class Shell {
  private readonly port: ShellPort;
  private folder = HOME;
  private before = HOME;
  private code = 0;
  private readonly variables: Variables;
  private noted = false;
  /** As it was when it was last looked at: for completion, which may not wait. */
  private tree = new FileTree([], []);

  constructor(port: ShellPort) {
    this.port = port;
    this.variables = new Variables(port.session);
  }

  get prompt(): string {
    return `${shortPath(this.folder)}$`;
  }

  /** Reads what files there are, for completion. */
  async look(): Promise<FileTree> {
    this.tree = await sessionTree(this.port.session);
    return this.tree;
  }

  async run(line: string, abort: AbortController): Promise<void> {
    const count = shellSteps(line)?.length;
    if (count === undefined) this.port.warn(shellTexts.openQuote);
    for (let i = 0; i < (count ?? 0) && !abort.signal.aborted; i += 1) {
      // Read again for each one: the one before may have set variables.
      const step = shellSteps(line, this.valueOf)?.[i];
      if (step === undefined) return;
      if (step.when !== 'always' && (step.when === 'succeeded') !== (this.code === 0)) continue;
      try {
        this.code = await this.step(step, abort);
      } catch (error) {
        this.port.warn(problemOf(error).what);
        this.code = 1;
      }
    }
  }

  private readonly valueOf = (name: string): string => (name === '?' ? String(this.code) : this.variables.value(name));

  private async step(step: ShellStep, abort: AbortController): Promise<number> {
    const { words, filters, target, background } = step;
    const wrong = background === true
      ? shellTexts.background
      : words.length === 0
      ? shellTexts.nothing
      : filters.some((filter) => filter.length === 0)
      ? shellTexts.nothingPiped
      : '';
    if (wrong !== '') {
      this.port.warn(wrong);
      return WRONG_LINE;
    }
    // Ends what runs, when Ctrl-C comes or nobody reads any more.
    const own = new AbortController();
    const end = (): void => own.abort();
    abort.signal.addEventListener('abort', end, { once: true });
    try {
      const file = target === undefined ? undefined : await this.target(target, step.append === true);
      if (file === null) return 1;
      const pipe = openPipe(filters, file?.take ?? this.port.print, end);
      if (typeof pipe === 'string') {
        this.port.warn(pipe);
        return WRONG_LINE;
      }
      const goesOn = filters.length > 0 || target !== undefined;
      const code = await this.program(words, { out: pipe.out, signal: own.signal, isSeen: !goesOn });
      const last = filters.length === 0 || abort.signal.aborted ? code : pipe.end();
      // Also what came before Ctrl-C.
      file?.write();
      return abort.signal.aborted ? INTERRUPTED : last;
    } finally {
      abort.signal.removeEventListener('abort', end);
    }
  }

  /** Where the output is kept until it is written; null: nowhere, as was said. */
  private async target(name: string, append: boolean): Promise<{ readonly take: (text: string) => void; readonly write: () => void; } | null> {
    const path = resolvePath(this.folder, name);
    if (path === '/dev/null') return { take: () => undefined, write: () => undefined };
    const { session, warn } = this.port;
    const own = ownFiles(session);
    const tree = await this.look();
    const trouble = tree.isFolder(path)
      ? shellTexts.isFolder('bash', name)
      : tree.file(path)?.source !== undefined
      ? shellTexts.isSource(name)
      : !mayWrite(path)
      ? shellTexts.notAllowed('bash', name)
      : !tree.isFolder(parentOf(path))
      ? shellTexts.noSuch('bash', name)
      : '';
    if (trouble !== '') {
      warn(trouble);
      return null;
    }
    let text = append ? (own.text(path) ?? '') : '';
    let full = false;
    return {
      take: (line) => {
        full ||= text.length + line.length >= MOST_TEXT_BYTES;
        if (!full) text += `${line}\n`;
      },
      write: () => {
        if (!own.write(path, text)) warn(shellTexts.full('bash'));
        else if (full) warn(shellTexts.tooLong(MOST_TEXT_BYTES));
      },
    };
  }

  private async program(words: readonly string[], { out, signal, isSeen }: ProgramPorts): Promise<number> {
    const { session, open, warn } = this.port;
    const plain = this.variables.take(words);
    const [program = '', ...rest] = plain;
    if (program === '') return 0;
    const own = this.ownWord(program, rest, out);
    if (own !== undefined) return own;
    if (program === 'cd') return await this.changeFolder(rest, out);
    const tool = textTool(plain, { out, stop: () => undefined });
    if (typeof tool === 'string') {
      warn(tool);
      return WRONG_LINE;
    }
    if (tool !== undefined) return await this.readFiles(program, tool);
    const word = fileWords.get(program);
    if (word !== undefined) {
      const edit = (file: string, line: number): boolean => open('source', line === 0 ? { file } : { file, line });
      return await word(rest, { tree: await this.look(), own: ownFiles(session), folder: this.folder, isSeen, out, warn, edit });
    }
    return await this.ros(plain, out, signal);
  }

  /** `ros2`, and what stands for programs that a site does not run. */
  private async ros(words: readonly string[], out: (text: string) => void, signal: AbortSignal): Promise<number> {
    const { session, open, warn, takeInput } = this.port;
    const [program = '', ...rest] = words;
    const window = desktopPanel(words, session.site.packages);
    if (window !== undefined) {
      const paths = window.rest.filter((word) => word.startsWith('/'));
      const opened = window.panel === 'plot' && paths.length > 0 ? open('plot', { paths }) : open(window.panel);
      if (opened) out(shellTexts.opened(window.program, texts.panels[window.panel as keyof typeof texts.panels]));
      return opened ? 0 : 1;
    }
    const why = needless(program);
    if (why !== undefined) {
      out(shellTexts.needless[why]);
      return 0;
    }
    if (program !== 'ros2') {
      warn(notFound(program));
      return NOT_FOUND;
    }
    const carried = programsOf(session.site).some((one) => one.package === 'tf2_ros' && one.executable === 'tf2_echo');
    const frames = readTfEcho(words, carried);
    if (typeof frames === 'string') {
      warn(frames);
      return 1;
    }
    if (frames !== undefined) return await runTfEcho(session, frames, out, signal);
    if (words[1] === 'pkg' && words[2] === 'create') await this.look();
    const code = await runCommand(session, rest, {
      signal,
      bags: bagsOf(session),
      newFiles: this.newFiles(),
      readText: (name) => readText(session, this.folder, name),
      takeInput,
      print: out,
      warn,
    });
    takeInput(undefined);
    return code;
  }

  private newFiles(): NewFiles {
    const whole = (name: string): string => resolvePath(this.folder, name);
    return {
      whole,
      exists: (name) => this.tree.isFolder(whole(name)) || this.tree.file(whole(name)) !== undefined,
      write: (name, text) => mayWrite(whole(name)) && ownFiles(this.port.session).write(whole(name), text),
    };
  }

  /** Runs a word that needs nothing but the shell itself; undefined: it is another one. */
  private ownWord(program: string, rest: readonly string[], out: (text: string) => void): number | undefined {
    switch (program) {
      case 'clear':
        this.port.clear();
        return 0;
      case 'help':
        out(shellTexts.help);
        return 0;
      case 'pwd':
        out(this.folder);
        return 0;
      case 'true':
      case 'false':
        return program === 'true' ? 0 : 1;
      case 'echo':
        out(echoed(rest));
        return 0;
      case 'export':
        return this.export(rest, out);
      case 'unset':
        rest.forEach((name) => this.variables.unset(name));
        return 0;
      case 'printenv':
      case 'env':
        return this.variables.print(rest, out);
      case 'history':
        return this.showHistory(rest, out);
      default:
        return undefined;
    }
  }

  private export(rest: readonly string[], out: (text: string) => void): number {
    if (rest.length === 0) return this.variables.print([], out);
    for (const word of rest) {
      const [name = ''] = word.split('=');
      if (!isName(name)) {
        this.port.warn(shellTexts.badVariable(word));
        return 1;
      }
      this.variables.take(assignment(word) ? [word] : []);
      // Once: a lab sheet sets several.
      if (!this.noted) out(shellTexts.variableNote(name));
      this.noted = true;
    }
    return 0;
  }

  private showHistory([word]: readonly string[], out: (text: string) => void): number {
    if (word === '-c') {
      this.port.forgetHistory();
      return 0;
    }
    const lines = this.port.history();
    const most = Number(word ?? lines.length);
    lines.forEach((line, index) => {
      if (index >= lines.length - most) out(`${String(index + 1).padStart(5)}  ${line}`);
    });
    return 0;
  }

  private async changeFolder(rest: readonly string[], out: (text: string) => void): Promise<number> {
    const found = changedFolder(rest, await this.look(), this.folder, this.before);
    if (typeof found === 'string') {
      this.port.warn(found);
      return 1;
    }
    this.before = this.folder;
    this.folder = found.folder;
    this.variables.moved(this.folder, this.before);
    if (rest[0] === '-') out(shortPath(this.folder));
    return 0;
  }

  private async readFiles(program: string, tool: TextTool): Promise<number> {
    const { warn } = this.port;
    const tree = await this.look();
    const wanted = tool.files.length === 0 && tool.recursive ? ['.'] : tool.files;
    if (wanted.length === 0) {
      warn(shellTexts.stdin(program));
      return 1;
    }
    const names = wanted.flatMap((name) => {
      const path = resolvePath(this.folder, name);
      if (!tool.recursive || !tree.isFolder(path)) return [name];
      return tree.below(path).map((file) => `${name === '/' ? '' : name.replace(/\/$/, '')}${file.path.slice(path === '/' ? 0 : path.length)}`);
    });
    let failed = 0;
    for (const name of names) {
      const path = resolvePath(this.folder, name);
      const text = await tree.file(path)?.text().catch((error: unknown) => new Error(problemOf(error).what));
      const trouble = tree.isFolder(path)
        ? shellTexts.isFolder(program, name)
        : text === undefined
        ? shellTexts.noSuch(program, name)
        : text instanceof Error
        ? shellTexts.unreadable(program, name, text.message)
        : text.includes('\0')
        ? shellTexts.unreadable(program, name, shellTexts.noText)
        : '';
      if (trouble !== '' || typeof text !== 'string') {
        // A search passes over what has no lines.
        if (!tool.recursive) warn(trouble);
        failed = tool.recursive ? failed : 1;
        continue;
      }
      const sink = tool.begin(name, names.length > 1);
      const lines = text.split(/\r?\n/);
      if (lines.at(-1) === '') lines.pop();
      for (const line of lines) sink.line(line);
      sink.end();
    }
    return tool.end(names.length > 1) || failed;
  }

  /** Finds completions for the Tab key. `told`: what was asked for it, as in ros2cli/complete.ts. */
  offer(line: string, known: Known): Offered {
    const begin = /^(?:.*(?:&&|\|\||;|\|))?\s*/.exec(line)?.[0].length ?? 0;
    const part = line.slice(begin);
    if (/^ros2(?:\s|$)/.test(part) || part === '') {
      const offered = complete(part, known);
      return { ...offered, start: offered.start + begin };
    }
    const start = /\S*$/.exec(part)?.index ?? 0;
    const word = part.slice(start);
    const programs = [...OWN_WORDS, ...textToolNames, ...fileWords.keys()].filter((name) => name.startsWith(word)).sort();
    return { word, start: start + begin, choices: start === 0 ? programs : completeName(this.tree, this.folder, word) };
  }
}

function notFound(program: string): string {
  if (program === 'python' || program === 'python3') return shellTexts.hints.python(program);
  if (program === 'git') return shellTexts.hints.git;
  return program.includes('/') ? shellTexts.hints.file(program) : shellTexts.notFound(program);
}

/** The words of echo: -e reads \n and \t, -n means nothing here. */
function echoed(rest: readonly string[]): string {
  const from = rest.findIndex((word) => !/^-[neE]+$/.test(word));
  const flags = rest.slice(0, from < 0 ? rest.length : from).join('');
  const text = (from < 0 ? [] : rest.slice(from)).join(' ');
  return flags.includes('e') ? text.replace(/\\([nt\\])/g, (_, letter: string) => ({ n: '\n', t: '\t' })[letter] ?? letter) : text;
}
