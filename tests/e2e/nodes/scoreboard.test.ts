// `./dev scoreboard` on packages of our own: rows are green as they are expected, and red when they are not.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, test } from 'node:test';
import { parse } from 'yaml';

import type { Row } from '../../scoreboard/board.ts';
import { nightly, nightlyTest } from '../../support/nightly.ts';
import { CLI } from '../support/pack_workspace.ts';

const root = resolve(import.meta.dirname, '../../..');
const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-board-'));
after(() => rmSync(folder, { recursive: true, force: true }));

function board(args: readonly string[]): Promise<{ readonly code: number; readonly rows: readonly Row[]; readonly output: string; }> {
  const json = join(folder, 'rows.json');
  return new Promise((done) => {
    execFile(process.execPath, [
      join(root, 'tests/scoreboard/run.ts'),
      '--build',
      dirname(CLI),
      '--json',
      json,
      join(root, 'tests/packages'),
      ...args,
    ], { env: { ...process.env, XDG_CACHE_HOME: process.env['ROS2WASM_TEST_CACHE'] ?? join(folder, 'cache') } }, (error, output, errors) => {
      const code = typeof error?.code === 'number' ? error.code : 0;
      done({ code, output: `${output}${errors}`, rows: code === 2 ? [] : JSON.parse(readFileSync(json, 'utf8')) as Row[] });
    });
  });
}

const stated = parse(readFileSync(join(root, 'tests/scoreboard/expectations/own_packages.yaml'), 'utf8')) as readonly {
  readonly package: string;
  readonly executable?: string;
  readonly launch?: string;
}[];
const rowsOf = (prefix: string): string[] =>
  stated.filter((row) => row.package.startsWith(prefix)).map((row) => `${row.package}/${row.executable ?? row.launch}`);

/** Rows of packages that were written from the documentation alone. */
const learned = rowsOf('learn_');
/** Launch files of packages in the shape of public workspaces with a simulated robot. */
const simulated = rowsOf('sim_');

nightlyTest('components, linked, loaded and in a container; interfaces of another package of the workspace', { timeout: 500_000 }, async () => {
  const { code, rows, output } = await board(['--only', 'board_companions', '--only', 'composed_talkers', '--only', 'countdown', '--only', 'key_reader',
    '--only', 'lifecycle_sensor/launch']);
  assert.equal(code, 0, output);
  assert.deepEqual(rows.map((row) => `${row.package}/${row.executable}`), ['board_companions/load_components', 'board_companions/set_parameters',
    'composed_talkers/composed_talkers::Echo', 'composed_talkers/linked', 'composed_talkers/loaded', 'composed_talkers/launch/composed.launch.py',
    'countdown/client', 'countdown/server', 'countdown/launch/countdown.launch.xml', 'key_reader/keys', 'lifecycle_sensor/launch/sensor.launch.yaml']);
  assert.ok(rows.every((row) => row.built && row.started && row.expected === true));
  assert.deepEqual(rows.filter((row) => row.log_lines.length === 0).map((row) => row.package), ['lifecycle_sensor']);
  assert.deepEqual(rows.filter((row) => row.kind === 'launch').map((row) => row.package), ['composed_talkers', 'countdown', 'lifecycle_sensor']);
  assert.deepEqual(rows[4]?.endpoints, ['publisher /count std_msgs/msg/Int32', 'subscription /count std_msgs/msg/Int32']);
  assert.match(output, /8 of 8 executables and 3 of 3 launch files are green/);
});

nightlyTest('in Chromium: files of a package and of a program, standard input, and a launch file', { timeout: 500_000 }, async () => {
  const { code, rows, output } = await board(['--chromium', '--only', 'file_checks', '--only', 'key_reader', '--only', 'countdown/launch']);
  assert.equal(code, 0, output);
  assert.deepEqual(rows.map((row) => `${row.package}/${row.executable}`), ['countdown/launch/countdown.launch.xml', 'file_checks/own_files',
    'file_checks/plain', 'file_checks/share', 'file_checks/threads_write', 'file_checks/written', 'file_checks/written_in_a_thread', 'key_reader/keys']);
});

/** Those of Python, but one with a companion of C++, whose build is the longer part. */
const ofPython = learned.filter((row) => /_py\//.test(row) && row !== 'learn_own_types_py/adder');

// Compatibility, works: fifteen packages written after ROS 2's documentation, five of C++ (from it alone) and ten of Python: topics
// (callbacks of every form), services, actions, parameters, tf2, managed nodes, own interfaces, threads, asyncio
test('packages written from the documentation alone', { timeout: 1_200_000 }, async () => {
  const wanted = nightly ? learned : ofPython;
  const { code, rows, output } = await board(wanted.flatMap((row) => ['--only', row]));
  assert.equal(code, 0, output);
  assert.deepEqual(rows.map((row) => `${row.package}/${row.executable}`).sort(), [...wanted].sort());
  assert.ok(rows.every((row) => row.built && row.started && row.expected === true), output);
});

nightlyTest('in Chromium: packages of Python that were written from the documentation alone', { timeout: 500_000 }, async () => {
  const { code, rows, output } = await board(['--chromium', ...ofPython.flatMap((row) => ['--only', row])]);
  assert.equal(code, 0, output);
  assert.deepEqual(rows.map((row) => `${row.package}/${row.executable}`).sort(), [...ofPython].sort());
  assert.ok(rows.every((row) => row.built && row.started && row.expected === true), output);
});

// Compatibility, works: ten packages in the shape of public workspaces with a simulated robot: TurtleBot-like ones (a variable chooses the
// model, server and client apart), a robot description that several share, robots in namespaces, arms, cars, courses with a camera or a lidar
test('packages in the shape of public workspaces with a simulated robot', { timeout: 600_000 }, async () => {
  const { code, rows, output } = await board(simulated.flatMap((row) => ['--only', row]));
  assert.equal(code, 0, output);
  assert.equal(new Set(rows.map((row) => row.package)).size, 10);
  assert.deepEqual(rows.map((row) => `${row.package}/${row.executable}`).sort(), [...simulated].sort());
  assert.ok(rows.every((row) => row.built && row.started && row.expected === true), output);
});

test('a row that is not as expected is red, and a launch file with wrong arguments is not packed', { timeout: 500_000 }, async () => {
  const file = join(folder, 'wrong.yaml');
  writeFileSync(file, `
- {package: composed_talkers, executable: linked, log: [^/nobody$], exit: 0, seconds: 5}
- {package: composed_talkers, launch: launch/composed.launch.py, log: [heard]}
- {package: composed_talkers, launch: launch/absent.launch.xml, log: [heard]}
`);
  const { code, rows } = await board(['--only', 'composed_talkers/linked', '--only', 'composed_talkers/launch', '--expect', file]);
  assert.equal(code, 1);
  assert.deepEqual(rows.map(({ executable, expected, error }) => [executable, expected, error?.code]), [
    ['linked', false, 'unmet'],
    ['launch/absent.launch.xml', null, 'absent'],
    ['launch/composed.launch.py', null, 'R2W0412'],
  ]);
  assert.equal(rows[0]?.error?.reason, 'no line fits ^/nobody$');
});

test('a word too many is refused with the usage', async () => {
  const { code, output } = await board(['--onyl']);
  assert.equal(code, 2);
  assert.match(output, /usage: \.\/dev scoreboard/);
});
