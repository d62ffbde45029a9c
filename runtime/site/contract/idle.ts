// Work of the page that may wait until it has nothing else to do.

const longestMs = 3000;

export function whenIdle(task: () => void): void {
  if ('requestIdleCallback' in globalThis) requestIdleCallback(() => task(), { timeout: longestMs });
  else setTimeout(task, longestMs);
}
