// A running site: the Session that the page and the headless runner see.

import type { Broker } from '../bus/broker.ts';
import { ComingUp } from './coming_up.ts';
import { GraphWatch } from './graph_watch.ts';
import { InterfaceTexts } from './interface_texts.ts';
import { NodeConsole } from '../program/console_log.ts';
import type { SentLine } from '../bus/console_sender.ts';
import { graphView } from '../bus/graph_view.ts';
import { interruptedReason, LaunchSteps, noReason } from '../launch/launch_steps.ts';
import { MessageTrace, type SentMessage } from '../program/message_trace.ts';
import { NodeRunner, type RunnerHost } from './node_runner.ts';
import { kernelId, kernelNode, type SiteNotebook } from '../contract/notebook.ts';
import { readEvent, SiteKernel } from './notebook_kernel.ts';
import type { GraphView, PageNode } from '../contract/page_node.ts';
import { PageParticipant } from '../page/page_participant.ts';
import type { Platform } from '../workers/platform.ts';
import type { ProcessRunner } from '../program/process_runner.ts';
import { PythonFiles } from '../python/python_files.ts';
import { PythonImages } from '../workers/python_images.ts';
import { PythonWorkers } from '../workers/python_workers.ts';
import { type CommonHost, runnerOf } from './runner_of.ts';
import { Sampler } from '../bus/sampler.ts';
import {
  type AddedNode,
  carriedPrograms,
  type CommandLoader,
  type ConsoleLog,
  type LastMessage,
  type LaunchedNodes,
  type LaunchRequest,
  type LinkKind,
  type NodeState,
  type NodeView,
  type Session,
  type SiteDescription,
  type SiteNode,
  type SiteTime,
  type SteppedRun,
  type TabView,
  type TopicView,
  type Unsubscribe,
} from '../contract/session.ts';
import { SourceFiles } from '../python/source_files.ts';
import { prefixOf, siteEnvironment, siteFiles } from '../program/site_files.ts';
import type { SiteChecks } from '../contract/site_checks.ts';
import type { SiteTasks } from '../contract/site_tasks.ts';
import { SiteTimeControl } from '../bus/site_time.ts';
import { InputWriter } from '../program/standard_input.ts';
import type { SteppedTime } from '../bus/stepped_time.ts';
import { Tabs } from './tabs.ts';
import { WrittenFiles } from '../program/written_files.ts';

const sampleMs = 250;

/** Whether a node is this tab's. */
const isHeld = (kind: NodeState['kind']): boolean => kind === 'starting' || kind === 'running' || kind === 'waiting';

export interface SessionOptions {
  readonly site: SiteDescription;
  readonly platform: Platform;
  readonly broker: Broker;
  /** A stepped run; the broker must be made for it. `time`: its time is in the page's hand. */
  readonly stepped?: { readonly seed: number; readonly time?: SteppedTime; };
  /** Must be there for a site whose launch file starts commands of `ros2`. */
  readonly commands?: CommandLoader;
  /** Called with each message that a node sends, in order. */
  readonly onSent?: (node: SiteNode, message: SentMessage) => void;
  /** Called with each line of the launch itself. */
  readonly onLaunchLine?: (time: number, text: string) => void;
  /** Called with each batch of lines as it comes. */
  readonly onLines?: (node: SiteNode, lines: readonly SentLine[], dropped: number) => void;
}

export class SiteSession implements Session {
  readonly site: SiteDescription;
  readonly link: LinkKind;
  readonly prefix: string;
  readonly time: SiteTime & { close(): void; };
  readonly stepped: SteppedRun | undefined;
  private readonly platform: Platform;
  private readonly broker: Broker;
  private readonly images: PythonImages | undefined;
  private readonly pythonWorkers: PythonWorkers;
  readonly launchLog: NodeConsole;
  private readonly onLaunchLine: SessionOptions['onLaunchLine'];
  private readonly steps: LaunchSteps;
  private readonly runners = new Map<string, ProcessRunner>();
  /** Those of them that are no part of the site, and those that have ended: who still shows one may still ask for its console. */
  private readonly added = new Set<string>();
  private readonly gone = new Set<string>();
  private readonly common: CommonHost;
  private readonly sampler: Sampler;
  private readonly input: InputWriter;
  private readonly nodeListeners = new Set<(nodes: readonly NodeView[]) => void>();
  private readonly topicListeners = new Set<(topics: readonly TopicView[]) => void>();
  /** Resolves when every node of the site has settled once. */
  readonly settled: Promise<void>;
  private readonly graphWatch: GraphWatch;
  private page: PageParticipant | undefined;
  readonly sources: SourceFiles | undefined;
  checks: (SiteChecks & { close(): void; }) | undefined;
  tasks: (SiteTasks & { close(): void; }) | undefined;
  readonly notebook: SiteKernel | undefined;
  readonly written = new WrittenFiles();
  private nodesTold = true;
  private sampling: ReturnType<typeof setInterval> | undefined;
  private readonly definitions: InterfaceTexts;
  private tabs: Tabs | undefined;
  /** restartAll() waits for the last node to end. */
  private again = false;
  private closed = false;

  constructor({ site, platform, broker, commands, onLines, onLaunchLine, stepped, onSent }: SessionOptions) {
    this.site = site;
    this.platform = platform;
    this.broker = broker;
    this.link = broker.kind;
    this.definitions = new InterfaceTexts(platform, site.interfaces);
    this.graphWatch = new GraphWatch(broker.link, (draw) => platform.frame(draw), () => this.participant(), () => this.graph());
    this.prefix = prefixOf(site);
    this.time = stepped?.time ?? new SiteTimeControl(broker, () => {
      for (const runner of this.runners.values()) runner.timeChanged();
      this.notebook?.runner.timeChanged();
      this.page?.timeChanged();
    });
    broker.onStrange((participant) => {
      const all = [...this.runners.values(), ...(this.notebook === undefined ? [] : [this.notebook.runner])];
      all.find((runner) => runner.participant() === participant)?.strange();
    });
    const trace = new MessageTrace();
    const traced = stepped?.time !== undefined;
    this.stepped = !traced ? undefined : {
      seed: stepped.seed,
      trace: () => ({ messages: trace.messages, sha256: trace.sha256() }),
    };
    this.sampler = new Sampler(broker);
    this.input = new InputWriter(broker.link);
    this.launchLog = new NodeConsole(platform.frame);
    this.onLaunchLine = onLaunchLine;
    this.steps = this.launchSteps();
    const unsettled = new Set(site.nodes);
    let allSettled: () => void = () => undefined;
    this.settled = new Promise((resolve) => {
      allSettled = resolve;
    });
    if (unsettled.size === 0) allSettled();
    const environment = siteEnvironment(site);
    const files = siteFiles(site, platform.place);
    // The bytes of an image are of no run: one that is to be the same each time boots.
    const pythonFiles = new PythonFiles(site, platform);
    this.pythonWorkers = new PythonWorkers(platform, pythonFiles);
    const { sources } = site;
    const { texts } = platform;
    if (sources !== undefined && texts !== undefined) {
      this.sources = new SourceFiles(sources, texts, () => pythonFiles.whole(sources.archive));
    }
    this.images = stepped === undefined ? new PythonImages(site, platform, this.pythonWorkers, files.prefix) : undefined;
    const comingUp = new ComingUp(() => this.nodes().some(({ loading }) => loading === true));
    const common: CommonHost = {
      environment,
      files,
      platform,
      broker,
      images: this.images,
      pythonWorkers: this.pythonWorkers,
      sources: this.sources,
      left: () => this.lookAtTopics(),
      stepped: stepped === undefined ? undefined : { seed: stepped.seed },
      sent: traced ? (of: SiteNode, message: SentMessage) => void trace.add(of.id, message) : onSent,
      resetInput: (id: string) => this.input.reset(id),
      wrote: (of: SiteNode, path: string, bytes: Uint8Array<ArrayBuffer>) => this.written.add({ node: of.id, path, content: new Blob([bytes]) }),
      comingUp,
      begins: (of) => comingUp.begins(of),
      commands: commands === undefined ? undefined : { session: this, load: commands, comingUp, file: (path) => platform.bytes(path) },
    };
    this.common = common;
    if (site.notebook !== undefined) this.notebook = this.kernel(site.notebook, common);
    for (const node of site.nodes) {
      const console = new NodeConsole(platform.frame);
      this.runners.set(node.id, runnerOf(node, console, {
        ...common,
        changed: () => this.nodesChanged(),
        settled: (of) => {
          this.images?.settled(of);
          unsettled.delete(of);
          if (unsettled.size === 0) allSettled();
        },
        shutdown: () => this.endAll(noReason),
        happened: (of, event) => this.steps.happened(of.id, event),
        lines: (of, { lines, dropped }) => {
          console.add(lines, dropped);
          onLines?.(of, lines, dropped);
          this.steps.printed(of.id, lines);
        },
      }));
    }
  }

  private kernel(notebook: SiteNotebook, common: CommonHost): SiteKernel {
    const node = kernelNode(notebook);
    const runner = new NodeRunner(node, new NodeConsole(this.platform.frame), {
      ...common,
      changed: () => kernel.changed(),
      begins: () => undefined,
      settled: (of) => this.images?.settled(of),
      shutdown: () => undefined,
      happened: () => undefined,
      // Lines that its program prints outside of Python.
      lines: (_of, { lines }) => {
        for (const [stream, , text] of lines) {
          kernel.told({ event: 'stream', cell: '', name: stream === 1 ? 'stdout' : 'stderr', text: `${text}\n` });
        }
      },
      event: (text) => kernel.told(readEvent(text)),
    });
    const kernel: SiteKernel = new SiteKernel(notebook.file, runner, (text) => {
      this.input.send(node.id, text);
      this.broker.wrote();
    });
    return kernel;
  }

  private launchSteps(): LaunchSteps {
    const { site, broker } = this;
    return new LaunchSteps({
      nodes: site.nodes,
      steps: site.launchSteps,
      after: (ms, task) => broker.after(ms, task),
      state: (id) => this.runner(id).view().state,
      start: (id, afterSeconds) => this.start(id, afterSeconds),
      stop: (id) => this.stop(id),
      stopAll: (reason) => this.endAll(reason),
      idle: () => ![...this.runners.values()].some((runner) => runner.active() || runner.respawns()),
      say: (level, logger, text) => {
        const time = this.now();
        const line = `[${level}] [${logger}]: ${text}`;
        this.launchLog.add([[1, time, line]], 0);
        this.onLaunchLine?.(time, line);
      },
      pageNode: () => this.node(),
    });
  }

  private runner(id: string): ProcessRunner {
    const runner = this.runners.get(id);
    if (runner === undefined) throw new RangeError(`the site has no node ${id}`);
    return runner;
  }

  nodes(): readonly NodeView[] {
    const { tabs } = this;
    const views = [...this.runners].filter(([id]) => !this.gone.has(id)).map(([, runner]) => runner.view());
    return tabs === undefined ? views : views.map((view) => ({ ...view, elsewhere: this.added.has(view.id) ? [] : tabs.elsewhere(view.id) }));
  }

  tab(): TabView | undefined {
    const { tabs } = this;
    return tabs === undefined ? undefined : { graph: tabs.graph, number: tabs.number, count: tabs.size + 1 };
  }

  async joinTabs(graph: string): Promise<void> {
    if (this.tabs !== undefined || this.closed) return;
    const { broker, platform } = this;
    const tabs = await Tabs.join({ graph, site: platform.place, broker, platform, changed: () => this.nodesChanged() });
    if (this.closed || this.tabs !== undefined) {
      tabs.close();
      return;
    }
    this.tabs = tabs;
    for (const { id, state } of this.nodes()) if (isHeld(state.kind) && !this.added.has(id)) await tabs.claim(id);
    this.nodesChanged();
  }

  /** Starts the nodes that no other tab runs. */
  async startUnclaimed(): Promise<void> {
    const { tabs } = this;
    if (tabs === undefined) {
      this.startAll();
      return;
    }
    this.steps.prepare();
    for (const node of this.site.nodes) if (await tabs.claim(node.id)) this.startAsLaunched(node);
    this.steps.launched();
  }

  /** They are closed with the session. */
  useChecks(checks: SiteChecks & { close(): void; }): void {
    this.checks = checks;
  }

  /** As checks are. */
  useTasks(tasks: SiteTasks & { close(): void; }): void {
    this.tasks = tasks;
  }

  /** `but`: further ones that are taken. */
  private idFor(executable: string, but: ReadonlySet<string> = new Set()): string {
    const isTaken = (id: string): boolean => but.has(id) || (this.runners.has(id) && !this.gone.has(id));
    let number = 1;
    while (isTaken(`${executable}-${number}`)) number += 1;
    return `${executable}-${number}`;
  }

  /** A node beside those of the site. It does not run yet. */
  private addedRunner(node: SiteNode, told: Pick<RunnerHost, 'happened' | 'shutdown' | 'changed' | 'lines'>): ProcessRunner {
    const console = new NodeConsole(this.platform.frame);
    const runner = runnerOf(node, console, {
      ...this.common,
      ...told,
      changed: () => {
        this.nodesChanged();
        told.changed();
      },
      settled: (of) => this.images?.settled(of),
      lines: (of, report) => {
        console.add(report.lines, report.dropped);
        told.lines(of, report);
      },
    });
    this.gone.delete(node.id);
    this.added.add(node.id);
    this.runners.set(node.id, runner);
    return runner;
  }

  run({ package: from, executable, arguments: given, onLines, onEnd }: AddedNode): string {
    const carried = carriedPrograms(this.site).find((one) => one.package === from && one.executable === executable);
    if (carried === undefined) throw new RangeError(`the site has no program ${from}/${executable}`);
    const id = this.idFor(executable);
    const { kind, program, names, python, threads } = carried;
    const node: SiteNode = {
      id,
      package: from,
      executable,
      label: executable,
      kind,
      program,
      threads,
      arguments: given,
      environment: {},
      ...(names === undefined ? {} : { names }),
      ...(python === undefined ? {} : { python }),
      output: 'screen',
      respawn: false,
      respawnDelay: 0,
      startAfter: 0,
      shutdownOnExit: false,
    };
    const runner = this.addedRunner(node, {
      changed: () => {
        const { state } = runner.view();
        if (state.kind !== 'exited' && state.kind !== 'crashed') return;
        queueMicrotask(() => {
          // It may have been restarted.
          if (runner.active() || this.gone.has(id)) return;
          this.gone.add(id);
          this.nodesChanged();
          onEnd(state);
        });
      },
      shutdown: () => undefined,
      happened: () => undefined,
      lines: (_of, { lines }) => onLines(lines.map(([stream, , text]) => ({ stream: stream === 1 ? 'stdout' : 'stderr', text }))),
    });
    runner.start();
    return id;
  }

  async launch(asked: LaunchRequest): Promise<LaunchedNodes> {
    const { platform, broker } = this;
    const [{ LaunchGroup }, site] = await Promise.all([
      import('../launch/launch_group.ts'),
      asked.arguments.size === 0
        ? this.site
        : import('../launch/launch_evaluation.ts').then(({ siteWithArguments }) => siteWithArguments(this.site, asked.arguments, platform)),
    ]);
    return new LaunchGroup(site.nodes, site.launchSteps, asked, {
      idFor: (executable, but) => this.idFor(executable, but),
      runnerOf: (node, told) =>
        this.addedRunner(node, {
          changed: told.changed,
          shutdown: told.shutdown,
          happened: (_of, event) => told.happened(event),
          lines: (_of, { lines }) => told.lines(lines),
        }),
      free: (ids) => {
        for (const id of ids) this.gone.add(id);
        this.nodesChanged();
      },
      after: (ms, task) => broker.after(ms, task),
      pageNode: () => this.node(),
    });
  }

  private running(): string[] {
    return [...this.runners].filter(([id, runner]) => runner.active() && !this.added.has(id)).map(([id]) => id);
  }

  /** `afterSeconds` of the site's time when the run is stepped, else of the real one. */
  start(id: string, afterSeconds = 0): void {
    this.tabs?.claim(id).catch(() => undefined);
    this.runner(id).start(afterSeconds * 1000);
  }

  stop(id: string): void {
    this.lookAtTopics();
    this.runner(id).stop();
  }

  restart(id: string): void {
    this.lookAtTopics();
    this.runner(id).restart();
  }

  /** While some nodes run, only the others are started: the launch goes on. */
  startAll(): void {
    const running = new Set(this.running());
    this.steps.prepare();
    const others = this.site.nodes.filter(({ id }) => !running.has(id));
    for (const node of others) this.startAsLaunched(node, running);
    this.steps.launched(running.size === 0 ? undefined : new Set(others.map(({ id }) => id)));
  }

  /** Does a node start again by itself? */
  respawns(): boolean {
    return [...this.runners.values()].some((runner) => runner.respawns());
  }

  /** A waiting node keeps waiting. One that would wait for an event of a node that already runs starts at once. */
  private startAsLaunched({ id, startOn, startAfter }: SiteNode, running: ReadonlySet<string> = new Set()): void {
    const goesOn = startOn !== undefined && startOn.event !== 'exit' && running.has(startOn.node);
    const runner = this.runner(id);
    if (startOn === undefined || (goesOn && runner.view().state.kind !== 'waiting')) this.start(id, startAfter);
    else runner.wait(startOn);
  }

  stopAll(): void {
    this.endAll(interruptedReason);
  }

  private endAll(reason: string): void {
    this.again = false;
    this.lookAtTopics();
    this.steps.shutdown(reason);
    for (const runner of this.runners.values()) runner.stop();
  }

  restartAll(): void {
    this.stopAll();
    this.again = true;
    this.startAgain();
  }

  /** Completes restartAll() as soon as no node runs any more. */
  private startAgain(): void {
    if (!this.again || this.running().length > 0) return;
    this.again = false;
    // The node that ended last must first be done with its end.
    queueMicrotask(() => {
      if (!this.closed) this.startAll();
    });
  }

  interrupt(id: string): void {
    const runner = this.runner(id);
    if (!runner.active()) return;
    runner.console.add([[1, this.now(), '^C']], 0);
    this.stop(id);
  }

  onNodes(listener: (nodes: readonly NodeView[]) => void): Unsubscribe {
    this.nodeListeners.add(listener);
    return () => void this.nodeListeners.delete(listener);
  }

  private nodesChanged(): void {
    this.tabs?.run(this.running());
    this.startAgain();
    if (!this.nodesTold || this.closed) return;
    this.nodesTold = false;
    this.platform.frame(() => {
      this.nodesTold = true;
      const nodes = this.nodes();
      for (const listener of [...this.nodeListeners]) listener(nodes);
    });
  }

  console(id: string): ConsoleLog {
    return this.runner(id).console;
  }

  topics(): readonly TopicView[] {
    return this.sampling === undefined ? this.sampler.sample(this.now()) : this.sampler.topics();
  }

  onTopics(listener: (topics: readonly TopicView[]) => void): Unsubscribe {
    this.topicListeners.add(listener);
    this.sampling ??= setInterval(() => {
      const topics = this.sampler.sample(this.now());
      for (const each of [...this.topicListeners]) each(topics);
    }, sampleMs);
    return () => {
      this.topicListeners.delete(listener);
      if (this.topicListeners.size === 0) this.stopSampling();
    };
  }

  private now(): number {
    return this.broker.link.clock.systemNs() / 1e6;
  }

  /** When a node goes: what it published last stays with the topic. */
  private lookAtTopics(): void {
    if (this.sampling !== undefined || this.checks !== undefined || this.tasks !== undefined) this.sampler.sample(this.now());
  }

  private stopSampling(): void {
    if (this.sampling !== undefined) clearInterval(this.sampling);
    this.sampling = undefined;
  }

  lastMessage(topic: string): LastMessage | undefined {
    return this.sampler.lastMessage(topic, this.now());
  }

  interfaces(): Promise<Map<string, string>> {
    return this.definitions.all();
  }

  learn(definitions: ReadonlyMap<string, string>): Promise<void> {
    return this.definitions.learn(definitions);
  }

  node(): PageNode {
    return this.participant();
  }

  private participant(): PageParticipant {
    this.page ??= new PageParticipant(this.broker);
    if (this.closed) this.page.close();
    return this.page;
  }

  graph(): GraphView {
    const { link } = this.broker;
    const records = link.records();
    const runners = this.notebook === undefined ? [...this.runners] : [...this.runners, [kernelId, this.notebook.runner] as const];
    const processes = new Map(runners.map(([id, runner]) => [runner.participant(), id]));
    return graphView(link.graphReplica.nodes.values(), records, (participant) => processes.get(participant));
  }

  onGraph(listener: (graph: GraphView) => void): Unsubscribe {
    return this.graphWatch.add(listener);
  }

  sendInput(id: string, text: string): void {
    const runner = this.runner(id);
    if (!runner.active() || runner.node.kind === 'command') return;
    this.input.send(id, text);
    this.broker.wrote();
  }

  close(): void {
    if (this.closed) return;
    this.closed = true;
    this.checks?.close();
    this.tasks?.close();
    this.stopSampling();
    this.steps.close();
    this.time.close();
    this.tabs?.close();
    for (const runner of this.runners.values()) runner.close();
    this.notebook?.close();
    this.graphWatch.close();
    this.page?.close();
    this.images?.close();
    this.pythonWorkers.close();
    this.sources?.close();
    this.nodeListeners.clear();
    this.topicListeners.clear();
    this.broker.close();
  }
}
