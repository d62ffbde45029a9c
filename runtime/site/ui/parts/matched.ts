// A message that is published before a subscription has found its publisher reaches nobody.

import type { PagePublisher } from '../../contract/session.ts';

const MATCH_MS = 1000;

/** Until a subscription has found it; no longer than a while. */
export async function matched(publisher: PagePublisher): Promise<void> {
  const end = performance.now() + MATCH_MS;
  while (publisher.matched() === 0 && performance.now() < end)
    await new Promise((go) => setTimeout(go, 20));
}
