// Which combinations of host, link and languages a run plays a scene in.
//
// Between two programs of TypeScript a scene is played on both links and in both hosts. With Python on one side or on both,
// two of the four combinations are enough to see each pairing in each host and on each link; half of the scenes take the
// one diagonal, half the other. A nightly run plays all four.

import type { LinkKind } from '../../../runtime/site/contract/session.ts';
import { nightly } from '../../support/nightly.ts';

export type Host = 'Node.js' | 'Chromium';

/** `index` is the place of the scene in its list, the same one in both hosts. */
export function isPlayed(host: Host, kind: LinkKind, index: number): boolean {
  return nightly || ((host === 'Node.js') === (kind === 'shared')) === (index % 2 === 0);
}
