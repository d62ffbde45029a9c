// How busy a machine is beside a bench: figures of a busy one say little, and no aim is judged by them.
import { readFileSync } from 'node:fs';
import { processTree } from './process_memory.ts';

/** Processes that want a processor, those of others too. */
export function machineLoad(): number {
  return Number(readFileSync('/proc/loadavg', 'utf8').split(' ')[0]);
}

/** Above this share of all processors, taken by processes of others, a missed aim is no failure. */
const QUIET_SHARE = 0.1;

/** Ticks of all processors. */
export interface Ticks {
  readonly all: number;
  /** In which one ran something. */
  readonly used: number;
  /** In which it ran something of ours. */
  readonly own: number;
}

/** Of all processors' time between two looks. */
export function othersShare(before: Ticks, after: Ticks): number {
  const others = after.used - before.used - (after.own - before.own);
  return Math.max(0, others) / Math.max(1, after.all - before.all);
}

/** Ticks of this process, of those that it started, and of those that these have waited for. */
function ownTicks(): number {
  return processTree(process.pid).reduce((sum, pid) => {
    try {
      const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');
      return sum + fields.slice(11, 15).map(Number).reduce((a, b) => a + b, 0);
    } catch {
      // It has just ended.
      return sum;
    }
  }, 0);
}

export function ticksNow(): Ticks {
  const [user = 0, nice = 0, system = 0, idle = 0, waiting = 0, irq = 0, soft = 0, stolen = 0] =
    (readFileSync('/proc/stat', 'utf8').split('\n')[0] ?? '').split(/\s+/).slice(1).map(Number);
  const used = user + nice + system + irq + soft + stolen;
  return { all: used + idle + waiting, used, own: ownTicks() };
}

/** What others take of the machine from now on. */
export class OthersLoad {
  private readonly begin = ticksNow();

  share(): number {
    return othersShare(this.begin, ticksNow());
  }

  quiet(): boolean {
    return this.share() < QUIET_SHARE;
  }
}
