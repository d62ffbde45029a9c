// A session under Node.js over the small test programs.

import { copyFileSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import type { CommandLoader, LinkKind, NodeState, NodeView, Session } from '../../../runtime/site/contract/session.ts';
import type { WorkerOrder } from '../../../runtime/site/workers/worker_messages.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { buildProgram } from './programs.ts';

const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);

export interface FixtureNode {
  readonly program: string;
  readonly threads?: boolean;
  readonly respawn?: boolean;
  readonly arguments?: readonly string[];
  /** Further fields of site.json: `start_after`, `on_exit` and the like. */
  readonly rules?: Readonly<Record<string, unknown>>;
  /** The names of the functions stand in a file of their own, as `pack` has them; otherwise in the program. */
  readonly namesApart?: boolean;
}

/** A module without its custom sections, and a module that has its "name" section only. */
export function splitNames(module: Uint8Array): { readonly program: Uint8Array; readonly names: Uint8Array; } {
  const header = module.subarray(0, 8);
  const program = [header];
  const names = [header];
  for (let at = 8; at < module.length;) {
    let end = at + 1;
    let size = 0;
    for (let shift = 0;; shift += 7) {
      const byte = module[end++] ?? 0;
      size += (byte & 127) << shift;
      if (byte < 128) break;
    }
    const whole = module.subarray(at, end + size);
    if (module[at] !== 0) program.push(whole);
    else if (Buffer.from(module.subarray(end, end + 5)).toString() === '\x04name') names.push(whole);
    at = end + size;
  }
  return { program: Buffer.concat(program), names: Buffer.concat(names) };
}

/** `more`: further members of site.json. */
export function makeFolder(nodes: readonly FixtureNode[], more: Readonly<Record<string, unknown>> = {}): string {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-session-'));
  mkdirSync(join(folder, 'programs'));
  const described = nodes.map(({ program, threads = false, respawn = false, arguments: args = [], rules = {}, namesApart }, i) => {
    const name = program.replace(/\..*/, '');
    const built = buildProgram(program, { threads });
    if (namesApart === true) {
      const split = splitNames(readFileSync(built));
      writeFileSync(join(folder, 'programs', `${name}.wasm`), split.program);
      writeFileSync(join(folder, 'programs', `${name}.names`), split.names);
    } else {
      copyFileSync(built, join(folder, 'programs', `${name}.wasm`));
    }
    return {
      id: `${name}-${i + 1}`,
      package: 'test',
      executable: name,
      label: `/${name}`,
      kind: 'cpp',
      threads,
      respawn,
      program: `programs/${name}.wasm`,
      ...(namesApart === true ? { names: `programs/${name}.names` } : {}),
      arguments: args,
      environment: { COLOUR: 'red' },
      output: 'screen',
      source: { file: 'workspace.yaml', line: 3 + i, column: 5 },
      ...rules,
    };
  });
  writeFileSync(join(folder, 'interfaces.json'), '{"std_msgs/msg/String": "string data\\n"}');
  writeFileSync(join(folder, 'site.json'), JSON.stringify({
    schema: 1,
    protocol: 1,
    generator: 'test',
    name: 'test',
    title: 'A test',
    version: '1',
    distro: 'jazzy',
    license: 'Apache-2.0',
    authors: [],
    nodes: described,
    interfaces: 'interfaces.json',
    ui: {},
    files: [],
    ...more,
  }));
  return folder;
}

/**
 * Runs `use` with a session; everything is closed after it. `posted`: what went to workers, in order. `more`: as of makeFolder().
 * `commands`: what runs those of `ros2`.
 */
export async function withSession(
  nodes: readonly FixtureNode[],
  use: (session: SiteSession, folder: string, posted: readonly WorkerOrder[]) => Promise<void>,
  link: LinkKind = 'shared',
  more: Readonly<Record<string, unknown>> = {},
  commands?: CommandLoader,
): Promise<void> {
  const folder = makeFolder(nodes, more);
  const posted: WorkerOrder[] = [];
  const plain = nodePlatform(folder, entry);
  const platform = {
    ...plain,
    startWorker: (...given: Parameters<typeof plain.startWorker>) => {
      const worker = plain.startWorker(...given);
      return {
        ...worker,
        post: (...order: Parameters<typeof worker.post>) => {
          posted.push(order[0]);
          worker.post(...order);
        },
      };
    },
  };
  const broker = link === 'shared' ? new SharedBroker({ ceiling: 256 << 20 }) : new PortBroker();
  const session = new SiteSession({ site: readSite(await platform.json('site.json')), platform, broker, ...(commands === undefined ? {} : { commands }) });
  try {
    await use(session, folder, posted);
  } finally {
    session.close();
    platform.close();
    rmSync(folder, { recursive: true });
  }
}

/** Resolves with the node's view when its state is of the kind. */
export function reaches(session: Session, id: string, kind: NodeState['kind']): Promise<NodeView> {
  return new Promise((resolve) => {
    const look = (nodes: readonly NodeView[]): boolean => {
      const node = nodes.find((each) => each.id === id && each.state.kind === kind);
      if (node !== undefined) resolve(node);
      return node !== undefined;
    };
    if (look(session.nodes())) return;
    const off = session.onNodes((nodes) => {
      if (look(nodes)) off();
    });
  });
}

/** Resolves with the first console line that fits, also one that is there already. Of `launch`: of the launch itself. */
export function prints(session: Session, id: string, pattern: RegExp): Promise<string> {
  return new Promise((resolve) => {
    const log = id === 'launch' ? session.launchLog : session.console(id);
    let done = false;
    const off = log.onLines((lines) => {
      const line = lines.find(({ text }) => pattern.test(text));
      if (line === undefined || done) return;
      done = true;
      off();
      resolve(line.text);
    });
    const line = log.lines().find(({ text }) => pattern.test(text));
    if (line === undefined) return;
    done = true;
    off();
    resolve(line.text);
  });
}
