// A random scene on the shared link, where a call's effect is there when it returns: each result is what the model
// says. Nothing may stay behind on the bus.

import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { Bus } from '../../../runtime/site/bus/bus.ts';
import { defaultQos } from '../../../runtime/site/contract/qos.ts';
import { SharedLink } from '../../../runtime/site/bus/shared_link.ts';
import { type Generator } from './generator.ts';
import { Model, type ModelSample } from './model.ts';
import { type Held, type Participant, RandomScene } from './random_scene.ts';

export class SharedScene extends RandomScene {
  private readonly broker = new SharedBroker({ participants: 16, nodes: 16, endpoints: 64, graphLog: 64, ceiling: 32 << 20 });

  constructor(random: Generator) {
    super(random, new Model());
  }

  protected admit(): { index: number; link: SharedLink; } {
    const index = this.broker.bus.claimParticipant();
    return { index, link: new SharedLink({ bus: new Bus(this.broker.bus.memory), participant: index, mayBlock: false }) };
  }

  protected end(person: Participant, dies: boolean): void {
    if (!dies) person.link.close();
    this.broker.end(person.index);
    if (dies) this.runOn(person);
    this.broker.gone(person.index);
  }

  /** A terminated worker goes on for a while: whatever it tries has no effect. */
  private runOn({ link, node, held }: Participant): void {
    const refused = (result: number | Promise<number>): void => this.equal(typeof result === 'number' && result < 0, true, 'refused');
    for (const { handle } of held) {
      refused(link.write(handle, this.heap, 64, 8, 0));
      refused(link.take(handle, this.heap, 64, 1000, 0));
    }
    const description = { kind: EndpointKind.publisher, node, name: '/x', type: 't', hash: '', qos: defaultQos, flags: 0 };
    refused(link.nodeCreate('late', '/'));
    refused(link.endpointCreate(description));
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
    this.broker.gone(this.broker.link.participant);
    this.broker.close();
    this.equal(this.broker.bus.usage().used, 0, 'pages left behind');
  }
}
