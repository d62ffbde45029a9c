// The page with a fake session, for tests in a browser. The scene is chosen by the address: ?scene=NAME.
// The session is reachable as globalThis.fake.

import { EndpointKind } from '../../../runtime/protocol/generated/constants.ts';
import type { GraphEndpointView, GraphNodeView, GraphView } from '../../../runtime/site/contract/session.ts';
import type { Sample } from '../../unit/site/graph_peer.ts';
import type { PagePublisher } from '../../../runtime/site/contract/session.ts';
import { mountPage } from '../../../runtime/site/ui/mount.tsx';
import { FakeChecks, type FakeOptions, FakeSession, FakeTasks, stringBytes } from '../../unit/ui/fake_session.ts';

const INTERFACES = new Map([
  ['std_msgs/msg/String', 'string data\n'],
  ['std_msgs/msg/Header', 'builtin_interfaces/Time stamp\nstring frame_id\n'],
  ['builtin_interfaces/msg/Time', 'int32 sec\nuint32 nanosec\n'],
  [
    'sensor_msgs/msg/LaserScan',
    'std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32[] ranges\n',
  ],
]);

const HOSTILE = '<img src=x onerror="document.title=\'owned\'"><script>document.title="owned"</script>';

function talkerListener(options: { readonly link?: 'shared' | 'port'; } = {}): FakeSession {
  const fake = new FakeSession({
    nodes: [{ executable: 'talker' }, { executable: 'listener' }],
    interfaces: INTERFACES,
    ...options,
  });
  let count = 0;
  const beat = (): void => {
    if (fake.nodes()[0]?.state.kind !== 'running') return;
    const text = `Hello, world! ${count}`;
    count += 1;
    fake.log('talker-1', 'INFO', `Publishing: '${text}'`);
    fake.log('listener-2', 'INFO', `I heard: '${text}'`);
    fake.publish('/topic', stringBytes(text));
    fake.setTopics([
      { name: '/topic', type: 'std_msgs/msg/String', rateHz: 2, bytesPerSecond: 56, count },
      {
        name: '/rosout',
        type: 'rcl_interfaces/msg/Log',
        publishers: 2,
        subscriptions: 0,
        rateHz: 4,
        bytesPerSecond: 480,
        count,
      },
      {
        name: '/parameter_events',
        type: 'rcl_interfaces/msg/ParameterEvent',
        publishers: 2,
        subscriptions: 2,
      },
    ]);
  };
  for (let i = 0; i < 12; i += 1) beat();
  setInterval(beat, 500);
  return fake;
}

function crowd(): FakeSession {
  const fake = new FakeSession({
    title: 'Mobile robot in a warehouse, exercise sheet 4',
    nodes: [
      { executable: 'diff_drive', package: 'mobile_robot', label: '/robot/diff_drive' },
      { executable: 'laser', package: 'mobile_robot', label: '/robot/laser' },
      { executable: 'planner', package: 'mobile_robot', label: '/planner' },
      { executable: 'safety', package: 'mobile_robot', label: '/safety' },
      { executable: 'logger', package: 'course_tools', label: '/logger' },
    ],
    interfaces: INTERFACES,
    link: 'port',
  });
  fake.log('diff_drive-1', 'INFO', 'Wheel separation 0.287 m, wheel radius 0.033 m');
  fake.log('diff_drive-1', 'DEBUG', 'cmd_vel 0.20 0.05');
  fake.log(
    'diff_drive-1',
    'WARN',
    'cmd_vel is 0.6 s old, stopping the wheels until a newer one comes',
  );
  fake.log('diff_drive-1', 'ERROR', 'Left motor does not answer');
  fake.log('diff_drive-1', 'FATAL', 'Giving up');
  fake.print(
    'laser-2',
    '\x1b[32mscan\x1b[0m ready, \x1b[1;34m360\x1b[0m beams, \x1b[7minverse\x1b[0m \x1b[41mred ground\x1b[0m',
  );
  fake.setState('planner-3', {
    kind: 'crashed',
    code: 'R2W0702',
    message:
      "terminate called after throwing an instance of 'std::out_of_range'\n  what():  vector::_M_range_check: __n (which is 7) >= this->size() (which is 7)",
  });
  fake.setState('safety-4', { kind: 'exited', code: 1 });
  fake.setState('logger-5', { kind: 'starting' });
  fake.setTopics([
    {
      name: '/scan',
      type: 'sensor_msgs/msg/LaserScan',
      rateHz: 10.02,
      bytesPerSecond: 14_820,
      count: 812,
      subscriptions: 2,
    },
    {
      name: '/odom',
      type: 'nav_msgs/msg/Odometry',
      rateHz: 29.9,
      bytesPerSecond: 21_300,
      count: 2390,
    },
    { name: '/cmd_vel', type: 'geometry_msgs/msg/Twist', publishers: 0, subscriptions: 1 },
    { name: '/tf', type: 'tf2_msgs/msg/TFMessage', rateHz: 60, bytesPerSecond: 9_100, count: 4900 },
    {
      name: '/map',
      type: 'nav_msgs/msg/OccupancyGrid',
      qos: [
        { reliability: 'reliable', durability: 'transient_local', history: 'keep_last', depth: 1 },
      ],
    },
  ]);
  fake.publish('/scan', scanBytes());
  return fake;
}

/** A LaserScan with 360 beams, written by hand: header, stamp, "laser", two angles, the ranges. */
function scanBytes(): Uint8Array {
  const bytes = new Uint8Array(4 + 8 + 4 + 8 + 8 + 4 + 360 * 4);
  const view = new DataView(bytes.buffer);
  bytes[1] = 1;
  view.setInt32(4, 1700000000, true);
  view.setUint32(8, 250000000, true);
  view.setUint32(12, 6, true);
  bytes.set(new TextEncoder().encode('laser\0'), 16);
  view.setFloat32(24, -3.14159, true);
  view.setFloat32(28, 3.14159, true);
  view.setUint32(32, 360, true);
  for (let i = 0; i < 360; i += 1) view.setFloat32(36 + i * 4, 1 + Math.sin(i / 20), true);
  return bytes;
}

function hostile(): FakeSession {
  const fake = new FakeSession({
    title: HOSTILE,
    authors: [HOSTILE],
    nodes: [
      {
        executable: 'talker',
        label: `/${HOSTILE}`,
        package: HOSTILE,
        source: { file: HOSTILE, line: 1, column: 1 },
      },
    ],
    interfaces: new Map([['std_msgs/msg/String', 'string data\n']]),
  });
  fake.print(
    'talker-1',
    HOSTILE,
    `[INFO] [1.0] [${HOSTILE}]: ${HOSTILE}`,
    `\x1b[31m${HOSTILE}\x1b[0m`,
    '\u202e\u2066 turned around',
    'x'.repeat(50_000),
  );
  fake.setTopics([
    { name: `/${HOSTILE}`, type: 'std_msgs/msg/String', count: 1 },
    { name: '/odd', type: HOSTILE, count: 1 },
  ]);
  fake.setGraph({
    nodes: [
      graphNode(`/${HOSTILE}`, 'talker-1', { publishers: [endpoint(`/__proto__/${HOSTILE}`, HOSTILE), endpoint('/\u202eodd\u0000', HOSTILE)] }),
      graphNode('/__proto__', 'talker-1', { subscriptions: [endpoint(`/__proto__/${HOSTILE}`, HOSTILE)] }),
      graphNode('/constructor', 'talker-1', { subscriptions: [endpoint(`/${'x'.repeat(5000)}`, HOSTILE)] }),
    ],
  });
  fake.publish(`/${HOSTILE}`, stringBytes(HOSTILE));
  fake.publish('/odd', stringBytes(HOSTILE));
  return fake;
}

/** Messages that really pass the graph: `globalThis.send(topic, type, value)` publishes one. */
async function signals(options: Partial<FakeOptions> = {}): Promise<FakeSession> {
  const fake = new FakeSession({
    nodes: [{ executable: 'robot' }],
    ...options,
    interfaces: new Map([
      ...INTERFACES,
      [
        'sensor_msgs/msg/Image',
        'std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\nuint32 step\nuint8[] data\n',
      ],
      [
        'sensor_msgs/msg/CompressedImage',
        'std_msgs/Header header\nstring format\nuint8[] data\n',
      ],
      [
        'rcl_interfaces/msg/Log',
        'builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\nstring function\nuint32 line\n',
      ],
      ['demo/srv/Add', 'int64 a\nint64 b\n---\nint64 sum\n'],
      ['service_msgs/msg/ServiceEventInfo', 'uint8 event_type\nbuiltin_interfaces/Time stamp\nchar[16] client_gid\nint64 sequence_number\n'],
      ['demo/msg/Sine', 'float64 value\nfloat64 other\nfloat32[] list\nstring mode\nint64 big\n'],
    ]),
  });
  fake.setTopics([
    { name: '/sine', type: 'demo/msg/Sine', rateHz: 100 },
    { name: '/camera', type: 'sensor_msgs/msg/Image' },
    { name: '/camera/compressed', type: 'sensor_msgs/msg/CompressedImage' },
    { name: '/rosout', type: 'rcl_interfaces/msg/Log' },
  ]);
  await giveSend(fake);
  return fake;
}

/** Frames and what stands in them; `globalThis.send` as in "signals", `goals` has what was published on /goal_pose, /initialpose and /clicked_point, `joints` what was on /joint_states. */
async function world(): Promise<FakeSession> {
  const { WORLD_FILES, WORLD_INTERFACES, WORLD_TOPICS } = await import('./world_interfaces.ts');
  const fake = new FakeSession({
    nodes: [{ executable: 'robot' }],
    interfaces: new Map(WORLD_INTERFACES),
    files: WORLD_FILES,
    ui: { opens: [{ panel: 'scene', file: 'share/meshes/view.rviz' }, { panel: 'joints' }, { panel: 'none' }, 7] },
  });
  fake.setTopics(WORLD_TOPICS);
  await giveSend(fake);
  const { createCodec } = await import('../../../runtime/site/decode/codec.ts');
  const codec = createCodec(await fake.interfaces());
  const goals: unknown[] = [];
  const listen = (topic: string, type: string, list: unknown[]): void => {
    fake.node().subscription(topic, type, {}, (bytes) => {
      const decoded = codec.decode(type, bytes);
      list.push(decoded.kind === 'value' ? decoded.value : decoded.reason);
    });
  };
  for (const [topic, name] of [['/goal_pose', 'PoseStamped'], ['/initialpose', 'PoseWithCovarianceStamped'], ['/clicked_point', 'PointStamped']] as const)
    listen(topic, `geometry_msgs/msg/${name}`, goals);
  const joints: unknown[] = [];
  listen('/joint_states', 'sensor_msgs/msg/JointState', joints);
  Object.assign(globalThis, { goals, joints });
  return fake;
}

/** Two turtle simulators, whose scenes a test sends; what drives /turtle1 and /two/turtle2 is in `globalThis.moves`. */
async function turtles(): Promise<FakeSession> {
  const fake = new FakeSession({
    nodes: [{ executable: 'turtlesim_node', package: 'turtlesim' }],
    checks: [{ title: '', aim: { kind: 'rate', topic: '/turtle1/pose' }, withinMs: 10_000 }],
    interfaces: new Map([
      ['turtlesim_scene/msg/Scene',
        'uint16 width\nuint16 height\nfloat32 meter\nuint8[3] background\nTurtle[] turtles\nuint32 picture\nuint32 first\nStroke[] strokes\n'],
      ['turtlesim_scene/msg/Turtle', 'string name\nfloat32 x\nfloat32 y\nfloat32 theta\nuint8 shape\nuint8[3] pen\nuint8 pen_width\nbool pen_on\n'],
      ['turtlesim_scene/msg/Stroke', 'float32 x1\nfloat32 y1\nfloat32 x2\nfloat32 y2\nuint8 r\nuint8 g\nuint8 b\nuint8 width\n'],
      ['geometry_msgs/msg/Twist', 'Vector3 linear\nVector3 angular\n'],
      ['geometry_msgs/msg/Vector3', 'float64 x\nfloat64 y\nfloat64 z\n'],
    ]),
  });
  fake.setTopics(['/turtlesim/_scene', '/two/turtlesim/_scene'].map((name) => ({ name, type: 'turtlesim_scene/msg/Scene' })));
  await giveSend(fake);
  const moves: string[] = [];
  for (const topic of ['/turtle1/cmd_vel', '/two/turtle2/cmd_vel']) {
    fake.node().subscription(topic, 'geometry_msgs/msg/Twist', { depth: 100 }, (bytes) => {
      const view = new DataView(bytes.buffer, bytes.byteOffset);
      moves.push(`${topic} ${view.getFloat64(4, true)} ${view.getFloat64(44, true)}`);
    });
  }
  Object.assign(globalThis, { moves });
  return fake;
}

async function giveSend(fake: FakeSession): Promise<void> {
  const { createCodec } = await import('../../../runtime/site/decode/codec.ts');
  const codec = createCodec(await fake.interfaces());
  const publishers = new Map<string, PagePublisher>();
  Object.assign(globalThis, {
    send: (topic: string, type: string, value: unknown): void => {
      const { qos } = fake.topics().find(({ name }) => name === topic) ?? {};
      const publisher = publishers.get(topic) ?? fake.node().publisher(topic, type, { ...qos?.[0], depth: 1000 });
      publishers.set(topic, publisher);
      const made = codec.encode(type, value);
      if (made.kind !== 'bytes') throw new Error(made.reason);
      const problem = publisher.publish(made.bytes);
      if (problem !== undefined) throw problem;
    },
    heard: (topic: string): number => publishers.get(topic)?.matched() ?? 0,
  });
}

/** A site with a text: the test puts the files beside the page. */
function sheet(): FakeSession {
  return new FakeSession({
    nodes: [{ executable: 'talker' }, { executable: 'listener' }],
    interfaces: INTERFACES,
    ui: { text: 'text/lab/README.md' },
    files: ['text/lab/README.md', 'text/lab/arm 1.svg', 'text/logo.svg'],
  });
}

/** A service that adds and an action that counts, served by another participant of a real graph. `globalThis.leave()` ends it, `hush(true)` silences the service. */
async function services(options: Partial<FakeOptions> = {}): Promise<FakeSession> {
  // Not part of the first view, which a test measures.
  const { GraphPeer } = await import('../../unit/site/graph_peer.ts');
  const fake = new FakeSession({
    nodes: [{ executable: 'server' }],
    ...options,
    interfaces: new Map([
      ['demo/srv/Add', 'int64 a\nint64 b\n---\nint64 sum\n'],
      ['demo/action/Count', 'int32 to\n---\nint32 end\n---\nint32 now\n'],
    ]),
  });
  const peer = new GraphPeer(fake.broker);
  const at = (part: string): string => `/count/_action/${part}`;
  const body = (...values: readonly number[]): Uint8Array => new Uint8Array([0, 1, 0, 0, ...values]);
  const add = peer.make(EndpointKind.server, 'server', '/add', 'demo/srv/Add');
  const goals = peer.make(EndpointKind.server, 'server', at('send_goal'), 'demo/action/Count_SendGoal');
  const cancels = peer.make(EndpointKind.server, 'server', at('cancel_goal'), 'action_msgs/srv/CancelGoal');
  const results = peer.make(EndpointKind.server, 'server', at('get_result'), 'demo/action/Count_GetResult');
  const feedback = peer.make(EndpointKind.publisher, 'server', at('feedback'), 'demo/action/Count_FeedbackMessage');
  peer.make(EndpointKind.publisher, 'server', at('status'), 'action_msgs/msg/GoalStatusArray', { depth: 1, durability: 'transient_local' });
  let asked: Sample | undefined;
  let canceled = false;
  let here = true;
  let hushed = false;
  const serve = async (endpoint: number, answer: (request: Sample) => void): Promise<void> => {
    while (here) {
      const request = await peer.next(endpoint);
      if (here) answer(request);
    }
  };
  void serve(add, (request) => {
    if (hushed) return;
    const view = new DataView(request.bytes.buffer);
    const reply = body(...new Uint8Array(8));
    new DataView(reply.buffer).setBigInt64(4, view.getBigInt64(4, true) + view.getBigInt64(12, true), true);
    peer.write(add, reply, request);
  });
  void serve(goals, (request) => {
    canceled = false;
    peer.write(goals, body(1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0), request);
    peer.write(feedback, body(...request.bytes.subarray(4, 20), 42, 0, 0, 0));
  });
  void serve(results, (request) => {
    if (canceled) peer.write(results, body(5, 0, 0, 0, 9, 0, 0, 0), request);
    else asked = request;
  });
  void serve(cancels, (request) => {
    canceled = true;
    peer.write(cancels, body(0, 0, 0, 0, 1, 0, 0, 0, ...request.bytes.subarray(4, 28)), request);
    if (asked !== undefined) peer.write(results, body(5, 0, 0, 0, 9, 0, 0, 0), asked);
  });
  const shown: GraphView = {
    nodes: [{
      name: '/server',
      process: 'server-1',
      publishers: [],
      subscriptions: [],
      clients: [],
      actionClients: [],
      services: [endpoint('/add', 'demo/srv/Add'), endpoint('/server/get_parameters', 'rcl_interfaces/srv/GetParameters')],
      actionServers: [{ name: '/count', type: 'demo/action/Count' }],
    }],
  };
  fake.setGraph(shown);
  Object.assign(globalThis, {
    hush: (on: boolean): void => {
      hushed = on;
    },
    leave: (): void => {
      here = false;
      peer.leave();
      fake.setGraph({ nodes: [] });
    },
  });
  return fake;
}

function graphNode(name: string, process: string, has: Partial<GraphNodeView> = {}): GraphNodeView {
  const rosout = endpoint('/rosout', 'rcl_interfaces/msg/Log');
  return {
    name,
    process,
    subscriptions: [],
    services: [],
    clients: [],
    actionServers: [],
    actionClients: [],
    ...has,
    publishers: [...(has.publishers ?? []), rosout],
  };
}

/** A robot in a namespace, a planner with an action, and nodes that a test adds and takes away: `globalThis.robotNodes()` is its graph. */
function graph(): FakeSession {
  const fake = new FakeSession({
    nodes: [
      { executable: 'laser', label: '/robot/laser' },
      { executable: 'diff_drive', label: '/robot/diff_drive' },
      { executable: 'planner', label: '/planner' },
      { executable: 'mission', label: '/mission' },
      { executable: 'safety', label: '/safety' },
    ],
    interfaces: INTERFACES,
  });
  const scan = endpoint('/robot/scan', 'sensor_msgs/msg/LaserScan');
  const odom = endpoint('/robot/odom', 'nav_msgs/msg/Odometry');
  const command = endpoint('/robot/cmd_vel', 'geometry_msgs/msg/Twist');
  const tf = endpoint('/tf', 'tf2_msgs/msg/TFMessage');
  const navigate = { name: '/navigate', type: 'demo/action/Navigate' };
  const robotNodes = (): readonly GraphNodeView[] => [
    graphNode('/_ros2wasm_page', 'page', { subscriptions: [scan] }),
    graphNode('/mission', 'mission-4', { actionClients: [navigate] }),
    graphNode('/planner', 'planner-3', {
      subscriptions: [odom, scan],
      publishers: [command, endpoint('/navigate/_action/feedback', 'demo/action/Navigate_FeedbackMessage')],
      services: [endpoint('/planner/get_parameters', 'rcl_interfaces/srv/GetParameters')],
      actionServers: [navigate],
    }),
    graphNode('/robot/diff_drive', 'diff_drive-2', { subscriptions: [command], publishers: [odom, tf] }),
    graphNode('/robot/laser', 'laser-1', { publishers: [scan] }),
    graphNode('/safety', 'safety-5', { subscriptions: [scan], publishers: [command] }),
  ];
  const set = (nodes: readonly GraphNodeView[]): void => fake.setGraph({ nodes: nodes.toSorted((a, b) => (a.name < b.name ? -1 : 1)) });
  set(robotNodes());
  fake.setTopics([
    { name: '/robot/scan', type: scan.type, rateHz: 10, bytesPerSecond: 14_820, count: 812, subscriptions: 3 },
    { name: '/robot/odom', type: odom.type, rateHz: 29.9, count: 2390 },
    { name: '/robot/cmd_vel', type: command.type, rateHz: 12, publishers: 2, count: 30 },
    { name: '/tf', type: tf.type, rateHz: 0 },
  ]);
  Object.assign(globalThis, { robotNodes, setNodes: set, graphNode, endpoint });
  return fake;
}

function endpoint(name: string, type: string): GraphEndpointView {
  return {
    name,
    type,
    hash: '',
    gid: '0'.repeat(32),
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
  };
}

const SCENES: Readonly<Record<string, () => FakeSession | Promise<FakeSession>>> = {
  talker: () => talkerListener(),
  port: () => talkerListener({ link: 'port' }),
  crowd,
  signals: () => signals(),
  bagged: () => signals({ ui: { bags: ['bags/walk.mcap'] }, files: ['bags/walk.mcap'] }),
  world,
  turtles,
  sheet,
  services: () => services(),
  /** A lab sheet beside services, an action and checks. */
  lab: async () => {
    const fake = await services({ ui: { text: 'text/lab/README.md' }, files: ['text/lab/README.md'] });
    fake.checks = new FakeChecks([
      { title: '/topic above 1 Hz', state: 'failed', seen: '0 Hz', afterMs: 5000, withinMs: 5000 },
      { title: HOSTILE, state: 'failed', seen: HOSTILE, afterMs: 5000, withinMs: 5000 },
    ]);
    return fake;
  },
  // Not part of the first view, which a test measures.
  health: async () => {
    const fake = await (await import('./page_fake_health.ts')).health();
    await giveSend(fake);
    return fake;
  },
  parameters: async () => (await import('./page_fake_parameters.ts')).parameters(HOSTILE),
  graph,
  teleop: async () => (await import('./page_fake_teleop.ts')).teleop(),
  hostile,
  hostile_work: async () => {
    const fake = await (await import('./page_fake_hostile.ts')).hostileWork(HOSTILE.slice(0, HOSTILE.indexOf('>') + 1));
    await giveSend(fake);
    return fake;
  },
  checks: () => {
    const fake = talkerListener();
    fake.checks = new FakeChecks([
      { title: '/topic above 1 Hz', state: 'passed', seen: '2 Hz', afterMs: 1250, withinMs: 10_000, source: { file: 'workspace.yaml', line: 12, column: 5 } },
      { title: HOSTILE, state: 'failed', seen: HOSTILE, afterMs: 5000, withinMs: 5000 },
      { title: 'listener prints /I heard/', state: 'waiting', seen: 'no line', withinMs: 20_000 },
    ]);
    return fake;
  },
  /** A lab with tasks, beside a console. `tasks` of the page are set by a test. */
  tasks: () => {
    const aim = { kind: 'rate', topic: '/topic' } as const;
    const fake = new FakeSession({
      nodes: [{ executable: 'talker' }, { executable: 'listener' }],
      interfaces: INTERFACES,
      tasks: [
        {
          title: 'Drive the turtle',
          text: 'Pass **x = 9**. [Start](ros2wasm:start?node=talker)',
          hint: 'Use *Teleop*.',
          solution: '`ros2 topic pub`',
          checks: [{ title: '', aim }, { title: '', aim }],
        },
        { title: HOSTILE, text: HOSTILE, hint: '', solution: HOSTILE, checks: [{ title: '', aim }] },
        { title: 'Stop it', text: '', hint: '', solution: '', checks: [{ title: '', aim }] },
      ],
    });
    fake.tasks = new FakeTasks([
      {
        title: 'Drive the turtle',
        done: false,
        checks: [
          { title: '/turtle1/pose: x is above 9', state: 'open', seen: 'no message', source: { file: 'workspace.yaml', line: 12, column: 5 } },
          { title: '/topic above 1 Hz', state: 'already', seen: '2 Hz' },
        ],
      },
      { title: HOSTILE, done: false, checks: [{ title: HOSTILE, state: 'open', seen: HOSTILE }] },
      { title: 'Stop it', done: false, checks: [{ title: 'talker ends', state: 'open', seen: 'it runs' }] },
    ]);
    return fake;
  },
  publish: () =>
    new FakeSession({
      nodes: [{ executable: 'robot' }],
      interfaces: new Map([
        ...INTERFACES,
        ['geometry_msgs/msg/Twist', 'Vector3 linear\nVector3 angular\n'],
        ['geometry_msgs/msg/Vector3', 'float64 x\nfloat64 y\nfloat64 z\n'],
      ]),
    }),
  empty: () => new FakeSession({ nodes: [] }),
  quiet: () =>
    new FakeSession({
      nodes: [{ executable: 'talker' }, { executable: 'listener' }],
      interfaces: INTERFACES,
    }),
  broken: () => {
    const fake = talkerListener();
    // A mistake in the page itself: one panel must fail alone.
    fake.topics = () => {
      throw new Error('topics are out of order');
    };
    return fake;
  },
  failure: () =>
    Promise.reject(
      Object.assign(
        new Error('this browser can neither isolate the page nor suspend WebAssembly'),
        {
          code: 'R2W0705',
          why: [
            'the page is inside a frame that is not isolated, and JavaScript Promise Integration is missing',
          ],
          fix: ['open the page by itself in a current version of Chrome or Edge'],
        },
      ),
    ),
  never: () => new Promise<FakeSession>(() => undefined),
};

const scene = SCENES[new URLSearchParams(location.search).get('scene') ?? 'talker'];
const root = document.getElementById('page');
if (root !== null && scene !== undefined) {
  const [started] = await Promise.allSettled([Promise.resolve().then(scene)]);
  if (started.status === 'fulfilled') Object.assign(globalThis, { fake: started.value });
  mountPage(root, started, Promise.resolve(true));
}
