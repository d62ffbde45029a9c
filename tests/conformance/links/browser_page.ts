// Runs scenes in a page; the test calls runScene.

import type { LinkKind } from '../../../runtime/site/contract/session.ts';
import { lifeOver, newLife } from '../../../runtime/site/workers/worker_life.ts';
import { allScenes } from './all_scenes.ts';
import { type RawWorker, World } from './world.ts';

type Start = () => Promise<RawWorker>;

function begin(script: string): RawWorker {
  const worker = new Worker(script);
  const life = newLife();
  worker.postMessage({ life });
  return {
    post: (message, transfer) => worker.postMessage(message, [...transfer]),
    onMessage: (listener) => {
      worker.onmessage = (event: MessageEvent<unknown>) => listener(event.data);
    },
    terminate: () => {
      worker.terminate();
      return lifeOver(life);
    },
  };
}

const start: Start = () => Promise.resolve(begin('browser_peer.js'));

/** Interpreters that have done their part in a scene: they take longer to start than most scenes last. */
const idle: RawWorker[] = [];

const startPython: Start = () => {
  const worker = idle.pop() ?? begin('python_browser_peer.js');
  return Promise.resolve({ ...worker, release: () => void idle.push(worker) });
};

/** Between whom a scene is, by turns in the order in which it starts its workers. */
const sides: Readonly<Record<string, readonly [Start, Start]>> = {
  TypeScript: [start, start],
  'Python to TypeScript': [startPython, start],
  'TypeScript to Python': [start, startPython],
  'Python to Python': [startPython, startPython],
};

/** Undefined when the link did what it must, else what it did instead. */
async function runScene(kind: LinkKind, name: string, between: string): Promise<string | undefined> {
  const scene = allScenes.find((each) => each.name === name);
  if (scene === undefined) return `no scene ${name}`;
  const starts = sides[between];
  if (starts === undefined) return `nobody for ${between}`;
  let begun = 0;
  const world = new World(kind, () => starts[begun++ % 2]!());
  try {
    await scene.run(world);
    return undefined;
  } catch (error) {
    return error instanceof Error ? (error.stack ?? error.message) : String(error);
  } finally {
    await world.close();
  }
}

Object.assign(globalThis, { runScene });
