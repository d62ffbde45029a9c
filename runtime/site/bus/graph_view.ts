// The graph as the page and commands see it: nodes with their endpoints, without hidden internals. Pure.

import { EndpointKind } from '../../protocol/generated/constants.ts';
import { joinName } from '../decode/ros_names.ts';
import { type EndpointRecord, hiddenNamespace, type NodeRecord } from './graph.ts';
import type { GraphActionView, GraphEndpointView, GraphNodeView, GraphView } from '../contract/page_node.ts';
import { endpointQosView } from '../contract/qos_view.ts';

/** `process`: which node of the site a participant runs. */
export function graphView(
  nodes: Iterable<NodeRecord>,
  records: readonly EndpointRecord[],
  process: (participant: number) => string | undefined,
): GraphView {
  const byNode = new Map<number, EndpointRecord[]>();
  for (const record of records) {
    const list = byNode.get(record.nodeKey);
    if (list === undefined) byNode.set(record.nodeKey, [record]);
    else list.push(record);
  }
  const views = [...nodes].filter(({ namespace }) => namespace !== hiddenNamespace).map((node): GraphNodeView => {
    const own = byNode.get(node.key) ?? [];
    const ofKind = (kind: number): GraphEndpointView[] => own.filter((record) => record.kind === kind).map(endpointView).sort(byName);
    const services = ofKind(EndpointKind.server);
    const clients = ofKind(EndpointKind.client);
    return {
      name: joinName(node.namespace, node.name),
      process: process(node.participant),
      publishers: ofKind(EndpointKind.publisher),
      subscriptions: ofKind(EndpointKind.subscription),
      services,
      clients,
      actionServers: actionsOf(services),
      actionClients: actionsOf(clients),
    };
  });
  return { nodes: views.sort(byName) };
}

/** As rmw tells actions: by the service that takes goals. */
function actionsOf(endpoints: readonly GraphEndpointView[]): GraphActionView[] {
  const found = new Map<string, GraphActionView>();
  for (const { name, type } of endpoints) {
    const action = /^(.+)\/_action\/send_goal$/.exec(name)?.[1];
    const of = /^(.+)_SendGoal$/.exec(type)?.[1];
    if (action !== undefined && of !== undefined) found.set(`${action} ${of}`, { name: action, type: of });
  }
  return [...found.values()];
}

function endpointView({ name, type, hash, qos, gid }: EndpointRecord): GraphEndpointView {
  return { name, type, hash, qos: endpointQosView(qos), gid: gidText(gid) };
}

export function gidText(words: Int32Array): string {
  const bytes = new Uint8Array(words.slice().buffer);
  return hexText(bytes);
}

export function hexText(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

function byName(a: { readonly name: string; }, b: { readonly name: string; }): number {
  return a.name < b.name ? -1 : a.name > b.name ? 1 : 0;
}
