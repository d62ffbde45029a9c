// Waiting for what only a promise tells: Playwright's waitForFunction takes a promise itself for true.
import assert from 'node:assert/strict';

export async function eventually(what: string, holds: () => Promise<boolean>, longestMs = 100_000): Promise<void> {
  const end = Date.now() + longestMs;
  while (!await holds()) {
    assert.ok(Date.now() < end, what);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}
