// Which parameters somebody has set over a session: by a panel, a link of a lab sheet, or a command. For links to a view.

import type { Session } from '../contract/session.ts';

const known = new WeakMap<Session, Map<string, Set<string>>>();

export function noteSet(session: Session, node: string, names: readonly string[]): void {
  const nodes = known.get(session) ?? new Map<string, Set<string>>();
  known.set(session, nodes);
  nodes.set(node, new Set([...(nodes.get(node) ?? []), ...names]));
}

/** Names of parameters by the full names of their nodes. */
export function setParameters(session: Session): ReadonlyMap<string, ReadonlySet<string>> {
  return known.get(session) ?? new Map();
}
