// The script of a node worker in a browser.

import { serveWorker, type WorkerOrder } from './node_worker.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;
const handle = serveWorker((report) => scope.postMessage(report));
scope.onmessage = (event: MessageEvent<WorkerOrder>) => handle(event.data);
