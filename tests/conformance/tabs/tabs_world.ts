// A world of two or three tabs with a bridge between each two. Peers come up in one tab after the other, so that every
// scene for a link is one for tabs too.

import type { Broker } from '../../../runtime/site/bus/broker.ts';
import { openLink } from '../../../runtime/site/bus/open_link.ts';
import type { LinkKind } from '../../../runtime/site/contract/session.ts';
import { TabBridge, tabChannel } from '../../../runtime/site/bus/tab_bridge.ts';
import { newBroker, type RawWorker, type RemotePeer, World } from '../links/world.ts';

interface Half {
  readonly broker: Broker;
  readonly participant: number;
  readonly bridge: TabBridge;
}

let pairs = 0;

function half(broker: Broker, channel: string): Half {
  const { participant, ticket } = broker.admit()!;
  const bridge = new TabBridge(openLink(ticket, false), tabChannel(new BroadcastChannel(channel)));
  void bridge.run();
  return { broker, participant, bridge };
}

export class TabsWorld extends World {
  readonly tabs: readonly Broker[];
  private readonly halves: Half[] = [];
  private next = 0;

  constructor(kinds: readonly LinkKind[], start: () => Promise<RawWorker>) {
    super(kinds[0]!, start);
    this.tabs = [this.broker, ...kinds.slice(1).map(newBroker)];
    for (const [i, a] of this.tabs.entries()) {
      for (const b of this.tabs.slice(i + 1)) {
        pairs += 1;
        this.halves.push(half(a, `tabs ${pairs}`), half(b, `tabs ${pairs}`));
      }
    }
  }

  override peer(): Promise<RemotePeer> {
    const broker = this.tabs[this.next % this.tabs.length]!;
    this.next += 1;
    return this.peerOf(broker);
  }

  peerIn(tab: number): Promise<RemotePeer> {
    return this.peerOf(this.tabs[tab]!);
  }

  /** The tab is gone: the others see it as the page does. */
  kill(tab: number): void {
    const [a, b] = this.halves as [Half, Half];
    const other = this.tabs[tab] === a.broker ? b : a;
    other.broker.end(other.participant, false);
  }

  override async close(): Promise<void> {
    for (const { bridge } of this.halves) bridge.close();
    await super.close();
    for (const broker of this.tabs) broker.close();
  }
}
