// Both links under Node.js worker threads.

import { test } from 'node:test';
import type { LinkKind } from '../../../runtime/site/contract/session.ts';
import { allScenes } from './all_scenes.ts';
import { startNodeWorker } from './node_start.ts';
import { World } from './world.ts';

const watchdogMs = 120_000;

for (const kind of ['shared', 'port'] as const satisfies readonly LinkKind[]) {
  for (const scene of allScenes) {
    test(`${kind}: ${scene.name}`, { timeout: watchdogMs }, async () => {
      const world = new World(kind, startNodeWorker);
      try {
        await scene.run(world);
      } finally {
        await world.close();
      }
    });
  }
}
