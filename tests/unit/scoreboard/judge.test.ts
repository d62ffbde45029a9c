// When a row of the score board is green.
import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { isGreen, ownEndpoints, type Row, summary } from '../../scoreboard/board.ts';
import { BadExpectation, parseExpectations, type Expectation } from '../../scoreboard/expectation.ts';
import { judge, type Seen, type SeenNode } from '../../scoreboard/judge.ts';
import { posted, received } from '../../scoreboard/posted.ts';
import { closure, findPackages, readPackage } from '../../scoreboard/packages.ts';
import { valueAt } from '../../scoreboard/play.ts';
import { firstError, whyLeftOut } from '../../scoreboard/site.ts';

function expectation(text: string): Expectation {
  const [one] = parseExpectations(`- {package: p, executable: e, ${text}}`, 'x.yaml');
  assert.ok(one !== undefined);
  return one;
}

const RUNS: SeenNode = { lines: [], started: true, exit: undefined, crash: undefined };

function seen(node: Partial<SeenNode>, more: Partial<Seen> = {}): Seen {
  return { node: { ...RUNS, ...node }, beside: [], endpoints: new Set(), value: () => undefined, ...more };
}

test('lines are wanted in order, others anywhere, some never', () => {
  const ordered = expectation('log: [a, b]');
  assert.deepEqual(judge(ordered, seen({ lines: ['b', 'a'] })), { final: false, missing: ['no line fits b'] });
  assert.deepEqual(judge(ordered, seen({ lines: ['a', 'x', 'b'] })), { final: true, missing: [] });
  assert.deepEqual(judge(ordered, seen({ lines: ['ab'] })).missing, ['no line fits b']);
  assert.deepEqual(judge(expectation('anywhere: [a, b]'), seen({ lines: ['b', 'a'] })).missing, []);
  assert.deepEqual(judge(expectation('log: [a], never: [bad]'), seen({ lines: ['a', 'too bad'] })), { final: true, missing: ['it must not say: too bad'] });
});

test('endpoints, values and what stands beside count', () => {
  const one = expectation('endpoints: [publisher /t T], values: {/t: {data: "^4"}}, beside: [{package: q, executable: f, log: [c]}]');
  const got = (value: string | undefined, line: string): Seen =>
    seen({}, { endpoints: new Set(['publisher /t T']), value: () => value, beside: [{ ...RUNS, lines: [line] }] });
  assert.deepEqual(judge(one, got('42', 'c')).missing, []);
  assert.deepEqual(judge(one, got('5', 'c')).missing, ['data on /t is 5, not ^4']);
  assert.deepEqual(judge(one, got(undefined, 'd')).missing, ['f: no line fits c', 'no data on /t']);
  assert.deepEqual(judge(one, seen({})).missing.includes('no publisher /t T'), true);
});

test('an end is judged: by the code that is wanted, else a clean one', () => {
  assert.deepEqual(judge(expectation('log: [a], exit: 0'), seen({ lines: ['a'] })).missing, ['it does not end']);
  assert.deepEqual(judge(expectation('log: [a], exit: 3'), seen({ lines: ['a'], exit: 3 })).missing, []);
  assert.deepEqual(judge(expectation('log: [a]'), seen({ lines: ['a'], exit: 1 })).missing, ['it ends with 1']);
  const crash = { code: 'R2W0705', message: 'unreachable' };
  assert.deepEqual(judge(expectation('log: [a]'), seen({ lines: ['a'], crash })), { final: true, missing: ['unreachable'] });
});

test('an expectation that says nothing, or what is not known, is refused', () => {
  for (
    const text of ['seconds: 3', 'never: [x]', 'logs: [x]', 'log: x', 'log: ["("]', 'log: [x], exit: zero', 'beside: [{package: q, executable: f, seconds: 3}]']
  ) {
    assert.throws(() => expectation(text), BadExpectation, text);
  }
  assert.throws(() => parseExpectations('a: b', 'x.yaml'), BadExpectation);
  assert.throws(() => parseExpectations('[{package: p, executable: e, log: [x]}, {package: p, executable: e, log: [y]}]', 'x.yaml'), /twice/);
});

test('of a launch file, arguments and what all nodes together show are stated', () => {
  const [one] = parseExpectations('- {package: p, launch: launch/all.launch.py, arguments: {robot: r2, speed: 2.5, sim: true}, log: [x]}', 'x.yaml');
  assert.deepEqual([one?.kind, one?.executable, one?.given], ['launch', 'launch/all.launch.py', { robot: 'r2', speed: 2.5, sim: true }]);
  const passed = received(posted({ kind: 'launch', expected: one }));
  assert.deepEqual([passed.kind, passed.expected?.given, passed.expected?.log], ['launch', one?.given, one?.log]);
  for (const text of ['executable: e', 'beside: []', 'arguments: [robot:=r2]', 'arguments: {a: [1]}', 'input: []'])
    assert.throws(() => parseExpectations(`- {package: p, launch: l.launch.py, log: [x], ${text}}`, 'x.yaml'), BadExpectation, text);
});

test('a row without expectation is not green', () => {
  const row: Row = {
    package: 'p',
    executable: 'e',
    language: 'cpp',
    kind: 'executable',
    built: true,
    started: true,
    endpoints: [],
    log_lines: [],
    expected: true,
    error: null,
  };
  assert.equal(isGreen(row), true);
  for (const worse of [{ expected: null }, { expected: false }, { started: false }, { built: false }, { error: { code: 'unmet', reason: 'x' } }]) {
    assert.equal(isGreen({ ...row, ...worse }), false);
  }
  assert.match(summary([row, { ...row, executable: 'f', expected: null }]), /1 of {2}2 {2}p\n +1 red: no expectation \(p\/f\)\n1 of 2 executables are green$/);
  const launch: Row = { ...row, executable: 'launch/all.launch.py', kind: 'launch' };
  assert.match(summary([row, launch, { ...launch, expected: false }]), /1 of 1 executables and 1 of 2 launch files are green$/);
});

test('endpoints that every node brings are skipped', () => {
  assert.deepEqual(
    ownEndpoints(['server /n/get_parameters rcl_interfaces/srv/GetParameters', 'subscription /rosout T', 'publisher /rosout T', 'publisher /a T',
      'client /n/x T']),
    ['client /n/x T', 'publisher /a T', 'subscription /rosout T'],
  );
});

test('what a package.xml needs, and what that needs', () => {
  const one = readPackage('/p',
    '<package><name>p</name><!-- <depend>old</depend> --><depend condition="$A == 1">q</depend><test_depend>t</test_depend><exec_depend>r</exec_depend></package>');
  const two = readPackage('/q', '<package><name>q</name><build_depend>p</build_depend><export><build_type>ament_python</build_type></export></package>');
  assert.ok(one !== undefined && two !== undefined);
  assert.deepEqual(one, { name: 'p', folder: '/p', language: 'cpp', needs: ['q', 'r'] });
  assert.equal(two.language, 'python');
  assert.deepEqual(closure(['q'], new Map([['p', one], ['q', two]])), [one, two]);
});

test('what only sources know of other packages is needed too', (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'packages-'));
  t.after(() => rmSync(folder, { recursive: true }));
  for (const name of ['arm', 'arm_tools', 'arm_bringup']) {
    mkdirSync(join(folder, name));
    writeFileSync(join(folder, name, 'package.xml'), `<package><name>${name}</name></package>`);
  }
  writeFileSync(join(folder, 'arm/node.py'), 'from arm_tools.joints import Joint\n');
  writeFileSync(join(folder, 'arm_bringup/arm_launch.xml'), '<launch><node pkg="arm" exec="node"/></launch>');
  assert.deepEqual([...findPackages([folder]).values()].map(({ name, needs }) => [name, needs]), [['arm', ['arm_tools']], ['arm_bringup', ['arm']], [
    'arm_tools',
    [],
  ]]);
});

test('values are found by path; the first error is told', () => {
  assert.equal(valueAt({ a: { b: [1, 2.5] } }, 'a.b.1'), '2.5');
  assert.equal(valueAt({ a: 1 }, 'a.b'), undefined);
  assert.deepEqual(
    firstError(
      '{"event":"progress"}\n{"code":"R2W0514","severity":"warning","message":"w"}\n{"code":"R2W0502","severity":"error","message":"m","detail":"x\\nan error: y\\n"}',
    ),
    { code: 'R2W0502', reason: 'm: an error: y' },
  );
  assert.equal(firstError('killed'), undefined);
});

test("a package that is skipped has the first reason of all, with its place; CMake's last line is none", () => {
  const event = (code: string, severity: string, message: string, more: object): string =>
    JSON.stringify({ event: 'diagnostic', code, severity, message, ...more });
  const messages = [
    event('R2W0519', 'warning', 'package `sim` is skipped: no channel has `gazebo`', { span: { file: 'src/sim/package.xml', line: 8 }, why: ['advice'] }),
    event('R2W0514', 'warning', 'package `lab` is skipped: it needs `sim`', {
      span: null,
      why: ['`sim` is skipped: no channel has `gazebo` (src/sim/package.xml:8)'],
    }),
  ].join('\n');
  assert.deepEqual(whyLeftOut(messages, 'sim'), { code: 'R2W0519', reason: 'package `sim` is skipped: no channel has `gazebo` (src/sim/package.xml:8)' });
  assert.deepEqual(whyLeftOut(messages, 'lab'), {
    code: 'R2W0514',
    reason: 'package `lab` is skipped: it needs `sim`: `sim` is skipped: no channel has `gazebo` (src/sim/package.xml:8)',
  });
  assert.deepEqual(whyLeftOut('', 'lab'), { code: 'R2W0514', reason: 'the package is skipped' });
  assert.deepEqual(firstError(event('R2W0503', 'error', 'CMakeLists.txt of package `x` failed: no zmq', {
    span: { file: 'src/x/CMakeLists.txt', line: 4 },
    detail: 'CMake Error\n-- Configuring incomplete, errors occurred!\n',
  })), { code: 'R2W0503', reason: 'CMakeLists.txt of package `x` failed: no zmq (src/x/CMakeLists.txt:4)' });
});
