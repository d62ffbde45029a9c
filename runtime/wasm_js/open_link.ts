// How a worker joins the graph with what the broker gave it.

import { Bus } from './bus.ts';
import type { Link } from './link.ts';
import { PortLink } from './port_link.ts';
import type { PeerPort } from './port_messages.ts';
import { SharedLink } from './shared_link.ts';

/** What a worker needs to join; goes there by postMessage. */
export type LinkTicket =
  | { readonly kind: 'shared'; readonly sab: SharedArrayBuffer; readonly participant: number }
  | {
    readonly kind: 'port';
    readonly participant: number;
    readonly session: readonly [number, number];
    readonly control: MessagePort;
    readonly peers: readonly PeerPort[];
  };

/** Joins the graph from within a worker. */
export function openLink(ticket: LinkTicket, mayBlock: boolean): Link {
  switch (ticket.kind) {
    case 'shared':
      return new SharedLink({ bus: new Bus(ticket.sab), participant: ticket.participant, mayBlock });
    case 'port':
      return new PortLink(ticket);
  }
}
