// The services and actions of a graph that can be called.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { endpointsToCall } from '../../../runtime/site/ui/model/callable.ts';
import type { GraphEndpointView, GraphView } from '../../../runtime/site/contract/session.ts';

const service = (name: string, type: string): GraphEndpointView => ({
  name,
  type,
  hash: '',
  gid: '',
  qos: {
    reliability: 'reliable',
    durability: 'volatile',
    history: 'keep_last',
    depth: 10,
    liveliness: 'automatic',
    deadlineNs: 0,
    lifespanNs: 0,
    leaseNs: 0,
  },
});

test('services and actions are named once, and those of every node on request', () => {
  const node = {
    name: '/a',
    process: 'a-1',
    publishers: [],
    subscriptions: [],
    clients: [],
    actionClients: [],
    services: [service('/add', 'demo/srv/Add'), service('/a/get_parameters', 'rcl_interfaces/srv/GetParameters'),
      service('/count/_action/send_goal', 'demo/action/Count_SendGoal')],
    actionServers: [{ name: '/count', type: 'demo/action/Count' }],
  };
  const graph: GraphView = { nodes: [node, { ...node, name: '/b' }] };
  assert.deepEqual(endpointsToCall(graph, false), [
    { kind: 'service', name: '/add', type: 'demo/srv/Add' },
    { kind: 'action', name: '/count', type: 'demo/action/Count' },
  ]);
  assert.equal(endpointsToCall(graph, true).length, 4);
});
