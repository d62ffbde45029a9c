// Gives workers their place on the bus (or in the mesh of ports) and clears up after them. Lives on the page's main
// thread and is never in the path of a message.

import { BusEndpoint, BusHeader, BusNode, BusParticipant, BusParticipantState, BusPhase, EndpointKind } from '../../protocol/generated/constants.ts';
import { type Bus, createBus, type BusOptions } from './bus.ts';
import { bumpGeneration, departEndpoint, logChange, nodeBit, readEndpoint, releaseEndpoint } from './bus_tables.ts';
import { Conductor } from './conductor.ts';
import { ordinaryTime, type TimeLaw } from './time_law.ts';
import { SharedCredit } from './console_sender.ts';
import { type EndpointRecord, relate } from './graph.ts';
import type { LinkTicket } from './open_link.ts';
import { PortLink } from './port_link.ts';
import type { PeerPort } from './port_messages.ts';
import { endpointKey, keyIndex, previousGeneration } from './shared_ring.ts';
import { SharedLink } from './shared_link.ts';
import type { Rest } from './turns.ts';
import { unread } from './unread.ts';

export interface Admission {
  readonly participant: number;
  readonly ticket: LinkTicket;
  readonly transfer: readonly MessagePort[];
}

export interface Broker {
  readonly kind: 'shared' | 'port';
  /** The page's own place; it must not block. */
  readonly link: SharedLink | PortLink;
  /** Set in a stepped run only. */
  readonly conductor: Conductor | undefined;
  /** A place for a worker; undefined when all are taken. */
  admit(): Admission | undefined;
  /** Time of the site follows another law from now on. */
  setTime(law: TimeLaw): void;
  /** In a stepped run: the participant waits. */
  rests(participant: number, rest: Rest): void;
  /** In a stepped run: called when a participant has come to rest or ended, before others go on. */
  onRest(call: () => void): void;
  /** The page itself has written. */
  wrote(): void;
  /** Calls `then` when the time has passed, in a stepped run that of the site; the result takes it back. */
  after(ms: number, then: () => void): () => void;
  /** As SIGINT. */
  stop(participant: number): void;
  /** The worker is terminated: its endpoints vanish. `closed`: it took its leave itself. */
  end(participant: number, closed: boolean): void;
  /** After `end`: none of its workers runs any more, so what they had may be given to others. */
  gone(participant: number): void;
  /** Called when a participant has sent a message that no program built by ros2wasm sends. */
  onStrange(call: (participant: number) => void): void;
  /** A batch of console lines of the participant was dealt with. */
  consoleSeen(participant: number): void;
  /** Batches that threads of the participant may have posted and that were not dealt with yet. */
  consoleAhead(participant: number): number;
  close(): void;
}

export interface SharedBrokerOptions extends BusOptions {
  /** One participant runs at a time. */
  readonly stepped?: boolean;
}

/** The options of a stepped run. With a random session the gids, and all that programs derive from them, would differ in each run. */
export function steppedBus(seed: number): SharedBrokerOptions {
  return { session: [0, seed], stepped: true };
}

function afterRealTime(ms: number, then: () => void): () => void {
  const timer = setTimeout(then, ms);
  return () => clearTimeout(timer);
}

export class SharedBroker implements Broker {
  readonly kind = 'shared';
  readonly bus: Bus;
  readonly link: SharedLink;
  private readonly lingering = new Set<number>();
  private timer: ReturnType<typeof setInterval> | undefined;
  private closed = false;
  private rested: () => void = () => undefined;
  readonly conductor: Conductor | undefined;

  constructor(options: SharedBrokerOptions = {}) {
    this.bus = createBus(options);
    this.conductor = options.stepped === true ? new Conductor(this.bus) : undefined;
    this.link = new SharedLink({ bus: this.bus, participant: this.bus.claimParticipant(), mayBlock: false });
  }

  admit(): Admission | undefined {
    const participant = this.bus.claimParticipant();
    if (participant < 0) return undefined;
    this.conductor?.expect(participant);
    return { participant, ticket: { kind: 'shared', memory: this.bus.memory, participant }, transfer: [] };
  }

  setTime(law: TimeLaw): void {
    this.bus.setTime(law);
    this.bus.rouseAll();
  }

  onRest(call: () => void): void {
    if (this.conductor !== undefined) this.rested = call;
  }

  rests(participant: number, rest: Rest): void {
    this.rested();
    this.conductor?.rests(participant, rest);
  }

  wrote(): void {
    this.conductor?.conduct();
  }

  /** Nobody can tell who wrote into shared memory. */
  onStrange(): void {}

  after(ms: number, then: () => void): () => void {
    return this.conductor === undefined ? afterRealTime(ms, then) : this.conductor.after(ms * 1e6, then);
  }

  stop(participant: number): void {
    this.bus.requestStop(participant);
    this.conductor?.conduct();
  }

  /** Workers of the participant may run on for seconds: nothing of theirs is freed here. */
  end(participant: number): void {
    const { bus } = this;
    bus.store(bus.participantWord(participant) + BusParticipant.state, BusParticipantState.ended);
    bus.store(bus.participantWord(participant) + BusParticipant.graphInterest, 0);
    this.rested();
    this.depart(participant, false);
  }

  gone(participant: number): void {
    if (this.closed) return;
    // Frees the endpoints that its workers were creating or freeing when they stopped.
    this.depart(participant, true);
    this.lingering.add(participant);
    this.reap();
  }

  /** Takes what the participant has out of the graph; when it is `gone`, frees what it had in hand. */
  private depart(participant: number, gone: boolean): void {
    const { bus } = this;
    const mine = (participant + 1) << 8;
    const endpoints = bus.used(BusHeader.endpointHigh, bus.endpointCount);
    for (let index = 0; index < bus.endpointCount; index += 1) {
      const word = bus.endpointWord(index);
      const state = bus.load(word);
      if (state === 0 && index >= endpoints) break;
      if ((state & ~255) !== mine) continue;
      const generation = bus.load(word + BusEndpoint.generation);
      if ((state & 255) === BusPhase.claimed) {
        if (!gone) continue;
        // It died while it made or freed this one: nobody else has seen it.
        if (generation !== 0) {
          bus.freeAll(endpointKey(index, generation));
          bus.freeAll(endpointKey(index, previousGeneration(generation)));
          bumpGeneration(bus, word);
        }
        bus.store(word, BusPhase.free);
        logChange(bus, index);
      } else {
        const record = readEndpoint(bus, index)?.record;
        if (!departEndpoint(bus, endpointKey(index, generation), participant)) {
          // It may have died before it could log the departure.
          logChange(bus, index);
        } else if (record?.kind === EndpointKind.publisher) {
          this.tellDeath(record);
        }
      }
    }
    const nodes = bus.used(BusHeader.nodeHigh, bus.nodeCount);
    for (let index = 0; index < bus.nodeCount; index += 1) {
      const word = bus.nodeWord(index);
      const state = bus.load(word + BusNode.state);
      if (state === 0 && index >= nodes) break;
      if ((state & ~255) !== mine) continue;
      if (gone) bus.store(word + BusNode.state, BusPhase.free);
      else if ((state & 255) === BusPhase.live) bus.compareExchange(word + BusNode.state, state, mine | BusPhase.departed);
      logChange(bus, nodeBit | index);
    }
    for (let other = 0; other < bus.participantCount; other += 1) {
      const state = bus.load(bus.participantWord(other) + BusParticipant.state);
      if (state === BusParticipantState.live) bus.bump(other);
    }
    this.conductor?.leaves(participant);
  }

  /** Its readers count a writer that ended without taking leave as not alive. */
  private tellDeath(writer: EndpointRecord): void {
    const { bus } = this;
    const length = bus.i32[bus.endpointWord(keyIndex(writer.key)) + BusEndpoint.nameLength];
    for (let index = 0; index < bus.used(BusHeader.endpointHigh, bus.endpointCount); index += 1) {
      const word = bus.endpointWord(index);
      if ((bus.load(word) & 255) !== BusPhase.live) continue;
      if (bus.i32[word + BusEndpoint.kind] !== EndpointKind.subscription) continue;
      // Saves reading the names of most.
      if (bus.i32[word + BusEndpoint.nameLength] !== length) continue;
      const reader = readEndpoint(bus, index)?.record;
      if (reader === undefined || relate(reader, writer).kind !== 'match') continue;
      bus.add(word + BusEndpoint.died, 1);
      bus.noteStatus(reader.participant);
    }
  }

  /** Frees what the ended have left behind once it is read. */
  private reap(): void {
    for (const participant of [...this.lingering]) if (this.release(participant)) this.lingering.delete(participant);
    if (this.lingering.size > 0 && this.timer === undefined) {
      this.timer = setInterval(() => this.reap(), 500);
      if (typeof this.timer === 'object') this.timer.unref();
    }
    if (this.lingering.size === 0 && this.timer !== undefined) {
      clearInterval(this.timer);
      this.timer = undefined;
    }
  }

  private release(participant: number): boolean {
    const { bus } = this;
    const departed = ((participant + 1) << 8) | BusPhase.departed;
    const endpoints = bus.used(BusHeader.endpointHigh, bus.endpointCount);
    let left = 0;
    for (let index = 0; index < endpoints; index += 1) {
      const word = bus.endpointWord(index);
      if (bus.load(word) !== departed) continue;
      const key = endpointKey(index, bus.load(word + BusEndpoint.generation));
      if (unread(bus, key)) left += 1;
      else releaseEndpoint(bus, key, participant, true);
    }
    if (left > 0) return false;
    bus.store(bus.participantWord(participant) + BusParticipant.state, BusParticipantState.free);
    return true;
  }

  consoleSeen(participant: number): void {
    this.bus.add(this.bus.participantWord(participant) + BusParticipant.consoleSeen, 1);
  }

  consoleAhead(participant: number): number {
    return new SharedCredit(this.bus, this.bus.participantWord(participant)).ahead();
  }

  close(): void {
    this.closed = true;
    if (this.timer !== undefined) clearInterval(this.timer);
    this.timer = undefined;
    this.lingering.clear();
  }
}

/** Beside the page itself; more do not fit into the keys of endpoints. */
const mostParticipants = 0x7ff;

export class PortBroker implements Broker {
  readonly kind = 'port';
  readonly link: PortLink;
  /** Runs are not stepped here: nobody can tell what is on its way in a port. */
  readonly conductor = undefined;
  private readonly session: readonly [number, number];
  private readonly controls = new Map<number, MessagePort>();
  private readonly newChannel: () => MessageChannel;
  private last = 0;
  private time: TimeLaw = ordinaryTime;

  /** `newChannel`: for tests that say themselves when a message arrives. */
  constructor(newChannel = () => new MessageChannel()) {
    this.newChannel = newChannel;
    const random = crypto.getRandomValues(new Int32Array(2));
    this.session = [random[0] ?? 0, random[1] ?? 0];
    const { port1, port2 } = newChannel();
    this.controls.set(0, port1);
    this.link = new PortLink({ participant: 0, session: this.session, time: this.time, control: port2, peers: [], known: { nodes: [], endpoints: [] } });
  }

  admit(): Admission | undefined {
    const participant = this.freeNumber();
    if (participant === undefined) return undefined;
    const control = this.newChannel();
    const known = this.link.made();
    const peers: PeerPort[] = [];
    for (const [other, port] of this.controls) {
      const channel = this.newChannel();
      const message: PeerPort = { participant, port: channel.port1 };
      if (other === 0) this.link.addPeer(message, true);
      else port.postMessage({ t: 'peer', peer: message }, [channel.port1]);
      peers.push({ participant: other, port: channel.port2 });
    }
    this.controls.set(participant, control.port1);
    const { session, time } = this;
    const ticket: LinkTicket = { kind: 'port', participant, session, time, control: control.port2, peers, known };
    return { participant, ticket, transfer: [control.port2, ...peers.map((peer) => peer.port)] };
  }

  /** In turn, so that a number rests as long as may be before it comes again. */
  private freeNumber(): number | undefined {
    if (this.controls.size > mostParticipants) return undefined;
    do this.last = this.last % mostParticipants + 1; while (this.controls.has(this.last));
    return this.last;
  }

  setTime(law: TimeLaw): void {
    this.time = law;
    for (const [participant, port] of this.controls) {
      if (participant === 0) this.link.setTime(law);
      else port.postMessage({ t: 'time', law });
    }
  }

  onStrange(call: (participant: number) => void): void {
    this.link.strange = call;
  }

  rests(): void {}

  onRest(): void {}

  wrote(): void {}

  after(ms: number, then: () => void): () => void {
    return afterRealTime(ms, then);
  }

  stop(participant: number): void {
    this.controls.get(participant)?.postMessage({ t: 'stop' });
  }

  end(participant: number, closed: boolean): void {
    this.controls.get(participant)?.close();
    this.controls.delete(participant);
    if (closed) return;
    for (const [other, port] of this.controls) {
      if (other === 0) this.link.dropPeer(participant, true);
      else port.postMessage({ t: 'gone', participant });
    }
  }

  /** Nothing is shared that it could still write to. */
  gone(): void {}

  consoleSeen(participant: number): void {
    this.controls.get(participant)?.postMessage({ t: 'seen' });
  }

  /** Programs on this link have no threads. */
  consoleAhead(): number {
    return 0;
  }

  close(): void {
    this.link.close();
    for (const port of this.controls.values()) port.close();
    this.controls.clear();
  }
}
