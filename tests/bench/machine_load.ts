// How busy a machine is beside a bench: figures of a busy one say little, and no aim is judged by them.
import { readdirSync, readFileSync } from 'node:fs';
import { processTree } from './process_memory.ts';

/** Processes that want a processor, those of others too. */
export function machineLoad(): number {
  return Number(readFileSync('/proc/loadavg', 'utf8').split(' ')[0]);
}

/** Above this share of all processors, taken by processes of others, a missed aim is not a failure. */
const QUIET_SHARE = 0.1;

/** The processor time that the machine has used so far, in ticks. */
export interface Ticks {
  readonly all: number;
  /** Taken by other machines of the same host. */
  readonly stolen: number;
  /** Ticks of processes that this bench did not start, by their ids; each includes the ended children that it waited for. */
  readonly others: ReadonlyMap<number, number>;
  /** Those of `others` whose parent has ended. */
  readonly orphans: ReadonlySet<number>;
  /** This process and those that it started. */
  readonly ours: ReadonlySet<number>;
}

/**
 * The share that others took of all processors' time between two looks. It is not the rest beside the bench's own time: a
 * browser's processes end without a parent that waits for them, and their ticks are then counted for nobody.
 */
export function othersShare(before: Ticks, after: Ticks): number {
  let others = after.stolen - before.stolen;
  for (const [pid, ticks] of after.others) {
    // A process of an ended browser of ours lives on for a moment.
    const mayBeOurs = before.ours.has(pid) || (after.orphans.has(pid) && !before.others.has(pid));
    if (!mayBeOurs) others += Math.max(0, ticks - (before.others.get(pid) ?? 0));
  }
  // A process that has waited for a long one gets all of its ticks at once, also those before the first look.
  return Math.min(1, Math.max(0, others) / Math.max(1, after.all - before.all));
}

const INIT = 1;
/** Parent of the kernel's threads, which work for whoever asks them: us, mostly. */
const KERNEL = 2;

/** The ticks of a process; undefined when it is the kernel's or has just ended. */
function lookAt(pid: number): { readonly ticks: number; readonly orphan: boolean; } | undefined {
  try {
    const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /s, '').split(' ').map(Number);
    const [user = 0, system = 0, waitedUser = 0, waitedSystem = 0] = fields.slice(11, 15);
    if (pid === KERNEL || fields[1] === KERNEL) return undefined;
    // The first process waits for those that have lost their parent, ours too.
    return { ticks: user + system + (pid === INIT ? 0 : waitedUser + waitedSystem), orphan: fields[1] === INIT };
  } catch {
    return undefined;
  }
}

export function ticksNow(): Ticks {
  const [user = 0, nice = 0, system = 0, idle = 0, waiting = 0, irq = 0, soft = 0, stolen = 0] = (readFileSync('/proc/stat', 'utf8').split('\n')[0] ?? '')
    .split(/\s+/).slice(1).map(Number);
  const ours = new Set(processTree(process.pid));
  const others = new Map<number, number>();
  const orphans = new Set<number>();
  for (const pid of readdirSync('/proc').map(Number)) {
    const found = Number.isNaN(pid) || ours.has(pid) ? undefined : lookAt(pid);
    if (found === undefined) continue;
    others.set(pid, found.ticks);
    if (found.orphan) orphans.add(pid);
  }
  return { all: user + nice + system + idle + waiting + irq + soft + stolen, stolen, others, orphans, ours };
}

/** Measures the share of the machine that others take from now on. */
export class OthersLoad {
  private readonly begin = ticksNow();

  share(): number {
    return othersShare(this.begin, ticksNow());
  }

  quiet(): boolean {
    return this.share() < QUIET_SHARE;
  }
}
