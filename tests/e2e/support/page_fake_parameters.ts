// The scene "parameters" of page_fake.tsx: nodes on a real graph that serve their parameters, by hand. `globalThis.robot`
// lets a test change them, leave and come again.

import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import { createCodec, type Codec } from '../../../runtime/site/decode/codec.ts';
import { FakeSession } from '../../unit/ui/fake_session.ts';
import { GraphPeer } from '../../unit/site/graph_peer.ts';
import { followGraph } from './page_fake_graph.ts';

type Value = Readonly<Record<string, unknown>>;

interface Declared {
  value: Value;
  readonly descriptor: Value;
}

const RANGE = 'from_value\nTYPE to_value\nSTEP step\n';
const INTERFACES = new Map([
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
  ['rcl_interfaces/msg/ParameterValue',
    'uint8 type\nbool bool_value\nint64 integer_value\nfloat64 double_value\nstring string_value\nbyte[] byte_array_value\nbool[] bool_array_value\nint64[] integer_array_value\nfloat64[] double_array_value\nstring[] string_array_value\n'],
  ['rcl_interfaces/msg/Parameter', 'string name\nParameterValue value\n'],
  ['rcl_interfaces/msg/ParameterEvent',
    'builtin_interfaces/Time stamp\nstring node\nParameter[] new_parameters\nParameter[] changed_parameters\nParameter[] deleted_parameters\n'],
  ['rcl_interfaces/msg/IntegerRange', `int64 ${RANGE.replace('TYPE', 'int64').replace('STEP', 'uint64')}`],
  ['rcl_interfaces/msg/FloatingPointRange', `float64 ${RANGE.replace('TYPE', 'float64').replace('STEP', 'float64')}`],
  ['rcl_interfaces/msg/ParameterDescriptor',
    'string name\nuint8 type\nstring description\nstring additional_constraints\nbool read_only\nbool dynamic_typing\nFloatingPointRange[<=1] floating_point_range\nIntegerRange[<=1] integer_range\n'],
  ['rcl_interfaces/msg/ListParametersResult', 'string[] names\nstring[] prefixes\n'],
  ['rcl_interfaces/msg/SetParametersResult', 'bool successful\nstring reason\n'],
  ['rcl_interfaces/srv/ListParameters', 'string[] prefixes\nuint64 depth\n---\nListParametersResult result\n'],
  ['rcl_interfaces/srv/GetParameters', 'string[] names\n---\nParameterValue[] values\n'],
  ['rcl_interfaces/srv/SetParameters', 'Parameter[] parameters\n---\nSetParametersResult[] results\n'],
  ['rcl_interfaces/srv/DescribeParameters', 'string[] names\n---\nParameterDescriptor[] descriptors\n'],
]);

/** A node of the graph. Without parameters it takes questions and answers none. */
class ParameterNode {
  private peer: GraphPeer | undefined;
  private events = -1;
  private readonly fake: FakeSession;
  private readonly codec: Codec;
  private readonly name: string;
  readonly declared: Map<string, Declared> | undefined;

  constructor(fake: FakeSession, codec: Codec, name: string, declared: Map<string, Declared> | undefined) {
    this.fake = fake;
    this.codec = codec;
    this.name = name;
    this.declared = declared;
    this.come();
  }

  come(): void {
    const peer = new GraphPeer(this.fake.broker);
    this.peer = peer;
    this.events = peer.make(EndpointKind.publisher, this.name, '/parameter_events', 'rcl_interfaces/msg/ParameterEvent', { depth: 1000 });
    this.serve(peer, 'list_parameters', 'ListParameters', () => ({ result: { names: [...(this.declared ?? new Map<string, Declared>()).keys()] } }));
    this.serve(peer, 'get_parameters', 'GetParameters', ({ names }) => ({ values: (names as string[]).map((name) => this.declared?.get(name)?.value ?? {}) }));
    this.serve(peer, 'describe_parameters', 'DescribeParameters', ({ names }) => ({
      descriptors: (names as string[]).map((name) => ({ name, ...this.declared?.get(name)?.descriptor })),
    }));
    this.serve(peer, 'set_parameters', 'SetParameters', ({ parameters }) => ({
      results: (parameters as { readonly name: string; readonly value: Value; }[]).map(({ name, value }) => {
        if (value['type'] === 3 && Number(value['double_value']) > 2) return { successful: false, reason: `${name} must not be above 2.0` };
        this.change(name, value);
        return { successful: true, reason: '' };
      }),
    }));
  }

  /** As by the node itself: told on /parameter_events. */
  change(name: string, value: Value): void {
    const known = this.declared?.get(name);
    this.declared?.set(name, { value, descriptor: known?.descriptor ?? { description: 'came later' } });
    this.tell({ [known === undefined ? 'new_parameters' : 'changed_parameters']: [{ name, value }] });
  }

  remove(name: string): void {
    this.declared?.delete(name);
    this.tell({ deleted_parameters: [{ name }] });
  }

  leave(): void {
    this.peer?.leave();
    this.peer = undefined;
  }

  private tell(event: Value): void {
    this.peer?.write(this.events, this.bytes('rcl_interfaces/msg/ParameterEvent', { node: `/${this.name}`, ...event }));
  }

  private serve(peer: GraphPeer, service: string, type: string, answer: (request: Value) => Value): void {
    const handle = peer.make(EndpointKind.server, this.name, `/${this.name}/${service}`, `rcl_interfaces/srv/${type}`);
    const work = async (): Promise<void> => {
      while (this.peer === peer) {
        const request = await peer.next(handle);
        if (this.peer !== peer || this.declared === undefined) continue;
        const decoded = this.codec.decode(`rcl_interfaces/srv/${type}_Request`, request.bytes);
        if (decoded.kind === 'failed') throw new Error(decoded.reason);
        peer.write(handle, this.bytes(`rcl_interfaces/srv/${type}_Response`, answer(decoded.value as Value)), request);
      }
    };
    void work();
  }

  private bytes(type: string, value: Value): Uint8Array {
    const made = this.codec.encode(type, value);
    if (made.kind === 'failed') throw new Error(`${made.path}: ${made.reason}`);
    return made.bytes;
  }
}

export async function parameters(hostile: string): Promise<FakeSession> {
  const fake = new FakeSession({ nodes: [{ executable: 'robot' }], interfaces: INTERFACES, ui: { text: 'text/lab/README.md' }, files: ['text/lab/README.md'] });
  const codec = createCodec(await fake.interfaces());
  const plain = (value: Value, descriptor: Value = {}): Declared => ({ value, descriptor: { type: value['type'], ...descriptor } });
  const robot = new ParameterNode(fake, codec, 'robot', new Map([
    ['speed', plain({ type: 3, double_value: 1.5 }, {
      description: 'How fast it may go, in m/s',
      floating_point_range: [{ from_value: 0, to_value: 4, step: 0.5 }],
    })],
    ['wheels.count',
      plain({ type: 2, integer_value: 4n }, { integer_range: [{ from_value: 2n, to_value: 8n, step: 2n }], additional_constraints: 'an even number' })],
    ['wheels.radius', plain({ type: 3, double_value: 0.1 })],
    ['use_sim_time', plain({ type: 1, bool_value: false })],
    ['frame', plain({ type: 4, string_value: 'base_link' }, { read_only: true, description: 'Decided at the start' })],
    ['motto', plain({ type: 4, string_value: 'first line\nsecond line' })],
    ['joints', plain({ type: 9, string_array_value: ['base', 'it\'s, "quoted"'] })],
    ['lengths', plain({ type: 8, double_array_value: [1, 0.5] })],
    ['image', plain({ type: 5, byte_array_value: [222, 173, 190, 239] })],
    ['anything', plain({ type: 0 }, { dynamic_typing: true })],
    [hostile, plain({ type: 4, string_value: hostile }, { description: hostile })],
    ['__proto__', plain({ type: 2, integer_value: 9007199254740993n })],
  ]));
  const silent = new ParameterNode(fake, codec, 'silent', undefined);
  followGraph(fake);
  Object.assign(globalThis, { robot, silent });
  return fake;
}
