// Converts the kernel's events about a cell to outputs of nbformat. Pure: old outputs in, new ones out.

import type { KernelEvent } from '../../contract/session.ts';
import { joined } from './notebook.ts';
import type { CellOutput } from './notebook.ts';

/** Characters of one stream that are kept. */
const MOST_TEXT = 2 << 20;
const MOST_OUTPUTS = 1000;

export interface ShownOutputs {
  readonly outputs: readonly CellOutput[];
  /** Names under which outputs can be updated, with their places. */
  readonly names: ReadonlyMap<string, readonly number[]>;
  /** All goes when something new comes. */
  readonly clears: boolean;
}

export const noOutputs: ShownOutputs = { outputs: [], names: new Map(), clears: false };

export function withEvent(shown: ShownOutputs, said: KernelEvent): ShownOutputs {
  switch (said.event) {
    case 'clear':
      return said.wait ? { ...shown, clears: true } : noOutputs;
    case 'stream':
      return withStream(fresh(shown), said.name, said.text);
    case 'display': {
      const before = fresh(shown);
      const output = { output_type: 'display_data', data: said.data, metadata: said.metadata };
      const after = added(before, output);
      if (said.display_id === undefined || after === before) return after;
      const places = [...(before.names.get(said.display_id) ?? []), before.outputs.length];
      return { ...after, names: new Map(before.names).set(said.display_id, places) };
    }
    case 'update': {
      const places = shown.names.get(said.display_id ?? '') ?? [];
      const outputs = shown.outputs.map((output, index) => places.includes(index) ? { ...output, data: said.data, metadata: said.metadata } : output);
      return { ...shown, outputs };
    }
    case 'result':
      return added(fresh(shown), {
        output_type: 'execute_result',
        data: said.data,
        metadata: said.metadata,
        execution_count: said.count,
      });
    case 'error':
      return added(fresh(shown), {
        output_type: 'error',
        ename: said.ename,
        evalue: said.evalue,
        traceback: said.traceback,
      });
    default:
      return shown;
  }
}

function fresh(shown: ShownOutputs): ShownOutputs {
  return shown.clears ? noOutputs : shown;
}

function added(shown: ShownOutputs, output: CellOutput): ShownOutputs {
  return shown.outputs.length >= MOST_OUTPUTS ? shown : { ...shown, outputs: [...shown.outputs, output] };
}

/** Text follows the text before it. */
function withStream(shown: ShownOutputs, name: string, text: string): ShownOutputs {
  const last = shown.outputs.at(-1);
  if (last?.['output_type'] !== 'stream' || last['name'] !== name)
    return added(shown, { output_type: 'stream', name, text });
  const whole = carriedBack(joined(last['text']) + text);
  return { ...shown, outputs: [...shown.outputs.slice(0, -1), { ...last, text: whole.slice(0, MOST_TEXT) }] };
}

/** A carriage return takes the line back to its begin, as a terminal does: bars of progress do that. */
function carriedBack(text: string): string {
  return text.includes('\r') ? text.replace(/\r\n/g, '\n').replace(/^[^\n]*\r(?=[^\n])/gm, '') : text;
}
