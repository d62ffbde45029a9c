// Commands of ros2 that a launch file starts: a service call when a node has started, parameters when the call is over, a
// subscription until Ctrl-C; headless on both links, in a stepped run, and in Chromium.

// Compatibility, works: `ExecuteProcess` and `executable` with commands of `ros2` (`service call`, `param set`, `topic pub`, `bag record`
// and the others that the site's terminal has), with `shell=True`, conditions, timers and event handlers, as processes of the launch

// Compatibility, differs: `ros2 bag record` of a launch file -> in `ros2wasm run` the recording lies in the present folder, wherever `-o` says;
// in the page on the panel's shelf

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { finished, PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };

const launchFile = `
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler, TimerAction
from launch.conditions import IfCondition
from launch.event_handlers import OnExecutionComplete, OnProcessExit, OnProcessIO, OnProcessStart
from launch.events import Shutdown
from launch.substitutions import FindExecutable, LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_launch_description():
    space, red, ends = LaunchConfiguration('space'), LaunchConfiguration('red'), LaunchConfiguration('ends')
    ros2 = FindExecutable(name='ros2')
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace=space)
    spawn = ExecuteProcess(cmd=[[ros2, ' service call ', space, '/spawn turtlesim/srv/Spawn "{x: 2, y: 2, theta: 0.2}"']], shell=True)
    change = ExecuteProcess(cmd=[[ros2, ' param set ', space, '/sim background_r 120']], shell=True)
    again = ExecuteProcess(condition=IfCondition(PythonExpression([red, ' > 120'])),
                           cmd=[ros2, 'param', 'set', [space, '/sim'], 'background_r', red])
    seen = ExecuteProcess(cmd=['ros2', 'param', 'get', [space, '/sim'], 'background_r'])
    return LaunchDescription([
        DeclareLaunchArgument('space', default_value='room'),
        DeclareLaunchArgument('red', default_value='200'),
        DeclareLaunchArgument('ends', default_value='true'),
        sim,
        ExecuteProcess(cmd=['ros2', 'topic', 'echo', '/room/turtle2/pose', 'turtlesim/msg/Pose', '--field', 'x'], name='echo'),
        ExecuteProcess(cmd=['ros2 topic list | grep pose'], shell=True),
        ExecuteProcess(cmd=['ros2', 'doctor']),
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[LogInfo(msg='the simulator has started'), spawn])),
        RegisterEventHandler(OnProcessIO(target_action=spawn, on_stdout=lambda event: LogInfo(
            msg=f'spawn says: {event.text.decode().strip()}') if 'turtle2' in event.text.decode() else None)),
        RegisterEventHandler(OnExecutionComplete(target_action=spawn, on_completion=[
            LogInfo(msg='a turtle is there'), change, TimerAction(period=0.5, actions=[again])])),
        RegisterEventHandler(OnProcessExit(target_action=again, on_exit=[seen])),
        RegisterEventHandler(condition=IfCondition(ends), event_handler=OnProcessExit(target_action=seen, on_exit=[
            EmitEvent(event=Shutdown(reason='the colour was seen'))])),
    ])
`;

/** The simulator is 1, what waits for nobody 2; then in the order of the handlers. */
const [echo, spawn, change, again, seen] = ['ros2-2', 'ros2-3', 'ros2-4', 'ros2-5', 'ros2-6'];
const expected = [
  /INFO\] \[launch\.user\]: the simulator has started$/m,
  new RegExp(`^\\[${spawn}\\] requester: making request: turtlesim\\.srv\\.Spawn_Request\\(x=2\\.0, y=2\\.0, theta=0\\.2, name=''\\)$`, 'm'),
  /^\[turtlesim_node-1\] .*\[room\.sim\]: Spawning turtle \[turtle2\] at x=\[2\.000000\], y=\[2\.000000\], theta=\[0\.200000\]$/m,
  /INFO\] \[launch\.user\]: spawn says: turtlesim\.srv\.Spawn_Response\(name='turtle2'\)$/m,
  /INFO\] \[launch\.user\]: a turtle is there$/m,
  new RegExp(`^\\[${echo}\\] 2\\.0$`, 'm'),
  new RegExp(`^\\[${change}\\] Set parameter successful$`, 'm'),
  new RegExp(`^\\[${again}\\] Set parameter successful$`, 'm'),
  new RegExp(`^\\[${seen}\\] Integer value is: 200$`, 'm'),
  /INFO\] \[launch\]: all nodes are stopped: the colour was seen$/m,
];

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.write('commands.launch.py', launchFile);
  workspace.write('workspace.yaml', 'schema: 1\nname: commands\npackages: []\ndependencies: [turtlesim]\nlaunch: commands.launch.py\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr,
    /warning\[R2W0415\]: `ros2 topic list \| grep pose` is skipped\n(?:.*\n)*?.*= why: a site has no shell, only the words of one command/);
  assert.match(packed.stderr, /warning\[R2W0415\]: `ros2 doctor` is skipped/);
  workspace.write('record.launch.xml', `<launch>
  <node pkg="turtlesim" exec="turtlesim_node"/>
  <executable cmd="ros2 bag record -o /somewhere/else -a"/>
  <executable cmd="ros2 param load /turtlesim $(dirname)/workspace.yaml"/>
</launch>
`);
  workspace.write('record.yaml', 'schema: 1\nname: record\npackages: []\ndependencies: [turtlesim]\nlaunch: record.launch.xml\n');
  const recorded = await workspace.run(['pack', 'record.yaml', '-o', 'record']);
  assert.equal(recorded.code, 0, recorded.stderr);
}, watchdog);
after(() => workspace.close());

for (const link of played('shared', 'port')) {
  test(`${link}: a service is called when the simulator has started, parameters are set when that is over`, watchdog, async () => {
    const run = await workspace.run(['run', 'site', '--link', link, '--for', '250s']);
    for (const line of expected) assert.match(run.stdout, line, run.stdout + run.stderr);
    for (const id of [spawn, change, again, seen]) assert.match(run.stderr, new RegExp(`^\\[${id}\\] process has finished cleanly$`, 'm'));
  });

  test(`${link}: other launch arguments are other words; Ctrl-C ends a command that goes on`, watchdog, async () => {
    const child = workspace.start(['run', 'site', '--link', link, 'red:=90', 'space:=room']);
    const ended = finished(child);
    let printed = '';
    let told = false;
    child.stdout?.on('data', (part: Buffer) => {
      printed += part.toString();
      // A second one would end all at once.
      if (told || !printed.includes(`[${change}] Set`) || !printed.includes(`[${echo}] 2.0`)) return;
      told = true;
      child.kill('SIGINT');
    });
    const { code, stdout, stderr } = await ended;
    assert.equal(code, 130, stderr);
    assert.doesNotMatch(stdout, /Integer value/);
    assert.match(stderr, new RegExp(`^\\[${echo}\\] process has `, 'm'));
  });
}

test('stepped runs: the same each time, in the time that is asked for', watchdog, async () => {
  const runs = [];
  for (const name of ['first.trace', 'second.trace']) {
    const run = await workspace.run(['run', 'site', '--stepped', '--seed', '7', '--for', '20s', '--trace', name]);
    for (const line of expected) assert.match(run.stdout, line, run.stdout + run.stderr);
    // Lines of two processes come in either order; what each says does not change.
    runs.push([run.stdout.split('\n').sort(), /^trace: \d+ messages, sha256 \w+$/m.exec(run.stderr)?.[0]]);
  }
  assert.ok(runs[0]?.[1] !== undefined);
  assert.deepEqual(runs[0], runs[1]);
});

// Guarantee, hostile input: commands of `ros2` that a site's launch file starts read no file of the machine that runs it (`ros2wasm run`), and
// write none but new recordings in the present folder
test('of the shell that runs it a site reads no file, and what it records lies in the present folder', watchdog, async () => {
  const child = workspace.start(['run', 'record']);
  const ended = finished(child);
  let printed = '';
  let told = false;
  child.stdout?.on('data', (part: Buffer) => {
    printed += part.toString();
    if (told || !/Subscribed to topic '\/turtle1\/pose'/.test(printed) || !/\[ros2-3\]/.test(printed)) return;
    told = true;
    child.kill('SIGINT');
  });
  const { stdout } = await ended;
  assert.match(stdout, /^\[ros2-3\] .*workspace\.yaml/m);
  assert.match(stdout, /^\[ros2-2\] .*Recording stopped$/m);
  assert.ok(existsSync(join(workspace.root, 'else.mcap')));
  const info = await workspace.run(['ros2', 'record', 'bag', 'info', 'else.mcap']);
  assert.match(info.stdout, /\/turtle1\/pose/, info.stderr);
  // Nor does a command of the shell's own record what the launch file would: only it is asked for.
  const called = await workspace.run(['ros2', 'record', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 1, name: new}']);
  assert.match(called.stdout, /Spawn_Response\(name='new'\)/, called.stderr);
});

test('in Chromium each command has its row and its console, and is started again', watchdog, async () => {
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    await page.goto(`${server.url}?ends:=false#layout=${encodeURIComponent(JSON.stringify({ row: ['nodes', 'console'], sizes: [1, 2] }))}`);
    const rowOf = (name: string) => page.getByRole('listitem').filter({ has: page.getByRole('button', { name, exact: true }) });
    const tileOf = (name: string) => page.getByRole('article', { name });
    const setting = 'ros2 param set room/sim background_r 120';
    const getting = 'ros2 param get room/sim background_r';
    await tileOf(`Console of ${getting}`).getByText('Integer value is: 200').waitFor();
    await tileOf("Console of ros2 service call room/spawn turtlesim/srv/Spawn '{x: 2, y: 2, theta: 0.2}'").getByText("Spawn_Response(name='turtle2')")
      .waitFor();
    await tileOf('Console of the launch file').getByText('[launch.user]: a turtle is there').waitFor();
    await rowOf(setting).getByText('Finished, code 0').waitFor();
    await rowOf(setting).getByText(change, { exact: true }).waitFor();
    assert.equal(await tileOf(`Console of ${setting}`).getByRole('button', { name: /input/i }).count(), 0);

    // Alone, with room for more than one line.
    await page.getByRole('button', { name: setting, exact: true }).click();
    await page.getByRole('button', { name: `Start ${setting}`, exact: true }).click();
    await tileOf(`Console of ${setting}`).getByText('Set parameter successful').nth(1).waitFor();
    await page.getByRole('button', { name: getting, exact: true }).click();
    await page.getByRole('button', { name: `Start ${getting}`, exact: true }).click();
    await tileOf(`Console of ${getting}`).getByText('Integer value is: 120').waitFor();

    const listening = 'ros2 topic echo /room/turtle2/pose turtlesim/msg/Pose --field x';
    await rowOf(listening).getByText('Running').waitFor();
    await page.getByRole('button', { name: `Stop ${listening}`, exact: true }).click();
    await rowOf(listening).getByText(/^(Finished|Exited)/).waitFor();
  } finally {
    await browser.close();
    await server.close();
  }
});

test('a page with a seed has sent what a headless run of it sends', watchdog, async () => {
  const run = await workspace.run(['run', 'site', 'ends:=false', '--stepped', '--seed', '7', '--for', '3s', '--trace', 'page.trace']);
  assert.match(run.stdout, /Integer value is: 200/, run.stderr);
  const expectedHash = /^trace: \d+ messages, sha256 (\w+)$/m.exec(run.stderr)?.[1] ?? run.stderr;
  const server = await serveFolder(join(workspace.root, 'site'), { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    page.setDefaultTimeout(120_000);
    await page.goto(`${server.url}?ends:=false&seed=7`);
    await page.selectOption('select[aria-label="Length of a step"]', '1000');
    const held = page.locator('.time[data-state=paused]');
    for (let second = 0; second < 3; second += 1) {
      await held.waitFor();
      await page.click('button[aria-label^="Let time run for"]');
    }
    await held.waitFor();
    const seen = page.locator('.time [data-sha256]');
    await page.waitForFunction((wanted) => document.querySelector('.time [data-sha256]')?.getAttribute('data-sha256') === wanted, expectedHash)
      .catch(async () => assert.equal(await seen.getAttribute('data-sha256'), expectedHash));
  } finally {
    await browser.close();
    await server.close();
  }
});
