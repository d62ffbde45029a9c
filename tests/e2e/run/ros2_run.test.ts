// ros2 run, pkg, component and param load on a packed site: programs that the site carries beside its nodes, started from the
// page's terminal and from a shell, with arguments, input and Ctrl-C.

// Compatibility, works: `ros2 run`, `ros2 pkg list`, `executables` and `prefix`, `ros2 component list`, `load` and `unload`,
// `ros2 param load`, in the page's terminal and as `ros2wasm ros2 SITE ...`

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { test } from 'node:test';
import type { Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { CLI, finished } from '../support/pack_workspace.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
const packed = packedInBrowser((workspace) => {
  workspace.copyPackages('command_robot', 'composed_talkers', 'key_reader');
  workspace.write('workspace.yaml', `schema: 1
name: run_on_demand
packages: [src/*]
launch:
  - {package: command_robot, executable: robot}
  - {package: composed_talkers, executable: component_container, name: box}
programs:
  - {package: command_robot, executable: gripper}
  - {package: key_reader}
`);
});

test('site.json tells what the site carries beside its nodes', () => {
  const { nodes, programs } = JSON.parse(packed.workspace.read('site/site.json').toString()) as Record<string, Record<string, unknown>[]>;
  assert.deepEqual(nodes?.map((node) => node['executable']), ['robot', 'component_container']);
  assert.deepEqual(programs?.map((program) => [program['package'], program['executable'], program['kind']]), [['command_robot', 'gripper', 'cpp'], [
    'key_reader',
    'keys',
    'cpp',
  ]]);
});

test('programs that nobody has are refused when packing', async () => {
  packed.workspace.write('wrong.yaml', `schema: 1
name: wrong
packages: [src/*]
launch:
  - {package: command_robot, executable: robot}
programs:
  - {package: command_robot, executable: grippr}
  - {package: nobody}
  - {package: std_msgs}
`);
  const { code, stderr } = await packed.workspace.run(['pack', '--quick', 'wrong.yaml', '-o', 'wrong']);
  assert.notEqual(code, 0);
  assert.match(stderr, /error\[R2W0402\]: package `command_robot` has no executable `grippr`[^]*write `executable: gripper`/);
  assert.match(stderr, /error\[R2W0401\]: there is no package `nobody`[^]*wrong\.yaml:8/);
  assert.match(stderr, /error\[R2W0402\]: package `std_msgs` has no programs that a site can run/);
});

for (const link of played('shared', 'port')) {
  test(`${link}: from a shell`, watchdog, async () => {
    const site = packed.site;
    const ros2 = (...words: string[]) => packed.workspace.run(['ros2', '--link', link, site, ...words]);
    assert.deepEqual(await ros2('pkg', 'executables', 'command_robot'), { code: 0, stdout: 'command_robot gripper\ncommand_robot robot\n', stderr: '' });
    assert.deepEqual(await ros2('run', 'command_robot', 'grippr'), {
      code: 1,
      stdout: '',
      stderr: 'No executable found; of this package the site has: gripper, robot\n',
    });
    assert.deepEqual(await ros2('run', 'nobody', 'gripper'), { code: 1, stdout: '', stderr: "Package 'nobody' not found\n" });

    const keys = spawn(CLI, ['ros2', '--link', link, site, 'run', 'key_reader', 'keys'], { stdio: ['pipe', 'pipe', 'pipe'] });
    const ended = finished(keys);
    keys.stdout.once('data', () => keys.stdin.write('.ab\nx\n'));
    const read = await ended;
    assert.equal(read.code, 0, read.stderr);
    assert.match(read.stdout, /key: a\nkey: b\nkey: x\n/);

    // From a terminal each key comes at once, without Enter.
    const pty = spawn('python3', ['-c', 'import pty, sys; sys.exit(pty.spawn(sys.argv[1:]) >> 8)', CLI, 'ros2', '--link', link, site, 'run', 'key_reader',
      'keys'], { stdio: ['pipe', 'pipe', 'pipe'] });
    const single = finished(pty);
    pty.stdout.once('data', () => pty.stdin.write('.kx'));
    const keyed = await single;
    assert.equal(keyed.code, 0, keyed.stderr);
    assert.match(keyed.stdout, /key: k\r\nkey: x\r\n/);

    // Ctrl-C is the program's.
    const interrupted = spawn(CLI, ['ros2', '--link', link, site, 'run', 'key_reader', 'keys'], { stdio: ['pipe', 'pipe', 'pipe'] });
    const stopped = finished(interrupted);
    interrupted.stdout.once('data', () => interrupted.kill('SIGINT'));
    const { code } = await stopped;
    interrupted.stdin.end();
    assert.equal(code, 0);

    const refused = await ros2('run', 'command_robot', 'robot', '--ros-args', '-p', 'speed:=2.5');
    assert.equal(refused.code, 1);
    assert.match(refused.stderr, /parameter 'speed'[^]*\(R2W0702\)/);
  });
}

async function type(page: Page, line: string): Promise<void> {
  await page.waitForSelector('.terminal-input input:not([readonly])', { timeout: 120_000 });
  await page.locator('.terminal-input input').fill(line);
  await page.locator('.terminal-input input').press('Enter');
}

for (const link of played('port', 'shared')) {
  test(`${link}: in the page's terminal: a second node, components, parameters from a file`, watchdog, async () => {
    await withTabs(packed.browser, packed.site, link, async (open) => {
      const layout = encodeURIComponent(JSON.stringify({ row: ['nodes', 'terminal'], sizes: [1, 1], shown: 'terminal' }));
      const page = await open(`#layout=${layout}`);
      await page.waitForSelector('.panel-terminal .terminal-input', { timeout: 120_000 });
      await type(page, 'ros2 component list');
      await shows(page, '/box');
      await type(page, 'ros2 component load /box composed_talkers composed_talkers::Counter -n one -p step:=2');
      await shows(page, "Loaded component 1 into '/box' container node as '/one'");
      await type(page, 'ros2 component list /box');
      await shows(page, '1  /one');
      await type(page, 'ros2 component unload /box 1');
      await shows(page, "Unloaded component 1 from '/box' container node");
      await type(page, 'ros2 component load /box composed_talkers composed_talkers::Nothing');
      await shows(page, 'Failed to load component');
      await type(page, 'ros2 component list /nobody');
      await shows(page, "Unable to find container node '/nobody'");

      await type(page, 'ros2 param set /robot speed 1.75');
      await shows(page, 'Set parameter successful');
      await type(page, 'ros2 param dump /robot > robot.yaml');
      await type(page, 'ros2 param set /robot speed 1.0');
      await type(page, 'ros2 param load /robot robot.yaml');
      await shows(page, 'Set parameter speed successful');
      await page.locator('.terminal-input input').fill('ros2 param get /robot sp');
      await page.locator('.terminal-input input').press('Tab');
      await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.terminal-input input')?.value === 'ros2 param get /robot speed ');
      await type(page, 'ros2 param get /robot speed');
      await shows(page, 'Double value is: 1.75');
      await type(page, 'ros2 param load /robot none.yaml');
      await shows(page, "No such file: 'none.yaml'");

      await type(page, 'ros2 run command_robot robot --ros-args -r __node:=second -r chatter:=other');
      await page.locator('.panel-nodes').getByText('robot-2').or(page.locator('.panel-nodes').getByText('robot').nth(1)).first().waitFor();
      await page.waitForSelector('.terminal-input input:not([readonly])');
      await page.locator('.terminal-input input').press('Control+c');
      await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.terminal-input input')?.placeholder === 'ros2 topic list');
      await type(page, 'ros2 node list');
      await shows(page, '/robot');

      await type(page, 'ros2 run key_reader keys');
      await shows(page, 'no key yet');
      const field = page.locator('.terminal-input input');
      await page.waitForSelector('.terminal-input input[placeholder^="Keys go to the node"]');
      // Each at once, without Enter.
      await field.press('.');
      await field.press('k');
      await shows(page, 'key: k');
      await field.press('ArrowUp');
      await shows(page, 'key: A');
      await field.press('x');
      await shows(page, 'key: x');
      await page.waitForSelector('.terminal-input input[placeholder="ros2 topic list"]');
      await page.waitForFunction(() => document.querySelector<HTMLInputElement>('.terminal-input input')?.placeholder === 'ros2 topic list');
    });
  });
}
