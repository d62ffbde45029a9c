// The head of a sample as the port link sends it: protocol/SPEC.md, the frame header.

import { EndpointKind } from '../../protocol/generated/constants.ts';
import { putNanoseconds, type SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';

/** Fills `header` and the program's SampleInfo (`given`, from word `at` on). Returns the one client it is for, or 0. */
export function fillHeader(
  record: EndpointRecord, clock: SiteClock, header: Int32Array, given: Int32Array, at: number, sequence: number, length: number,
): number {
  const client = record.kind === EndpointKind.client;
  header[0] = length;
  putNanoseconds(header, 2, sequence);
  if (given[at + 4] === 0 && given[at + 5] === 0) putNanoseconds(header, 4, clock.systemNs());
  else header.set(given.subarray(at + 4, at + 6), 4);
  if (client) {
    putNanoseconds(header, 6, sequence);
    header.set(record.gid, 8);
  } else {
    header.set(given.subarray(at + 6, at + 12), 6);
  }
  header.set(record.gid, 12);
  given.set(header, at);
  return record.kind === EndpointKind.server ? header[10]! : 0;
}
