// The last lines of some nodes since each began to run, for panels that show them beside something else.

import { useEffect, useReducer, useRef } from 'preact/hooks';
import type { NodeView, Session } from '../../contract/session.ts';

/** Lines of a node that are looked at: a traceback fits in. */
const MOST_LINES = 400;

export interface NodeOutput {
  readonly node: NodeView;
  readonly lines: readonly string[];
}

export function useNodeOutput(session: Session, nodes: readonly NodeView[]): readonly NodeOutput[] {
  const [, changed] = useReducer<number, void>((n) => n + 1, 0);
  const buffers = useRef(new Map<string, string[]>());
  const begun = useRef(new Map<string, number | undefined>());
  for (const { id, startedAt, state } of nodes) {
    const before = begun.current.get(id);
    if (state.kind !== 'starting' && (startedAt === undefined || startedAt === before)) continue;
    // Another run: what the last one printed is over.
    if (begun.current.has(id)) buffers.current.set(id, []);
    begun.current.set(id, startedAt);
  }
  const ids = nodes.map(({ id }) => id).join('\n');
  useEffect(() => {
    const stops = (ids === '' ? [] : ids.split('\n')).map((id) => {
      const console = session.console(id);
      buffers.current.set(id, console.lines().slice(-MOST_LINES).map(({ text }) => text));
      return console.onLines((batch) => {
        const lines = buffers.current.get(id) ?? [];
        lines.push(...batch.slice(-MOST_LINES).map(({ text }) => text));
        buffers.current.set(id, lines.slice(-MOST_LINES));
        changed();
      });
    });
    changed();
    return () => {
      for (const stop of stops) stop();
    };
  }, [session, ids]);
  return nodes.map((node) => ({ node, lines: buffers.current.get(node.id) ?? [] }));
}
