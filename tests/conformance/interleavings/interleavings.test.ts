// All interleavings of small scenes on the shared bus, over the runtime's own code.

import { before, test } from 'node:test';
import { explore } from './explorer.ts';
import { scenes } from './scenes.ts';
import { Laboratory } from './world.ts';

let laboratory: Laboratory;

before(async () => {
  laboratory = await Laboratory.make();
});

for (const { name, make, limits } of scenes) {
  test(name, { timeout: 300_000 }, (context) => {
    const { states, runs } = explore(laboratory.stepper, () => make(laboratory), { interruptions: 2, ...limits });
    context.diagnostic(`${states} states in ${runs} runs`);
  });
}
