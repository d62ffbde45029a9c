// Conformance workers whose program is Python, as Node.js worker threads. One that has done its part in a scene is kept
// for the next: an interpreter takes longer to start than most scenes last.

import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import type { PythonPeerData } from './python_peer.ts';
import { peerArchive, peerEntry } from './python_serving.ts';
import type { RawWorker } from './world.ts';

const root = fileURLToPath(new URL('../../..', import.meta.url));

/** It is about one message of 300 MB, of which an interpreter would keep three copies to its end. */
export const tooLarge = 'messages larger than there can be room for are refused';

/** Puts what the program needs into a folder. */
export function putPeerArchive(folder: string): void {
  const made = mkdtempSync(join(tmpdir(), 'ros2wasm-python-peer-'));
  const entry = join(made, peerEntry);
  mkdirSync(dirname(entry), { recursive: true });
  copyFileSync(fileURLToPath(new URL('python_peer.py', import.meta.url)), entry);
  execFileSync('python3', [
    join(root, 'tests/support/make_archive.py'),
    join(folder, peerArchive),
    `${dirname(entry)}=${dirname(peerEntry)}`,
    ...['rclpy', 'ros2wasm'].map((name) => `${join(root, 'runtime/packages/client/rclpy', name)}=lib/python3.12/site-packages/${name}`),
  ]);
  rmSync(made, { recursive: true });
}

export class PythonWorkers {
  private readonly folder = mkdtempSync(join(tmpdir(), 'ros2wasm-python-peer-'));
  private readonly idle: Worker[] = [];
  /** How many interpreters were started. */
  started = 0;

  constructor() {
    putPeerArchive(this.folder);
  }

  readonly start = (): Promise<RawWorker> => {
    const worker = this.idle.pop() ?? this.begin();
    return Promise.resolve({
      post: (message, transfer) => worker.postMessage(message, transfer as never),
      onMessage: (listener) => worker.on('message', listener),
      terminate: async () => void (await worker.terminate()),
      release: () => {
        worker.removeAllListeners('message');
        this.idle.push(worker);
      },
    });
  };

  private begin(): Worker {
    this.started += 1;
    const workerData: PythonPeerData = { base: `${this.folder}/` };
    return new Worker(new URL('python_peer.ts', import.meta.url), { workerData });
  }

  async close(): Promise<void> {
    await Promise.all(this.idle.map((worker) => worker.terminate()));
    rmSync(this.folder, { recursive: true });
  }
}
