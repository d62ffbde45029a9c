// Joins what a console held when it was first read with the batches that come later.

import type { ConsoleLine } from '../../contract/session.ts';

/**
 * A filter for the batches after `snapshot`. A batch gathered before the snapshot was taken repeats its
 * last lines; those are dropped. Lines are told apart by identity.
 */
export function afterSnapshot(
  snapshot: readonly ConsoleLine[],
): (batch: readonly ConsoleLine[]) => readonly ConsoleLine[] {
  const last = snapshot.at(-1);
  let first = true;
  return (batch) => {
    if (!first || last === undefined) return batch;
    first = false;
    return batch.slice(batch.lastIndexOf(last) + 1);
  };
}
