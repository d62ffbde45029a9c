// The services and actions of the graph that can be called, once each, however many nodes serve them. Pure.

import type { GraphView } from '../../contract/session.ts';
import { isHiddenName } from '../../decode/ros_names.ts';

export interface Callable {
  readonly kind: 'service' | 'action';
  readonly name: string;
  readonly type: string;
}

/** Services that every node has, for its parameters, type descriptions and logger levels. */
const EVERY_NODE = /^(?:rcl_interfaces|type_description_interfaces)\/srv\//;

/** One that somebody made, and that is not hidden. */
export function isShownService({ name, type }: { readonly name: string; readonly type: string; }): boolean {
  return !isHiddenName(name) && !EVERY_NODE.test(type);
}

/** With `all`: hidden ones, too, and those that every node has. */
export function endpointsToCall({ nodes }: GraphView, all: boolean): Callable[] {
  const found = new Map<string, Callable>();
  const add = (kind: Callable['kind'], name: string, type: string): void => {
    found.set(`${kind} ${name} ${type}`, { kind, name, type });
  };
  for (const { services, actionServers } of nodes) {
    for (const { name, type } of services) if (all || isShownService({ name, type })) add('service', name, type);
    for (const { name, type } of actionServers) if (all || !isHiddenName(name)) add('action', name, type);
  }
  return [...found.values()];
}
