// A Jupyter notebook (nbformat 4) as cells, and back to the same file: what is not understood here stays as it was.

import { viewTexts } from '../texts_views.ts';
import { isRecord, member, textMember } from './json.ts';

export type CellKind = 'code' | 'markdown' | 'raw';

/** An output in nbformat's own form; output_view.tsx reads it with care. */
export type CellOutput = Readonly<Record<string, unknown>>;

export interface NotebookCell {
  /** Names the cell while the page is open. */
  readonly key: string;
  readonly kind: CellKind;
  readonly source: string;
  readonly outputs: readonly CellOutput[];
  readonly count: number | null;
  /** The cell as the file has it. */
  readonly kept: Readonly<Record<string, unknown>>;
}

export interface Notebook {
  readonly cells: readonly NotebookCell[];
  readonly minor: number;
  /** The file without its cells. */
  readonly kept: Readonly<Record<string, unknown>>;
}

export type ReadNotebook =
  | { readonly kind: 'read'; readonly notebook: Notebook; }
  | { readonly kind: 'failed'; readonly reason: string; };

const words = viewTexts.notebook.unread;
export const MOST_NOTEBOOK = 8 << 20;
export const MOST_CELLS = 1000;
const MOST_OUTPUTS = 1000;
const NEWEST_MINOR = 5;
/** From this minor version on each cell has an id in the file. */
const MINOR_OF_IDS = 5;
const ID = /^[a-zA-Z0-9_-]{1,64}$/;

export function readNotebook(text: string): ReadNotebook {
  const failed = (reason: string): ReadNotebook => ({ kind: 'failed', reason });
  if (text.length > MOST_NOTEBOOK) return failed(words.tooLarge);
  let file: unknown;
  try {
    file = JSON.parse(text);
  } catch {
    return failed(words.notJson);
  }
  if (!isRecord(file)) return failed(words.noNotebook);
  const { cells, ...kept } = file;
  if (member(file, 'nbformat') !== 4) return failed(words.otherFormat);
  if (!Array.isArray(cells)) return failed(words.noCells);
  if (cells.length > MOST_CELLS) return failed(words.tooMany(MOST_CELLS));
  const minor = member(file, 'nbformat_minor');
  if (typeof minor !== 'number' || !Number.isInteger(minor) || minor < 0) return failed(words.noMinor);
  const notebook = {
    cells: cells.filter(isRecord).map(readCell),
    minor: Math.min(minor, NEWEST_MINOR),
    kept: { ...kept, metadata: isRecord(kept['metadata']) ? kept['metadata'] : {} },
  };
  return { kind: 'read', notebook };
}

let made = 0;

/** A key for a cell of this page; each is given once. */
function newKey(): string {
  made += 1;
  return `cell-${made}`;
}

function readCell(cell: Readonly<Record<string, unknown>>): NotebookCell {
  const type = textMember(cell, 'cell_type');
  const kind = type === 'code' || type === 'markdown' ? type : 'raw';
  const { outputs, execution_count: count } = cell;
  return {
    key: newKey(),
    kind,
    source: joined(cell['source']),
    outputs: kind === 'code' && Array.isArray(outputs) ? outputs.filter(isRecord).slice(0, MOST_OUTPUTS) : [],
    count: kind === 'code' && Number.isInteger(count) ? (count as number) : null,
    kept: cell,
  };
}

export function newCell(kind: CellKind): NotebookCell {
  return { key: newKey(), kind, source: '', outputs: [], count: null, kept: {} };
}

/** nbformat writes a text as one string, or as lines with their ends. */
export function joined(text: unknown): string {
  if (typeof text === 'string') return text;
  return Array.isArray(text) ? text.filter((part) => typeof part === 'string').join('') : '';
}

function asLines(text: string): readonly string[] {
  return text === '' ? [] : text.split(/(?<=\n)/);
}

/** Parts of a cell that belong to its kind, and not to what a file may say beside it. */
const OWN_PARTS = new Set(['cell_type', 'id', 'source', 'outputs', 'execution_count', 'metadata', 'attachments']);

function writeCell(cell: NotebookCell, minor: number, taken: Set<string>): Record<string, unknown> {
  const others = Object.entries(cell.kept).filter(([name]) => !OWN_PARTS.has(name));
  const wanted = textMember(cell.kept, 'id');
  let id = ID.test(wanted) && !taken.has(wanted) ? wanted : cell.key;
  while (taken.has(id)) id = newKey();
  taken.add(id);
  const attachments = cell.kept['attachments'];
  return {
    ...Object.fromEntries(others),
    cell_type: cell.kind,
    ...(minor >= MINOR_OF_IDS ? { id } : {}),
    metadata: isRecord(cell.kept['metadata']) ? cell.kept['metadata'] : {},
    ...(cell.kind !== 'code' && isRecord(attachments) ? { attachments } : {}),
    ...(cell.kind === 'code' ? { execution_count: cell.count, outputs: cell.outputs } : {}),
    source: asLines(cell.source),
  };
}

/** The text of an .ipynb file, as Jupyter writes it. */
export function writeNotebook({ cells, minor, kept }: Notebook): string {
  const taken = new Set<string>();
  const file = { cells: cells.map((cell) => writeCell(cell, minor, taken)), ...kept, nbformat: 4, nbformat_minor: minor };
  return `${JSON.stringify(file, null, 1)}\n`;
}
