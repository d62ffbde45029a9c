// Entry of a conformance worker under Node.js whose program is Python (python_peer.py). The interpreter is started once;
// each scene gives it a link of its own.

import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname } from 'node:path';
import { parentPort, workerData } from 'node:worker_threads';
import { loadPyodide } from 'pyodide';
import type { SiteClock } from '../../../runtime/wasm_js/clock.ts';
import type { Link } from '../../../runtime/wasm_js/link.ts';
import { type LinkTicket, openLink } from '../../../runtime/wasm_js/open_link.ts';
import type { ProgramHost } from '../../../runtime/wasm_js/program.ts';
import { runPython } from '../../../runtime/wasm_js/python_program.ts';

/** What the worker is started with. */
export interface PythonPeerData {
  /** Folder of the archive, with "/" at the end. */
  readonly base: string;
  readonly archive: string;
  readonly entry: string;
}

interface Request {
  readonly ticket?: LinkTicket;
  readonly call?: string;
  readonly args?: readonly unknown[];
}

if (parentPort === null) throw new Error('this file is a worker');
const port = parentPort;
const pyodide = `${dirname(createRequire(import.meta.url).resolve('pyodide'))}/`;
const { base, archive, entry } = workerData as PythonPeerData;

let link: Link | undefined;
const whole = (): Link => {
  if (link === undefined) throw new Error('not open');
  return link;
};

/** An object whose parts are those of whatever is there at the moment. */
function present<T extends object>(current: () => T): T {
  return new Proxy({} as T, {
    get: (_target, name) => {
      const now = current();
      const part: unknown = Reflect.get(now, name);
      return typeof part === 'function' ? (part.bind(now) as unknown) : part;
    },
  });
}

const clock = present<SiteClock>(() => whole().clock);
const anyLink = present<Link>(() => new Proxy(whole(), { get: (target, name) => name === 'clock' ? clock : Reflect.get(target, name, target) as unknown }));

interface Command {
  readonly call: string;
  readonly args: readonly unknown[];
}

const requests: Request[] = [];
let next: Command | undefined;
let wanted: ((typed: Uint8Array) => void) | undefined;

/** Gives Python the next command, when both are there. */
function pass(): void {
  if (wanted === undefined) return;
  const request = requests.shift();
  if (request === undefined) return;
  if (request.call === 'close') {
    whole().close();
    port.postMessage({ value: true });
    pass();
    return;
  }
  if (request.ticket !== undefined) link = openLink(request.ticket, true);
  if (request.call !== undefined) port.postMessage({ begun: request.call });
  next = { call: request.call ?? 'open', args: request.args ?? [] };
  const take = wanted;
  wanted = undefined;
  take(new Uint8Array([10]));
}

/** Standard input of the program: a byte for each command. */
const input = {
  read: () => new Promise<Uint8Array>((resolve) => {
    wanted = resolve;
    pass();
  }),
};

Object.assign(globalThis, {
  scene: {
    take: () => next,
    isHeld: () => whole().clock.law().limitNs !== Infinity,
    answer: (value: unknown) => port.postMessage({ value }),
    fail: (error: string) => port.postMessage({ error }),
  },
});

async function run(): Promise<void> {
  const host = {
    link: anyLink, arguments: ['peer'], environment: {}, idle: () => undefined, input, random: undefined, sent: undefined,
    stepped: false, files: { prefix: '/opt/ros/jazzy', place: '', files: [] }, readNow: () => undefined, tell: () => 0,
    line: (_stream: string, text: string) => process.stderr.write(`${text}\n`),
  } as unknown as ProgramHost;
  const module = await WebAssembly.compile(readFileSync(`${pyodide}pyodide.asm.wasm`));
  const start = { base, home: '', archives: [archive], entry, image: undefined, sources: undefined, parts: { found: new Map(), listed: [] } };
  const end = await runPython(module, start, host, {
    pyodide: async () => (options) => loadPyodide({ ...options, indexURL: pyodide }),
    bytes: async (place) => Uint8Array.from(readFileSync(place)),
  }, { broken: () => undefined, read: () => undefined });
  port.postMessage({ error: `Python ended: ${JSON.stringify(end)}` });
}

port.on('message', (request: Request) => {
  requests.push(request);
  // The interpreter begins with the first link: its clock is that of the site.
  if (link === undefined && request.ticket !== undefined) {
    link = openLink(request.ticket, true);
    requests.splice(0, 1, {});
    void run();
  }
  pass();
});
