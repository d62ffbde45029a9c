// Conformance workers as Node.js worker threads.

import { Worker } from 'node:worker_threads';
import type { RawWorker } from './world.ts';

export function startNodeWorker(): Promise<RawWorker> {
  const worker = new Worker(new URL('node_peer.ts', import.meta.url));
  return Promise.resolve({
    post: (message, transfer) => worker.postMessage(message, transfer as never),
    onMessage: (listener) => worker.on('message', listener),
    terminate: async () => void (await worker.terminate()),
  });
}
