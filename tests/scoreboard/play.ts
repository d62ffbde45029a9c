// Plays a packed site until its first node, or all that its launch file starts, is as expected, or cannot be any more, or time is up. Runs wherever a
// site does.
import { createDecoder } from '../../runtime/site/decode/decoder.ts';
import { EndpointKind } from '../../runtime/protocol/generated/constants.ts';
import { launchedCommands } from '../../runtime/site/ros2cli/launched_command.ts';
import { type Admission, SharedBroker } from '../../runtime/site/bus/broker.ts';
import type { Platform } from '../../runtime/site/workers/platform.ts';
import type { NodeView } from '../../runtime/site/contract/session.ts';
import { readSite } from '../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../runtime/site/session/site_session.ts';
import type { Expectation } from './expectation.ts';
import { judge, type Seen, type SeenNode, type Verdict } from './judge.ts';

export interface Asked {
  /** For an executable, the first node of the site is watched, and the nodes that run beside it. */
  readonly kind: 'executable' | 'launch';
  readonly expected: Expectation | undefined;
}

export interface Played {
  /** For a launch file, all its nodes as one; each line begins with the node's name. */
  readonly node: SeenNode;
  /** Those that it made. */
  readonly endpoints: readonly string[];
  /** undefined when nothing is expected. */
  readonly verdict: Verdict | undefined;
}

const LOOK_MS = 40;
/** How long a program is watched that nobody expects anything of. */
const UNEXPECTED_SECONDS = 3;
/** Upper bound for the start of each Python node, on a busy machine too. */
const PYTHON_START_SECONDS = 30;

/** The commands of `ros2` that launch files start; their recordings are dropped. */
const COMMANDS = launchedCommands({
  readText: () => Promise.resolve(undefined),
  bags: { open: () => Promise.resolve(undefined), create: () => Promise.resolve({ write: () => undefined, end: () => undefined }) },
});

const KINDS: Readonly<Record<number, string>> = {
  [EndpointKind.publisher]: 'publisher',
  [EndpointKind.subscription]: 'subscription',
  [EndpointKind.client]: 'client',
  [EndpointKind.server]: 'server',
};

/** Knows which places on the bus the first node got. */
class NotingBroker extends SharedBroker {
  readonly admitted: number[] = [];

  override admit(): Admission | undefined {
    const admission = super.admit();
    if (admission !== undefined) this.admitted.push(admission.participant);
    return admission;
  }
}

class Watched {
  readonly lines: string[] = [];
  started = false;
  exit: number | undefined;
  crash: SeenNode['crash'];

  note({ state }: NodeView): void {
    if (state.kind === 'running' || state.kind === 'exited') this.started = true;
    if (state.kind === 'exited') this.exit = state.code;
    if (state.kind === 'crashed') this.crash = { code: state.code, message: state.message };
  }
}

export async function play(platform: Platform, { kind, expected }: Asked): Promise<Played> {
  const site = readSite(await platform.json('site.json'));
  platform.expect(site.files);
  const broker = new NotingBroker();
  const watched = site.nodes.map(() => new Watched());
  /** All nodes as one. */
  const all = new Watched();
  const endpoints = new Set<string>();
  const inputs = [expected, ...(expected?.beside ?? [])].map((start) => [...(start?.input ?? [])]);
  const stops = [expected, ...(expected?.beside ?? [])].map((start) => start?.stop);
  const session = new SiteSession({
    site,
    platform,
    broker,
    onLines: (node, lines) => {
      const texts = lines.map(([, , text]) => text);
      watched[site.nodes.indexOf(node)]?.lines.push(...texts);
      all.lines.push(...texts.map((text) => `[${node.id}] ${text}`));
    },
    commands: COMMANDS,
    onLaunchLine: (_, text) => all.lines.push(text),
  });
  const decoder = createDecoder(await session.interfaces());
  const own = new Set<number>();
  const seen: Seen = {
    node: kind === 'launch' ? all : watched[0] ?? new Watched(),
    beside: kind === 'launch' ? [] : watched.slice(1),
    endpoints,
    value: (topic, path) => {
      const type = session.topics().find(({ name }) => name === topic)?.type;
      const last = session.lastMessage(topic);
      if (type === undefined || last === undefined) return undefined;
      const decoded = decoder.decode(type, last.bytes);
      return decoded.kind === 'value' ? valueAt(decoded.value, path) : undefined;
    },
  };
  const look = (): void => {
    for (const record of broker.link.records()) {
      if (kind === 'launch' ? broker.admitted.includes(record.participant) : own.has(record.participant))
        endpoints.add(`${KINDS[record.kind]} ${record.name} ${record.type}`);
    }
    const views = session.nodes();
    views.forEach((view, index) => watched[index]?.note(view));
    all.started ||= site.nodes.every(({ startOn, startAfter }, index) => startOn !== undefined || startAfter > 0 || watched[index]?.started === true);
    all.crash ??= watched.find(({ crash }) => crash !== undefined)?.crash;
    const isOver = !session.respawns() && views.every(({ state }) => !['starting', 'running', 'waiting'].includes(state.kind));
    if (isOver) all.exit = watched.find(({ exit }) => exit !== undefined && exit !== 0)?.exit ?? 0;
    else all.exit = undefined;
    inputs.forEach((waiting, index) => {
      const [next] = waiting;
      const node = site.nodes[index];
      if (next === undefined || node === undefined || watched[index]?.lines.some((line) => next.after.test(line)) !== true) return;
      waiting.shift();
      session.sendInput(node.id, next.text);
    });
  };
  const stopWhoSaidSo = (): void => {
    stops.forEach((after, index) => {
      const node = site.nodes[index];
      if (after === undefined || node === undefined || watched[index]?.lines.some((line) => after.test(line)) !== true) return;
      if (index === 0 && expected?.endpoints.some((endpoint) => !endpoints.has(endpoint)) === true) return;
      stops[index] = undefined;
      session.stop(node.id);
    });
  };
  try {
    if (kind === 'launch') session.startAll();
    else for (const [index, node] of site.nodes.entries()) {
        session.start(node.id);
        if (index === 0) { for (const place of broker.admitted) own.add(place); }
      }
    const starting = PYTHON_START_SECONDS * site.nodes.filter((node) => node.kind === 'python').length;
    let until = performance.now() + 1000 * ((expected?.seconds ?? UNEXPECTED_SECONDS) + starting);
    let verdict: Verdict | undefined;
    do {
      await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
      look();
      stopWhoSaidSo();
      verdict = expected === undefined ? undefined : judge(expected, seen);
      // In a launch file, one node may have printed everything while another still starts.
      if (verdict?.final === true && (seen.node.started || verdict.missing.length > 0)) break;
      if (expected !== undefined) continue;
      if (over(seen.node)) break;
      // Python runs long before a program does something.
      if (seen.node.started && (endpoints.size > 0 || seen.node.lines.length > 0)) until = Math.min(until, performance.now() + 1000 * UNEXPECTED_SECONDS);
    } while (performance.now() < until);
    return { node: seen.node, endpoints: [...endpoints], verdict };
  } finally {
    session.close();
  }
}

function over(node: SeenNode): boolean {
  return node.exit !== undefined || node.crash !== undefined;
}

/** `header.frame_id`, `ranges.0`: what stands there, as text. */
export function valueAt(value: unknown, path: string): string | undefined {
  let at = value;
  for (const part of path.split('.')) {
    if (typeof at !== 'object' || at === null) return undefined;
    at = (at as Readonly<Record<string, unknown>>)[part];
  }
  return at === undefined ? undefined : typeof at === 'object' ? JSON.stringify(at) : String(at);
}
