// Both links under Node.js worker threads.

import { test } from 'node:test';
import { Worker } from 'node:worker_threads';
import type { LinkKind } from '../../../runtime/wasm_js/session.ts';
import { scenes } from './scenes.ts';
import { type RawWorker, World } from './world.ts';

const watchdogMs = 30_000;

function start(): Promise<RawWorker> {
  const worker = new Worker(new URL('node_peer.ts', import.meta.url));
  return Promise.resolve({
    post: (message, transfer) => worker.postMessage(message, transfer as never),
    onMessage: (listener) => worker.on('message', listener),
    terminate: async () => void (await worker.terminate()),
  });
}

for (const kind of ['shared', 'port'] as const satisfies readonly LinkKind[]) {
  for (const scene of scenes) {
    test(`${kind}: ${scene.name}`, { timeout: watchdogMs }, async () => {
      const world = new World(kind, start);
      try {
        await scene.run(world);
      } finally {
        await world.close();
      }
    });
  }
}
