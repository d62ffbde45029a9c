// The program behind the page's notebook: a Python node of its own, which runs cells (runtime/packages/client/rclpy/ros2wasm/notebook.py).
// It starts when it is wanted and is none of the nodes that are launched.

import type { NodeRunner } from './node_runner.ts';
import type { KernelEvent, KernelOrder, NotebookKernel } from '../contract/notebook.ts';
import type { NodeState, Unsubscribe } from '../contract/session.ts';

/** Reads an event of a kernel. The text comes from its program, so it may be anything. undefined: it is not an event. */
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
    if (event !== undefined) { for (const listener of [...this.events]) listener(event); }
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
