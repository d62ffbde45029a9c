// Where the fields of a SampleInfo are, in Int32 words: in front of a payload, and in what a program gives and gets.

import { SampleInfoLayout } from '../../protocol/generated/constants.ts';

export const InfoWord = {
  length: SampleInfoLayout.length >> 2,
  flags: SampleInfoLayout.flags >> 2,
  sequence: SampleInfoLayout.sequence >> 2,
  sourceTimestamp: SampleInfoLayout.sourceTimestampNs >> 2,
  relatedSequence: SampleInfoLayout.relatedSequence >> 2,
  relatedGid: SampleInfoLayout.relatedGid >> 2,
  writerGid: SampleInfoLayout.writerGid >> 2,
} as const;

/** Words of the whole. */
export const INFO_WORDS = SampleInfoLayout.size >> 2;
/** Words of a gid. */
export const GID_WORDS = InfoWord.writerGid - InfoWord.relatedGid;
