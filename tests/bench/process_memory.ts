// Memory of a process and all that it started, from /proc: proportional set size, so that pages shared
// between the processes of a browser count once.
import { readFileSync, readdirSync } from 'node:fs';

function parents(): Map<number, number> {
  const found = new Map<number, number>();
  for (const name of readdirSync('/proc')) {
    if (!/^\d+$/.test(name)) continue;
    try {
      const stat = readFileSync(`/proc/${name}/stat`, 'utf8');
      const afterName = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
      found.set(Number(name), Number(afterName[1]));
    } catch {
      // The process ended between the two reads.
    }
  }
  return found;
}

function proportionalKb(pid: number): number {
  try {
    const text = readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8');
    return Number(/^Pss:\s+(\d+) kB/m.exec(text)?.[1] ?? 0);
  } catch {
    return 0;
  }
}

/** `root` and its descendants. */
export function processTree(root: number): number[] {
  const parentOf = parents();
  const belongs = (pid: number | undefined): boolean =>
    pid !== undefined && (pid === root || belongs(parentOf.get(pid)));
  return [...parentOf.keys()].filter(belongs);
}

/** Proportional set size of `root` and its descendants, in kB. */
export function treeMemoryKb(root: number): number {
  return processTree(root).reduce((sum, pid) => sum + proportionalKb(pid), 0);
}
