// The page's data about publishers elsewhere on the port link: their answers, and the last sample of each one that left,
// which is stored until the page has looked twice.

import { EndpointKind, flagHidden } from '../../protocol/generated/constants.ts';
import type { EndpointRecord } from './graph.ts';
import type { WriterSample } from './port_messages.ts';

/** More than leave between two looks; nobody may be looking any more. */
const mostDeparted = 256;

export class PortSamples {
  /** By the key of the publisher. */
  readonly samples = new Map<number, WriterSample>();
  private looks = false;
  private fresh: EndpointRecord[] = [];
  private told: EndpointRecord[] = [];

  note(sample: WriterSample): void {
    this.samples.set(sample.key, sample);
  }

  forget(key: number): void {
    this.samples.delete(key);
  }

  /** A publisher that did this left. */
  leave(record: EndpointRecord | undefined, last: WriterSample | undefined): void {
    if (!this.looks || record?.kind !== EndpointKind.publisher || last === undefined) return;
    if ((record.flags & flagHidden) !== 0 || this.fresh.length >= mostDeparted) return;
    this.fresh.push(record);
    this.note(last);
  }

  /** The page begins a look: what was there at the one before is not needed any more. */
  look(): void {
    this.looks = true;
    for (const { key } of this.told) this.forget(key);
    this.told = this.fresh;
    this.fresh = [];
  }

  departed(): readonly EndpointRecord[] {
    return [...this.told, ...this.fresh];
  }
}
