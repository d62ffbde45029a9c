// Parameters from YAML files: a C++ node, a controller as ros2_controllers writes them, a node with the parameters of another package,
// and a Python node. Values are set by `ros2 param`, and each rule refuses one; headless.

// Compatibility, works: generate_parameter_library for C++ and Python: all types, maps, checks of `rsl` and of the workspace, changes while the
// node runs, exported targets; controllers whose parameters come from it; `generate_parameter_module()` in setup.py and in CMakeLists.txt

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { bagFiles, textOfFile } from '../../../runtime/site/ros2cli/shell_files.ts';
import { runCommand } from '../../../runtime/site/ros2cli/run.ts';
import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import type { Session } from '../../../runtime/site/contract/session.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 400_000 };
const entry = new URL('../../../runtime/site/session/headless.ts', import.meta.url);

let workspace: PackWorkspace;
let site: string;

before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.copyPackages('parameter_checks', 'parameter_checks_py', 'parameter_checks_user');
  workspace.write('workspace.yaml', 'schema: 1\nname: checks\npackages: [src/*]\nlaunch: src/parameter_checks/launch/checks.launch.yaml\n');
  site = await workspace.packed();
}, watchdog);
after(() => workspace.close());

/** The lines that a node has said, without time and name of rclcpp. */
function said(session: Session, program: string): string[] {
  const node = session.nodes().find(({ executable }) => executable === program);
  assert.ok(node, `the site does not have the program ${program}`);
  return session.console(node.id).lines().map(({ text }) => text.replace(/^\[INFO\] \[[\d.]+\] \[[\w.]+\]: /, ''));
}

/** Waits until a node has said a line like that since line `from`; gives its number. */
async function until(session: Session, program: string, line: RegExp, from = 0): Promise<number> {
  const end = Date.now() + 60_000;
  for (;;) {
    const index = said(session, program).findIndex((text, at) => at >= from && line.test(text));
    if (index >= 0) return index;
    assert.ok(Date.now() < end, `${line} never came:\n${said(session, program).join('\n')}`);
    await new Promise((done) => setTimeout(done, 20));
  }
}

async function ros2(session: Session, ...words: readonly string[]): Promise<string> {
  let out = '';
  const print = (text: string): void => {
    out += `${text}\n`;
  };
  await runCommand(session, words, {
    signal: new AbortController().signal,
    bags: bagFiles,
    readText: textOfFile,
    takeInput: () => undefined,
    print,
    warn: print,
  });
  return out.trimEnd();
}

test('parameters of YAML files', watchdog, async (t) => {
  const { session, close } = await openHeadless(site, 'shared', entry);
  const set = (node: string, name: string, value: string): Promise<string> => ros2(session, 'param', 'set', node, name, value);
  const done = 'Set parameter successful';
  const refused = (reason: string): string => `Setting parameter failed: ${reason}`;
  try {
    session.startAll();
    await session.settled;
    const arm = 'arm';

    await t.test('a node has the defaults, and what its file gives', async () => {
      const end = await until(session, arm, /^left/);
      assert.deepEqual(said(session, arm).slice(0, end + 1), [
        'rate 2.5 tries 3 slow 0 title it\'s "quoted" */ \\n offset 1 base base_link serial 42 changed 0',
        'joints a,b axes x,z flags 2 counts 5000000000 weights 0.5,1',
        'mode fast gains 1,2 (3) names left parity 2',
        'period 10 a=1/x=0.25/z=0.25 b=2.5/x=0.25/z=0.75',
        'stack 2.5 10 fast',
        'left is there',
      ]);
    });

    await t.test('each rule refuses a value', async () => {
      const cases: readonly (readonly [string, string, string])[] = [
        ['rate', '0.0', "Parameter {rate} doesn't comply with floating point range."],
        ['rate', '100.5', "Parameter {rate} doesn't comply with floating point range."],
        ['tries', '6', "Parameter {tries} doesn't comply with integer range."],
        ['title', '', "Parameter 'title' cannot be empty"],
        ['base', 'other', "parameter 'base' cannot be set because it is read-only"],
        ['joints', '[a, a]', "Parameter 'joints' must only contain unique values"],
        ['axes', '[x, w]', "Entry 'w' in parameter 'axes' is not in the set '{x, y, z}'"],
        ['axes', '[x, x, x, x]', "Length of parameter 'axes' is '4' but must be less than '4'"],
        ['flags', '[true]', "Length of parameter 'flags' is '1' but must be equal to '2'"],
        ['counts', '[3, -1]', "Value '-1' in parameter 'counts' must be above lower bound of '0'"],
        ['weights', '[0.5, 1.25]', "Value '1.25' in parameter 'weights' must be within bounds '[0, 1]'"],
        ['weights', '[1.0, 1.0]', "the sum of 'weights' is 2"],
        ['mode', 'slowly', "Parameter 'mode' with the value 'slowly' is not in the set '{fast, slow, fastest}'"],
        ['mode', 'fastest', "Length of parameter 'mode' is '7' but must be less than '7'"],
        ['gains', '[1.0, 9.5]', "Value '9.5' in parameter 'gains' must be below upper bound of '9'"],
        ['gains', '[1.0, 2.0, 3.0, 4.0]', "Length of parameter 'gains' is '4' but must be less than '4'"],
        ['parity', '3', "'parity' is odd: 3"],
        ['pid.a.p', '-0.5', "Parameter {pid.a.p} doesn't comply with floating point range."],
        ['rate', 'fast', 'Wrong parameter type, parameter {rate} is of type {double}, setting it to {string} is not allowed.'],
      ];
      const answers = [];
      for (const [name, value] of cases) answers.push(await set('/arm', name, value));
      assert.deepEqual(answers, cases.map(([, , reason]) => refused(reason)));
    });

    await t.test('changes reach the node, and keys that come later have parameters', async () => {
      const before = said(session, arm).length;
      assert.equal(await set('/arm', 'rate', '20.0'), done);
      await until(session, arm, /^rate 20 .* changed 20$/, before);
      assert.match(await set('/arm', 'pid.c.p', '4.0'), /not declared|undeclared/);
      assert.equal(await set('/arm', 'joints', '[a, c]'), done);
      await until(session, arm, /^period 10 a=1\/x=0.25\/z=0.25 b=2.5\/x=0.25\/z=0.75 c=1\/x=0.25\/z=0.25$/, before);
      assert.equal(await set('/arm', 'pid.c.z.limit', '0.5'), done);
      await until(session, arm, / c=1\/x=0.25\/z=0.5$/, before);
    });

    await t.test('a parameter is described as in its file', async () => {
      assert.equal(await ros2(session, 'param', 'describe', '/arm', 'rate'), `Parameter name: rate
  Type: double
  Description: Cycles per second, counted from the start
  Constraints:
    Min value: 5e-324
    Max value: 100.0
    Additional constraints: a divisor of 100`);
    });

    await t.test('a controller has parameters of a map, and follows them', async () => {
      const manager = 'ros2_control_node';
      const first = await until(session, manager, /lift is held at 0.50$/);
      assert.equal(await set('/holder', 'hold.lift.at', '1.25'), done);
      await until(session, manager, /lift is held at 1.25$/, first);
      assert.equal(await set('/holder', 'hold.lift.at', '2.0'), refused("Parameter {hold.lift.at} doesn't comply with floating point range."));
    });

    await t.test('a package uses the parameters of another, and hears what is wrong at the start', async () => {
      await until(session, 'user', /^serial 7$/);
      assert.deepEqual(said(session, 'user').slice(0, 4), [
        "uninitialized: parameter 'serial' is not initialized",
        "invalid: Invalid value set during initialization for parameter 'parity': 'parity' is odd: 3",
        "invalid: parameter 'tries' could not be set: Parameter {tries} doesn't comply with integer range.",
        'serial 7',
      ]);
    });

    await t.test('a Python node has modules that setup.py and CMake made', async () => {
      const python = 'arm_py';
      await until(session, python, /^rate 2.5 parity 2 speed 0.5 gains a=1.0 b=1.0$/);
      assert.equal(await set('/arm_py', 'parity', '3'), refused('parity is odd'));
      assert.equal(await set('/arm_py', 'joints', '[c, c]'), refused("Parameter 'joints' must only contain unique values"));
      assert.equal(await set('/arm_py', 'joints', '[c]'), done);
      await until(session, python, /gains c=1.0$/);
      assert.equal(await set('/arm_py', 'pid.c.p', '3.5'), done);
      await until(session, python, /gains c=3.5$/);
    });
  } finally {
    await close();
  }
});

test('a mistake in a YAML file stops the build with its line', watchdog, async () => {
  const own = new PackWorkspace('shared');
  try {
    own.addPackage('wrong', {}, {
      cmake: 'find_package(generate_parameter_library REQUIRED)\ngenerate_parameter_library(wrong_parameters src/wrong.yaml)\n',
      depends: ['generate_parameter_library'],
    });
    own.write('src/wrong/src/wrong.yaml', 'wrong:\n  rate:\n    type: double\n    validation:\n      boundz<>: [1.0, 2.0]\n');
    own.write('workspace.yaml', 'schema: 1\nname: wrong\npackages: [src/*]\nlaunch: [{package: wrong, executable: node}]\n');
    const { code, stderr } = await own.run(['pack', '--quick']);
    assert.equal(code, 1);
    assert.match(stderr, /src\/wrong\.yaml:5: error: `boundz`, the validation of rate, is not a known function\n.*fix: write `bounds<>`/);
  } finally {
    own.close();
  }
});
