// The page's entry: starts the session at once, and draws while it starts.

import { startSession } from '../wasm_js/launcher.ts';
import { mountPage } from './mount.tsx';

const root = document.getElementById('page');
if (root !== null) {
  let keep: (kept: boolean) => void = () => undefined;
  const kept = new Promise<boolean>((resolve) => {
    keep = resolve;
  });
  mountPage(root, startSession({ onOffline: keep }), kept);
}
