// All scenes, in the order in which they run.

import { killScenes } from './kill_scenes.ts';
import { qosScenes } from './qos_scenes.ts';
import { type Scene, scenes } from './scenes.ts';
import { serviceScenes } from './service_scenes.ts';
import { timeScenes } from './time_scenes.ts';

export const allScenes: readonly Scene[] = [...scenes, ...qosScenes, ...serviceScenes, ...killScenes, ...timeScenes];
