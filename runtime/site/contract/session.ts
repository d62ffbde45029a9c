// The view that the page (and any other host of a site) has of a running site: its nodes, consoles and topics.
// Types only, plus unreachable(); launcher.ts makes Sessions.

import type { NotebookKernel, SiteNotebook } from './notebook.ts';
import type { GraphView, PageNode, QosView } from './page_node.ts';
import type { SiteCheck, SiteChecks } from './site_checks.ts';
import type { SiteSources, Sources } from './site_sources.ts';
import type { HowOften, NodeMoment, NodeState, SiteNode, SiteProgram, SourcePlace, Unsubscribe } from './site_nodes.ts';
import type { SiteTask, SiteTasks } from './site_tasks.ts';

export type { KernelEvent, KernelOrder, MimeBundle, NotebookKernel } from './notebook.ts';
export type { CheckView, SiteChecks } from './site_checks.ts';
export type { SiteTask, SiteTasks, TaskCheckView, TaskView } from './site_tasks.ts';
export type { SourceKept, Sources, SourceView } from './site_sources.ts';
export type * from './page_node.ts';
export type * from './site_nodes.ts';

/** The same, or the end of all. */
export type LaunchMoment =
  | NodeMoment
  | (HowOften & { readonly event: 'shutdown'; readonly node?: undefined; });

interface LaunchStepAt {
  /** undefined: when the site is launched. */
  readonly on?: LaunchMoment;
  /** Seconds after that. */
  readonly after: number;
  readonly source?: SourcePlace;
}

/** The actions of the launcher besides starting nodes. */
export type LaunchStep =
  & LaunchStepAt
  & (
    | { readonly do: 'log'; readonly level: string; readonly text: string; }
    | { readonly do: 'shutdown'; readonly reason: string; }
    /** Asks the node with this id to end. */
    | { readonly do: 'end'; readonly node: string; }
    /** Transitions of the managed node with that id and full name, in this order; the numbers are of lifecycle_msgs/msg/Transition. */
    | { readonly do: 'transition'; readonly node: string; readonly name: string; readonly transitions: readonly number[]; }
  );

export interface SiteFile {
  readonly path: string;
  readonly size: number;
  readonly sha256: string;
  readonly reason: string;
  /** Where it lies, relative to site.json: in parts, one after the other. Without it, at its path. */
  readonly at?: readonly string[];
}

export interface LaunchArgument {
  readonly name: string;
  readonly value: string;
  /** The default in the launch file. */
  readonly default?: string;
  /** The value that the site starts with when its URL gives none. */
  readonly packed?: string;
  readonly description: string;
  /** Empty: any value. */
  readonly choices: readonly string[];
}

/** The part of a site that evaluates the Python of its launch file. */
export interface LaunchPython {
  /** Arguments for which every value was evaluated in Python when the site was packed. */
  readonly tried: readonly string[];
  /** Pyodide in the site, which evaluates the file again for other values; undefined: the answers of packing stay. */
  readonly program?: string;
  readonly archives: readonly string[];
}

/** The launch file of which the site's nodes are. */
export interface LaunchFile {
  /** Relative to the manifest. */
  readonly file: string;
  /** In whose folder it lies; undefined: in none. */
  readonly package?: string;
}

/** A launch file that can be evaluated again when the site starts. Paths are relative to site.json. */
export interface LaunchView {
  readonly data: string;
  readonly evaluator: string;
  /** With their present values. */
  readonly arguments: readonly LaunchArgument[];
  /** Messages of the evaluation, if there was one. */
  readonly notes: readonly string[];
  /** Some parts are still evaluated for other values, because only Python could decide them. */
  readonly decided: boolean;
  /** Python ran again for these values. */
  readonly reran: boolean;
  /** undefined: the launch file asks no Python. */
  readonly python?: LaunchPython;
}

export interface SiteAuthor {
  readonly name: string;
  readonly family: string;
  /** Empty where `family` is the whole name. */
  readonly given: string;
}

export interface SiteCitation {
  /** `2026-11-23` */
  readonly date: string;
  /** Empty where there is none. */
  readonly doi: string;
}

/** site.json, checked. */
export interface SiteDescription {
  readonly protocol: number;
  readonly generator: string;
  readonly name: string;
  readonly title: string;
  readonly version: string;
  readonly distro: string;
  readonly license: string;
  readonly authors: readonly SiteAuthor[];
  /** undefined: the manifest does not say how it is cited. */
  readonly citation?: SiteCitation;
  readonly nodes: readonly SiteNode[];
  /** That none of the nodes runs; each once. */
  readonly programs: readonly SiteProgram[];
  readonly launchSteps: readonly LaunchStep[];
  /** undefined: the manifest names no launch file. */
  readonly launchFile?: LaunchFile;
  /** undefined: no launch argument can change what runs. */
  readonly launch?: LaunchView;
  /** Path of interfaces.json, relative to site.json; empty when the site has none. */
  readonly interfaces: string;
  /** Those that programs can ask the index of packages for. */
  readonly packages: readonly string[];
  /** The Python files of the workspace; undefined: none. */
  readonly sources?: SiteSources;
  /** The author's checks, which must pass while the site runs. */
  readonly checks: readonly SiteCheck[];
  /** The tasks that a student does in it. */
  readonly tasks: readonly SiteTask[];
  /** The site's notebook; undefined: there is none. */
  readonly notebook?: SiteNotebook;
  readonly ui: Readonly<Record<string, unknown>>;
  /** Origins of pages that may act on the site when they show it in a frame; `*`: every page. */
  readonly embed: readonly string[];
  readonly files: readonly SiteFile[];
  /** It shares a store with other sites, and with what it was before. */
  readonly stored?: true;
}

export type LinkKind = 'shared' | 'port';

/** As a program sets its terminal with termios: Ctrl-C stops it, or is a key like any other. */
export type KeyMode = 'cbreak' | 'raw';

export interface NodeView {
  readonly id: string;
  readonly label: string;
  readonly package: string;
  readonly executable: string;
  readonly state: NodeState;
  /** ms since 1970. */
  readonly startedAt?: number;
  readonly source?: SourcePlace;
  /** Its interpreter is loaded: none of its own code has run yet. */
  readonly loading?: true;
  /** It reads each key at once, not lines; `raw`: Ctrl-C too. */
  readonly terminal?: KeyMode;
  /** Numbers of the other tabs of the graph in which it runs. */
  readonly elsewhere?: readonly number[];
  /** It is a command of `ros2`, which reads nothing that is typed. */
  readonly command?: true;
  /** Paths of the sources that it has read since it started, or had when it ended, in that order; and of those the changed ones. */
  readonly usedSources?: readonly string[];
  readonly changedSources?: readonly string[];
}

/** This tab's place among those that have joined one graph. */
export interface TabView {
  readonly graph: string;
  readonly number: number;
  /** How many tabs there are. */
  readonly count: number;
}

export type LogLevel = 'DEBUG' | 'INFO' | 'WARN' | 'ERROR' | 'FATAL';

export interface ConsoleLine {
  /** ms since 1970, by the site's time. */
  readonly time: number;
  readonly stream: 'stdout' | 'stderr';
  readonly text: string;
  /** Set when the text has the form of a ROS 2 log line. */
  readonly level?: LogLevel;
}

/** A node beside those of the site, as `ros2 run` starts one. */
export interface AddedNode {
  readonly package: string;
  readonly executable: string;
  /** Behind the program's name. */
  readonly arguments: readonly string[];
  readonly onLines: (lines: readonly Pick<ConsoleLine, 'stream' | 'text'>[]) => void;
  /** It is in nodes() no more. */
  readonly onEnd: (state: Extract<NodeState, { readonly kind: 'exited' | 'crashed'; }>) => void;
}

/** A request of `ros2 launch`: it starts the nodes of the launch file, besides those of the site. */
export interface LaunchRequest {
  /** Arguments that are omitted have the values of the site. */
  readonly arguments: ReadonlyMap<string, string>;
  /** Called with the lines that one of the nodes prints. */
  readonly onLines: (node: SiteNode, lines: readonly Pick<ConsoleLine, 'stream' | 'text'>[]) => void;
  /** Each kind of state once, as it comes. */
  readonly onNode: (node: SiteNode, state: NodeState) => void;
  /** A line of the launch itself. */
  readonly onSaid: (text: string) => void;
  /** None of them runs any more, and nothing is to come: they are in nodes() no more. */
  readonly onEnd: () => void;
}

/** Nodes that one launch has started. */
export interface LaunchedNodes {
  /** As Ctrl-C does. */
  stop(): void;
}

/** A command that the launch file starts, as it is run. */
export interface RunningCommand {
  readonly session: Session;
  /** Behind `ros2`. */
  readonly words: readonly string[];
  /** One line or several, without the newline at the end. */
  readonly print: (text: string) => void;
  /** The same, on standard error. */
  readonly warn: (text: string) => void;
  /** A file of the site, by its path there. Rejects with a SiteError. */
  readonly file: (path: string) => Promise<ArrayBuffer>;
  /** Ctrl-C. */
  readonly signal: AbortSignal;
}

/** Loads what runs commands of `ros2`, which the session has not itself; that then gives each one's exit code. */
export type CommandLoader = (session: Session) => Promise<(command: RunningCommand) => Promise<number>>;

export interface ConsoleLog {
  /** The newest lines, oldest first; the count is bounded. */
  lines(): readonly ConsoleLine[];
  /** Lines that fell out of the ring so far. */
  dropped(): number;
  /** Called with the lines that came since the last call, at most once per animation frame. */
  onLines(listener: (lines: readonly ConsoleLine[]) => void): Unsubscribe;
  clear(): void;
}

export interface TopicView {
  readonly name: string;
  readonly type: string;
  readonly publishers: number;
  readonly subscriptions: number;
  readonly rateHz: number;
  readonly bytesPerSecond: number;
  /** Messages since the session began, also those of publishers that left. */
  readonly count: number;
  /** The QoS profiles of the publishers, or of the last ones when none is left; each once. */
  readonly qos: readonly QosView[];
}

export interface LastMessage {
  /** Whole CDR buffer, a copy. */
  readonly bytes: Uint8Array;
  /** ms since 1970, by the site's time: when it was published. */
  readonly receivedAt: number;
  /** As in TopicView: how many there were up to this one. */
  readonly count: number;
}

export interface TimeView {
  readonly state: 'running' | 'stepping' | 'paused';
  /** Site seconds per second. */
  readonly rate: number;
  /** ms since 1970, as programs see it. */
  readonly now: number;
}

/** Time as all programs of the site see it: clocks, timers, sleeps, deadlines. */
export interface SiteTime {
  view(): TimeView;
  pause(): void;
  resume(): void;
  /** Lets time run on by so much from where it is held (or will be), and holds it there. */
  step(ns: number): void;
  /** 0.001 to 1000; also while time is held. */
  setRate(rate: number): void;
  /** Called when anything but `now` changes. */
  onChange(listener: (view: TimeView) => void): Unsubscribe;
}

/** A run in which one node runs at a time and time is held at first: every run of a seed sends the same messages. */
export interface SteppedRun {
  readonly seed: number;
  /** The messages sent so far: their number, and the sha256 of the file that `ros2wasm run --trace` writes. */
  trace(): { readonly messages: number; readonly sha256: string; };
}

/** A file that a node has written and closed. */
export interface WrittenFile {
  /** Its id. */
  readonly node: string;
  /** In the node's own file system. */
  readonly path: string;
  readonly content: Blob;
}

export interface Written {
  /** Returns the files that came since the last call, and removes them from here. */
  take(): readonly WrittenFile[];
  onChange(listener: () => void): Unsubscribe;
}

export interface Session {
  readonly site: SiteDescription;
  readonly link: LinkKind;
  /** The folder in which programs find what is installed. */
  readonly prefix: string;
  readonly time: SiteTime;
  /** undefined: nodes run side by side. */
  readonly stepped: SteppedRun | undefined;
  /** In launch order. */
  nodes(): readonly NodeView[];
  /** undefined while this tab is by itself. */
  tab(): TabView | undefined;
  /** Joins the graph of that name with the other tabs that have, once and for as long as the page is open. Rejects with a SiteError. */
  joinTabs(graph: string): Promise<void>;
  start(id: string): void;
  stop(id: string): void;
  restart(id: string): void;
  /** Its id. The program must be one that the site carries: of a node, or of its own. */
  run(node: AddedNode): string;
  /** Rejects with the SiteError of launch arguments that cannot be. */
  launch(asked: LaunchRequest): Promise<LaunchedNodes>;
  startAll(): void;
  stopAll(): void;
  /** Stops all, and launches the site again when the last one has ended. */
  restartAll(): void;
  /** Ctrl-C in the node's terminal: its console shows `^C`, and it is stopped. */
  interrupt(id: string): void;
  /** At most once per animation frame. */
  onNodes(listener: (nodes: readonly NodeView[]) => void): Unsubscribe;
  console(id: string): ConsoleLog;
  /** The output of the launch file's actions while the site runs, and their errors. */
  readonly launchLog: ConsoleLog;
  /** Sampled 4 times per second while someone listens. A topic stays when its publishers have left, with its last message. */
  topics(): readonly TopicView[];
  onTopics(listener: (topics: readonly TopicView[]) => void): Unsubscribe;
  /** undefined before the first one, and for a large one that nobody looked at in time. */
  lastMessage(topic: string): LastMessage | undefined;
  /** Type name -> definition text; fetched at the first call. The same map at each, which learn() makes larger. */
  interfaces(): Promise<ReadonlyMap<string, string>>;
  /** Definitions from elsewhere, as a bag brings them: those of types that the site knows itself are skipped. */
  learn(definitions: ReadonlyMap<string, string>): Promise<void>;
  /** The bags that nodes have written. */
  readonly written: Written;
  /** The page as a participant of the graph, made at the first call. */
  node(): PageNode;
  /** undefined: the site has none. They look from before the first node starts. */
  readonly checks: SiteChecks | undefined;
  /** undefined: the site has none, or nobody could do them, as in a headless run. */
  readonly tasks: SiteTasks | undefined;
  /** undefined: the site has none. */
  readonly sources: Sources | undefined;
  /** The same session for what goes on by itself, such as a bag that plays; undefined: this one. */
  readonly unattended?: Session;
  /** undefined: the site has no notebook. */
  readonly notebook: NotebookKernel | undefined;
  /** As it is now. */
  graph(): GraphView;
  /** Called when the graph has changed, at most once per animation frame. */
  onGraph(listener: (graph: GraphView) => void): Unsubscribe;
  /** Text for the node's standard input; end lines with \n. An empty one is the end of its input. */
  sendInput(id: string, text: string): void;
  close(): void;
}

/** Those of its nodes, then those that it carries besides. */
export function carriedPrograms({ nodes, programs }: SiteDescription): SiteProgram[] {
  return [...nodes.filter((node) => node.kind !== 'command'), ...programs];
}

/** Marks a branch that the types rule out. */
export function unreachable(value: never): never {
  throw new TypeError(`unreachable: ${JSON.stringify(value)}`);
}
