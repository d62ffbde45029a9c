// Entry of a conformance worker under Node.js.

import { parentPort } from 'node:worker_threads';
import { servePeer } from './peer.ts';

if (parentPort === null) throw new Error('this file is a worker');
const port = parentPort;
const handle = servePeer((message) => port.postMessage(message));
port.on('message', (message: unknown) => void handle(message));
