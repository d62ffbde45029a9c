// Entry of a conformance worker in a browser.

import { holdLife } from '../../../runtime/site/workers/worker_life.ts';
import { servePeer } from './peer.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;
const handle = servePeer((message) => scope.postMessage(message));
let held = Promise.resolve();
scope.onmessage = ({ data }: MessageEvent<{ life?: string; }>) => {
  if (data.life !== undefined) held = holdLife(data.life, navigator.locks);
  else void held.then(() => handle(data));
};
