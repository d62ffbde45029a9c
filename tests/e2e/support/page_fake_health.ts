// The scene "health" of page_fake.tsx: managed nodes on a real graph, by hand, and a topic of diagnostics.
// `globalThis.driver` lets a test change its answers, leave and come again.

import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { createCodec, type Codec } from '../../../runtime/site/decode/codec.ts';
import { FakeSession } from '../../unit/ui/fake_session.ts';
import { GraphPeer } from '../../unit/site/graph_peer.ts';
import { followGraph } from './page_fake_graph.ts';

type Value = Readonly<Record<string, unknown>>;

export const HEALTH_INTERFACES: ReadonlyMap<string, string> = new Map([
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['diagnostic_msgs/msg/DiagnosticArray', 'std_msgs/Header header\nDiagnosticStatus[] status\n'],
  ['diagnostic_msgs/msg/DiagnosticStatus', 'byte level\nstring name\nstring message\nstring hardware_id\nKeyValue[] values\n'],
  ['diagnostic_msgs/msg/KeyValue', 'string key\nstring value\n'],
  ['lifecycle_msgs/msg/State', 'uint8 id\nstring label\n'],
  ['lifecycle_msgs/msg/Transition', 'uint8 id\nstring label\n'],
  ['lifecycle_msgs/msg/TransitionDescription', 'Transition transition\nState start_state\nState goal_state\n'],
  ['lifecycle_msgs/msg/TransitionEvent', 'uint64 timestamp\nTransition transition\nState start_state\nState goal_state\n'],
  ['lifecycle_msgs/srv/GetState', '---\nState current_state\n'],
  ['lifecycle_msgs/srv/GetAvailableTransitions', '---\nTransitionDescription[] available_transitions\n'],
  ['lifecycle_msgs/srv/ChangeState', 'Transition transition\n---\nbool success\n'],
]);

const STATES: Readonly<Record<number, string>> = { 1: 'unconfigured', 2: 'inactive', 3: 'active', 4: 'finalized' };
const TRANSITIONS = [
  { id: 1, label: 'configure', from: 1, to: 2 },
  { id: 2, label: 'cleanup', from: 2, to: 1 },
  { id: 3, label: 'activate', from: 2, to: 3 },
  { id: 4, label: 'deactivate', from: 3, to: 2 },
  { id: 5, label: 'shutdown', from: 1, to: 4 },
] as const;

export class ManagedPeer {
  /** Its callbacks fail. */
  refuses = false;
  /** It takes requests and does not answer them. */
  silent = false;
  private peer: GraphPeer | undefined;
  private events = -1;
  private state = 1;
  private readonly fake: FakeSession;
  private readonly codec: Codec;
  private readonly name: string;
  private readonly dress: (label: string) => string;

  /** `dress`: what its states and transitions are called, by what they are called elsewhere. */
  constructor(fake: FakeSession, codec: Codec, name: string, dress = (label: string): string => label) {
    this.fake = fake;
    this.codec = codec;
    this.name = name;
    this.dress = dress;
    this.come();
  }

  come(): void {
    const peer = new GraphPeer(this.fake.broker);
    this.peer = peer;
    this.state = 1;
    this.events = peer.make(EndpointKind.publisher, this.name, `/${this.name}/transition_event`, 'lifecycle_msgs/msg/TransitionEvent', { depth: 100 });
    this.serve(peer, 'get_state', 'GetState', () => ({ current_state: this.stateOf(this.state) }));
    this.serve(peer, 'get_available_transitions', 'GetAvailableTransitions', () => ({
      available_transitions: TRANSITIONS.filter(({ from }) => from === this.state).map(({ id, label, from, to }) => ({
        transition: { id, label: this.dress(label) },
        start_state: this.stateOf(from),
        goal_state: this.stateOf(to),
      })),
    }));
    this.serve(peer, 'change_state', 'ChangeState', ({ transition }) => {
      const { id } = transition as { readonly id: number; };
      const chosen = TRANSITIONS.find((each) => each.id === id && each.from === this.state);
      if (chosen === undefined || this.refuses) return { success: false };
      this.go(chosen.label, chosen.to);
      return { success: true };
    });
  }

  /** As asked by somebody else. */
  go(label: string, to: number): void {
    const event = { transition: { id: 0, label: this.dress(label) }, start_state: this.stateOf(this.state), goal_state: this.stateOf(to) };
    this.state = to;
    this.peer?.write(this.events, this.bytes('lifecycle_msgs/msg/TransitionEvent', event));
  }

  leave(): void {
    this.peer?.leave();
    this.peer = undefined;
  }

  private serve(peer: GraphPeer, service: string, type: string, answer: (request: Value) => Value): void {
    const handle = peer.make(EndpointKind.server, this.name, `/${this.name}/${service}`, `lifecycle_msgs/srv/${type}`);
    const work = async (): Promise<void> => {
      while (this.peer === peer) {
        const request = await peer.next(handle);
        if (this.peer !== peer || this.silent) continue;
        const decoded = this.codec.decode(`lifecycle_msgs/srv/${type}_Request`, request.bytes);
        if (decoded.kind === 'failed') throw new Error(decoded.reason);
        peer.write(handle, this.bytes(`lifecycle_msgs/srv/${type}_Response`, answer(decoded.value as Value)), request);
      }
    };
    void work();
  }

  private stateOf(id: number): Value {
    return { id, label: this.dress(STATES[id] ?? 'unknown') };
  }

  private bytes(type: string, value: Value): Uint8Array {
    const made = this.codec.encode(type, value);
    if (made.kind === 'failed') throw new Error(`${made.path}: ${made.reason}`);
    return made.bytes;
  }
}

export async function health(): Promise<FakeSession> {
  const fake = new FakeSession({ nodes: [{ executable: 'driver' }], interfaces: HEALTH_INTERFACES });
  fake.setTopics([{ name: '/diagnostics', type: 'diagnostic_msgs/msg/DiagnosticArray' }]);
  const codec = createCodec(await fake.interfaces());
  const driver = new ManagedPeer(fake, codec, 'driver');
  const camera = new ManagedPeer(fake, codec, 'camera');
  followGraph(fake);
  Object.assign(globalThis, { driver, camera });
  return fake;
}
