// The part of the page's participant that its endpoints use.

import type { Broker } from '../bus/broker.ts';
import type { SiteTimers } from '../bus/site_timers.ts';
import { SiteError } from '../contract/site_error.ts';

/** An endpoint of the page: what it does when there is something to take. */
export interface PageReader {
  readonly handle: number;
  /** Takes one sample; false: there is none. */
  takeOne(): boolean;
}

export interface Taken {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** SampleInfo. */
  readonly words: Int32Array;
}

export type Made = { readonly handle: number; } | { readonly problem: SiteError; };

export interface Watcher {
  /** At an event, before samples are taken. */
  readonly before?: () => void;
  /** When what had come is taken. */
  readonly after: () => void;
}

export interface Participant {
  readonly broker: Broker;
  readonly timers: SiteTimers;
  /** The session ends: nobody answers any more. */
  readonly ending: boolean;
  /** One sample of an own endpoint. */
  take(handle: number): Taken | undefined;
  /** Sends one sample; its sequence number (low word), why not, or a promise of that: it waits for room. */
  write(handle: number, bytes: Uint8Array, name: string): number | SiteError | Promise<SiteError | undefined>;
  /** The endpoint is read from now on. */
  read(reader: PageReader): void;
  unread(handle: number): void;
  watch(watcher: Watcher): () => void;
  forget(closed: { close(): void; }): void;
}

/** Reports a throwing listener to the global error handler, without affecting the others. */
export function guarded(call: () => void): void {
  try {
    call();
  } catch (error) {
    queueMicrotask(() => {
      throw error;
    });
  }
}

export function closedError(name: string): SiteError {
  return new SiteError('R2W0718', `\`${name}\` was closed`);
}
