// Random scenes on each link against its model. ROS2WASM_SEED repeats the scenes of a run, or with ROS2WASM_SCENES=1 one;
// a nightly run plays more of them.

import { test } from 'node:test';
import { nightly } from '../../support/nightly.ts';
import { Generator } from './generator.ts';
import { PortScene } from './port_scene.ts';
import { SharedScene } from './shared_scene.ts';

const first = Number(process.env['ROS2WASM_SEED'] ?? crypto.getRandomValues(new Uint32Array(1))[0]);
const count = Number(process.env['ROS2WASM_SCENES'] ?? (nightly ? 20_000 : 4_000));

for (const [link, Scene] of [['shared', SharedScene], ['port', PortScene]] as const) {
  test(`random scenes on the ${link} link end as the model says`, { timeout: 600_000 }, (context) => {
    context.diagnostic(`${count} scenes from seed ${first}`);
    for (let seed = first; seed < first + count; seed += 1) {
      const random = new Generator(seed);
      const scene = new Scene(random);
      try {
        scene.run(20 + random.below(80));
      } catch (error) {
        const last = scene.story.slice(-40).join('\n  ');
        throw new Error(`seed ${seed}: ${error instanceof Error ? error.message : String(error)}\n  ${last}`, { cause: error });
      }
    }
  });
}
