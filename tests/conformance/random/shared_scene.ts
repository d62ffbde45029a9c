// A random scene on the shared link, where a call's effect is there when it returns: each result is what the model
// says. Nothing may stay behind on the bus.

import { SharedBroker } from '../../../runtime/wasm_js/broker.ts';
import { Bus } from '../../../runtime/wasm_js/bus.ts';
import { SharedLink } from '../../../runtime/wasm_js/shared_link.ts';
import { type Generator } from './generator.ts';
import { Model, type ModelSample } from './model.ts';
import { type Held, type Participant, RandomScene } from './random_scene.ts';

export class SharedScene extends RandomScene {
  private readonly broker = new SharedBroker({ participants: 16, nodes: 16, endpoints: 64, graphLog: 64, ceiling: 32 << 20 });

  constructor(random: Generator) {
    super(random, new Model());
  }

  protected admit(): { index: number; link: SharedLink } {
    const index = this.broker.bus.claimParticipant();
    return { index, link: new SharedLink({ bus: new Bus(this.broker.bus.sab), participant: index, mayBlock: false }) };
  }

  protected end(person: Participant, dies: boolean): void {
    if (!dies) person.link.close();
    this.broker.end(person.index);
  }

  protected expected(reader: Held): ModelSample | undefined {
    return this.model.take(reader.model);
  }

  protected count(person: Participant): void {
    this.compareCounts(person);
  }

  protected meanwhile(): void {}

  protected close(): void {
    this.broker.end(this.broker.link.participant);
    this.broker.close();
    this.equal(this.broker.bus.usage().used, 0, 'pages left behind');
  }
}
