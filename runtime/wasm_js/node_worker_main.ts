// The script of a node worker in a browser.

import { fetchNow } from './fetch_now.ts';
import { type HoldOrder, serveWorker, type WorkerOrder } from './node_worker.ts';
import { holdLife } from './worker_life.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;
const handle = serveWorker((report) => scope.postMessage(report), fetchNow);
let held = Promise.resolve();
scope.onmessage = ({ data: order }: MessageEvent<HoldOrder | WorkerOrder>) => {
  if (order.t === 'hold') held = holdLife(order.life);
  else void held.then(() => handle(order));
};
