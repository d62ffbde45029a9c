// Lists out of the graph, as the commands show them: topics, services, actions with their types. Pure.

import { isHiddenName } from '../decode/ros_names.ts';
import type { GraphEndpointView, GraphNodeView, GraphView } from '../contract/session.ts';

export interface Named {
  readonly name: string;
  /** Sorted, without repetition. */
  readonly types: readonly string[];
}

export function named(list: Iterable<{ readonly name: string; readonly type: string; }>): Named[] {
  const found = new Map<string, Set<string>>();
  for (const { name, type } of list) {
    const types = found.get(name);
    if (types === undefined) found.set(name, new Set([type]));
    else types.add(type);
  }
  return [...found].map(([name, types]) => ({ name, types: [...types].sort() })).sort(byName);
}

export function topicsOf(graph: GraphView): Named[] {
  return named(graph.nodes.flatMap(({ publishers, subscriptions }) => [...publishers, ...subscriptions]));
}

export function servicesOf(graph: GraphView): Named[] {
  return named(graph.nodes.flatMap(({ services }) => services));
}

export function actionsOf(graph: GraphView): Named[] {
  return named(graph.nodes.flatMap(({ actionServers, actionClients }) => [...actionServers, ...actionClients]));
}

const ofContainers = ['load_node', 'unload_node', 'list_nodes'];

/** Full names of the nodes that take components. */
export function containersOf(graph: GraphView): string[] {
  return graph.nodes.filter(({ services }) => ofContainers.every((verb) => services.some(({ name }) => name.endsWith(`_container/${verb}`)))).map(({ name }) =>
    name
  ).sort();
}

export interface OfNode {
  readonly node: GraphNodeView;
  readonly endpoint: GraphEndpointView;
}

/** All endpoints of one kind that bear the name. */
export function endpointsOf(
  graph: GraphView,
  kind: 'publishers' | 'subscriptions' | 'services' | 'clients',
  name: string,
): OfNode[] {
  return graph.nodes.flatMap((node) => node[kind].filter((endpoint) => endpoint.name === name).map((endpoint) => ({ node, endpoint })));
}

export function shown<T extends { readonly name: string; }>(list: readonly T[], hiddenToo: boolean): T[] {
  return hiddenToo ? [...list] : list.filter(({ name }) => !isHiddenName(name));
}

function byName(a: Named, b: Named): number {
  return a.name < b.name ? -1 : 1;
}
