// How a worker joins the graph with what the broker gave it.

import { Bus } from './bus.ts';
import { PortLink } from './port_link.ts';
import type { PortTicket } from './port_messages.ts';
import { SharedLink } from './shared_link.ts';
import { type Rest, Turns } from './turns.ts';

/** The data that a worker needs to join the graph; sent to it by postMessage. */
export type LinkTicket =
  | { readonly kind: 'shared'; readonly memory: WebAssembly.Memory; readonly participant: number; }
  | ({ readonly kind: 'port'; } & PortTicket);

/** Joins the graph from within a worker; in a stepped run `rest` tells the page that it waits. */
export function openLink(ticket: LinkTicket, mayBlock: boolean, rest?: (rest: Rest) => void): SharedLink | PortLink {
  switch (ticket.kind) {
    case 'shared': {
      const { participant } = ticket;
      const bus = new Bus(ticket.memory);
      const turns = rest === undefined ? undefined : new Turns(bus, participant, rest);
      return new SharedLink({ bus, participant, mayBlock, turns });
    }
    case 'port':
      return new PortLink(ticket);
  }
}
