// The commands of ros2 on a packed site with C++ nodes: their output letter for letter as upstream's, on both links, over a
// session that runs; then from a shell, with exit codes, Ctrl-C and a pipe that closes.

// Compatibility, works: the commands `ros2 topic`, `node`, `service`, `action`, `param`, `interface`, `lifecycle` and `doctor`, in the
// page's terminal and as `ros2wasm ros2 SITE ...`, with upstream's output

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';
import type { Page } from 'playwright-core';
import { bagFiles, textOfFile } from '../../../runtime/site/ros2cli/shell_files.ts';
import { runCommand } from '../../../runtime/site/ros2cli/run.ts';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import type { Session } from '../../../runtime/site/contract/session.ts';
import { played } from '../../support/nightly.ts';
import { CLI, finished } from '../support/pack_workspace.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);
const packed = packedInBrowser((workspace) => {
  workspace.copyPackages('command_robot');
  workspace.write('workspace.yaml', `schema: 1
name: command_robot
packages: [src/*]
launch:
  - {package: command_robot, executable: robot}
  - {package: command_robot, executable: gripper}
`);
});

interface Ran {
  readonly code: number;
  readonly out: string;
  readonly warned: string;
}

class Shell {
  readonly session: Session;
  /** The running command's function that takes typed text. */
  type: ((text: string) => void) | undefined;

  constructor(session: Session) {
    this.session = session;
  }

  /** `until`: Ctrl-C as soon as the output so far is like that. */
  async run(words: readonly string[], until?: RegExp): Promise<Ran> {
    const abort = new AbortController();
    let [out, warned] = ['', ''];
    const code = await runCommand(this.session, words, {
      signal: abort.signal,
      bags: bagFiles,
      readText: textOfFile,
      takeInput: (taker) => {
        this.type = taker;
      },
      print: (text) => {
        out += `${text}\n`;
        if (until?.test(out) === true) abort.abort();
      },
      warn: (text) => {
        warned += `${text}\n`;
      },
    });
    return { code, out, warned };
  }

  async prints(words: readonly string[]): Promise<string> {
    const { code, out, warned } = await this.run(words);
    assert.equal(code, 0, warned);
    return out;
  }
}

/** Resolves when the graph has what the nodes make. */
function discovered(session: Session): Promise<void> {
  return new Promise((done) => {
    const whole = (): boolean => {
      const nodes = new Map(session.graph().nodes.map((node) => [node.name, node]));
      return nodes.get('/robot')?.services.some(({ name }) => name === '/robot/get_type_description') === true
        && nodes.get('/gripper')?.services.some(({ name }) => name === '/gripper/get_type_description') === true
        && nodes.get('/robot')?.actionServers.length === 1;
    };
    const off = session.onGraph(() => {
      if (!whole()) return;
      off();
      done();
    });
    if (!whole()) return;
    off();
    done();
  });
}

/** Resolves when a node has printed it. */
function printed(session: Session, id: string, pattern: RegExp): Promise<void> {
  return new Promise((done) => {
    const log = session.console(id);
    const there = (): boolean => log.lines().some(({ text }) => pattern.test(text));
    const off = log.onLines(() => {
      if (!there()) return;
      off();
      done();
    });
    if (!there()) return;
    off();
    done();
  });
}

for (const link of played('shared', 'port')) {
  test(`${link}: every command over a running site`, watchdog, async (t) => {
    const { session, close } = await openHeadless(packed.site, link, entry);
    const shell = new Shell(session);
    try {
      session.startAll();
      await session.settled;
      await discovered(session);

      await t.test('node list and info', async () => {
        assert.equal(await shell.prints(['node', 'list']), '/gripper\n/robot\n');
        const info = await shell.prints(['node', 'info', '/robot']);
        assert.match(info,
          /^\/robot\n {2}Subscribers:\n( {4}\/\S+: \S+\n)* {4}\/words: std_msgs\/msg\/String\n {2}Publishers:\n {4}\/chatter: std_msgs\/msg\/String\n {4}\/map: /);
        assert.match(info,
          / {2}Service Servers:\n {4}\/add_two_ints: example_interfaces\/srv\/AddTwoInts\n {4}\/robot\/describe_parameters: rcl_interfaces\/srv\/DescribeParameters\n/);
        assert.match(info, / {2}Service Clients:\n\n {2}Action Servers:\n {4}\/fibonacci: example_interfaces\/action\/Fibonacci\n {2}Action Clients:\n\n$/);
        const unknown = await shell.run(['node', 'info', '/nobody']);
        assert.deepEqual(unknown, { code: 1, out: '', warned: "Unable to find node '/nobody'\n" });
      });

      await t.test('topic list, type, find and info', async () => {
        const list = await shell.prints(['topic', 'list']);
        assert.deepEqual(list.trimEnd().split('\n'), ['/chatter', '/gripper/transition_event', '/map', '/parameter_events', '/place', '/rosout', '/words']);
        assert.match(await shell.prints(['topic', 'list', '-t']), /^\/chatter \[std_msgs\/msg\/String\]$/m);
        assert.match(await shell.prints(['topic', 'list', '--include-hidden-topics']), /^\/fibonacci\/_action\/feedback$/m);
        assert.match(await shell.prints(['topic', 'list', '-v']),
          /^Published topics:\n \* \/chatter \[std_msgs\/msg\/String\] 1 publisher\n[^]*\n\nSubscribed topics:\n[^]* \* \/words \[std_msgs\/msg\/String\] 1 subscriber\n\n$/);
        assert.equal(await shell.prints(['topic', 'type', '/chatter']), 'std_msgs/msg/String\n');
        assert.equal(await shell.prints(['topic', 'find', 'std_msgs/msg/String']), '/chatter\n/map\n/words\n');
        assert.equal(await shell.prints(['topic', 'info', '/chatter']), 'Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 0\n');
        assert.match(await shell.prints(['topic', 'info', '-v', '/place']), new RegExp(
          ['^Type: geometry_msgs/msg/PointStamped', '', 'Publisher count: 1', '', 'Node name: robot', 'Node namespace: /',
            'Topic type: geometry_msgs/msg/PointStamped', 'Topic type hash: RIHS01_[0-9a-f]{64}', 'Endpoint type: PUBLISHER',
            'GID: [0-9a-f]{2}(?:\\.[0-9a-f]{2}){15}', 'QoS profile:', '  Reliability: BEST_EFFORT', '  History \\(Depth\\): KEEP_LAST \\(5\\)',
            '  Durability: VOLATILE', '  Lifespan: Infinite', '  Deadline: Infinite', '  Liveliness: AUTOMATIC', '  Liveliness lease duration: Infinite', '',
            'Subscription count: 0', '', '$'].join('\n'),
        ));
        // Whom its messages do not reach is said beside what upstream prints.
        const strict = session.node().subscription('/place', 'geometry_msgs/msg/PointStamped', { reliability: 'reliable' }, () => undefined);
        const misfit = await shell.run(['topic', 'info', '-v', '/place']);
        assert.match(misfit.out, /\nSubscription count: 1\n/);
        assert.equal(misfit.warned, 'WARNING: messages of /robot on /place do not reach /_ros2wasm_page: their QoS policies do not fit, RELIABILITY\n');
        strict.close();
        assert.deepEqual(await shell.run(['topic', 'info', '/none']), { code: 1, out: '', warned: "Unknown topic '/none'\n" });
      });

      await t.test('topic echo, hz, bw and delay', async () => {
        assert.match(await shell.prints(['topic', 'echo', '--once', '/chatter']), /^data: 'Hello World: \d+'\n---\n$/);
        assert.match(await shell.prints(['topic', 'echo', '--once', '--field', 'data', '/chatter']), /^Hello World: \d+\n---\n$/);
        assert.match(await shell.prints(['topic', 'echo', '--once', '/place']),
          /^header:\n {2}stamp:\n {4}sec: \d+\n {4}nanosec: \d+\n {2}frame_id: map\npoint:\n {2}x: 0\.5\n {2}y: 2\.0\n {2}z: 0\.0\n---\n$/);
        assert.match(await shell.prints(['topic', 'echo', '--once', '--csv', '--field', 'point', '/place']), /^0\.5,2(\.0)?,0(\.0)?\n$/);
        assert.equal(await shell.prints(['topic', 'echo', '--once', '--field', 'point.y', '/place']), '2.0\n---\n');
        assert.equal(await shell.prints(['topic', 'echo', '--once', '/map']), 'data: the map\n---\n');
        const several = await shell.run(['topic', 'echo', '/chatter'], /(data: 'Hello World: \d+'\n---\n){3}/);
        assert.equal(several.code, 0);
        const none = await shell.run(['topic', 'echo', '/none']);
        assert.deepEqual(none, {
          code: 1,
          out: '',
          warned: 'WARNING: topic [/none] does not appear to be published yet\nCould not determine the type for the passed topic\n',
        });
        assert.match((await shell.run(['topic', 'echo', '--once', '--field', 'dta', '/chatter'])).warned, /^Invalid field 'dta'/);
        // Only each fifth one, and of a field only what fits it.
        assert.match(await shell.prints(['topic', 'echo', '--once', '--filter', "int(m.data[-1]) % 5 == 0 and m.data.startswith('Hello')", '/chatter']),
          /^data: 'Hello World: \d*[05]'\n---\n$/);
        assert.equal(await shell.prints(['topic', 'echo', '--once', '--field', 'point', '--filter', 'm.x < 1 < m.y', '/place']),
          'x: 0.5\ny: 2.0\nz: 0.0\n---\n');
        assert.deepEqual(await shell.run(['topic', 'echo', '--filter', 'm.dta', '/chatter']), {
          code: 1,
          out: '',
          warned: "AttributeError: the message has no attribute 'dta'\n",
        });
        assert.match((await shell.run(['topic', 'echo', '--filter', 'import os', '/chatter'])).warned, /^NameError: name 'import' is not defined/);
        assert.match((await shell.run(['topic', 'hz', '--filter', 'm.data / 2', '/chatter'])).warned, /^TypeError: a str is not a number/);
        // About a fifth as many as all.
        const [some, all] = [await shell.run(['topic', 'hz', '--filter', 'm.data[-1] in "05"', '/chatter'], /window: \d+\n/),
          await shell.run(['topic', 'hz', '/chatter'], /window: \d+\n/)];
        const rate = (out: string): number => Number(/^average rate: (.*)$/m.exec(out)?.[1]);
        assert.ok(rate(some.out) < 0.5 * rate(all.out), `${some.out}${all.out}`);
        const hz = await shell.run(['topic', 'hz', '/chatter'], /window: \d+\n/);
        assert.match(hz.out, /^average rate: \d+\.\d{3}\n\tmin: \d+\.\d{3}s max: \d+\.\d{3}s std dev: \d+\.\d{5}s window: \d+\n/);
        const bw = await shell.run(['topic', 'bw', '/chatter'], /from \d+ messages\n.*\n/);
        assert.match(bw.out, /^Subscribed to \[\/chatter\]\n\d+(?:\.\d+)? K?B\/s from \d+ messages\n\tMessage size mean: \S+ K?B min: \S+ K?B max: \S+ K?B\n/);
        const delay = await shell.run(['topic', 'delay', '/place'], /window: \d+\n/);
        assert.match(delay.out, /^average delay: -?\d+\.\d{3}\n\tmin: -?\d+\.\d{3}s max: -?\d+\.\d{3}s std dev: \d+\.\d{5}s window: \d+\n/);
      });

      await t.test('pkg xml', async () => {
        const [name = ''] = session.site.packages;
        const xml = await shell.run(['pkg', 'xml', name]);
        assert.deepEqual([xml.code, xml.out], [1, '']);
        assert.match(xml.warned, /^The package\.xml of '\w+' is not in this site: .* The workspace and the channel have it\.\n$/);
        assert.equal((await shell.run(['pkg', 'xml', 'no_such_package'])).warned, 'Package not found\n');
      });

      await t.test('doctor', async () => {
        const slow = link === 'port';
        const plain = await shell.run(['doctor']);
        assert.deepEqual([plain.code, plain.out], [0, '\nAll 4 checks passed\n\n']);
        assert.equal(plain.warned.includes('not cross-origin isolated'), slow);
        for (const words of ['Publisher without subscriber detected on /chatter.', 'Subscriber without publisher detected on /words.'])
          assert.ok(plain.warned.includes(`UserWarning: ${words}\n`), plain.warned);
        assert.doesNotMatch(plain.warned, /rosout|parameter_events/);
        const strict = session.node().subscription('/place', 'geometry_msgs/msg/PointStamped', { reliability: 'reliable' }, () => undefined);
        const failed = await shell.run(['wtf', '-rf']);
        strict.close();
        assert.equal(failed.code, 0);
        assert.match(failed.warned,
          /^UserWarning: ERROR: QoS compatibility error found on topic '\/place': Best effort publisher and reliable subscription;$/m);
        assert.match(failed.out, /^\n1\/4 check\(s\) failed\n\nFailed modules: middleware\n\n {3}QOS COMPATIBILITY LIST\n/);
        assert.ok(
          failed.out.includes(
            ['topic [type]            : /place [geometry_msgs/msg/PointStamped]', 'publisher node          : robot', 'subscriber node         : _ros2wasm_page',
              'compatibility status    : ERROR: Best effort publisher and reliable subscription;', ''].join('\n'),
          ),
          failed.out,
        );
        assert.match(failed.out, /\n {3}RMW MIDDLEWARE\nmiddleware name    : rmw_wasm_cpp\n$/);
        assert.match((await shell.run(['doctor', '-iw'])).out,
          slow ? /^\n2\/4 check\(s\) failed\n\nFailed modules: network topic\n$/ : /^\n1\/4 check\(s\) failed\n\nFailed modules: topic\n$/);
        const report = await shell.prints(['doctor', '--report']);
        assert.deepEqual(report.match(/^ {3}.*/gm)?.map((title) => title.trim()), ['NETWORK CONFIGURATION', 'NODE LIST', 'PACKAGE VERSIONS',
          'PLATFORM INFORMATION', 'QOS COMPATIBILITY LIST', 'RMW MIDDLEWARE', 'ROS 2 INFORMATION', 'TOPIC LIST']);
        assert.match(report, slow ? /^device {2}: none.* through message ports$/m : /^device {2}: none.* in shared memory$/m);
        assert.match(report, /\nnode {4}: robot-1\nstate {3}: running\n/);
        assert.match(report, /\nplatform info {4}: Node\.js/);
        assert.match(report, /\ndistribution name {6}: jazzy\n/);
        assert.match(report, /\ntopic {15}: \/words\npublisher count {5}: 0\nsubscriber count {4}: 1\n/);
        assert.doesNotMatch(await shell.prints(['doctor', '-r', '-ep']), /PACKAGE VERSIONS/);
      });

      await t.test('topic pub', async () => {
        const out = await shell.prints(['topic', 'pub', '--once', '/words', 'std_msgs/msg/String', '{data: \'from the "command"\'}']);
        assert.match(out,
          /^(Waiting for at least 1 matching subscription\(s\)\.\.\.\n)?publisher: beginning loop\npublishing #1: std_msgs\.msg\.String\(data='from the "command"'\)\n\n$/);
        await printed(session, 'robot-1', /heard \[from the "command"\]/);
        const rated = await shell.prints(['topic', 'pub', '-r', '100', '-t', '5', '-p', '5', '/words', 'std_msgs/String', 'data: word']);
        assert.match(rated, /publisher: beginning loop\npublishing #5: /);
        const wrong = await shell.run(['topic', 'pub', '--once', '/words', 'std_msgs/msg/String', '{dta: x}']);
        assert.equal(wrong.code, 1);
        assert.match(wrong.warned, /Failed to populate field: dta: there is no such field/);
        const stopped = await shell.run(['topic', 'pub', '-r', '50', '/words', 'std_msgs/msg/String', '{data: again}'], /publishing #3/);
        assert.equal(stopped.code, 130);
      });

      await t.test('service list, type, find, info and call', async () => {
        assert.match(await shell.prints(['service', 'list']), /^\/add_two_ints\n/);
        assert.match(await shell.prints(['service', 'list', '-t']), /^\/add_two_ints \[example_interfaces\/srv\/AddTwoInts\]\n/);
        assert.equal(await shell.prints(['service', 'type', '/add_two_ints']), 'example_interfaces/srv/AddTwoInts\n');
        assert.equal(await shell.prints(['service', 'find', 'example_interfaces/srv/AddTwoInts']), '/add_two_ints\n');
        assert.equal(await shell.prints(['service', 'info', '/add_two_ints']),
          'Type: example_interfaces/srv/AddTwoInts\nClients count: 0\nServices count: 1\n');
        assert.equal(await shell.prints(['service', 'call', '/add_two_ints', 'example_interfaces/srv/AddTwoInts', '{a: 2, b: -5}']),
          'requester: making request: example_interfaces.srv.AddTwoInts_Request(a=2, b=-5)\n\nresponse:\nexample_interfaces.srv.AddTwoInts_Response(sum=-3)\n\n');
      });

      await t.test('action list, info, type and send_goal', async () => {
        const type = 'example_interfaces/action/Fibonacci';
        assert.equal(await shell.prints(['action', 'list', '-t']), `/fibonacci [${type}]\n`);
        assert.equal(await shell.prints(['action', 'info', '-t', '/fibonacci']),
          `Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /robot [${type}]\n`);
        const sent = await shell.prints(['action', 'send_goal', '--feedback', '/fibonacci', type, '{order: 3}']);
        assert.match(sent, /^Waiting for an action server to become available\.\.\.\nSending goal:\n {5}order: 3\n\nGoal accepted with ID: [0-9a-f]{32}\n\n/);
        assert.match(sent, /\nFeedback:\n {4}sequence:\n- 0\n- 1\n- 1\n- 2\n\n/);
        assert.match(sent, /\nResult:\n {4}sequence:\n- 0\n- 1\n- 1\n- 2\n\nGoal finished with status: SUCCEEDED\n$/);
        assert.match((await shell.run(['action', 'send_goal', '/fibonacci', type, '{order: -1}'])).out, /Goal was rejected\.\n$/);
        const given = await shell.run(['action', 'send_goal', '-f', '/fibonacci', type, '{order: 1000000}'], /Feedback:/);
        assert.equal(given.code, 130);
        await printed(session, 'robot-1', /goal canceled/);
      });

      await t.test('param list, get, set, describe and dump', async () => {
        assert.equal(await shell.prints(['param', 'get', '/robot', 'speed']), 'Double value is: 1.5\n');
        assert.equal(await shell.prints(['param', 'get', '/robot', 'label']), 'String value is: blue\n');
        assert.equal(await shell.prints(['param', 'get', '/robot', 'arm.joints']), "String values are: ['base', 'elbow']\n");
        assert.equal(await shell.prints(['param', 'get', '--hide-type', '/robot', 'use_sim_time']), 'False\n');
        assert.match(await shell.prints(['param', 'list', '/robot']), /^ {2}arm\.joints\n {2}arm\.lengths\n {2}label\n/);
        assert.match(await shell.prints(['param', 'list']), /^\/gripper:\n {2}[^]*\/robot:\n {2}arm\.joints\n/);
        assert.equal(await shell.prints(['param', 'set', '/robot', 'speed', '0.25']), 'Set parameter successful\n');
        assert.equal(await shell.prints(['param', 'get', '/robot', 'speed']), 'Double value is: 0.25\n');
        const refused = await shell.run(['param', 'set', '/robot', 'speed', '7.0']);
        assert.equal(refused.code, 1);
        assert.match(refused.warned, /^Setting parameter failed: .*range/);
        assert.equal(await shell.prints(['param', 'describe', '/robot', 'speed']),
          'Parameter name: speed\n  Type: double\n  Description: How fast it may go\n  Constraints:\n    Min value: 0.0\n    Max value: 2.0\n');
        assert.match(await shell.prints(['param', 'dump', '/robot']),
          /^\/robot:\n {2}ros__parameters:\n {4}arm:\n {6}joints:\n {6}- base\n {6}- elbow\n {6}lengths:\n {6}- 1\.0\n {6}- 0\.5\n {4}label: blue\n[^]* {4}speed: 0\.25\n/);
        assert.equal((await shell.run(['param', 'get', '/robot', 'none'])).code, 1);
        assert.deepEqual(await shell.run(['param', 'get', '/nobody', 'x']), { code: 1, out: '', warned: 'Node not found\n' });
      });

      await t.test('lifecycle nodes, get, list and set', async () => {
        assert.equal(await shell.prints(['lifecycle', 'nodes']), '/gripper\n');
        assert.equal(await shell.prints(['lifecycle', 'get', '/gripper']), 'unconfigured [1]\n');
        assert.match(await shell.prints(['lifecycle', 'list', '/gripper']),
          /^- configure \[1\]\n\tStart: unconfigured\n\tGoal: configuring\n- shutdown \[5\]\n/);
        assert.equal(await shell.prints(['lifecycle', 'set', '/gripper', 'configure']), 'Transitioning successful\n');
        assert.equal(await shell.prints(['lifecycle', 'get']), '/gripper: inactive [2]\n');
        const unknown = await shell.run(['lifecycle', 'set', '/gripper', 'configure']);
        assert.equal(unknown.code, 1);
        assert.match(unknown.warned, /^Unknown transition requested, available ones are:\n- cleanup \[2\]\n/);
      });

      await t.test('interface show, list, package and proto', async () => {
        assert.match(await shell.prints(['interface', 'show', 'geometry_msgs/msg/PointStamped', '--no-comments']),
          /^std_msgs\/Header header\n\tbuiltin_interfaces\/Time stamp\n\t\tint32 sec\n\t\tuint32 nanosec\n\tstring frame_id\nPoint point\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\n$/);
        assert.match(await shell.prints(['interface', 'list', '-s']), /^Services:\n( {4}\S+\/srv\/\S+\n)+$/);
        assert.match(await shell.prints(['interface', 'package', 'example_interfaces']), /^example_interfaces\/srv\/AddTwoInts$/m);
        assert.equal(await shell.prints(['interface', 'proto', 'geometry_msgs/msg/Point']), '"x: 0.0\ny: 0.0\nz: 0.0\n"\n');
      });

      assert.equal(session.graph().nodes.find(({ name }) => name === session.node().name)?.subscriptions.length, 0, 'commands leave nothing behind');
    } finally {
      close();
    }
  });
}

async function type(page: Page, line: string): Promise<void> {
  await page.waitForSelector('.terminal-input input:not([readonly])', { timeout: 120_000 });
  await page.locator('.terminal-input input').fill(line);
  await page.locator('.terminal-input input').press('Enter');
}

for (const link of played('port', 'shared')) {
  test(`${link}: the terminal of the page in Chromium reaches the nodes: topics, a service, a goal, parameters`, watchdog, async () => {
    await withTabs(packed.browser, packed.site, link, async (open) => {
      const layout = encodeURIComponent(JSON.stringify({ row: ['console', 'terminal'], sizes: [1, 1], shown: 'terminal' }));
      const page = await open(`#layout=${layout}`);
      await page.waitForSelector('.panel-terminal .terminal-input', { timeout: 120_000 });
      await type(page, 'ros2 topic echo --once /chatter');
      await shows(page, "data: 'Hello World: ");
      await type(page, "ros2 topic pub --once /words std_msgs/msg/String '{data: from the page}'");
      await shows(page, 'heard [from the page]');
      await type(page, "ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts '{a: 40, b: 2}'");
      await shows(page, 'AddTwoInts_Response(sum=42)');
      await type(page, "ros2 action send_goal -f /fibonacci example_interfaces/action/Fibonacci '{order: 4}'");
      await shows(page, 'Goal finished with status: SUCCEEDED');
      await type(page, "ros2 action send_goal -f /fibonacci example_interfaces/action/Fibonacci '{order: 1000000}'");
      await page.waitForFunction(() => document.querySelector('.terminal')?.textContent?.includes('- 63245986') === true, undefined, { timeout: 120_000 });
      await page.locator('.terminal-input input').press('Control+c');
      await shows(page, 'goal canceled');
      await type(page, 'ros2 param set /robot speed 9.0');
      await shows(page, 'Setting parameter failed');
      await type(page, 'ros2 node list');
      await shows(page, '/gripper');
      await type(page, 'ros2 doctor --report | grep "platform info"');
      await shows(page, 'platform info    : Mozilla/');
    });
  });
}

test('from a shell: result on stdout, exit codes, and what is wrong on stderr', watchdog, async () => {
  const site = packed.site;
  const ros2 = (...words: string[]) => packed.workspace.run(['ros2', site, ...words]);
  assert.deepEqual(await ros2('node', 'list'), { code: 0, stdout: '/gripper\n/robot\n', stderr: '' });
  const once = await packed.workspace.run(['ros2', '--link', 'port', site, 'topic', 'echo', '--once', '/chatter']);
  assert.equal(once.code, 0, once.stderr);
  assert.match(once.stdout, /^data: 'Hello World: \d+'\n---\n$/);
  const wrong = await ros2('topic', 'pub', '-1');
  assert.equal(wrong.code, 2);
  assert.match(wrong.stderr, /^usage: ros2 topic pub .*\nros2 topic pub: error: the following arguments are required: topic_name, message_type\n$/);
  assert.equal((await ros2('topic', 'info', '/none')).code, 1);
  const doctor = await ros2('doctor');
  assert.deepEqual([doctor.code, doctor.stdout], [0, '\nAll 4 checks passed\n\n']);
  assert.match(doctor.stderr, /^UserWarning: Publisher without subscriber detected on \/chatter\.$/m);
  assert.match((await ros2('topic', '--help')).stdout, /^usage: ros2 topic \[-h\] <command> \.\.\.\n/);
  const nothing = await packed.workspace.run(['ros2', join(packed.workspace.root, 'nowhere'), 'node', 'list']);
  assert.match(nothing.stderr, /^error\[R2W\d+\]/);
});

test('from a shell: Ctrl-C ends a command, and so does a reader that has enough', watchdog, async () => {
  const site = packed.site;
  const child = spawn(CLI, ['ros2', site, 'topic', 'echo', '/chatter'], { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = finished(child);
  child.stdout.once('data', () => child.kill('SIGINT'));
  const { code, stderr } = await ended;
  assert.deepEqual([code, stderr], [0, '']);
  const piped = spawn('sh', ['-c', '"$0" ros2 "$1" topic echo /chatter | head -n 1', CLI, site], { stdio: ['ignore', 'pipe', 'pipe'] });
  const head = await finished(piped);
  assert.match(head.stdout, /^data: 'Hello World: \d+'\n$/);
  assert.equal(head.stderr, '');
});
