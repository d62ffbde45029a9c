// The turtle simulator of the channel: what it answers (tests/packages/turtlesim_checks), its keys, and example 03, on
// both links. Runs are stepped where numbers are looked at, so that a loaded machine changes none of them.
import assert from 'node:assert/strict';
import { cpSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { SharedBroker } from '../../runtime/wasm_js/broker.ts';
import { nodePlatform } from '../../runtime/wasm_js/node_platform.ts';
import { readSite } from '../../runtime/wasm_js/site_reader.ts';
import { SiteSession } from '../../runtime/wasm_js/site_session.ts';
import { PackWorkspace } from './pack_workspace.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../examples/03_turtlesim');
const PACKAGES = resolve(import.meta.dirname, '../packages');
const HEADLESS = resolve(process.env['ROS2WASM_BUILD'] ?? 'build', 'runtime/headless.js');
const watchdog = { timeout: 600_000 };
let workspace: PackWorkspace;

before(() => {
  workspace = new PackWorkspace('shared');
  for (const one of ['turtlesim_checks', 'rclcpp_checks/src']) {
    cpSync(join(PACKAGES, one), join(workspace.root, 'src', one), { recursive: true });
  }
  cpSync(EXAMPLE, join(workspace.root, 'example'), { recursive: true });
});
after(() => workspace.close());

async function pack(manifest: string, site: string): Promise<void> {
  const packed = await workspace.run(['pack', manifest, '-o', site]);
  assert.equal(packed.code, 0, packed.stderr);
}

/** The lines of a file of expectations, found in this order. */
function expectation(file: string): RegExp {
  return new RegExp(readFileSync(join(EXAMPLE, file), 'utf8').trimEnd().split('\n').join('.*\n(?:.*\n)*.*'));
}

test('topics, services, action, parameters and picture of the simulator', watchdog, async () => {
  workspace.write('workspace.yaml', `schema: 1
name: turtles
packages: [src/turtlesim_checks]
launch:
  - {package: turtlesim, executable: turtlesim_node}
  - {package: turtlesim_checks, executable: visitor}
`);
  await pack('workspace.yaml', 'site');
  for (const how of [['--stepped'], ['--link', 'port']]) {
    const ran = await workspace.run(['run', 'site', ...how, '--for', '120s', '--until', 'all \\d+ checks hold']);
    const said = ran.stdout + ran.stderr;
    assert.equal(ran.code, 0, said);
    assert.doesNotMatch(said, /does not hold/);
    for (const text of [
      'A turtle named [turtle2] already exists', 'Cannot spawn a turtle named [no name/of a topic]: ',
      'Tried to kill turtle [bob], which does not exist', 'Clearing turtlesim.', 'Resetting turtlesim.',
      'Oh no! I hit the wall! (Clamping from [x=100.000000, y=111.088889])', 'Rotation goal completed successfully',
      'Rotation goal received before a previous goal finished. Aborting previous goal', 'Rotation goal canceled',
      'Velocity command received during rotation goal. Aborting goal',
    ]) assert.ok(said.includes(text), `${text} in\n${said}`);
  }
});

test('example 03: a turtle driven by keys', watchdog, async () => {
  await pack('example/workspace.yaml', 'keys');
  const platform = nodePlatform(join(workspace.root, 'keys'), pathToFileURL(HEADLESS));
  const said: string[] = [];
  const session = new SiteSession({
    site: readSite(await platform.json('site.json')),
    platform,
    broker: new SharedBroker(),
    onLines: (node, lines) => said.push(...lines.map(([, , text]) => `[${node.id}] ${text}`)),
  });
  const [turtlesim, teleop] = ['turtlesim_node-1', 'turtle_teleop_key-2'];
  const type = (text: string): void => session.sendInput(teleop, text);
  const says = (text: string) => (): boolean => said.some((line) => line.includes(text));
  /** `meanwhile` is done again and again. */
  const until = async (condition: () => boolean, meanwhile: () => void = () => undefined): Promise<void> => {
    const end = performance.now() + 100_000;
    while (!condition()) {
      assert.ok(performance.now() < end, `${posed(0)} ${posed(3)}\n${said.join('\n')}`);
      meanwhile();
      await new Promise((done) => { setTimeout(done, 100); });
    }
  };
  /** A message's floats stand behind four bytes. */
  const posed = (index: number): number => {
    session.topics();  // samples are taken while somebody looks
    const bytes = session.lastMessage('/turtle1/pose')?.bytes;
    return bytes === undefined ? NaN : new DataView(bytes.buffer, bytes.byteOffset).getFloat32(4 + 4 * index, true);
  };
  try {
    session.startAll();
    await until(() => says("'Q' to quit.")() && says('Spawning turtle [turtle1]')());
    // The first keys may come before anybody listens; how far one leads depends on how busy the machine is.
    await until(() => posed(0) > 6, () => type('\u001b[A'));
    await until(() => posed(3) === 0);
    assert.ok(Math.abs(posed(1) - 5.544445) < 1e-4, `${posed(1)}`);
    type('e');
    await until(says('Rotation goal completed successfully'));
    assert.ok(Math.abs(posed(2) - 2.3562) < 0.04, `${posed(2)}`);
    // An arrow may come before the goal has, or after it is reached.
    const keys = ['v', '\u001b[D', 'e', '\u001b[C'];
    await until(says('Velocity command received during rotation goal. Aborting goal'), () => {
      const key = keys.shift();
      if (key !== undefined) type(key);
      if (key !== undefined) keys.push(key);
    });
    type('q');
    await until(() => session.nodes().some(({ id, state }) => id === teleop && state.kind === 'exited'));
    assert.deepEqual(session.nodes().map(({ id, state }) => [id, state.kind]), [[turtlesim, 'running'], [teleop, 'exited']]);
    assert.match(said.join('\n'), expectation('expected.txt'));
    const banner = said.filter((line) => line.startsWith(`[${teleop}]`));
    assert.deepEqual(banner, [
      'Reading from keyboard', '---------------------------', 'Use arrow keys to move the turtle.',
      "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.", "'Q' to quit.",
    ].map((line) => `[${teleop}] ${line}`));
  } finally {
    session.close();
    platform.close();
  }
});

test('example 03: one turtle draws squares, and that of another simulator mimics it', watchdog, async () => {
  await pack('example/squares.yaml', 'squares');
  const ran = await workspace.run(['run', 'squares', '--stepped', '--for', '30s']);
  assert.equal(ran.code, 0, ran.stderr);
  assert.match(ran.stdout, expectation('expected_squares.txt'));

  workspace.write('seen.launch.xml', `<launch>
  <include file="$(dirname)/example/launch/squares.launch.xml"/>
  <node pkg="turtlesim_checks" exec="spectator"/>
</launch>
`);
  workspace.write('seen.yaml', 'schema: 1\nname: seen\npackages: [src/turtlesim_checks]\ndependencies: [turtlesim]\nlaunch: seen.launch.xml\n');
  await pack('seen.yaml', 'seen');
  const seen = await workspace.run(['run', 'seen', '--stepped', '--for', '60s', '--until', 'two sides, the turtles are 0\\.[01]\\d+ apart']);
  assert.equal(seen.code, 0, seen.stdout + seen.stderr);
});
