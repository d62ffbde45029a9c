// Memory of a process and all that it started, from /proc.
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

function memoryKb(pid: number, kind: 'Pss' | 'Private_Dirty'): number {
  try {
    const text = readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8');
    return Number(new RegExp(`^${kind}:\\s+(\\d+) kB`, 'm').exec(text)?.[1] ?? 0);
  } catch {
    return 0;
  }
}

/** `root` and its descendants. */
export function processTree(root: number): number[] {
  const parentOf = parents();
  const belongs = (pid: number | undefined): boolean => pid !== undefined && (pid === root || belongs(parentOf.get(pid)));
  return [...parentOf.keys()].filter(belongs);
}

/** Proportional set size of `root` and its descendants, in kB: pages shared between the processes of a browser count once. */
export function treeMemoryKb(root: number): number {
  return processTree(root).reduce((sum, pid) => sum + memoryKb(pid, 'Pss'), 0);
}

/** The memory that only `root` and its descendants have written, shared with nobody, in kB: other browsers do not change it. */
export function treePrivateKb(root: number): number {
  return processTree(root).reduce((sum, pid) => sum + memoryKb(pid, 'Private_Dirty'), 0);
}
