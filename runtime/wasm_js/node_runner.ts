// One node of a site: its worker and thread workers, its state, its rules (stop, respawn).

import { TerminalMode } from '../protocol/generated/constants.ts';
import type { Admission, Broker } from './broker.ts';
import type { NodeConsole } from './console_log.ts';
import type { SentMessage } from './message_trace.ts';
import type { WorkerReport, WorkerStart } from './node_worker.ts';
import { functionsIn, withNames } from './function_names.ts';
import type { Platform, WorkerHandle } from './platform.ts';
import type { ProgramEnd } from './program.ts';
import { homeOf, type PythonFiles } from './python_files.ts';
import { folderOf, type PythonImages } from './python_images.ts';
import type { PythonStart } from './python_program.ts';
import type { NodeMoment, NodeState, NodeView, SiteNode } from './session.ts';
import { SiteError } from './site_error.ts';
import type { SourceFiles } from './source_files.ts';
import type { SiteFiles } from './site_files.ts';
import { type ThreadMemory, tellThreads } from './thread_waits.ts';

/** After a stop is requested; `ros2 launch` waits as long before it sends SIGTERM. */
export const stopGraceMs = 5000;
/** Exit code of a node that did not stop in time, as a shell tells of SIGKILL. */
const killedCode = 137;
/** A crash is told without function names when they do not come in time. */
const namesMs = 3000;
/** A node that crashes at once is not started again without pause. */
const leastRespawnMs = 100;
/** A program that reads lines for a moment between two keys still reads keys. */
const betweenKeysMs = 200;
/** A thread that was about to wait when time changed is told again. */
const retellMs = 1;

export interface RunnerHost {
  readonly environment: Readonly<Record<string, string>>;
  readonly files: SiteFiles;
  readonly platform: Platform;
  readonly broker: Broker;
  /** undefined: Python programs boot by themselves. */
  readonly images: PythonImages | undefined;
  readonly pythonFiles: PythonFiles;
  /** undefined: Python programs run as they were packed. */
  readonly sources: SourceFiles | undefined;
  readonly changed: () => void;
  /** The node's program waits for the first time, or is over. */
  readonly settled: (node: SiteNode) => void;
  /** A program is out of the graph; what it published is not yet freed. */
  readonly left: () => void;
  readonly stepped: { readonly seed: number } | undefined;
  /** Tells of every message; undefined: nobody asks. */
  readonly sent: ((node: SiteNode, message: SentMessage) => void) | undefined;
  readonly resetInput: (id: string) => void;
  /** It has written a file and closed it. */
  readonly wrote: (node: SiteNode, path: string, bytes: Uint8Array<ArrayBuffer>) => void;
  /** A node ended with which all shall end. */
  readonly shutdown: () => void;
  /** The node has started, has ended by itself, or otherwise (`stop`): it was stopped, or could not start. */
  readonly happened: (node: SiteNode, event: 'start' | 'exit' | 'stop') => void;
  /** A batch of lines was taken over from a worker of the participant. */
  readonly lines: (node: SiteNode, report: Extract<WorkerReport, { t: 'lines' }>) => void;
  /** Of the kernel of a notebook. */
  readonly event?: (event: string) => void;
}

interface Run {
  readonly participant: number;
  readonly main: WorkerHandle;
  readonly threads: Set<WorkerHandle>;
  readonly start: WorkerStart;
  readonly startedAt: number;
  /** Of a program with threads, once it is loaded. */
  memory: ThreadMemory | undefined;
  over: boolean;
}

export class NodeRunner {
  readonly node: SiteNode;
  readonly console: NodeConsole;
  private readonly host: RunnerHost;
  private state: NodeState = { kind: 'stopped' };
  private run: Run | undefined;
  /** Counts starts, so that what belongs to an older one is dropped. */
  private attempt = 0;
  private stopping = false;
  private again = false;
  /** Of the grace after a stop. */
  private timer: ReturnType<typeof setTimeout> | undefined;
  /** Calls off a start that is yet to come. */
  private keepFromStart: (() => void) | undefined;
  private terminal: TerminalMode = TerminalMode.cooked;
  private terminalTimer: ReturnType<typeof setTimeout> | undefined;
  /** Respawns since somebody started it. */
  private retries = 0;
  /** Of the newest run: the sources that it has read, and whether they were changed. */
  private readonly used = new Map<string, boolean>();

  constructor(node: SiteNode, console: NodeConsole, host: RunnerHost) {
    this.node = node;
    this.console = console;
    this.host = host;
  }

  view(): NodeView {
    const { id, label, executable, source } = this.node;
    const changed = [...this.used].filter(([, isChanged]) => isChanged).map(([path]) => path);
    return {
      id,
      label,
      package: this.node.package,
      executable,
      state: this.state,
      ...(this.run === undefined ? {} : { startedAt: this.run.startedAt }),
      ...(source === undefined ? {} : { source }),
      ...(this.terminal === TerminalMode.cooked ? {} : { terminal: this.terminal === TerminalMode.raw ? 'raw' : 'cbreak' }),
      ...(this.used.size === 0 ? {} : { usedSources: [...this.used.keys()] }),
      ...(changed.length === 0 ? {} : { changedSources: changed }),
    };
  }

  /** Its place in the graph while it runs. */
  participant(): number | undefined {
    return this.run?.participant;
  }

  active(): boolean {
    return this.state.kind === 'starting' || this.state.kind === 'running';
  }

  /** Until start(), of another node's start or end. */
  wait(on: NodeMoment): void {
    if (this.active()) return;
    this.clearTimer();
    this.set({ kind: 'waiting', on });
  }

  /** Ended, and about to start by itself. */
  respawns(): boolean {
    return this.keepFromStart !== undefined && !this.active();
  }

  /** `afterMs`: it is starting until then. */
  start(afterMs = 0): void {
    if (this.active()) return;
    this.retries = 0;
    this.begin(afterMs);
  }

  private begin(afterMs: number): void {
    if (this.active()) return;
    this.clearTimer();
    this.stopping = false;
    this.again = false;
    this.attempt += 1;
    this.host.resetInput(this.node.id);
    this.set({ kind: 'starting' });
    const { attempt } = this;
    if (afterMs === 0) void this.launch(attempt);
    else this.keepFromStart = this.host.broker.after(afterMs, () => void this.launch(attempt));
  }

  /** As Ctrl-C; a second time, or after the grace, the worker is killed. */
  stop(): void {
    const respawned = this.respawns();
    this.clearTimer();
    if (respawned) this.host.changed();
    if (this.state.kind === 'waiting') {
      this.host.happened(this.node, 'stop');
      this.set({ kind: 'stopped' });
    }
    if (!this.active()) return;
    const { run } = this;
    if (run === undefined || this.stopping) {
      // It does not end by itself: no rule is followed.
      this.stopping = true;
      this.kill();
      return;
    }
    this.stopping = true;
    this.host.broker.stop(run.participant);
    this.timer = setTimeout(() => this.kill(), stopGraceMs);
  }

  /** A stop that the program may live through: the kernel of a notebook does. */
  interrupt(): void {
    if (this.run !== undefined) this.host.broker.stop(this.run.participant);
  }

  restart(): void {
    if (!this.active()) {
      this.start();
      return;
    }
    this.again = true;
    if (!this.stopping) this.stop();
  }

  /** Ends the node wherever it is. */
  kill(): void {
    if (!this.active()) return;
    this.attempt += 1;
    this.finish({ kind: 'exited', code: killedCode }, false);
  }

  close(): void {
    this.again = false;
    this.stopping = true;
    this.kill();
    this.clearTimer();
  }

  /** The threads that wait in the program's own memory are told here: the bus does not reach them. */
  timeChanged(): void {
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

  private async launch(attempt: number): Promise<void> {
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
      this.run = { participant, main, threads: new Set(), start, startedAt, memory: undefined, over: false };
      main.post({ t: 'start', start }, transfer);
    } catch (error) {
      if (this.attempt !== attempt) return;
      const code = error instanceof SiteError ? error.code : 'R2W0708';
      this.host.happened(this.node, 'stop');
      this.set({ kind: 'crashed', code, message: error instanceof Error ? error.message : String(error) });
    }
  }

  private async python(environment: Readonly<Record<string, string>>): Promise<PythonStart | undefined> {
    const { python, program } = this.node;
    if (python === undefined) return undefined;
    const { images, pythonFiles, platform } = this.host;
    const image = await images?.take(this.node, environment);
    const parts = await pythonFiles.parts(program, python.archives.slice(image?.archives ?? 0));
    const sources = this.host.sources?.forStart();
    return { ...python, base: folderOf(platform.place), home: homeOf(program), parts, image, sources };
  }

  /** It reports nothing before it is admitted. */
  private worker(participant: () => number | undefined, attempt: number): WorkerHandle {
    const handle = this.host.platform.startWorker(this.node.id, {
      report: (report) => {
        const own = participant();
        if (this.attempt === attempt && own !== undefined) this.onReport(report, handle, own);
      },
      failed: (message) => {
        if (this.attempt === attempt) this.finish({ kind: 'crashed', code: 'R2W0708', message }, false);
      },
    });
    return handle;
  }

  private onReport(report: WorkerReport, handle: WorkerHandle, participant: number): void {
    const { run } = this;
    switch (report.t) {
      case 'running':
        this.set({ kind: 'running' });
        this.host.happened(this.node, 'start');
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
        return;
      case 'broken_image':
        this.host.images?.broken(run?.start.python?.image);
        return;
      case 'source':
        this.used.set(report.path, run?.start.python?.sources?.changed.has(report.path) === true);
        this.host.changed();
        return;
      case 'waits':
        this.host.settled(this.node);
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
        } else {
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
  private async onEnd(end: Exclude<ProgramEnd, { kind: 'thread' }>, closed: boolean): Promise<void> {
    const { attempt } = this;
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

  private finish(state: NodeState, closed: boolean): void {
    const { run, again } = this;
    const byItself = !this.stopping && !again;
    const { respawnMaxRetries } = this.node;
    const respawns = this.node.respawn && byItself && (respawnMaxRetries === undefined || this.retries < respawnMaxRetries);
    this.run = undefined;
    this.clearTimer();
    clearTimeout(this.terminalTimer);
    this.terminal = TerminalMode.cooked;
    // Before the others of a stepped run go on.
    if (respawns) {
      const delay = Math.max(leastRespawnMs, this.node.respawnDelay * 1000);
      this.retries += 1;
      this.keepFromStart = this.host.broker.after(delay, () => this.begin(0));
    }
    this.host.happened(this.node, byItself ? 'exit' : 'stop');
    this.stopping = false;
    this.again = false;
    this.attempt += 1;
    // Before time goes on: in a stepped run it may, as soon as the program is out of the graph.
    this.set(state);
    if (run !== undefined && !run.over) {
      run.over = true;
      this.bury(run.participant, [run.main, ...run.threads], closed);
    }
    if (byItself && this.node.shutdownOnExit && !respawns) this.host.shutdown();
    if (again) this.start();
  }

  /** The graph loses the program at once; its place and its memory are free when none of its workers runs any more. */
  private bury(participant: number | undefined, workers: readonly WorkerHandle[], closed: boolean): void {
    const gone = workers.map((worker) => worker.terminate());
    if (participant === undefined) return;
    this.host.broker.end(participant, closed);
    this.host.left();
    void Promise.all(gone).then(() => this.host.broker.gone(participant));
  }

  private clearTimer(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.keepFromStart?.();
    this.keepFromStart = undefined;
  }

  private set(state: NodeState): void {
    this.state = state;
    this.host.changed();
    if (!this.active()) this.host.settled(this.node);
  }
}

function stateOf(end: Exclude<ProgramEnd, { kind: 'thread' }>): NodeState {
  switch (end.kind) {
    case 'exit':
      return { kind: 'exited', code: end.code };
    case 'crash':
      return { kind: 'crashed', code: end.code, message: end.message };
  }
}
