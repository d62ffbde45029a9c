// The notebook of a session: its cells, what runs, and what the browser keeps. It goes on while its panel is closed.

import type { KernelEvent, NodeState, NotebookKernel, Session, Unsubscribe } from '../../contract/session.ts';
import { noOutputs, withEvent } from '../model/cell_outputs.ts';
import type { ShownOutputs } from '../model/cell_outputs.ts';
import { MOST_CELLS, MOST_NOTEBOOK, newCell, readNotebook, writeNotebook } from '../model/notebook.ts';
import type { CellKind, Notebook, NotebookCell } from '../model/notebook.ts';
import { problemOf } from '../model/problem.ts';
import { viewTexts } from '../texts_views.ts';
import { forgetNotebook, keepNotebook, keptNotebook } from './stored_notebook.ts';

const KEEP_AFTER_MS = 400;

export interface NotebookView {
  /** null: not read yet. */
  readonly notebook: Notebook | null;
  /** Why it cannot be read. */
  readonly problem: string;
  readonly kernel: NodeState;
  /** Key of the cell that runs. */
  readonly running: string | null;
  /** Keys of those that come next. */
  readonly queued: ReadonlySet<string>;
  /** The cell that waits for standard input, and its prompt. */
  readonly asks: { readonly cell: string; readonly prompt: string; } | null;
  /** Other than packed: kept by the browser, not yet or not at all. */
  readonly change: 'none' | 'pending' | 'kept' | 'lost';
}

/** Tells whether a kernel in this state can run cells now or soon. */
export function isUp(state: NodeState): boolean {
  return state.kind === 'starting' || state.kind === 'running';
}

export class NotebookStore {
  readonly file: string;
  private readonly kernel: NotebookKernel;
  private readonly key: string;
  private readonly read: () => Promise<string>;
  private packed = '';
  private view: NotebookView;
  private readonly shown = new Map<string, ShownOutputs>();
  private readonly listeners = new Set<(view: NotebookView) => void>();
  private timer: ReturnType<typeof setTimeout> | undefined;
  private told = true;

  /** `key`: under which the browser keeps it; `read`: gives the packed one. */
  constructor(kernel: NotebookKernel, key: string, read: () => Promise<string>) {
    this.kernel = kernel;
    this.file = kernel.file;
    this.key = key;
    this.read = read;
    this.view = { notebook: null, problem: '', kernel: kernel.state(), running: null, queued: new Set(), asks: null, change: 'none' };
    kernel.onEvent((event) => this.happened(event));
    kernel.onState((state) => this.kernelChanged(state));
    globalThis.addEventListener?.('pagehide', () => this.keepNow());
    void this.load();
  }

  now(): NotebookView {
    return this.view;
  }

  onChange(listener: (view: NotebookView) => void): Unsubscribe {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  private set(change: Partial<NotebookView>): void {
    this.view = { ...this.view, ...change };
    if (!this.told) return;
    // All changes of one turn are drawn together.
    this.told = false;
    queueMicrotask(() => {
      this.told = true;
      for (const listener of [...this.listeners]) listener(this.view);
    });
  }

  private async load(): Promise<void> {
    try {
      this.packed = await this.read();
    } catch (error) {
      this.set({ problem: viewTexts.notebook.failed(this.file, problemOf(error).what) });
      return;
    }
    const kept = await keptNotebook(this.key);
    const found = kept === null ? null : readNotebook(kept);
    if (found?.kind === 'read') this.set({ notebook: found.notebook, change: 'kept' });
    else this.showPacked();
  }

  private showPacked(): void {
    const found = readNotebook(this.packed);
    if (found.kind === 'failed') this.set({ problem: viewTexts.notebook.failed(this.file, found.reason) });
    else this.set({ notebook: found.notebook, change: 'none' });
  }

  // ---- cells

  private cells(): readonly NotebookCell[] {
    return this.view.notebook?.cells ?? [];
  }

  private setCells(cells: readonly NotebookCell[]): void {
    const { notebook } = this.view;
    if (notebook === null) return;
    this.set({ notebook: { ...notebook, cells }, change: 'pending' });
    // Not later for each output: a cell that prints without end is kept too.
    this.timer ??= setTimeout(() => this.keepNow(), KEEP_AFTER_MS);
  }

  private setCell(key: string, change: Partial<NotebookCell>): void {
    this.setCells(this.cells().map((cell) => (cell.key === key ? { ...cell, ...change } : cell)));
  }

  private keepNow(): void {
    const { notebook, change } = this.view;
    this.stopTimer();
    if (change !== 'pending' || notebook === null) return;
    const text = writeNotebook(notebook);
    const keeping = text.length > MOST_NOTEBOOK ? Promise.resolve(false) : keepNotebook(this.key, text);
    void keeping.then((kept) => {
      if (this.view.notebook === notebook) this.set({ change: kept ? 'kept' : 'lost' });
    });
  }

  private stopTimer(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  setSource(key: string, source: string): void {
    if (this.cells().find((cell) => cell.key === key)?.source !== source) this.setCell(key, { source });
  }

  setKind(key: string, kind: CellKind): void {
    this.shown.delete(key);
    this.setCell(key, { kind, outputs: [], count: null });
  }

  /** Below that cell, or at the end. Returns its key; null: there are too many. */
  add(kind: CellKind, below?: string): string | null {
    const cells = this.cells();
    if (cells.length >= MOST_CELLS) return null;
    const cell = newCell(kind);
    const at = below === undefined ? cells.length : cells.findIndex(({ key }) => key === below) + 1;
    this.setCells([...cells.slice(0, at), cell, ...cells.slice(at)]);
    return cell.key;
  }

  remove(key: string): void {
    this.shown.delete(key);
    this.setCells(this.cells().filter((cell) => cell.key !== key));
  }

  move(key: string, by: 1 | -1): void {
    const cells = [...this.cells()];
    const at = cells.findIndex((cell) => cell.key === key);
    const [moved] = cells.splice(at, 1);
    if (at < 0 || moved === undefined || at + by < 0 || at + by > cells.length) return;
    cells.splice(at + by, 0, moved);
    this.setCells(cells);
  }

  clearOutputs(): void {
    this.shown.clear();
    this.setCells(this.cells().map((cell) => (cell.kind === 'code' ? { ...cell, outputs: [], count: null } : cell)));
  }

  reset(): void {
    this.stopTimer();
    this.shown.clear();
    this.showPacked();
    void forgetNotebook(this.key);
  }

  /** The text of an .ipynb file. */
  text(): string {
    return this.view.notebook === null ? this.packed : writeNotebook(this.view.notebook);
  }

  // ---- running

  run(keys: readonly string[]): void {
    const cells = this.cells().filter((cell) => keys.includes(cell.key) && cell.kind === 'code' && cell.source.trim() !== '');
    if (cells.length === 0) return;
    this.kernel.start();
    this.set({ queued: new Set([...this.view.queued, ...cells.map(({ key }) => key)]) });
    this.runNext();
  }

  /** One at a time: after a cell that fails nobody runs. */
  private runNext(): void {
    const { running, queued } = this.view;
    if (running !== null) return;
    const left = new Set(queued);
    for (const key of queued) {
      left.delete(key);
      const cell = this.cells().find((one) => one.key === key);
      if (cell === undefined) continue;
      this.set({ running: key, queued: left });
      this.kernel.send({ cell: key, code: cell.source });
      return;
    }
    if (queued.size > 0) this.set({ queued: left });
  }

  runAll(): void {
    this.run(this.cells().map(({ key }) => key));
  }

  /** The cells after it are not run either. */
  interrupt(): void {
    this.kernel.interrupt();
  }

  restart(): void {
    this.kernel.restart();
  }

  answer(text: string): void {
    this.kernel.send({ input: text });
    this.set({ asks: null });
  }

  private kernelChanged(kernel: NodeState): void {
    if (kernel.kind === this.view.kernel.kind) return;
    this.set({ kernel, ...(isUp(kernel) ? {} : { running: null, queued: new Set<string>(), asks: null }) });
  }

  private happened(event: KernelEvent): void {
    const { running } = this.view;
    const key = event.cell === '' ? running : event.cell;
    if (key === null) return;
    switch (event.event) {
      case 'begin':
        this.shown.set(key, noOutputs);
        this.setCell(key, { outputs: [], count: event.count });
        return;
      case 'end':
        this.set({ running: null, asks: null, ...(event.good ? {} : { queued: new Set<string>() }) });
        this.runNext();
        return;
      case 'input':
        this.set({ asks: { cell: key, prompt: event.prompt } });
        return;
      default: {
        const cell = this.cells().find((one) => one.key === key);
        if (cell === undefined) return;
        const before = this.shown.get(key) ?? { ...noOutputs, outputs: cell.outputs };
        const after = withEvent(before, event);
        if (after === before) return;
        this.shown.set(key, after);
        if (after.outputs !== before.outputs) this.setCell(key, { outputs: after.outputs });
      }
    }
  }
}

const stores = new WeakMap<Session, NotebookStore>();

/** null: the site has no notebook. */
export function notebookStore(session: Session, read: (path: string) => Promise<string>): NotebookStore | null {
  const { notebook, site } = session;
  if (notebook === undefined) return null;
  const known = stores.get(session);
  if (known !== undefined) return known;
  const { file } = notebook;
  const sha256 = site.files.find(({ path }) => path === file)?.sha256 ?? '';
  const store = new NotebookStore(notebook, `${location.pathname} ${file} ${sha256}`, () => read(file));
  stores.set(session, store);
  return store;
}
