// The scenes between Python programs, and between Python and TypeScript, on both links under Node.js.

// Compatibility, works: Python on either side of the middleware's scenes, on both links: matching,
// order, depth, transient_local, backpressure, QoS and its events, services, deaths, the graph,
// time that is held, stepped and scaled

import { after, test } from 'node:test';
import type { LinkKind } from '../../../runtime/site/contract/session.ts';
import { allScenes } from './all_scenes.ts';
import { isPlayed } from './combinations.ts';
import { killScenes } from './kill_scenes.ts';
import { startNodeWorker } from './node_start.ts';
import { PythonWorkers, tooLarge } from './python_start.ts';
import { type RawWorker, World } from './world.ts';

const watchdogMs = 120_000;

/** The only pair that plays the kill scenes: both the killed worker and the one that starts then are Python. */
const killing = 'Python to Python';

const python = new PythonWorkers();
after(() => python.close());

type Start = () => Promise<RawWorker>;

/** By turns, in the order in which a scene starts its workers: mostly the one that publishes or serves comes first. */
const sides: Readonly<Record<string, readonly [Start, Start]>> = {
  'Python to Python': [python.start, python.start],
  'Python to TypeScript': [python.start, startNodeWorker],
  'TypeScript to Python': [startNodeWorker, python.start],
};

for (const kind of ['shared', 'port'] as const satisfies readonly LinkKind[]) {
  for (const [between, starts] of Object.entries(sides)) {
    for (const [index, scene] of allScenes.entries()) {
      if (scene.name === tooLarge) continue;
      if (killScenes.includes(scene) ? between !== killing : !isPlayed('Node.js', kind, index)) continue;
      test(`${kind}, ${between}: ${scene.name}`, { timeout: watchdogMs }, async () => {
        let begun = 0;
        const world = new World(kind, () => starts[begun++ % 2]!());
        try {
          await scene.run(world);
        } finally {
          await world.close();
        }
      });
    }
  }
}
