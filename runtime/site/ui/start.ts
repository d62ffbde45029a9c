// The page's entry: starts the nodes first, then loads and draws the page (mount.tsx), which would hold them up.
// Runs as soon as it is there, which may be before the body is.

import { startSession } from '../session/launcher.ts';

let keep: (kept: boolean) => void = () => undefined;
const kept = new Promise<boolean>((resolve) => {
  keep = resolve;
});
const session = startSession({
  onOffline: keep,
  // The page's files have them already, for its terminal.
  commands: async (of) => (await (await import('./mount.tsx')).loadCommands())(of),
});

function whenParsed(): Promise<void> {
  if (document.readyState !== 'loading') return Promise.resolve();
  return new Promise((resolve) => {
    document.addEventListener('DOMContentLoaded', () => resolve(), { once: true });
  });
}

const [started] = await Promise.allSettled([session]);
const [{ mountPage }] = await Promise.all([import('./mount.tsx'), whenParsed()]);
const root = document.getElementById('page');
// The page shows a failure too.
if (root !== null) mountPage(root, started, kept);
