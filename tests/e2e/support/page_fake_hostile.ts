// The scene "hostile_work" of page_fake.tsx: nodes on a real graph whose names, fields, values, states and transitions
// are markup. `globalThis.kept` has the bytes of what was published on /ground, `managed` the managed nodes.

import { createCodec } from '../../../runtime/site/decode/codec.ts';
import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { FakeSession } from '../../unit/ui/fake_session.ts';
import { GraphPeer } from '../../unit/site/graph_peer.ts';
import { HEALTH_INTERFACES, ManagedPeer } from './page_fake_health.ts';
import { followGraph } from './page_fake_graph.ts';

export async function hostileWork(markup: string): Promise<FakeSession> {
  const fake = new FakeSession({
    nodes: [{ executable: 'server' }],
    interfaces: new Map([
      ...HEALTH_INTERFACES,
      ['demo/msg/Word', `string word "${markup.replaceAll('"', "'")}"\n`],
      ['demo/msg/Odd', `string ${markup}\n`],
      ['demo/srv/Echo', `string word "${markup.replaceAll('"', "'")}"\n---\nstring word\nstring[] words\n`],
      ['demo/srv/Odd', `string ${markup}\n---\nstring ${markup}\n`],
    ]),
  });
  const codec = createCodec(await fake.interfaces());
  const peer = new GraphPeer(fake.broker);
  peer.make(EndpointKind.server, 'server', `/${markup}`, 'demo/srv/Echo');
  peer.make(EndpointKind.server, 'server', '/odd_fields', 'demo/srv/Odd');
  peer.make(EndpointKind.server, 'server', '/odd_type', markup);
  peer.make(EndpointKind.subscription, 'server', `/${markup}`, 'demo/msg/Word');
  peer.make(EndpointKind.subscription, 'server', '/odd_fields', 'demo/msg/Odd');
  const echo = peer.make(EndpointKind.server, 'server', '/echo', 'demo/srv/Echo');
  const answer = async (): Promise<void> => {
    for (;;) {
      const request = await peer.next(echo);
      const made = codec.encode('demo/srv/Echo_Response', { word: markup, words: [markup] });
      if (made.kind === 'failed') throw new Error(made.reason);
      peer.write(echo, made.bytes, request);
    }
  };
  void answer();
  const kept: Uint8Array[] = [];
  fake.node().subscription('/ground', 'demo/msg/Word', { depth: 10 }, (bytes) => kept.push(bytes.slice()));
  const dress = (label: string): string => `${markup} ${label}`;
  const managed = [markup, 'driver'].map((name) => new ManagedPeer(fake, codec, name, dress));
  fake.setTopics([{ name: '/ground', type: 'demo/msg/Word' }, { name: `/${markup}`, type: 'demo/msg/Word' }, { name: '/odd_type', type: markup }]);
  followGraph(fake);
  Object.assign(globalThis, { kept, managed });
  return fake;
}
