// The head of a sample as the port link sends it: protocol/SPEC.md, the frame header.

import { EndpointKind } from '../../protocol/generated/constants.ts';
import { putNanoseconds, type SiteClock } from './clock.ts';
import type { EndpointRecord } from './graph.ts';
import { InfoWord } from './sample_info.ts';

/** The word of a gid that has the endpoint's key. */
const KEY_WORD = 2;

/** Fills `header` and the program's SampleInfo (`given`, from word `at` on). Returns the one client it is for, or 0. */
export function fillHeader(
  record: EndpointRecord,
  clock: SiteClock,
  header: Int32Array,
  given: Int32Array,
  at: number,
  sequence: number,
  length: number,
): number {
  const client = record.kind === EndpointKind.client;
  const { sourceTimestamp: stamp, relatedSequence, relatedGid, writerGid } = InfoWord;
  header[InfoWord.length] = length;
  putNanoseconds(header, InfoWord.sequence, sequence);
  if (given[at + stamp] === 0 && given[at + stamp + 1] === 0) putNanoseconds(header, stamp, clock.systemNs());
  else header.set(given.subarray(at + stamp, at + stamp + 2), stamp);
  if (client) {
    putNanoseconds(header, relatedSequence, sequence);
    header.set(record.gid, relatedGid);
  } else {
    header.set(given.subarray(at + relatedSequence, at + writerGid), relatedSequence);
  }
  header.set(record.gid, writerGid);
  given.set(header, at);
  return record.kind === EndpointKind.server ? header[relatedGid + KEY_WORD]! : 0;
}
