// Plays a packed site until its first node is as expected, or cannot be any more, or time is up. Runs wherever a
// site does.
import { createDecoder } from '../../runtime/decode/decoder.ts';
import { EndpointKind } from '../../runtime/protocol/generated/constants.ts';
import { type Admission, SharedBroker } from '../../runtime/wasm_js/broker.ts';
import type { Platform } from '../../runtime/wasm_js/platform.ts';
import type { NodeView } from '../../runtime/wasm_js/session.ts';
import { readSite } from '../../runtime/wasm_js/site_reader.ts';
import { SiteSession } from '../../runtime/wasm_js/site_session.ts';
import type { Expectation } from './expectation.ts';
import { judge, type Seen, type SeenNode, type Verdict } from './judge.ts';

export interface Played {
  readonly node: SeenNode;
  /** Those that it made. */
  readonly endpoints: readonly string[];
  /** undefined when nothing is expected. */
  readonly verdict: Verdict | undefined;
}

const LOOK_MS = 40;
/** How long a program is watched that nobody expects anything of. */
const UNEXPECTED_SECONDS = 3;
/** What each Python node may take to start, on a busy machine too. */
const PYTHON_START_SECONDS = 30;

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

export async function play(platform: Platform, expected: Expectation | undefined): Promise<Played> {
  const site = readSite(await platform.json('site.json'));
  platform.expect(site.files);
  const broker = new NotingBroker();
  const watched = site.nodes.map(() => new Watched());
  const endpoints = new Set<string>();
  const inputs = [expected, ...(expected?.beside ?? [])].map((start) => [...(start?.input ?? [])]);
  const stops = [expected, ...(expected?.beside ?? [])].map((start) => start?.stop);
  const session = new SiteSession({
    site,
    platform,
    broker,
    onLines: (node, lines) => watched[site.nodes.indexOf(node)]?.lines.push(...lines.map(([, , text]) => text)),
  });
  const decoder = createDecoder(await session.interfaces());
  const own = new Set<number>();
  const seen: Seen = {
    node: watched[0] ?? new Watched(),
    beside: watched.slice(1),
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
      if (own.has(record.participant)) endpoints.add(`${KINDS[record.kind]} ${record.name} ${record.type}`);
    }
    session.nodes().forEach((view, index) => watched[index]?.note(view));
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
      stops[index] = undefined;
      session.stop(node.id);
    });
  };
  try {
    for (const [index, node] of site.nodes.entries()) {
      session.start(node.id);
      if (index === 0) for (const place of broker.admitted) own.add(place);
    }
    const starting = PYTHON_START_SECONDS * site.nodes.filter((node) => node.kind === 'python').length;
    const until = performance.now() + 1000 * ((expected?.seconds ?? UNEXPECTED_SECONDS) + starting);
    let verdict: Verdict | undefined;
    do {
      await new Promise((resolve) => setTimeout(resolve, LOOK_MS));
      look();
      stopWhoSaidSo();
      verdict = expected === undefined ? undefined : judge(expected, seen);
      if (verdict?.final === true || (expected === undefined && over(seen.node))) break;
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
