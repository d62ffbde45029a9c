// A message that is published before a subscription has found its publisher reaches nobody.

import type { PagePublisher } from '../../contract/session.ts';

const kMatchMs = 1000;

/** Until a subscription has found it; no longer than a while. */
export async function matched(publisher: PagePublisher): Promise<void> {
  const end = performance.now() + kMatchMs;
  while (publisher.matched() === 0 && performance.now() < end)
    await new Promise((go) => setTimeout(go, 20));
}
