// The programs of a site, the nodes that run them, and the states of nodes.

import type { DiagnosticCode } from './diagnostic_codes.ts';

export type Unsubscribe = () => void;

/** A place in the manifest or a launch file. Lines and columns count from 1. */
export interface SourcePlace {
  readonly file: string;
  readonly line: number;
  readonly column: number;
}

/** The program of a node of kind "python". Paths are relative to site.json. */
export interface PythonProgram {
  /** Zip files, unpacked over each other into one installation. */
  readonly archives: readonly string[];
  /** Compiled libraries in the installation that are loaded before any code, in this order. */
  readonly libraries?: readonly string[];
  /** `module:function`, or the path of a script in the installation. */
  readonly entry: string;
}

/** A program, whatever starts it. */
export interface SiteProgram {
  readonly package: string;
  readonly executable: string;
  readonly kind: 'cpp' | 'python';
  /** Path of the program, relative to site.json; of a Python node, of Pyodide's wasm file beside its others. */
  readonly program: string;
  /** Path of the names of the program's functions, for crash reports; fetched only then. */
  readonly names?: string;
  /** For kind "python". */
  readonly python?: PythonProgram;
  readonly threads: boolean;
}

/** A process of the launch, and the rules by which it starts. */
interface LaunchedProcess {
  /** `<executable>-<n>`, the process name that `ros2 launch` prints. */
  readonly id: string;
  readonly label: string;
  readonly arguments: readonly string[];
  readonly environment: Readonly<Record<string, string>>;
  readonly output: string;
  readonly respawn: boolean;
  /** Seconds. */
  readonly respawnDelay: number;
  /** undefined: as often as it ends. */
  readonly respawnMaxRetries?: number;
  /** Starts when that node has started, or has ended by itself; else with all others. */
  readonly startOn?: NodeMoment;
  /** Seconds after that. */
  readonly startAfter: number;
  /** When it ends by itself, all nodes are stopped. */
  readonly shutdownOnExit: boolean;
  readonly source?: SourcePlace;
}

export interface ProgramNode extends SiteProgram, LaunchedProcess {}

/** A command of `ros2` that the launch file starts, no program of the site: `arguments` are its words. */
export interface CommandNode extends LaunchedProcess {
  readonly kind: 'command';
  readonly package: '';
  readonly executable: string;
}

export type SiteNode = ProgramNode | CommandNode;

/** Whether a moment counts each time. */
export interface HowOften {
  readonly once?: boolean;
  /** Among moments with the same number only the first one counts. */
  readonly handler?: number;
}

/** Something that happens to a node, by its id. */
export type NodeMoment =
  | (HowOften & { readonly event: 'start' | 'exit'; readonly node: string; })
  | OutputMoment
  | StateMoment;

/** A property that a line has, or with `holds` of false does not have. */
export interface LineTest {
  readonly how: 'contains' | 'begins' | 'ends' | 'is';
  readonly text: string;
  /** Small and large letters are the same. */
  readonly anyCase: boolean;
  readonly holds: boolean;
}

/** A node prints a line that all tests fit. */
export interface OutputMoment extends HowOften {
  readonly event: 'output';
  readonly node: string;
  readonly stream: 'stdout' | 'stderr';
  readonly tests: readonly LineTest[];
}

/** A change of a managed node's state, by labels; those that are skipped may be any. */
export interface StateMoment extends HowOften {
  readonly event: 'transition';
  readonly node: string;
  /** Full, of the managed node. */
  readonly name: string;
  readonly transition?: string;
  readonly startState?: string;
  readonly goalState?: string;
  /** The first time only. */
}

export type NodeState =
  | { readonly kind: 'stopped'; }
  | { readonly kind: 'waiting'; readonly on: NodeMoment; }
  | { readonly kind: 'starting'; }
  | { readonly kind: 'running'; }
  | { readonly kind: 'exited'; readonly code: number; }
  | { readonly kind: 'crashed'; readonly message: string; readonly code: DiagnosticCode; };
