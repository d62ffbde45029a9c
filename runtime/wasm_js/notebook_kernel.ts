// The program behind the page's notebook: a Python node of its own, which runs cells (runtime/rclpy/ros2wasm/notebook.py).
// It starts when it is wanted and is none of the nodes that are launched.

import type { NodeRunner } from './node_runner.ts';
import type { NodeState, ProgramNode, Unsubscribe } from './session.ts';

/** Of site.json. Paths are relative to it. */
export interface SiteNotebook {
  /** In Jupyter's nbformat 4. */
  readonly file: string;
  /** As of a node of kind "python". */
  readonly program: string;
  readonly archives: readonly string[];
}

/** Forms by MIME type: texts, bytes as base64, or what JSON can say. */
export type MimeBundle = Readonly<Record<string, unknown>>;

/** What a cell does. `cell` is the name that its order gave it. */
export type KernelEvent = { readonly cell: string } & (
  /** The kernel waits for its first order. */
  | { readonly event: 'idle' }
  | { readonly event: 'begin'; readonly count: number }
  | { readonly event: 'end'; readonly good: boolean }
  | { readonly event: 'stream'; readonly name: 'stdout' | 'stderr'; readonly text: string }
  /** `update`: in place of what was shown under that name. */
  | { readonly event: 'display' | 'update'; readonly data: MimeBundle; readonly metadata: MimeBundle; readonly display_id?: string }
  | { readonly event: 'result'; readonly count: number; readonly data: MimeBundle; readonly metadata: MimeBundle }
  | { readonly event: 'error'; readonly ename: string; readonly evalue: string; readonly traceback: readonly string[] }
  /** `wait`: when something new comes. */
  | { readonly event: 'clear'; readonly wait: boolean }
  /** Somebody reads standard input. */
  | { readonly event: 'input'; readonly prompt: string }
);

/** Run a cell, once those before it are over; or a line for who reads standard input. */
export type KernelOrder = { readonly cell: string; readonly code: string } | { readonly input: string };

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

/** What runs it. */
export function kernelNode({ file, program, archives }: SiteNotebook): ProgramNode {
  const name = file.slice(file.lastIndexOf('/') + 1);
  return {
    id: kernelId, package: '', executable: name, label: name, kind: 'python', program, python: { archives, entry: 'ros2wasm.notebook:main' },
    threads: false, arguments: [], environment: {}, output: 'screen', respawn: false, respawnDelay: 0, startAfter: 0, shutdownOnExit: false,
  };
}

/** What a kernel says is its program's word: it may be anything. undefined: it is no event. */
export function readEvent(text: string): KernelEvent | undefined {
  let said: unknown;
  try {
    said = JSON.parse(text);
  } catch {
    return undefined;
  }
  if (typeof said !== 'object' || said === null) return undefined;
  const { event, cell, text: printed, name, data, metadata, traceback, prompt, ename, evalue } = said as Record<string, unknown>;
  const isBundle = (value: unknown): boolean => typeof value === 'object' && value !== null && !Array.isArray(value);
  const isText = (...values: readonly unknown[]): boolean => values.every((value) => typeof value === 'string');
  if (!isText(event, cell)) return undefined;
  const good = {
    idle: true,
    begin: true,
    end: true,
    clear: true,
    stream: isText(printed) && (name === 'stdout' || name === 'stderr'),
    display: isBundle(data) && isBundle(metadata),
    update: isBundle(data) && isBundle(metadata),
    result: isBundle(data) && isBundle(metadata),
    error: isText(ename, evalue) && Array.isArray(traceback) && isText(...traceback),
    input: isText(prompt),
  }[event as KernelEvent['event']];
  return good === true ? said as KernelEvent : undefined;
}

export class SiteKernel implements NotebookKernel {
  readonly file: string;
  readonly runner: NodeRunner;
  private readonly write: (text: string) => void;
  private readonly events = new Set<(event: KernelEvent) => void>();
  private readonly states = new Set<(state: NodeState) => void>();

  /** `write`: to its standard input. */
  constructor(file: string, runner: NodeRunner, write: (text: string) => void) {
    this.file = file;
    this.runner = runner;
    this.write = write;
  }

  state(): NodeState {
    return this.runner.view().state;
  }

  start(): void {
    this.runner.start();
  }

  send(order: KernelOrder): void {
    if (this.runner.active()) this.write(`${JSON.stringify(order)}\n`);
  }

  interrupt(): void {
    this.runner.interrupt();
  }

  stop(): void {
    this.runner.kill();
  }

  restart(): void {
    this.runner.kill();
    this.runner.start();
  }

  onEvent(listener: (event: KernelEvent) => void): Unsubscribe {
    this.events.add(listener);
    return () => void this.events.delete(listener);
  }

  onState(listener: (state: NodeState) => void): Unsubscribe {
    this.states.add(listener);
    return () => void this.states.delete(listener);
  }

  told(event: KernelEvent | undefined): void {
    if (event !== undefined) for (const listener of [...this.events]) listener(event);
  }

  changed(): void {
    for (const listener of [...this.states]) listener(this.state());
  }

  close(): void {
    this.events.clear();
    this.states.clear();
    this.runner.close();
  }
}
