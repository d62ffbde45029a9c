// The page in the design of the ROS2WASM paper, replayed: every message goes through its main thread as text. It keeps the
// newest of a topic until somebody asks, and sends it then to all workers.

import type { PaperMessage, PaperReport, PaperTask } from './paper_worker.ts';

/** Runs one worker for each task until the first is done; what that one told. */
function runPaperDesign(tasks: readonly PaperTask[]): Promise<readonly number[]> {
  const newest = new Map<string, string>();
  const workers = tasks.map(() => new Worker('paper_worker.js'));
  return new Promise((resolve) => {
    for (const worker of workers) {
      worker.onmessage = ({ data }: MessageEvent<PaperReport>) => {
        switch (data.command) {
          case 'publish':
            newest.set(data.topic, data.message.replaceAll('\n', ', '));
            return;
          case 'retrieve': {
            const { topic } = data;
            const message = newest.get(topic);
            if (message === undefined) return;
            newest.delete(topic);
            for (const each of workers) each.postMessage({ topic, message } satisfies PaperMessage);
            return;
          }
          case 'done':
            if (worker !== workers[0]) return;
            for (const each of workers) each.terminate();
            resolve(data.ms);
            return;
        }
      };
    }
    for (const [i, task] of tasks.entries()) workers[i]?.postMessage({ task });
  });
}

Object.assign(globalThis, { runPaperDesign });
