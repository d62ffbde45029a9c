// Visits the interleavings of a scene's processes: depth first, a run from the start for each branch, and no state
// twice. Two runs are in the same state when the shared memory is the same and every process has read the same so far.
// A mortal process may die before each of its accesses.

import type { Process, Stepper } from './stepper.ts';

export interface Run {
  readonly memory: WebAssembly.Memory;
  readonly processes: Process[];
  /** From a process that may die to the process that starts then (the broker, clearing up); indices of processes. */
  readonly mortal: ReadonlyMap<number, number>;
  /** Goes on alone, before all others, until it is about to store to the word. */
  readonly lead: { readonly process: number; readonly word: number; } | undefined;
  /** Back to the beginning. */
  restore(): void;
  /** Called when nobody can go on. Throws when something is not as it must be. */
  check(): void;
}

export interface Limits {
  /** How often a process may be interrupted that could go on; endless when omitted. */
  readonly interruptions?: number;
  /** Most deaths in a run. */
  readonly deaths?: number;
  /** Words whose accesses are points; the others are then passed over, so that more interruptions can be had. */
  readonly focus?: (word: number) => boolean;
  /** Ends the search when there are this many states: a scene must be made smaller then. */
  readonly states?: number;
}

export interface Visited {
  readonly states: number;
  readonly runs: number;
  readonly complete: number;
  readonly passes: number;
}

/** Process to go on with; below 0: process -choice - 1 dies. */
type Choice = number;

interface Branch {
  readonly choices: readonly Choice[];
  taken: number;
}

class Execution {
  readonly run: Run;
  private readonly stepper: Stepper;
  private readonly limits: Limits;
  private last = -1;
  private interruptions = 0;
  private deaths = 0;

  constructor(stepper: Stepper, run: Run, limits: Limits) {
    this.stepper = stepper;
    this.run = run;
    this.limits = limits;
    stepper.begin(run.processes);
    for (const process of run.processes) if (process.state === 'ready') this.advance(process);
    if (run.lead === undefined) return;
    const leader = run.processes[run.lead.process]!;
    while (leader.state === 'ready' && !(leader.operation === stepper.store && leader.at === run.lead.word)) this.advance(leader);
  }

  private advance(process: Process): void {
    this.stepper.current = process;
    process.resume();
    this.stepper.current = undefined;
  }

  choices(): Choice[] {
    const { processes, mortal } = this.run;
    const able = processes.filter((process) => process.state === 'ready').map((process) => process.index);
    const choices: Choice[] = [];
    const mayGoOn = able.includes(this.last);
    if (mayGoOn) choices.push(this.last);
    if (!mayGoOn || this.interruptions < (this.limits.interruptions ?? Infinity)) {
      choices.push(...able.filter((index) => index !== this.last));
    }
    // To die later is the same as not to go on: only who has just moved, or nobody yet, need die here.
    if (this.deaths < (this.limits.deaths ?? 0)) {
      for (const index of mortal.keys()) {
        const { state } = processes[index]!;
        if ((index === this.last || this.last < 0) && (state === 'ready' || state === 'asleep')) choices.push(-index - 1);
      }
    }
    return choices;
  }

  take(choice: Choice): void {
    const { processes, mortal } = this.run;
    if (choice < 0) {
      const index = -choice - 1;
      processes[index]!.state = 'dead';
      this.deaths += 1;
      const heir = processes[mortal.get(index)!]!;
      heir.state = 'ready';
      this.advance(heir);
      return;
    }
    if (this.last >= 0 && choice !== this.last && processes[this.last]!.state === 'ready') this.interruptions += 1;
    this.last = choice;
    this.advance(processes[choice]!);
  }

  key(): number {
    const { stepper } = this;
    let high = stepper.memory;
    let low = stepper.memoryToo;
    for (const { index, state, history } of this.run.processes) {
      const here = Math.imul(history ^ Math.imul(index + 1, 0x27d4eb2f), 0x165667b1) ^ (state.charCodeAt(1) << (index * 3));
      high = Math.imul(high, 31) + here | 0;
      low = (Math.imul(low, 0x01000193) ^ here ^ (here >>> 11)) | 0;
    }
    const bounded = this.limits.interruptions === undefined ? 0 : this.interruptions;
    // The process that moved last is part of the state: it decides which may die and which is interrupted.
    high = Math.imul(high, 33) + this.last * 7 + bounded * 64 + this.deaths * 1024 | 0;
    return (high >>> 0) * 2 ** 21 + ((low >>> 0) & 0x1fffff);
  }

  /** Nobody can go on. */
  finish(): void {
    const stuck = this.run.processes.filter((process) => process.state === 'asleep' || process.state === 'ready');
    if (stuck.length > 0) throw new Error(`sleeps for ever: ${stuck.map((process) => process.name).join(', ')}`);
    this.run.check();
  }
}

/** A failure with the choices that lead to it. */
export class Found extends Error {
  readonly choices: readonly Choice[];

  constructor(cause: unknown, choices: readonly Choice[]) {
    super(`${cause instanceof Error ? cause.message : String(cause)}\nafter the choices [${shortened(choices)}]`, { cause });
    this.choices = choices;
  }
}

function shortened(choices: readonly Choice[]): string {
  const parts: string[] = [];
  for (let i = 0; i < choices.length;) {
    let n = 1;
    while (choices[i + n] === choices[i]) n += 1;
    parts.push(n === 1 ? `${choices[i]}` : `${choices[i]}x${n}`);
    i += n;
  }
  return parts.join(' ');
}

/** A scene that can be begun again and again. A buffer cannot shrink: when it grew, the scene is made anew. */
class Beginning {
  private readonly make: () => Run;
  private run: Run;
  private readonly size: number;

  constructor(make: () => Run) {
    this.make = make;
    this.run = make();
    this.size = this.run.memory.buffer.byteLength;
  }

  begin(): Run {
    if (this.run.memory.buffer.byteLength !== this.size) this.run = this.make();
    this.run.restore();
    return this.run;
  }
}

/** Visits them all; throws Found at the first fault. */
export function explore(stepper: Stepper, make: () => Run, limits: Limits = {}): Visited {
  const beginning = new Beginning(make);
  stepper.accesses.forget();
  let passes = 0;
  let runs = 0;
  for (;;) {
    passes += 1;
    stepper.accesses.learn(limits.focus ?? (() => true));
    const pass = explorePass(stepper, beginning, limits);
    runs += pass.runs;
    // Had it been known which words are contended, there would have been more points.
    if (!stepper.accesses.grown) return { ...pass, runs, passes };
  }
}

function explorePass(stepper: Stepper, beginning: Beginning, limits: Limits): Omit<Visited, 'passes'> {
  const visited = new Set<number>();
  const branches: Branch[] = [];
  let runs = 0;
  let complete = 0;
  for (;;) {
    runs += 1;
    const taken: Choice[] = [];
    try {
      const execution = new Execution(stepper, beginning.begin(), limits);
      for (const { choices, taken: index } of branches) {
        const choice = choices[index]!;
        taken.push(choice);
        execution.take(choice);
      }
      for (;;) {
        const key = execution.key();
        if (visited.has(key)) break;
        visited.add(key);
        if (visited.size > (limits.states ?? 2_000_000)) throw new Error(`more than ${limits.states} states`);
        const choices = execution.choices();
        if (choices.every((choice) => choice < 0)) {
          complete += 1;
          execution.finish();
        }
        if (choices.length === 0) break;
        branches.push({ choices, taken: 0 });
        taken.push(choices[0]!);
        execution.take(choices[0]!);
      }
    } catch (error) {
      throw new Found(error, taken);
    }
    while (branches.length > 0) {
      const branch = branches[branches.length - 1]!;
      branch.taken += 1;
      if (branch.taken < branch.choices.length) break;
      branches.pop();
    }
    if (branches.length === 0) return { states: visited.size, runs, complete };
    // Contended words found on the way change where the points are: begin anew.
    if (stepper.accesses.grown && runs > 500) return { states: visited.size, runs, complete };
  }
}
