// A bus with participants for an explored scene: made anew for every run, the same each time.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { BusHeader, EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import type { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import type { EndpointDescription } from '../../../runtime/site/bus/link.ts';
import { defaultQos, type EndpointQos } from '../../../runtime/site/contract/qos.ts';
import type { Run } from './explorer.ts';
import type * as programs from './programs.ts';
import { Snapshot } from './snapshot.ts';
import { steppedBundle } from './stepped_code.ts';
import { Process, type Step, Stepper } from './stepper.ts';

type Programs = typeof programs;

const programsFile = fileURLToPath(new URL('programs.ts', import.meta.url));
const words = 1 << 20;
/** Instead of 4096, so that a few messages fill a history: no less than a ring has to begin with. */
export const keepAllLimit = 8;
const heapBytes = 1 << 18;

/** Atomics themselves, or the bus's own functions in their place. */
const reaching = /\bAtomics\b|\bbus\.(load|store|add|sub|or|exchange|compareExchange)\(/;

const floors = ['contract', 'bus', 'program', 'python', 'workers', 'launch', 'page', 'checks', 'session'];

/** Every file of the runtime that reaches shared memory, and the programs. */
function steppedFiles(): string[] {
  const site = fileURLToPath(new URL('../../../runtime/site/', import.meta.url));
  const files = floors.flatMap((floor) => readdirSync(join(site, floor)).map((file) => join(site, floor, file)));
  return [...files.filter((file) => reaching.test(readFileSync(file, 'utf8'))), programsFile];
}

/** Evaluates the stepped code with a stepper in the place of Atomics and of the clocks. */
export class Laboratory {
  readonly stepper: Stepper;
  readonly code: Programs;

  private constructor(stepper: Stepper, code: Programs) {
    this.stepper = stepper;
    this.code = code;
  }

  static async make(): Promise<Laboratory> {
    const text = await steppedBundle(programsFile, steppedFiles(), { keepAllLimit, serviceLimit: keepAllLimit });
    const stepper = new Stepper(words);
    const performance = { now: () => stepper.now(), timeOrigin: 0 };
    const setInterval = (act: () => unknown): number => stepper.timers.push(act);
    const crypto = { getRandomValues: (array: Int32Array) => array.fill(7) };
    const make = new Function('S', 'performance', 'setInterval', 'clearInterval', 'crypto', `${text}; return stepped;`);
    return new Laboratory(stepper, make(stepper, performance, setInterval, () => undefined, crypto) as Programs);
  }

  /** A call of stepped code outside the scene: in one go. */
  now<T>(call: T): T {
    return this.stepper.drive(call) as T;
  }
}

export interface SceneOptions {
  readonly participants?: number;
  readonly pages?: number;
  readonly endpoints?: number;
}

/** Byte offsets in a scene's bus with the default options. */
export const sceneLayout = { endpoints: 6912, pages: 16384 };

const volatileQos: EndpointQos = { ...defaultQos, depth: 8 };

/** Builds a scene: participants, endpoints, processes and checks. */
export class SceneWorld {
  readonly laboratory: Laboratory;
  readonly broker: SharedBroker;
  private readonly processes: Process[] = [];
  private readonly mortal = new Map<number, number>();
  private readonly checks: (() => void)[] = [];
  private readonly state: object[] = [];
  private lead: { process: number; word: number; } | undefined;

  constructor(laboratory: Laboratory, { participants = 6, pages = 64, endpoints = 8 }: SceneOptions = {}) {
    this.laboratory = laboratory;
    const tables = 1024 + participants * 128 + 8 * 640 + 64 + endpoints * 1088 + 64 * 4;
    const ceiling = tables + (pages + 2) * 4100;
    this.broker = new laboratory.code.SharedBroker({ participants, nodes: 8, endpoints, graphLog: 64, ceiling });
    const { i32 } = this.broker.bus;
    const layout = { endpoints: i32[BusHeader.endpoints], pages: i32[BusHeader.pages] };
    const usual = endpoints === 8 && pages === 64;
    if (usual && JSON.stringify(layout) !== JSON.stringify(sceneLayout)) throw new Error(`sceneLayout is ${JSON.stringify(layout)}`);
  }

  /** A participant with a node of its own (its handle is the participant's index - 1). */
  join(): programs.Hands & { readonly node: number; readonly participant: number; } {
    const { laboratory, broker } = this;
    const participant = laboratory.now(broker.bus.claimParticipant());
    const hands = this.thread({ participant });
    return { ...hands, participant, node: laboratory.now(hands.link.nodeCreate(`n${participant}`, '/')) };
  }

  /** One more thread of a participant. */
  thread({ participant }: { participant: number; }): programs.Hands {
    const { laboratory, broker } = this;
    const bus = new laboratory.code.Bus(broker.bus.memory);
    const link = new laboratory.code.SharedLink({ bus, participant, mayBlock: true });
    const buffer = new ArrayBuffer(heapBytes);
    const heap = { u8: new Uint8Array(buffer), i32: new Int32Array(buffer) };
    this.state.push(link);
    return { link, heap };
  }

  describe({ node }: { node: number; }, kind: number, qos: Partial<EndpointQos> = {}, name = '/x'): EndpointDescription {
    return { kind, node, name, type: 't', hash: '', qos: { ...volatileQos, ...qos }, flags: 0 };
  }

  create(hands: programs.Hands & { node: number; }, kind: number, qos: Partial<EndpointQos> = {}, name = '/x'): number {
    return this.laboratory.now(hands.link.endpointCreate(this.describe(hands, kind, qos, name)));
  }

  publisher(hands: programs.Hands & { node: number; }, qos: Partial<EndpointQos> = {}, name = '/x'): number {
    return this.create(hands, EndpointKind.publisher, qos, name);
  }

  subscription(hands: programs.Hands & { node: number; }, qos: Partial<EndpointQos> = {}, name = '/x'): number {
    return this.create(hands, EndpointKind.subscription, qos, name);
  }

  /** Adds a process; returns its index. */
  process(name: string, start: () => unknown, unborn = false): number {
    const index = this.processes.length;
    this.processes.push(new Process(index, name, start as () => Step, unborn));
    return index;
  }

  /** The process may die anywhere; the broker then clears up after its participant. */
  mayDie(process: number, participant: number): void {
    this.mortal.set(process, this.process('broker', () => this.laboratory.code.bury(this.broker, participant), true));
  }

  /** A list that processes write to; empty at the start of a run. */
  log<T>(): T[] {
    const list: T[] = [];
    this.state.push(list);
    return list;
  }

  /** Takes pages away, so that memory ends sooner. What it returns gives them back. */
  occupy(pages: number): () => void {
    const { bus } = this.broker;
    const owner = 0x7fffffff;
    if (this.laboratory.now(bus.allocate(pages, owner)) < 0) throw new Error(`no ${pages} pages`);
    return () => void this.laboratory.now(bus.freeAll(owner));
  }

  /** Registers an object that a run changes, in addition to links: each run starts with its present content. */
  keep(object: object): void {
    this.state.push(object);
  }

  /** The process goes on alone until it stores to the word. */
  leads(process: number, word: number): void {
    this.lead = { process, word };
  }

  /** To hold at the end of every run. */
  finally(check: () => void): void {
    this.checks.push(check);
  }

  died(process: number): boolean {
    return this.processes[process]!.state === 'dead';
  }

  /** Everybody takes their leave: nothing may stay behind on the bus. */
  closeAll(hands: readonly programs.Hands[]): void {
    const { laboratory, broker } = this;
    for (const { link } of hands) laboratory.now(link.close());
    for (const { link } of hands) laboratory.now(laboratory.code.bury(broker, link.participant));
    for (const act of [...laboratory.stepper.timers]) laboratory.now(act());
    const { used } = laboratory.now(broker.bus.usage());
    if (used !== 0) throw new Error(`${used} pages stay behind`);
    const { endpoints, nodes } = laboratory.now(broker.link.graph());
    if (endpoints.length + nodes.length > 0) throw new Error(`the graph still has ${JSON.stringify([nodes, endpoints])}`);
  }

  /** The scene as it is now is where every run begins. */
  run(): Run {
    const snapshot = new Snapshot([this.state, this.broker, this.processes], this.broker.bus.memory.buffer);
    return {
      restore: () => snapshot.restore(this.laboratory.stepper.changed),
      memory: this.broker.bus.memory,
      processes: this.processes,
      lead: this.lead,
      mortal: this.mortal,
      check: () => {
        for (const check of this.checks) check();
      },
    };
  }
}
