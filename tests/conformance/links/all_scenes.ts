// All scenes, in the order in which they run.

import { qosScenes } from './qos_scenes.ts';
import { type Scene, scenes } from './scenes.ts';

export const allScenes: readonly Scene[] = [...scenes, ...qosScenes];
