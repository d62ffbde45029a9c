// `ros2 doctor` in a site: why QoS policies do not fit, in rmw's words, exactly where the bus refuses a match; nodes that failed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { doctorCommand, misfitReason } from '../../../runtime/site/ros2cli/doctor_commands.ts';
import { misfitPolicy } from '../../../runtime/site/contract/qos_view.ts';
import type { EndpointQosView, NodeView, Session } from '../../../runtime/site/contract/session.ts';

const qos: EndpointQosView = {
  reliability: 'reliable',
  durability: 'volatile',
  history: 'keep_last',
  depth: 10,
  liveliness: 'automatic',
  deadlineNs: 0,
  lifespanNs: 0,
  leaseNs: 0,
};

test('there is a reason exactly where the bus sees a misfit', () => {
  const kinds: EndpointQosView[] = [];
  for (const reliability of ['reliable', 'best_effort'] as const)
    for (const durability of ['volatile', 'transient_local'] as const)
      for (const liveliness of ['automatic', 'manual_by_topic'] as const)
        for (const deadlineNs of [0, 1000, 2000])
          for (const leaseNs of [0, 1000, 2000]) kinds.push({ ...qos, reliability, durability, liveliness, deadlineNs, leaseNs });
  for (const offered of kinds) {
    for (const requested of kinds) {
      assert.equal(misfitReason(offered, requested) === '', misfitPolicy(offered, requested) === undefined, JSON.stringify([offered, requested]));
    }
  }
  assert.equal(misfitReason({ ...qos, reliability: 'best_effort', deadlineNs: 2 }, { ...qos, durability: 'transient_local', deadlineNs: 1 }),
    'ERROR: Best effort publisher and reliable subscription;ERROR: Volatile publisher and transient local subscription;ERROR: Subscription deadline is less than publisher deadline;');
});

async function looked(nodes: readonly Pick<NodeView, 'id' | 'state'>[], names: readonly string[]): Promise<readonly [string, string]> {
  let [out, warned] = ['', ''];
  const graph = {
    nodes: names.map((name) => ({
      name,
      process: undefined,
      publishers: [],
      subscriptions: [],
      services: [],
      clients: [],
      actionServers: [],
      actionClients: [],
    })),
  };
  const session = { link: 'shared', graph: () => graph, nodes: () => nodes } as unknown as Session;
  await doctorCommand.run({
    session,
    signal: new AbortController().signal,
    bags: { open: () => Promise.resolve(undefined), create: () => Promise.resolve(undefined) },
    readText: () => Promise.resolve(undefined),
    takeInput: () => undefined,
    codec: () => Promise.reject(new Error('none')),
    print: (text) => {
      out += text;
    },
    warn: (text) => {
      warned += `${text}\n`;
    },
  }, { positionals: [], options: new Map([['report-failed', '']]) });
  return [out, warned];
}

test('nodes that crashed fail, those with a code or a shared name are warned of', async () => {
  const [out, warned] = await looked([
    { id: 'talker-1', state: { kind: 'crashed', code: 'R2W0708', message: 'unreachable\nat main' } },
    { id: 'listener-1', state: { kind: 'exited', code: 3 } },
    { id: 'once-1', state: { kind: 'exited', code: 0 } },
    { id: 'late-1', state: { kind: 'running' } },
  ], ['/talker', '/twin', '/twin']);
  assert.equal(warned,
    ['UserWarning: ERROR: Node talker-1 has crashed (R2W0708): unreachable', 'UserWarning: Node listener-1 has exited with code 3.',
      'UserWarning: Several nodes have the name /twin.', ''].join('\n'));
  assert.equal(out,
    ['', '1/4 check(s) failed', '', 'Failed modules: node', '   NODE LIST', 'node    : talker-1', 'state   : crashed (R2W0708): unreachable',
      'node    : listener-1', 'state   : exited with code 3', 'node    : once-1', 'state   : exited with code 0', 'node    : late-1', 'state   : running'].join(
        '\n',
      ));
  assert.deepEqual(await looked([{ id: 'late-1', state: { kind: 'running' } }], ['/late']), ['\nAll 4 checks passed\n', '']);
});
