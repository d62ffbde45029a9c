// How a graph reaches another one: a bridge is a participant here that makes, for each endpoint over there, one of the
// same name, type and QoS (a mirror), and carries what comes to it. Plug point: one file per way, such as tab_bridge.ts.

import type { PortLink } from './port_link.ts';
import type { SharedLink } from './shared_link.ts';

/** The two bridges of a pair speak over this; what was sent before both are there may be lost. */
export interface BridgeChannel {
  post(message: unknown): void;
  listen(listener: (message: unknown) => void): void;
  close(): void;
}

export interface Bridge {
  /** Carries until it is closed. */
  run(): Promise<void>;
  /** Takes leave of the graph here; the bridge over there is told. */
  close(): void;
}

export type BridgeLink = SharedLink | PortLink;
