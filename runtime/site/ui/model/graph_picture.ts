// The contents of the graph panel, without positions: boxes, the wires between them, and groups of namespaces. Made from the
// graph and the visitor's choices. Pure.

import type { GraphNodeView, GraphView } from '../../contract/session.ts';
import { isHiddenName, splitNodeName } from '../../decode/ros_names.ts';
import { isShownService } from './callable.ts';
import { isHiddenTopic } from './hidden_names.ts';

export interface PictureOptions {
  /** Topics on the wires between nodes, or as boxes of their own. */
  readonly mode: 'nodes' | 'topics';
  readonly hidden: boolean;
  /** Services as well. */
  readonly services: boolean;
  readonly groups: boolean;
  /** Only what has it in its name, and what that is connected with. */
  readonly text: string;
}

/** The kinds of connections between nodes. */
export type WireKind = 'topic' | 'action' | 'service';
export type BoxKind = 'node' | WireKind;

export interface Box {
  /** Unique, also when several nodes have the same name. */
  readonly id: string;
  readonly kind: BoxKind;
  /** Fully qualified. */
  readonly name: string;
  /** The text in the box: the name within its group, shortened. */
  readonly label: string;
  readonly group: string | null;
}

/** One line of the text on a wire between two nodes. */
export interface WireLine {
  readonly kind: WireKind;
  readonly name: string;
  readonly label: string;
}

export interface Wire {
  readonly id: string;
  readonly from: string;
  readonly to: string;
  readonly kind: WireKind;
  /** Names of the topics, actions or services it stands for. */
  readonly names: readonly string[];
  /** The topic whose rate the wire shows, since all of its messages pass it; null: none. */
  readonly rateOf: string | null;
  readonly lines: readonly WireLine[];
  /** How many more would be written on it. */
  readonly more: number;
}

export interface Group {
  /** The namespace. */
  readonly id: string;
  readonly label: string;
  readonly parent: string | null;
}

export interface Picture {
  readonly boxes: readonly Box[];
  readonly wires: readonly Wire[];
  /** Outer ones first. */
  readonly groups: readonly Group[];
  /** How many boxes were skipped because there are too many. */
  readonly leftOut: number;
}

/** More take the layout too long, and nobody could read them. */
const MOST_BOXES = 150;
const MOST_WIRES = 400;
/** Upper bound of the pairs of nodes that are examined: far more than are drawn. */
const MOST_PAIRS = 50_000;
const MOST_LINES = 4;
const LONGEST_LABEL = 40;

export function boxId(kind: BoxKind, name: string, number = 1): string {
  return number === 1 ? `${kind} ${name}` : `${kind} ${name} ${number}`;
}

/** The nodes that may be shown, each with the id of its box. */
export function shownNodes(graph: GraphView, hidden: boolean): readonly { readonly id: string; readonly node: GraphNodeView; }[] {
  const met = new Map<string, number>();
  return graph.nodes
    .filter(({ name }) => hidden || !isHiddenName(name))
    .map((node) => {
      const number = (met.get(node.name) ?? 0) + 1;
      met.set(node.name, number);
      return { id: boxId('node', node.name, number), node };
    });
}

interface Ends {
  readonly from: Set<string>;
  readonly to: Set<string>;
}

/** For each topic by name: the boxes that write to it, and those that read. */
export function topicEnds(graph: GraphView, hidden: boolean): ReadonlyMap<string, Ends> {
  const found = new Map<string, Ends>();
  for (const { id, node } of shownNodes(graph, hidden)) {
    for (const { name } of node.publishers) if (hidden || !isHiddenTopic(name)) endsOf(found, name).from.add(id);
    for (const { name } of node.subscriptions) if (hidden || !isHiddenTopic(name)) endsOf(found, name).to.add(id);
  }
  return found;
}

/** From the clients to the servers. */
export function actionEnds(graph: GraphView, hidden: boolean): ReadonlyMap<string, Ends> {
  const found = new Map<string, Ends>();
  for (const { id, node } of shownNodes(graph, hidden)) {
    for (const { name } of node.actionClients) if (hidden || !isHiddenName(name)) endsOf(found, name).from.add(id);
    for (const { name } of node.actionServers) if (hidden || !isHiddenName(name)) endsOf(found, name).to.add(id);
  }
  return found;
}

/** From the clients to the servers; those that every node has are hidden ones. */
export function serviceEnds(graph: GraphView, hidden: boolean): ReadonlyMap<string, Ends> {
  const found = new Map<string, Ends>();
  for (const { id, node } of shownNodes(graph, hidden)) {
    for (const each of node.clients) if (hidden || isShownService(each)) endsOf(found, each.name).from.add(id);
    for (const each of node.services) if (hidden || isShownService(each)) endsOf(found, each.name).to.add(id);
  }
  return found;
}

function endsOf(all: Map<string, Ends>, name: string): Ends {
  const ends = all.get(name) ?? { from: new Set(), to: new Set() };
  all.set(name, ends);
  return ends;
}

type Bare = Omit<Box, 'label' | 'group'>;

export function pictureOf(graph: GraphView, options: PictureOptions): Picture {
  const nodes = shownNodes(graph, options.hidden).map(({ id, node }): Bare => ({ id, kind: 'node', name: node.name }));
  const all: readonly (readonly [WireKind, ReadonlyMap<string, Ends>])[] = [
    ['topic', topicEnds(graph, options.hidden)],
    ['action', actionEnds(graph, options.hidden)],
    ['service', options.services ? serviceEnds(graph, options.hidden) : new Map()],
  ];
  let boxes: readonly Bare[] = nodes;
  let wires: readonly Wire[];
  if (options.mode === 'topics') {
    const ofKind = (kind: BoxKind, names: Iterable<string>): Bare[] => [...names].sort().map((name) => ({ id: boxId(kind, name), kind, name }));
    boxes = [...nodes, ...all.flatMap(([kind, ends]) => ofKind(kind, ends.keys()))];
    wires = all.flatMap(([kind, ends]) => wiresThrough(kind, ends));
  } else {
    wires = all.flatMap(([kind, ends]) => wiresBetween(kind, ends));
  }
  const near = nearText(boxes, wires, options.text);
  const wanted = boxes.filter(({ id }) => near.has(id));
  let kept = wanted.slice(0, MOST_BOXES);
  let shown = between(wires, kept);
  while (shown.length > MOST_WIRES) {
    kept = kept.slice(0, Math.floor(kept.length * 0.8));
    shown = between(wires, kept);
  }
  const grouped = options.groups ? groupsOf(kept) : { groups: [], of: new Map<string, string>() };
  return {
    boxes: kept.map((box): Box => {
      const group = grouped.of.get(box.id) ?? null;
      return { ...box, group, label: shortName(group === null ? box.name : box.name.slice(group.length + 1)) };
    }),
    wires: shown,
    groups: grouped.groups,
    leftOut: wanted.length - kept.length,
  };
}

function between(wires: readonly Wire[], boxes: readonly Bare[]): readonly Wire[] {
  const ids = new Set(boxes.map(({ id }) => id));
  return wires.filter(({ from, to }) => ids.has(from) && ids.has(to));
}

/** Node to topic, topic to node. */
function wiresThrough(kind: WireKind, all: ReadonlyMap<string, Ends>): readonly Wire[] {
  return [...all].sort(byKey).flatMap(([name, { from, to }]) => {
    const middle = boxId(kind, name);
    const wire = (a: string, b: string, carriesAll: boolean): Wire => ({
      id: `${a} > ${b}`,
      from: a,
      to: b,
      kind,
      names: [name],
      rateOf: kind === 'topic' && carriesAll ? name : null,
      lines: [],
      more: 0,
    });
    // The rate of a topic is known, not that of each publisher: it stands where all messages pass.
    return [
      ...[...from].map((node) => wire(node, middle, from.size === 1)),
      ...[...to].map((node) => wire(middle, node, from.size !== 1)),
    ];
  });
}

/** From each publisher (or client) to each subscriber (or server) one wire, with the names of all that leads there. */
function wiresBetween(kind: WireKind, all: ReadonlyMap<string, Ends>): readonly Wire[] {
  const byPair = new Map<string, { from: string; to: string; names: string[]; }>();
  for (const [name, { from, to }] of [...all].sort(byKey)) {
    for (const a of from) {
      for (const b of to) {
        const key = `${kind} ${a} > ${b}`;
        const known = byPair.get(key);
        if (known === undefined && byPair.size >= MOST_PAIRS) continue;
        const pair = known ?? { from: a, to: b, names: [] };
        byPair.set(key, pair);
        pair.names.push(name);
      }
    }
  }
  return [...byPair].map(([id, { from, to, names }]): Wire => {
    const shown = names.length <= MOST_LINES ? names : names.slice(0, MOST_LINES - 1);
    return {
      id,
      from,
      to,
      kind,
      names,
      rateOf: null,
      lines: shown.map((name) => ({ kind, name, label: shortName(name) })),
      more: names.length - shown.length,
    };
  });
}

/** The boxes that have the text in their name or on their wires, and those that they are connected with. */
function nearText(boxes: readonly Bare[], wires: readonly Wire[], text: string): ReadonlySet<string> {
  const wanted = text.trim().toLowerCase();
  const has = (name: string): boolean => name.toLowerCase().includes(wanted);
  const near = new Set(boxes.filter(({ name }) => has(name)).map(({ id }) => id));
  if (wanted === '') return near;
  const kinds = new Map(boxes.map(({ id, kind }) => [id, kind]));
  const around = (inside: ReadonlySet<string>, of: (id: string) => boolean): void => {
    for (const { from, to } of wires) {
      if (inside.has(from) && of(from)) near.add(to);
      if (inside.has(to) && of(to)) near.add(from);
    }
  };
  around(new Set(near), () => true);
  for (const wire of wires) {
    if (wire.lines.some(({ name }) => has(name))) near.add(wire.from).add(wire.to);
  }
  // A topic with one end only would look as if nobody were at the other.
  around(new Set(near), (id) => kinds.get(id) !== 'node');
  return near;
}

/** Namespaces that hold two things or more; which of them, the innermost, each box is in. */
function groupsOf(boxes: readonly Bare[]): { readonly groups: readonly Group[]; readonly of: ReadonlyMap<string, string>; } {
  const of = new Map(boxes.map(({ id, name }) => [id, splitNodeName(name).namespace]));
  const things = new Map<string, Set<string>>();
  const put = (space: string, thing: string): void => {
    if (space === '/') return;
    if (!things.has(space)) {
      things.set(space, new Set());
      put(splitNodeName(space).namespace, space);
    }
    things.get(space)?.add(thing);
  };
  for (const [id, space] of of) put(space, id);
  // The innermost first: one that goes gives what it has to the one around it.
  for (const space of [...things.keys()].sort((a, b) => b.length - a.length)) {
    const inside = things.get(space) ?? new Set();
    if (inside.size >= 2) continue;
    const outer = splitNodeName(space).namespace;
    things.delete(space);
    things.get(outer)?.delete(space);
    for (const thing of inside) {
      if (things.has(outer)) things.get(outer)?.add(thing);
      if (of.has(thing)) of.set(thing, outer);
    }
  }
  for (const [id, space] of [...of]) if (!things.has(space)) of.delete(id);
  const parentOf = (space: string): string | null => {
    let outer = splitNodeName(space).namespace;
    while (outer !== '/' && !things.has(outer)) outer = splitNodeName(outer).namespace;
    return outer === '/' ? null : outer;
  };
  const groups = [...things.keys()]
    .sort((a, b) => a.length - b.length || (a < b ? -1 : 1))
    .map((space): Group => ({ id: space, label: shortName(space), parent: parentOf(space) }));
  return { groups, of };
}

/** A name fit for a drawing: no character that turns or breaks the text, and a long one without its middle. */
export function shortName(name: string): string {
  const plain = name.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}\p{Cs}]/gu, '\ufffd');
  const letters = [...plain];
  if (letters.length <= LONGEST_LABEL) return plain;
  const half = Math.floor((LONGEST_LABEL - 1) / 2);
  return `${letters.slice(0, half).join('')}\u2026${letters.slice(-half).join('')}`;
}

function byKey<T>(a: readonly [string, T], b: readonly [string, T]): number {
  return a[0] < b[0] ? -1 : a[0] > b[0] ? 1 : 0;
}
