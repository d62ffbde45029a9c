// The notebook of a page: its entry in site.json, and the messages between the page and its kernel.

import { fileName } from './file_name.ts';
import type { NodeState, ProgramNode, Unsubscribe } from './site_nodes.ts';

/** As in site.json. Paths are relative to it. */
export interface SiteNotebook {
  /** In Jupyter's nbformat 4. */
  readonly file: string;
  /** As of a node of kind "python". */
  readonly program: string;
  readonly archives: readonly string[];
  readonly libraries?: readonly string[];
}

/** Forms by MIME type: texts, bytes as base64, or what JSON can say. */
export type MimeBundle = Readonly<Record<string, unknown>>;

/** An event of a cell. `cell` is the name that its order gave it. */
export type KernelEvent =
  & { readonly cell: string; }
  & (
    /** The kernel waits for its first order. */
    | { readonly event: 'idle'; }
    | { readonly event: 'begin'; readonly count: number; }
    | { readonly event: 'end'; readonly good: boolean; }
    | { readonly event: 'stream'; readonly name: 'stdout' | 'stderr'; readonly text: string; }
    /** `update`: in place of what was shown under that name. */
    | { readonly event: 'display' | 'update'; readonly data: MimeBundle; readonly metadata: MimeBundle; readonly display_id?: string; }
    | { readonly event: 'result'; readonly count: number; readonly data: MimeBundle; readonly metadata: MimeBundle; }
    | { readonly event: 'error'; readonly ename: string; readonly evalue: string; readonly traceback: readonly string[]; }
    /** `wait`: when something new comes. */
    | { readonly event: 'clear'; readonly wait: boolean; }
    /** Somebody reads standard input. */
    | { readonly event: 'input'; readonly prompt: string; }
  );

/** Run a cell, once those before it are over; or a line for who reads standard input. */
export type KernelOrder = { readonly cell: string; readonly code: string; } | { readonly input: string; };

export interface NotebookKernel {
  readonly file: string;
  state(): NodeState;
  /** Nothing happens when it runs. */
  start(): void;
  send(order: KernelOrder): void;
  /** Ends the cell that runs, as Ctrl-C does. */
  interrupt(): void;
  /** Ends the program at once; nothing is left of what its cells have made. */
  stop(): void;
  restart(): void;
  /** In order, as they come. */
  onEvent(listener: (event: KernelEvent) => void): Unsubscribe;
  onState(listener: (state: NodeState) => void): Unsubscribe;
}

export const kernelId = 'notebook';

/** The node that runs it. */
export function kernelNode({ file, program, archives, libraries }: SiteNotebook): ProgramNode {
  const name = fileName(file);
  return {
    id: kernelId,
    package: '',
    executable: name,
    label: name,
    kind: 'python',
    program,
    python: { archives, ...(libraries === undefined ? {} : { libraries }), entry: 'ros2wasm.notebook:main' },
    threads: false,
    arguments: [],
    environment: {},
    output: 'screen',
    respawn: false,
    respawnDelay: 0,
    startAfter: 0,
    shutdownOnExit: false,
  };
}
