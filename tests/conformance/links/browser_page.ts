// Runs scenes in a page; the test calls runScene.

import type { LinkKind } from '../../../runtime/wasm_js/session.ts';
import { lifeOver, newLife } from '../../../runtime/wasm_js/worker_life.ts';
import { allScenes } from './all_scenes.ts';
import { type RawWorker, World } from './world.ts';

function start(): Promise<RawWorker> {
  const worker = new Worker('browser_peer.js');
  const life = newLife();
  worker.postMessage({ life });
  return Promise.resolve({
    post: (message, transfer) => worker.postMessage(message, [...transfer]),
    onMessage: (listener) => {
      worker.onmessage = (event: MessageEvent<unknown>) => listener(event.data);
    },
    terminate: () => {
      worker.terminate();
      return lifeOver(life);
    },
  });
}

/** Undefined when the link did what it must, else what it did instead. */
async function runScene(kind: LinkKind, name: string): Promise<string | undefined> {
  const scene = allScenes.find((each) => each.name === name);
  if (scene === undefined) return `no scene ${name}`;
  const world = new World(kind, start);
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
