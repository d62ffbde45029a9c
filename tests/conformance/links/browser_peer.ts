// Entry of a conformance worker in a browser.

import { servePeer } from './peer.ts';

const scope = self as unknown as DedicatedWorkerGlobalScope;
const handle = servePeer((message) => scope.postMessage(message));
scope.onmessage = (event) => void handle(event.data);
