// The turtle simulator of the channel: what it answers (tests/packages/turtlesim_checks), its keys, and example 03, on
// both links. Runs are stepped where numbers are looked at, so that a loaded machine changes none of them.
import assert from 'node:assert/strict';
import { cpSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../../examples/03_turtlesim');
const PACKAGES = resolve(import.meta.dirname, '../../packages');
const HEADLESS = resolve(process.env['ROS2WASM_BUILD'] ?? 'build', 'runtime/headless.js');
const watchdog = { timeout: 600_000 };
const [TURTLESIM, TELEOP] = ['turtlesim_node-1', 'turtle_teleop_key-2'];
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
    for (
      const text of [
        'A turtle named [turtle2] already exists',
        'Cannot spawn a turtle named [no name/of a topic]: ',
        'Tried to kill turtle [bob], which does not exist',
        'Clearing turtlesim.',
        'Resetting turtlesim.',
        'Oh no! I hit the wall! (Clamping from [x=100.000000, y=111.088889])',
        'Rotation goal completed successfully',
        'Rotation goal received before a previous goal finished. Aborting previous goal',
        'Rotation goal canceled',
        'Velocity command received during rotation goal. Aborting goal',
      ]
    ) assert.ok(said.includes(text), `${text} in\n${said}`);
    // 16 ms by the clock of the site, which a busy machine cannot delay when it is stepped.
    assert.match(said, how.includes('--stepped') ? /the pose comes at 62\.\d Hz/ : /the pose comes at \d/);
  }
});

/** A site with turtlesim_node and turtle_teleop_key, whose keys are typed. */
class Driven {
  readonly said: string[] = [];
  readonly session: SiteSession;
  private readonly platform: ReturnType<typeof nodePlatform>;

  private constructor(platform: ReturnType<typeof nodePlatform>, site: unknown) {
    this.platform = platform;
    this.session = new SiteSession({
      site: readSite(site),
      platform,
      broker: new SharedBroker(),
      onLines: (node, lines) => this.said.push(...lines.map(([, , text]) => `[${node.id}] ${text}`)),
    });
  }

  /** Returns when both programs listen. */
  static async start(folder: string): Promise<Driven> {
    const platform = nodePlatform(join(workspace.root, folder), pathToFileURL(HEADLESS));
    const driven = new Driven(platform, await platform.json('site.json'));
    driven.session.startAll();
    await driven.until(() => driven.says("'Q' to quit.")() && driven.says('Spawning turtle [turtle1]')());
    return driven;
  }

  type(text: string): void {
    this.session.sendInput(TELEOP, text);
  }

  says(text: string): () => boolean {
    return () => this.said.some((line) => line.includes(text));
  }

  /** `meanwhile` is done again and again. */
  async until(condition: () => boolean, meanwhile: () => void = () => undefined): Promise<void> {
    const end = performance.now() + 100_000;
    while (!condition()) {
      assert.ok(performance.now() < end, `${this.posed(0)} ${this.posed(3)}\n${this.said.join('\n')}`);
      meanwhile();
      await new Promise((done) => {
        setTimeout(done, 100);
      });
    }
  }

  /** A message's floats stand behind four bytes. */
  posed(index: number): number {
    return this.newest('/turtle1/pose')?.getFloat32(4 + 4 * index, true) ?? NaN;
  }

  /** The newest command: speed ahead, and turning to the left. */
  asked(): readonly [number, number] {
    const view = this.newest('/turtle1/cmd_vel');
    return [view?.getFloat64(4, true) ?? NaN, view?.getFloat64(44, true) ?? NaN];
  }

  private newest(topic: string): DataView | undefined {
    this.session.topics(); // samples are taken while somebody looks
    const bytes = this.session.lastMessage(topic)?.bytes;
    return bytes === undefined ? undefined : new DataView(bytes.buffer, bytes.byteOffset);
  }

  close(): void {
    this.session.close();
    this.platform.close();
  }
}

test('example 03: a turtle driven by keys', watchdog, async () => {
  await pack('example/workspace.yaml', 'keys');
  const driven = await Driven.start('keys');
  const { session, said } = driven;
  try {
    // The first keys may come before anybody listens; how far one leads depends on how busy the machine is.
    await driven.until(() => driven.posed(0) > 6, () => driven.type('\u001b[A'));
    await driven.until(() => driven.posed(3) === 0);
    assert.ok(Math.abs(driven.posed(1) - 5.544445) < 1e-4, `${driven.posed(1)}`);
    assert.deepEqual(driven.asked(), [2, 0]);
    driven.type('e');
    await driven.until(driven.says('Rotation goal completed successfully'));
    assert.ok(Math.abs(driven.posed(2) - 2.3562) < 0.04, `${driven.posed(2)}`);
    // An arrow may come before the goal has, or after it is reached; so may the key that cancels it.
    const inTurn = (keys: string[]) => (): void => {
      const key = keys.shift();
      if (key === undefined) return;
      driven.type(key);
      keys.push(key);
    };
    await driven.until(driven.says('Velocity command received during rotation goal. Aborting goal'), inTurn(['v', '\u001b[D', 'e', '\u001b[C']));
    await driven.until(driven.says('Rotation goal canceled'), inTurn(['v', 'f', 'e', 'f']));
    driven.type('q');
    await driven.until(() => session.nodes().some(({ id, state }) => id === TELEOP && state.kind === 'exited'));
    assert.deepEqual(session.nodes().map(({ id, state }) => [id, state.kind]), [[TURTLESIM, 'running'], [TELEOP, 'exited']]);
    assert.match(said.join('\n'), expectation('expected.txt'));
    const banner = said.filter((line) => line.startsWith(`[${TELEOP}]`));
    assert.deepEqual(banner, [
      'Reading from keyboard',
      '---------------------------',
      'Use arrow keys to move the turtle.',
      "Use G|B|V|C|D|E|R|T keys to rotate to absolute orientations. 'F' to cancel a rotation.",
      "'Q' to quit.",
    ].map((line) => `[${TELEOP}] ${line}`));
  } finally {
    driven.close();
  }
});

test('scale_linear and scale_angular of turtle_teleop_key', watchdog, async () => {
  workspace.write('scaled.yaml', `schema: 1
name: scaled
dependencies: [turtlesim]
launch:
  - {package: turtlesim, executable: turtlesim_node}
  - {package: turtlesim, executable: turtle_teleop_key, parameters: {scale_linear: 0.5, scale_angular: 0.25}}
`);
  await pack('scaled.yaml', 'scaled');
  const driven = await Driven.start('scaled');
  try {
    for (const [letter, ahead, turn] of [['A', 0.5, 0], ['B', -0.5, 0], ['C', 0, -0.25], ['D', 0, 0.25]] as const) {
      await driven.until(() => {
        const [isAhead, isTurn] = driven.asked();
        return isAhead === ahead && isTurn === turn;
      }, () => driven.type(`\u001b[${letter}`));
    }
  } finally {
    driven.close();
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
