// How a page learns that a worker runs no more. A browser ends a busy worker some time after terminate() (Chromium: two
// seconds) and tells nobody; a Web Lock that the worker holds comes free when it is really over.

/** Longer than a browser lets a terminated worker run on. */
const restMs = 4000;

function lockManager(): LockManager | undefined {
  return (navigator as { locks?: LockManager; }).locks;
}

/** Name of a lock for one worker. */
export function newLife(): string {
  return `ros2wasm worker ${crypto.getRandomValues(new Uint32Array(4)).join('-')}`;
}

/** In the worker, before it runs anything: resolves when the lock is held, which it is as long as the worker lives. */
export function holdLife(life: string, locks: LockManager | undefined): Promise<void> {
  return new Promise((resolve) => {
    const held = (): Promise<never> => {
      resolve();
      return new Promise(() => undefined);
    };
    // Some pages may not lock (file:, a sandbox): then the page waits for a time instead.
    if (locks === undefined) resolve();
    else locks.request(life, held).catch(() => resolve());
  });
}

/** On the page, after terminate(): resolves when the worker runs no more. */
export async function lifeOver(life: string): Promise<void> {
  try {
    const locks = lockManager();
    if (locks !== undefined) return await locks.request(life, () => undefined);
  } catch {
    // As in holdLife.
  }
  await new Promise((resolve) => setTimeout(resolve, restMs));
}
