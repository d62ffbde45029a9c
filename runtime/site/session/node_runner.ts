// One node of a site: its worker and thread workers.

import { TerminalMode } from '../../protocol/generated/constants.ts';
import type { Admission } from '../bus/broker.ts';
import type { NodeConsole } from '../program/console_log.ts';
import type { SentMessage } from '../program/message_trace.ts';
import type { WorkerReport, WorkerStart } from '../workers/worker_messages.ts';
import { functionsIn, withNames } from '../program/function_names.ts';
import type { Platform, WorkerEvents, WorkerHandle } from '../workers/platform.ts';
import type { ProgramEnd } from '../program/program.ts';
import { folderOf, homeOf } from '../python/python_files.ts';
import type { PythonImages } from '../workers/python_images.ts';
import type { PythonWorkers } from '../workers/python_workers.ts';
import type { PythonStart } from '../python/python_program.ts';
import { type ProcessHost, ProcessRunner } from '../program/process_runner.ts';
import type { NodeState, NodeView, ProgramNode, SiteNode } from '../contract/session.ts';
import { SiteError } from '../contract/site_error.ts';
import type { SourceFiles } from '../python/source_files.ts';
import type { SiteFiles } from '../program/site_files.ts';
import { type ThreadMemory, tellThreads } from '../program/thread_waits.ts';
import { strangeReport } from '../workers/worker_reports.ts';

/** A crash is told without function names when they do not come in time. */
const namesMs = 3000;
/** A program that reads lines for a moment between two keys still reads keys. */
const betweenKeysMs = 200;
/** Reports that only a program's own code brings about. */
const signsOfCode: ReadonlySet<WorkerReport['t']> = new Set(['waits', 'lines', 'source', 'event', 'file', 'thread', 'end']);
/** A thread that was about to wait when time changed is told again. */
const retellMs = 1;
/** The page waits this long for the last output of the threads of a program that has ended. */
const lastWordsMs = 2000;

export interface RunnerHost extends ProcessHost {
  readonly environment: Readonly<Record<string, string>>;
  readonly files: SiteFiles;
  readonly platform: Platform;
  /** undefined: Python programs boot by themselves. */
  readonly images: PythonImages | undefined;
  readonly pythonWorkers: PythonWorkers;
  /** undefined: Python programs run as they were packed. */
  readonly sources: SourceFiles | undefined;
  /** A program is out of the graph; what it published is not yet freed. */
  readonly left: () => void;
  readonly stepped: { readonly seed: number; } | undefined;
  /** Tells of every message; undefined: nobody asks. */
  readonly sent: ((node: SiteNode, message: SentMessage) => void) | undefined;
  readonly resetInput: (id: string) => void;
  /** It has written a file and closed it. */
  readonly wrote: (node: SiteNode, path: string, bytes: Uint8Array<ArrayBuffer>) => void;
  /** A batch of lines was received from a worker of the participant. */
  readonly lines: (node: SiteNode, report: Extract<WorkerReport, { t: 'lines'; }>) => void;
  /** Called with an event of a notebook's kernel. */
  readonly event?: (event: string) => void;
}

interface Run {
  readonly participant: number;
  readonly main: WorkerHandle;
  readonly threads: Set<WorkerHandle>;
  readonly start: WorkerStart;
  readonly startedAt: number;
  /** When each of its files was written that has come. */
  readonly written: Map<string, number>;
  /** The memory of a program with threads, once it is loaded. */
  memory: ThreadMemory | undefined;
  /** One of its workers has reported how it ended: later reports of others about that are ignored. */
  ended: boolean;
  over: boolean;
}

export class NodeRunner extends ProcessRunner<ProgramNode> {
  private readonly host: RunnerHost;
  private run: Run | undefined;
  /** Code of the program has run. */
  private begun = false;
  private terminal: TerminalMode = TerminalMode.cooked;
  private terminalTimer: ReturnType<typeof setTimeout> | undefined;
  /** For the newest run: the sources that it has read, and whether they were changed. */
  private readonly used = new Map<string, boolean>();

  constructor(node: ProgramNode, console: NodeConsole, host: RunnerHost) {
    super(node, console, host);
    this.host = host;
  }

  override view(): NodeView {
    const changed = [...this.used].filter(([, isChanged]) => isChanged).map(([path]) => path);
    return {
      ...super.view(),
      ...(this.run === undefined ? {} : { startedAt: this.run.startedAt }),
      ...(this.node.python === undefined || this.begun || this.run === undefined ? {} : { loading: true as const }),
      ...(this.terminal === TerminalMode.cooked ? {} : { terminal: this.terminal === TerminalMode.raw ? 'raw' : 'cbreak' }),
      ...(this.used.size === 0 ? {} : { usedSources: [...this.used.keys()] }),
      ...(changed.length === 0 ? {} : { changedSources: changed }),
    };
  }

  override participant(): number | undefined {
    return this.run?.participant;
  }

  protected override begin(afterMs: number): void {
    this.begun = false;
    if (!this.active()) this.host.resetInput(this.node.id);
    super.begin(afterMs);
  }

  protected override signal(): boolean {
    if (this.run === undefined) return false;
    this.host.broker.stop(this.run.participant);
    return true;
  }

  /** A stop that the program may live through: the kernel of a notebook does. */
  interrupt(): void {
    this.signal();
  }

  override strange(): void {
    if (this.active()) this.finish({ kind: 'crashed', ...strangeReport });
  }

  /** The threads that wait in the program's own memory are told here: the bus does not reach them. */
  override timeChanged(): void {
    const { run } = this;
    if (run?.memory === undefined || run.over) return;
    if (tellThreads(run.memory, this.host.broker.link.clock.lawVersion())) return;
    setTimeout(() => this.timeChanged(), retellMs);
  }

  private admit(): Admission {
    const admission = this.host.broker.admit();
    if (admission === undefined) throw new SiteError('R2W0707', 'the site has more nodes than the bus has places');
    return admission;
  }

  protected override async launch(attempt: number): Promise<void> {
    try {
      // A stepped run counts on it from now on. Ports are made when they can be handed on at once: under Node.js they
      // cannot any more when the node at the other end is over.
      let admission = this.host.broker.kind === 'port' ? undefined : this.admit();
      const main = this.worker(() => admission?.participant, attempt);
      const startedAt = Date.now();
      const environment = { ...this.host.environment, ...this.node.environment };
      let module: WebAssembly.Module;
      let python: PythonStart | undefined;
      try {
        [module, python] = await Promise.all([this.host.platform.compile(this.node.program), this.python(environment)]);
        if (this.attempt === attempt) admission ??= this.admit();
      } catch (error) {
        this.bury(admission?.participant, [main], false);
        throw error;
      }
      if (this.attempt !== attempt || admission === undefined) {
        this.bury(admission?.participant, [main], false);
        return;
      }
      const { participant, ticket, transfer } = admission;
      const start: WorkerStart = {
        module,
        python,
        ticket,
        id: this.node.id,
        arguments: [this.node.executable, ...this.node.arguments],
        environment,
        files: this.host.files,
        stepped: this.host.stepped,
        traced: this.host.sent !== undefined,
      };
      this.used.clear();
      this.run = { participant, main, threads: new Set(), start, startedAt, written: new Map(), memory: undefined, ended: false, over: false };
      main.post({ t: 'start', start }, transfer);
    } catch (error) {
      if (this.attempt !== attempt) return;
      const code = error instanceof SiteError ? error.code : 'R2W0708';
      this.fail(code, error instanceof Error ? error.message : String(error));
    }
  }

  private async python(environment: Readonly<Record<string, string>>): Promise<PythonStart | undefined> {
    const { python, program } = this.node;
    if (python === undefined) return undefined;
    const { images, pythonWorkers, platform } = this.host;
    const image = await images?.take(this.node, environment);
    const parts = await pythonWorkers.files.parts(program, python.archives.slice(image?.archives ?? 0));
    const sources = this.host.sources?.forStart();
    return { ...python, base: folderOf(platform.place), home: homeOf(program), parts, image, sources };
  }

  /** It reports nothing before it is admitted. */
  private worker(participant: () => number | undefined, attempt: number): WorkerHandle {
    const { platform, pythonWorkers } = this.host;
    const { id, program, python } = this.node;
    const events: WorkerEvents = {
      report: (report) => {
        const own = participant();
        if (this.attempt !== attempt || own === undefined) return;
        if (this.mayBe(report)) this.onReport(report, handle, own);
        else events.failed(strangeReport.message, strangeReport.code);
      },
      failed: (message, code = 'R2W0708') => {
        if (this.attempt === attempt) this.finish({ kind: 'crashed', code, message });
      },
    };
    const handle = python === undefined ? platform.startWorker(id, events) : pythonWorkers.start(program, id, events);
    return handle;
  }

  /** Whether a program of this kind, started as it was, reports that. */
  private mayBe({ t }: WorkerReport): boolean {
    switch (t) {
      case 'image':
      case 'launch':
        return false;
      case 'thread':
      case 'memory':
        return this.node.python === undefined && this.host.broker.kind === 'shared';
      case 'rest':
        return this.host.stepped !== undefined;
      case 'sent':
        return this.host.sent !== undefined;
      default:
        return true;
    }
  }

  private onReport(report: WorkerReport, handle: WorkerHandle, participant: number): void {
    const { run } = this;
    if (!this.begun && signsOfCode.has(report.t)) {
      this.begun = true;
      this.host.changed();
    }
    switch (report.t) {
      case 'running':
        this.runs();
        return;
      case 'memory':
        if (run !== undefined) run.memory = report.memory;
        this.timeChanged();
        return;
      case 'rest':
        this.host.broker.rests(participant, report.rest);
        return;
      case 'terminal':
        this.terminalSet(report.mode);
        return;
      case 'sent':
        this.host.sent?.(this.node, report.message);
        return;
      case 'image':
      case 'launch':
        return;
      case 'broken_image':
        this.host.images?.broken(run?.start.python?.image);
        return;
      case 'source':
        if (run?.start.python?.sources?.watched.includes(report.path) !== true) return;
        this.used.set(report.path, run?.start.python?.sources?.changed.has(report.path) === true);
        this.host.changed();
        return;
      case 'waits':
        this.host.settled(this.node);
        if (this.node.python !== undefined) this.host.pythonWorkers.settled(this.node.program);
        return;
      case 'lines':
        this.host.lines(this.node, report);
        this.host.broker.consoleSeen(participant);
        return;
      case 'event':
        // First: whatever becomes of it, there is room for the next one.
        this.host.broker.consoleSeen(participant);
        this.host.event?.(report.event);
        return;
      case 'file':
        this.host.broker.consoleSeen(participant);
        // When several threads have closed a file, the newest content counts, in whatever order the reports arrive.
        if (report.at < (run?.written.get(report.path) ?? 0)) return;
        run?.written.set(report.path, report.at);
        this.host.wrote(this.node, report.path, report.bytes);
        return;
      case 'thread': {
        if (run === undefined) return;
        const thread = this.worker(() => participant, this.attempt);
        run.threads.add(thread);
        const start = { ...run.start, thread: { ...report.request, memory: report.memory } };
        thread.post({ t: 'start', start }, []);
        return;
      }
      case 'end':
        if (report.end.kind === 'thread') {
          run?.threads.delete(handle);
          void handle.terminate();
        } else if (run?.ended !== true) {
          if (run !== undefined) run.ended = true;
          void this.onEnd(report.end, report.closed);
        }
        return;
    }
  }

  private terminalSet(mode: TerminalMode): void {
    clearTimeout(this.terminalTimer);
    const change = (): void => {
      if (mode === this.terminal) return;
      this.terminal = mode;
      this.host.changed();
    };
    if (mode === TerminalMode.cooked) this.terminalTimer = setTimeout(change, betweenKeysMs);
    else change();
  }

  /** The program is over and its worker rests; a trap's report gets its names before it is told. */
  private async onEnd(end: Exclude<ProgramEnd, { kind: 'thread'; }>, closed: boolean): Promise<void> {
    const { attempt } = this;
    if (this.run !== undefined && this.run.threads.size > 0) await this.lastWords(this.run);
    if (this.attempt !== attempt) return;
    const state = stateOf(end);
    const { names } = this.node;
    if (state.kind !== 'crashed' || names === undefined || functionsIn(state.message).size === 0) {
      this.finish(state, closed);
      return;
    }
    let timer: ReturnType<typeof setTimeout> | undefined;
    const named = await Promise.race([
      this.host.platform.bytes(names).then((bytes) => withNames(state.message, bytes), () => state.message),
      new Promise<string>((resolve) => {
        timer = setTimeout(() => resolve(state.message), namesMs);
      }),
    ]);
    clearTimeout(timer);
    if (this.attempt === attempt) this.finish({ ...state, message: named }, closed);
  }

  /** Each thread has a way to the page of its own: what it wrote may come after the program's end. */
  private async lastWords({ threads, participant }: Run): Promise<void> {
    const until = performance.now() + lastWordsMs;
    while (threads.size > 0 && this.host.broker.consoleAhead(participant) > 0 && performance.now() < until) {
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
  }

  protected override leave(closed: boolean): () => void {
    const { run } = this;
    this.run = undefined;
    clearTimeout(this.terminalTimer);
    this.terminal = TerminalMode.cooked;
    return () => {
      if (run === undefined || run.over) return;
      run.over = true;
      this.bury(run.participant, [run.main, ...run.threads], closed);
    };
  }

  /** The graph loses the program at once; its place and its memory are free when none of its workers runs any more. */
  private bury(participant: number | undefined, workers: readonly WorkerHandle[], closed: boolean): void {
    const gone = workers.map((worker) => worker.terminate());
    if (participant === undefined) return;
    this.host.broker.end(participant, closed);
    this.host.left();
    void Promise.all(gone).then(() => this.host.broker.gone(participant));
  }
}

function stateOf(end: Exclude<ProgramEnd, { kind: 'thread'; }>): NodeState {
  switch (end.kind) {
    case 'exit':
      return { kind: 'exited', code: end.code };
    case 'crash':
      return { kind: 'crashed', code: end.code, message: end.message };
  }
}
