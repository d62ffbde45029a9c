// A conformance worker whose program is Python (python_peer.py). The interpreter is started once; each scene gives it a
// link of its own.

import type { SiteClock } from '../../../runtime/site/bus/clock.ts';
import type { Link } from '../../../runtime/site/bus/link.ts';
import { type LinkTicket, openLink } from '../../../runtime/site/bus/open_link.ts';
import type { ProgramHost } from '../../../runtime/site/program/program.ts';
import { runPython } from '../../../runtime/site/python/python_program.ts';
import type { WorkerFiles } from '../../../runtime/site/python/worker_files.ts';

/** Where its parts lie. */
export interface PythonPeerPlace {
  /** Folder of the archive, with "/" at the end. */
  readonly base: string;
  /** Pyodide's in it, with "/" at the end. */
  readonly home: string;
  readonly module: () => Promise<WebAssembly.Module>;
  readonly files: WorkerFiles;
  readonly line: (text: string) => void;
}

export const peerArchive = 'all.zip';
/** In the archive. */
export const peerEntry = 'lib/test/peer';

interface Request {
  readonly ticket?: LinkTicket;
  readonly call?: string;
  readonly args?: readonly unknown[];
}

interface Command {
  readonly call: string;
  readonly args: readonly unknown[];
}

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

/** Connects the program with the scene, as servePeer() does: `{call, args}` in, `{value}` or `{error}` out. */
export function servePythonPeer(post: (message: unknown) => void, place: PythonPeerPlace): (message: unknown) => void {
  let link: Link | undefined;
  const whole = (): Link => {
    if (link === undefined) throw new Error('not open');
    return link;
  };

  const clock = present<SiteClock>(() => whole().clock);
  const anyLink = present<Link>(() => new Proxy(whole(), { get: (target, name) => name === 'clock' ? clock : Reflect.get(target, name, target) as unknown }));

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
      post({ value: true });
      pass();
      return;
    }
    if (request.ticket !== undefined) link = openLink(request.ticket, true);
    if (request.call !== undefined) post({ begun: request.call });
    next = { call: request.call ?? 'open', args: request.args ?? [] };
    const take = wanted;
    wanted = undefined;
    take(new Uint8Array([10]));
  }

  /** Standard input of the program: a byte for each command. */
  const input = {
    read: () =>
      new Promise<Uint8Array>((resolve) => {
        wanted = resolve;
        pass();
      }),
  };

  Object.assign(globalThis, {
    scene: {
      take: () => next,
      isHeld: () => whole().clock.law().limitNs !== Infinity,
      answer: (value: unknown) => post({ value }),
      fail: (error: string) => post({ error }),
    },
  });

  async function run(): Promise<void> {
    const host = {
      link: anyLink,
      arguments: ['peer'],
      environment: {},
      idle: () => undefined,
      input,
      random: undefined,
      sent: undefined,
      stepped: false,
      files: { prefix: '/opt/ros/jazzy', place: '', files: [] },
      readNow: () => undefined,
      tell: () => 0,
      line: (_stream: string, text: string) => place.line(text),
    } as unknown as ProgramHost;
    const { base, home } = place;
    const start = { base, home, archives: [peerArchive], entry: peerEntry, image: undefined, sources: undefined, parts: { found: new Map(), listed: [] } };
    const end = await runPython(await place.module(), start, host, place.files, { broken: () => undefined, read: () => undefined });
    post({ error: `Python ended: ${JSON.stringify(end)}` });
  }

  return (message) => {
    const request = message as Request;
    requests.push(request);
    // The interpreter begins with the first link: its clock is that of the site.
    if (link === undefined && request.ticket !== undefined) {
      link = openLink(request.ticket, true);
      requests.splice(0, 1, {});
      void run();
    }
    pass();
  };
}
