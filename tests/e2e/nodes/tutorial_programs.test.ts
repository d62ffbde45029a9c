// The programs that tutorials begin with, from the channel, with no package of one's own: in C++, in Python, and with each other.

// Compatibility, works: the programs `talker`, `listener`, `add_two_ints_server`, `add_two_ints_client` and `_async` of demo_nodes_cpp and
// demo_nodes_py, `parameter_blackboard`, `talker_listener_launch.py`, `.xml` and `.yaml`, with upstream's names and texts

// Compatibility, works: `teleop_twist_keyboard`: its keys, texts and parameters (`stamped`, `frame_id`, `speed`, `turn`); keys that are
// typed before Enter come one by one

// Compatibility, works: `view_frames` of tf2_tools: what it says of the frames

// Compatibility, differs: `view_frames` of tf2_tools -> writes NAME.gv into its own memory, and makes no PDF of it; the page draws frames

import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { createDecoder } from '../../../runtime/site/decode/decoder.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const HEADLESS = resolve(process.env['ROS2WASM_BUILD'] ?? 'build', 'runtime/headless.js');
const watchdog = { timeout: 400_000 };
let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace('shared');
});
after(() => workspace.close());

/** A site that runs in this process: what its nodes say, and what they publish. */
class Played {
  readonly said: string[] = [];
  readonly session: SiteSession;
  readonly close: () => void;

  private constructor(session: (onLine: (line: string) => void) => SiteSession, endPlatform: () => void) {
    this.session = session((line) => this.said.push(line));
    this.close = () => {
      this.session.close();
      endPlatform();
    };
  }

  static async of(manifest: string): Promise<Played> {
    workspace.write('workspace.yaml', manifest);
    const platform = nodePlatform(await workspace.packed(), pathToFileURL(HEADLESS));
    const site = readSite(await platform.json('site.json'));
    return new Played((onLine) =>
      new SiteSession({
        site,
        platform,
        broker: new SharedBroker(),
        onLines: (node, lines) => {
          for (const [, , text] of lines) onLine(`[${node.id}] ${text}`);
        },
      }), () => platform.close());
  }

  async until(what: string, condition: () => boolean, meanwhile: () => void = () => undefined): Promise<void> {
    const end = performance.now() + 120_000;
    while (!condition()) {
      assert.ok(performance.now() < end, `${what}\n${this.said.join('\n')}`);
      meanwhile();
      await new Promise((done) => {
        setTimeout(done, 50);
      });
    }
  }

  says(text: RegExp): Promise<void> {
    return this.until(String(text), () => this.said.some((line) => text.test(line)));
  }
}

test('talkers, listeners, services and parameters', watchdog, async () => {
  const played = await Played.of(`schema: 1
name: tutorials
dependencies: [demo_nodes_cpp, demo_nodes_py]
launch:
  - {package: demo_nodes_cpp, executable: talker, name: talker}
  - {package: demo_nodes_py, executable: talker, name: snake}
  - {package: demo_nodes_cpp, executable: listener, name: listener}
  - {package: demo_nodes_py, executable: listener, name: ear}
  - {package: demo_nodes_cpp, executable: add_two_ints_server, name: server, remappings: {add_two_ints: sums}}
  - {package: demo_nodes_py, executable: add_two_ints_client, name: asks_cpp, remappings: {add_two_ints: sums}}
  - {package: demo_nodes_py, executable: add_two_ints_server, name: adder}
  - {package: demo_nodes_cpp, executable: add_two_ints_client, name: asks_py}
  - {package: demo_nodes_cpp, executable: add_two_ints_client_async, name: asks_later}
  - {package: demo_nodes_cpp, executable: parameter_blackboard, parameters: {colour: blue}}
`);
  try {
    played.session.startAll();
    await played.says(/\[talker\]: Publishing: 'Hello World: \d+'/);
    await played.says(/\[snake\]: Publishing: "Hello World: \d+"/);
    for (const ear of ['listener', 'ear']) await played.says(new RegExp(`\\[${ear}\\]: I heard: \\[Hello World: \\d+\\]`));
    for (const server of ['server', 'adder']) await played.says(new RegExp(`\\[${server}\\]: Incoming request$`));
    await played.says(/a: 2 b: 3$/);
    for (const client of ['asks_cpp', 'asks_py', 'asks_later']) await played.says(new RegExp(`\\[${client}\\]: Result of add_two_ints: 5$`));
    await played.says(/Parameter blackboard node named '\/parameter_blackboard' ready, and serving '[1-9]\d*' parameters already!/);
    await played.until('clients end well', () => played.session.nodes().filter(({ state }) => state.kind === 'exited' && state.code === 0).length === 3);
  } finally {
    played.close();
  }
});

for (const form of ['py', 'xml', 'yaml']) {
  test(`ros2 launch demo_nodes_cpp talker_listener_launch.${form}`, watchdog, async () => {
    workspace.write('talks.launch.xml', `<launch>
  <include file="$(find-pkg-share demo_nodes_cpp)/launch/topics/talker_listener_launch.${form}"/>
</launch>`);
    const played = await Played.of('schema: 1\nname: talks\ndependencies: [demo_nodes_cpp]\nlaunch: talks.launch.xml\n');
    try {
      played.session.startAll();
      await played.says(/\[listener\]: I heard: \[Hello World: \d+\]/);
    } finally {
      played.close();
    }
  });
}

for (const stamped of [false, true]) {
  test(`keys drive a robot${stamped ? ', with a time and a frame' : ''}`, watchdog, async () => {
    const played = await Played.of(`schema: 1
name: keys
dependencies: [teleop_twist_keyboard]
launch:
  - {package: teleop_twist_keyboard, executable: teleop_twist_keyboard${stamped ? ', parameters: {stamped: true, frame_id: base, turn: 2.0}' : ''}}
`);
    const [teleop] = played.session.nodes();
    assert.ok(teleop !== undefined);
    try {
      played.session.startAll();
      await played.says(/currently:\tspeed 0\.5\tturn [12]/);
      assert.ok(played.said.some((line) => line.endsWith('q/z : increase/decrease max speeds by 10%')));
      const decoder = createDecoder(await played.session.interfaces());
      const type = `geometry_msgs/msg/Twist${stamped ? 'Stamped' : ''}`;
      const driven = (): string => {
        played.session.topics(); // samples are taken while somebody looks
        const bytes = played.session.lastMessage('/cmd_vel')?.bytes;
        const decoded = bytes === undefined ? undefined : decoder.decode(type, bytes);
        return decoded?.kind === 'value' ? JSON.stringify(decoded.value) : '';
      };
      const drives = (key: string, what: RegExp): Promise<void> =>
        played.until(`${key}: ${what}, not ${driven()}`, () => what.test(driven()), () => played.session.sendInput(teleop.id, key));
      await drives('o', stamped ? /"frame_id":"base".*"x":0\.5,.*"z":-2\}/ : /^\{"linear":\{"x":0\.5,"y":0,"z":0\},"angular":\{"x":0,"y":0,"z":-1\}\}$/);
      await drives('J', /"linear":\{"x":0,"y":0\.5,/);
      await drives('t', /"linear":\{"x":0,"y":0,"z":0\.5\}/);
      await drives('k', /"linear":\{"x":0,"y":0,"z":0\}/);
      played.session.sendInput(teleop.id, 'w\n');
      await played.says(/currently:\tspeed 0\.55\tturn [12] /);
      played.session.sendInput(teleop.id, '\u0003');
      await played.until('it ends', () => played.session.nodes()[0]?.state.kind === 'exited');
    } finally {
      played.close();
    }
  });
}

test('ros2 run tf2_tools view_frames', watchdog, async () => {
  const played = await Played.of(`schema: 1
name: frames
dependencies: [tf2_ros, tf2_tools]
launch:
  - {package: tf2_ros, executable: static_transform_publisher, arguments: [--x, 1, --frame-id, map, --child-frame-id, base]}
  - {package: tf2_tools, executable: view_frames, arguments: [-t, 2, -o, seen]}
`);
  try {
    played.session.startAll();
    await played.says(/Listening to tf data for 2\.0 seconds\.\.\./);
    await played.says(/Generating graph\.\.\./);
    await played.says(/Result:tf2_msgs\.srv\.FrameGraph_Response\(frame_yaml="base: ?\\n {2}parent: 'map'\\n/);
    await played.says(/Exporting graph in seen\.gv file\.\.\./);
    await played.until('it ends well', () => played.session.nodes().some(({ state }) => state.kind === 'exited' && state.code === 0));
  } finally {
    played.close();
  }
});
