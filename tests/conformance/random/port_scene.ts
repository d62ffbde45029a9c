// A random scene on the port link: messages between participants arrive late, and in any order between two channels.

import { ErrorCode } from '../../../runtime/protocol/generated/constants.ts';
import { PortBroker } from '../../../runtime/site/bus/broker.ts';
import { reads } from '../../../runtime/site/bus/graph.ts';
import { PortLink } from '../../../runtime/site/bus/port_link.ts';
import { windowFrames } from '../../../runtime/site/bus/port_writer.ts';
import { type Generator } from './generator.ts';
import { HandNet, type HandPort } from './hand_channel.ts';
import type { ModelEndpoint, ModelSample } from './model.ts';
import { PortModel } from './port_model.ts';
import { type Held, type Participant, RandomScene } from './random_scene.ts';

export class PortScene extends RandomScene {
  private readonly net = new HandNet();
  private readonly broker = new PortBroker(() => this.net.channel());
  private readonly owed: PortModel;

  constructor(random: Generator) {
    const model = new PortModel();
    super(random, model);
    this.owed = model;
  }

  protected admit(): { index: number; link: PortLink; } {
    const { participant, ticket } = this.broker.admit()!;
    if (ticket.kind !== 'port') throw new Error('not a port link');
    for (const port of [ticket.control, ...ticket.peers.map((peer) => peer.port)]) (port as unknown as HandPort).owner = participant;
    return { index: participant, link: new PortLink(ticket) };
  }

  protected end(person: Participant, dies: boolean): void {
    if (dies) {
      this.net.kill(person.index, this.random);
      this.owed.died(person.index);
    }
    person.link.close();
    this.broker.end(person.index, !dies);
  }

  protected expected({ model }: Held, length: number, key: number, sequence: number): ModelSample | undefined {
    if (length === ErrorCode.nothing) return undefined;
    return this.owed.came(model, this.writer(key), sequence);
  }

  private writer(key: number): ModelEndpoint {
    for (const [model, each] of this.keys) if (each === key) return model;
    throw new Error(`nobody has the key ${key}`);
  }

  protected override burst(): number {
    return this.random.pick([12, 12, 30, 150]);
  }

  protected meanwhile(): void {
    const { random } = this;
    for (let left = random.pick([0, 0, 1, 5, 20]); left > 0; left -= 1) this.net.pick(random)?.deliver();
    if (random.chance(10)) this.settle();
    if (random.chance(10)) this.bounded();
  }

  private settle(): void {
    for (let port = this.net.pick(this.random); port !== undefined; port = this.net.pick(this.random)) port.deliver();
    this.story.push('all is quiet');
    this.owed.quiet();
  }

  /** Nobody is flooded. */
  private bounded(): void {
    const live = new Set(this.held().map(({ model }) => this.keys.get(model)));
    const most = this.net.crowd((writer) => live.has(writer));
    if (most > windowFrames) throw new Error(`${most} frames of one writer are on their way`);
  }

  protected count(person: Participant): void {
    this.settle();
    this.compareCounts(person);
    const readers = person.held.filter(({ model }) => reads(model.kind));
    // Each taken sample makes room for more, also for the other readers here.
    let taken: number;
    do {
      taken = readers.reduce((sum, reader) => sum + this.takeFrom(person, reader, Infinity), 0);
      this.settle();
    } while (taken > 0);
    for (const { model } of readers) this.owed.complete(model);
  }

  protected close(): void {
    this.settle();
    this.equal(this.broker.link.records().length, 0, 'endpoints left behind');
    this.equal(this.broker.link.graph().nodes.length, 0, 'nodes left behind');
    this.broker.close();
  }
}
