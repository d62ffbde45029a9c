// `offered_qos_profiles`, the YAML in which rosbag2 keeps the QoS of a topic's publishers: as Jazzy writes it, and as
// older ones did, with numbers for policies. Pure; what cannot be read is skipped.

import type { EndpointQosView, QosRequest } from '../contract/session.ts';

/** The number that ROS 2 writes for "no limit". */
const endless = 2n ** 63n - 1n;
const second = 1_000_000_000n;
const mostCharacters = 1 << 16;

export function writeProfiles(offered: readonly EndpointQosView[]): string {
  return offered.map((qos) =>
    [
      `- history: ${qos.history}`,
      `  depth: ${qos.depth}`,
      `  reliability: ${qos.reliability}`,
      `  durability: ${qos.durability}`,
      ...duration('deadline', qos.deadlineNs),
      ...duration('lifespan', qos.lifespanNs),
      `  liveliness: ${qos.liveliness}`,
      ...duration('liveliness_lease_duration', qos.leaseNs),
      '  avoid_ros_namespace_conventions: false',
    ].join('\n')
  ).join('\n');
}

function duration(name: string, ns: number): string[] {
  const exact = ns > 0 ? BigInt(Math.round(ns)) : endless;
  return [`  ${name}:`, `    sec: ${exact / second}`, `    nsec: ${exact % second}`];
}

/** One for each publisher that there was. */
export function readProfiles(text: string): QosRequest[] {
  if (text.length > mostCharacters) return [];
  const found: QosRequest[] = [];
  // Mappings one below the other: `- ` begins one, deeper lines belong to the key above them.
  let fields: Map<string, string> | undefined;
  let above = '';
  const end = (): void => {
    if (fields !== undefined) found.push(profileOf(fields));
  };
  for (const line of text.split('\n')) {
    const match = /^(- | {2}| {4})(\w+):[ \t]*(\S*)\s*$/.exec(line);
    if (match === null) continue;
    const [, indent, key = '', value = ''] = match;
    if (indent === '- ') {
      end();
      fields = new Map();
    }
    if (indent === '    ') {
      fields?.set(`${above}.${key}`, value);
    } else {
      above = key;
      fields?.set(key, value);
    }
  }
  end();
  return found;
}

function profileOf(fields: ReadonlyMap<string, string>): QosRequest {
  /** The policy in words; numbers are those of rmw. */
  const policy = (name: string, words: readonly string[]): string | undefined => {
    const value = fields.get(name) ?? '';
    return words.includes(value) ? value : /^\d$/.test(value) ? words[Number(value)] : undefined;
  };
  const ns = (name: string): number => {
    const whole = (part: string): bigint => {
      const value = fields.get(`${name}.${part}`) ?? '';
      return /^\d{1,20}$/.test(value) ? BigInt(value) : 0n;
    };
    const exact = whole('sec') * second + whole('nsec');
    // The largest of Foxy's implementations stand for none, too.
    return exact >= 2_147_483_647n * second ? 0 : Number(exact);
  };
  const depth = Number(fields.get('depth') ?? '');
  const history = policy('history', ['', 'keep_last', 'keep_all']);
  const reliability = policy('reliability', ['', 'reliable', 'best_effort']);
  const durability = policy('durability', ['', 'transient_local', 'volatile']);
  const liveliness = policy('liveliness', ['', 'automatic', '', 'manual_by_topic']);
  return {
    ...(history === 'keep_all' || history === 'keep_last' ? { history } : {}),
    ...(Number.isInteger(depth) && depth > 0 ? { depth } : {}),
    ...(reliability === 'best_effort' || reliability === 'reliable' ? { reliability } : {}),
    ...(durability === 'transient_local' || durability === 'volatile' ? { durability } : {}),
    ...(liveliness === 'manual_by_topic' || liveliness === 'automatic' ? { liveliness } : {}),
    deadlineNs: ns('deadline'),
    lifespanNs: ns('lifespan'),
    leaseNs: ns('liveliness_lease_duration'),
  };
}

/** The QoS of a subscription that matches all of these publishers. */
export function requestFor(offered: readonly QosRequest[]): QosRequest {
  const isLatched = offered.length > 0 && offered.every(({ durability }) => durability === 'transient_local');
  return {
    reliability: offered.some(({ reliability }) => reliability === 'best_effort') ? 'best_effort' : 'reliable',
    durability: isLatched ? 'transient_local' : 'volatile',
    depth: 1000,
  };
}

/** The QoS of a publisher that represents all of these: theirs where they agree, else ROS 2's default, as in rosbag2. */
export function offerFor(offered: readonly QosRequest[]): QosRequest {
  const [first] = offered;
  if (first === undefined) return {};
  const kind = (qos: QosRequest): string => [qos.reliability, qos.durability, qos.deadlineNs, qos.liveliness, qos.leaseNs].join();
  if (!offered.every((qos) => kind(qos) === kind(first))) return {};
  return { ...first, history: 'keep_last', depth: Math.max(10, ...offered.map(({ depth }) => Math.min(depth ?? 10, 1000))) };
}
