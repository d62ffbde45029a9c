// A Session for tests of the page: no worker runs, a test says what happens. Never part of a site.

import { PortBroker } from '../../../runtime/site/bus/broker.ts';
import { graphView } from '../../../runtime/site/bus/graph_view.ts';
import { PageParticipant } from '../../../runtime/site/page/page_participant.ts';
import type {
  AddedNode,
  LaunchedNodes,
  LaunchRequest,
  ConsoleLine,
  ConsoleLog,
  LogLevel,
  GraphView,
  KernelEvent,
  KeyMode,
  KernelOrder,
  LastMessage,
  LinkKind,
  NodeState,
  NodeView,
  NotebookKernel,
  PageNode,
  Session,
  SiteDescription,
  SiteNode,
  SiteTime,
  Sources,
  TimeView,
  TabView,
  TopicView,
  Unsubscribe,
} from '../../../runtime/site/contract/session.ts';
import type { CheckView, SiteChecks } from '../../../runtime/site/contract/site_checks.ts';
import type { SiteTasks, TaskView } from '../../../runtime/site/contract/site_tasks.ts';
import { WrittenFiles } from '../../../runtime/site/program/written_files.ts';

/** Checks that a test decides. */
export class FakeChecks implements SiteChecks {
  /** How often all began again. */
  begun = 0;
  private shown: readonly CheckView[];
  private readonly listeners = new Set<(views: readonly CheckView[]) => void>();

  constructor(views: readonly CheckView[]) {
    this.shown = views;
  }

  views(): readonly CheckView[] {
    return this.shown;
  }

  onChange(listener: (views: readonly CheckView[]) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  again(at?: number): void {
    this.begun += 1;
    this.set(
      this.shown.map((view, index) =>
        at === undefined || at === index ? { title: view.title, withinMs: view.withinMs, state: 'waiting', seen: 'nothing' } : view
      ),
    );
  }

  set(views: readonly CheckView[]): void {
    this.shown = views;
    for (const listener of this.listeners) listener(views);
  }
}

/** Tasks as a test sets them. */
export class FakeTasks implements SiteTasks {
  private shown: readonly TaskView[];
  private acts = false;
  private readonly listeners = new Set<(views: readonly TaskView[]) => void>();

  constructor(views: readonly TaskView[]) {
    this.shown = views;
  }

  views(): readonly TaskView[] {
    return this.shown;
  }

  begun(): boolean {
    return this.acts;
  }

  acted(): void {
    this.acts = true;
  }

  onChange(listener: (views: readonly TaskView[]) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  set(views: readonly TaskView[]): void {
    this.shown = views;
    for (const listener of this.listeners) listener(views);
  }
}

export interface FakeNode {
  readonly executable: string;
  readonly label?: string;
  readonly package?: string;
  readonly source?: SiteNode['source'];
}

export interface FakeOptions {
  readonly title?: string;
  readonly link?: LinkKind;
  readonly nodes: readonly FakeNode[];
  readonly authors?: readonly string[];
  readonly interfaces?: ReadonlyMap<string, string>;
  readonly launchSteps?: SiteDescription['launchSteps'];
  readonly embed?: readonly string[];
  readonly ui?: Readonly<Record<string, unknown>>;
  readonly checks?: SiteDescription['checks'];
  readonly tasks?: SiteDescription['tasks'];
  /** Path of the notebook in the site. */
  readonly notebook?: string;
  /** That no node runs. */
  readonly programs?: SiteDescription['programs'];
  /** Paths of files of the site, beside the page's own. */
  readonly files?: readonly string[];
}

class FakeConsole implements ConsoleLog {
  private kept: ConsoleLine[] = [];
  private readonly listeners = new Set<(lines: readonly ConsoleLine[]) => void>();

  lines(): readonly ConsoleLine[] {
    return this.kept;
  }

  dropped(): number {
    return 0;
  }

  onLines(listener: (lines: readonly ConsoleLine[]) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  clear(): void {
    this.kept = [];
  }

  add(lines: readonly ConsoleLine[]): void {
    this.kept = this.kept.concat(lines).slice(-200_000);
    for (const listener of this.listeners) listener(lines);
  }

  get listenerCount(): number {
    return this.listeners.size;
  }
}

class FakeTime implements SiteTime {
  /** The calls of the page: `step 100000000`. */
  readonly asked: string[] = [];
  private held = false;
  private rate = 1;
  private readonly listeners = new Set<(view: TimeView) => void>();

  view(): TimeView {
    return { state: this.held ? 'paused' : 'running', rate: this.rate, now: Date.now() };
  }

  pause(): void {
    this.asked.push('pause');
    this.set(true, this.rate);
  }

  resume(): void {
    this.asked.push('resume');
    this.set(false, this.rate);
  }

  step(ns: number): void {
    this.asked.push(`step ${ns}`);
    this.set(true, this.rate);
  }

  setRate(rate: number): void {
    this.asked.push(`rate ${rate}`);
    this.set(this.held, rate);
  }

  onChange(listener: (view: TimeView) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  get listenerCount(): number {
    return this.listeners.size;
  }

  private set(held: boolean, rate: number): void {
    this.held = held;
    this.rate = rate;
    for (const listener of this.listeners) listener(this.view());
  }
}

/** A kernel that a test directs: it notes its orders. */
export class FakeKernel implements NotebookKernel {
  readonly file: string;
  readonly orders: KernelOrder[] = [];
  readonly asked: string[] = [];
  private shown: NodeState = { kind: 'stopped' };
  private readonly events = new Set<(event: KernelEvent) => void>();
  private readonly states = new Set<(state: NodeState) => void>();

  constructor(file: string) {
    this.file = file;
  }

  state(): NodeState {
    return this.shown;
  }

  setState(state: NodeState): void {
    this.shown = state;
    for (const listener of this.states) listener(state);
  }

  start(): void {
    if (this.shown.kind !== 'running') this.setState({ kind: 'running' });
  }

  send(order: KernelOrder): void {
    this.orders.push(order);
  }

  interrupt(): void {
    this.asked.push('interrupt');
  }

  stop(): void {
    this.setState({ kind: 'exited', code: 137 });
  }

  restart(): void {
    this.asked.push('restart');
    this.stop();
    this.start();
  }

  onEvent(listener: (event: KernelEvent) => void): Unsubscribe {
    this.events.add(listener);
    return () => this.events.delete(listener);
  }

  onState(listener: (state: NodeState) => void): Unsubscribe {
    this.states.add(listener);
    return () => this.states.delete(listener);
  }

  tell(event: KernelEvent): void {
    for (const listener of this.events) listener(event);
  }
}

export class FakeSession implements Session {
  readonly time = new FakeTime();
  readonly notebook: FakeKernel | undefined;
  checks: SiteChecks | undefined;
  tasks: SiteTasks | undefined;
  readonly stepped = undefined;
  readonly written = new WrittenFiles();
  sources: Sources | undefined;
  private joined: TabView | undefined;
  readonly site: SiteDescription;
  readonly link: LinkKind;
  readonly prefix = '/opt/ros/jazzy';
  /** The calls of the page: `start talker-1`, `input talker-1 text`. */
  readonly asked: string[] = [];
  private views: readonly NodeView[];
  private shown: readonly TopicView[] = [];
  readonly launchLog = new FakeConsole();
  private readonly consoles = new Map<string, FakeConsole>();
  private readonly last = new Map<string, LastMessage>();
  /** The requests to launch(). */
  readonly launches: LaunchRequest[] = [];
  /** The nodes given to run(). */
  readonly added: AddedNode[] = [];
  private readonly nodeListeners = new Set<(nodes: readonly NodeView[]) => void>();
  private readonly topicListeners = new Set<(topics: readonly TopicView[]) => void>();
  private readonly known: Map<string, string>;
  /** A graph of its own, on which the page is alone unless a test admits others. */
  readonly broker = new PortBroker();
  private page: PageParticipant | undefined;
  private shownGraph: GraphView | undefined;
  private readonly graphListeners = new Set<(graph: GraphView) => void>();

  constructor(options: FakeOptions) {
    this.link = options.link ?? 'shared';
    if (options.notebook !== undefined) this.notebook = new FakeKernel(options.notebook);
    this.known = new Map(options.interfaces ?? [['std_msgs/msg/String', 'string data\n']]);
    const nodes = options.nodes.map((node, index): SiteNode => ({
      id: `${node.executable}-${index + 1}`,
      package: node.package ?? `tutorial_${node.executable}`,
      executable: node.executable,
      label: node.label ?? `/${node.executable}`,
      kind: 'cpp',
      program: `programs/${node.executable}.wasm`,
      threads: false,
      arguments: [],
      environment: {},
      output: 'screen',
      respawn: false,
      startAfter: 0,
      shutdownOnExit: false,
      respawnDelay: 0,
      source: node.source ?? { file: 'workspace.yaml', line: 13 + 2 * index, column: 5 },
    }));
    this.site = {
      protocol: 1,
      generator: 'ros2wasm 0.1.0',
      name: 'talker_listener',
      title: options.title ?? 'Talker and listener',
      version: '1.0.0',
      distro: 'jazzy',
      license: 'Apache-2.0',
      authors: (options.authors ?? ['Ada Example']).map((name) => ({ name, family: name, given: '' })),
      nodes,
      programs: options.programs ?? [],
      checks: options.checks ?? [],
      tasks: options.tasks ?? [],
      launchSteps: options.launchSteps ?? [],
      packages: [],
      interfaces: 'interfaces.json',
      ...(options.notebook === undefined ? {} : { notebook: { file: options.notebook, program: 'pyodide/pyodide.asm.wasm', archives: [] } }),
      ui: options.ui ?? {},
      embed: options.embed ?? [],
      files: [
        { path: 'index.html', size: 2048, sha256: '', reason: 'runtime page' },
        { path: 'main.js', size: 61_000, sha256: '', reason: 'runtime script' },
        ...(options.files ?? []).map((path) => ({ path, size: 1, sha256: '', reason: '' })),
      ],
    };
    this.views = nodes.map((node) => {
      this.consoles.set(node.id, new FakeConsole());
      return {
        id: node.id,
        label: node.label,
        package: node.package,
        executable: node.executable,
        state: { kind: 'running' },
        startedAt: Date.now(),
        ...(node.source === undefined ? {} : { source: node.source }),
      };
    });
  }

  tab(): TabView | undefined {
    return this.joined;
  }

  joinTabs(graph: string): Promise<void> {
    this.asked.push(`join ${graph}`);
    this.joined = { graph, number: 1, count: 2 };
    for (const listener of this.nodeListeners) listener(this.views);
    return Promise.resolve();
  }

  nodes(): readonly NodeView[] {
    return this.views;
  }

  onNodes(listener: (nodes: readonly NodeView[]) => void): Unsubscribe {
    this.nodeListeners.add(listener);
    return () => this.nodeListeners.delete(listener);
  }

  start(id: string): void {
    this.asked.push(`start ${id}`);
    this.setState(id, { kind: 'running' });
  }

  stop(id: string): void {
    this.asked.push(`stop ${id}`);
    this.setState(id, { kind: 'stopped' });
  }

  restart(id: string): void {
    this.asked.push(`restart ${id}`);
    this.setState(id, { kind: 'running' });
  }

  startAll(): void {
    for (const node of this.views) this.start(node.id);
  }

  stopAll(): void {
    for (const node of this.views) this.stop(node.id);
  }

  restartAll(): void {
    for (const node of this.views) this.restart(node.id);
  }

  interrupt(id: string): void {
    this.print(id, '^C');
    this.stop(id);
  }

  console(id: string): FakeConsole {
    const found = this.consoles.get(id);
    if (found === undefined) throw new Error(`no node ${id}`);
    return found;
  }

  topics(): readonly TopicView[] {
    return this.shown;
  }

  onTopics(listener: (topics: readonly TopicView[]) => void): Unsubscribe {
    this.topicListeners.add(listener);
    return () => this.topicListeners.delete(listener);
  }

  lastMessage(topic: string): LastMessage | undefined {
    return this.last.get(topic);
  }

  interfaces(): Promise<ReadonlyMap<string, string>> {
    return Promise.resolve(this.known);
  }

  learn(definitions: ReadonlyMap<string, string>): Promise<void> {
    for (const [type, text] of definitions) if (!this.known.has(type)) this.known.set(type, text);
    return Promise.resolve();
  }

  node(): PageNode {
    this.page ??= new PageParticipant(this.broker);
    return this.page;
  }

  /** The graph that a test has set, else the graph that the page itself has made. */
  graph(): GraphView {
    const { link } = this.broker;
    return this.shownGraph ?? graphView(link.graphReplica.nodes.values(), link.records(), () => undefined);
  }

  onGraph(listener: (graph: GraphView) => void): Unsubscribe {
    this.graphListeners.add(listener);
    return () => this.graphListeners.delete(listener);
  }

  run(node: AddedNode): string {
    this.added.push(node);
    this.asked.push(`run ${node.package}/${node.executable} ${node.arguments.join(' ')}`);
    return `${node.executable}-${this.added.length}`;
  }

  launch(asked: LaunchRequest): Promise<LaunchedNodes> {
    this.launches.push(asked);
    this.asked.push(`launch ${[...asked.arguments].map(([name, value]) => `${name}:=${value}`).join(' ')}`);
    return Promise.resolve({ stop: () => this.asked.push('stop launch') });
  }

  sendInput(id: string, text: string): void {
    this.asked.push(`input ${id} ${text}`);
  }

  close(): void {
    this.asked.push('close');
    this.page?.close();
    this.broker.close();
  }

  // Functions for tests ---------------------------------------------------------------------------

  setGraph(graph: GraphView): void {
    this.shownGraph = graph;
    for (const listener of this.graphListeners) listener(graph);
  }

  /** The page has made or closed endpoints. */
  graphChanged(): void {
    for (const listener of this.graphListeners) listener(this.graph());
  }

  setState(id: string, state: NodeState): void {
    this.views = this.views.map((node) => node.id === id ? { ...node, state, startedAt: Date.now() } : node);
    for (const listener of this.nodeListeners) listener(this.views);
  }

  /** The node reads keys from now on, or lines. */
  setTerminal(id: string, terminal: KeyMode | undefined): void {
    this.views = this.views.map(({ terminal: _, ...node }) => node.id !== id || terminal === undefined ? node : { ...node, terminal });
    for (const listener of this.nodeListeners) listener(this.views);
  }

  print(id: string, ...texts: readonly string[]): void {
    this.console(id).add(texts.map((text) => {
      const level = /^\[(DEBUG|INFO|WARN|ERROR|FATAL)\] \[/.exec(text)?.[1] as LogLevel | undefined;
      return { time: Date.now(), stream: 'stderr', text, ...(level === undefined ? {} : { level }) };
    }));
  }

  log(id: string, level: string, message: string): void {
    const now = Date.now();
    const stamp = `${Math.floor(now / 1000)}.${String(now % 1000).padStart(3, '0')}482913`;
    const name = (this.views.find((node) => node.id === id)?.label ?? id)
      .replace(/^\//, '')
      .replaceAll('/', '.');
    this.print(id, `[${level}] [${stamp}] [${name}]: ${message}`);
  }

  setTopics(topics: readonly (Pick<TopicView, 'name' | 'type'> & Partial<TopicView>)[]): void {
    this.shown = topics.map((topic) => ({
      publishers: 1,
      subscriptions: 1,
      rateHz: 0,
      bytesPerSecond: 0,
      count: 0,
      qos: [{ reliability: 'reliable', durability: 'volatile', history: 'keep_last', depth: 10 }],
      ...topic,
    }));
    for (const listener of this.topicListeners) listener(this.shown);
  }

  publish(topic: string, bytes: Uint8Array): void {
    this.last.set(topic, {
      bytes,
      receivedAt: Date.now(),
      count: (this.last.get(topic)?.count ?? 0) + 1,
    });
  }

  get listenerCount(): number {
    let count = this.nodeListeners.size + this.topicListeners.size + this.time.listenerCount;
    for (const console of this.consoles.values()) count += console.listenerCount;
    return count;
  }
}

/** CDR of a std_msgs/msg/String. */
export function stringBytes(text: string): Uint8Array {
  const body = new TextEncoder().encode(`${text}\0`);
  const bytes = new Uint8Array(8 + body.length);
  bytes[1] = 1;
  new DataView(bytes.buffer).setUint32(4, body.length, true);
  bytes.set(body, 8);
  return bytes;
}
