// The command line of ros2: words and quotes, options, what is refused, completion, and Python's way to write values.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { complete, wanted } from '../../../runtime/site/ros2cli/complete.ts';
import { parametersOfFile } from '../../../runtime/site/ros2cli/parameter_file.ts';
import { parseCommand, splitLine } from '../../../runtime/site/ros2cli/parse.ts';
import { reprFloat, reprMessage, reprText } from '../../../runtime/site/ros2cli/python_text.ts';
import { dumpText, parameterValue, pythonValue } from '../../../runtime/site/ros2cli/parameters.ts';
import { commands } from '../../../runtime/site/ros2cli/table.ts';
import type { GraphView } from '../../../runtime/site/contract/session.ts';

test('words are split as a shell does it', () => {
  assert.deepEqual(splitLine(`ros2 topic pub  /x "{a: 1}" '{b: "2"}' a\\ b ""`), ['ros2', 'topic', 'pub', '/x', '{a: 1}', '{b: "2"}', 'a b', '']);
  assert.deepEqual(splitLine('say "it\'s \\"so\\" \\n"'), ['say', 'it\'s "so" \\n']);
  assert.deepEqual(splitLine("x'y z'w"), ['xy zw']);
  assert.deepEqual(splitLine('  '), []);
  assert.equal(splitLine('topic "open'), undefined);
});

function given(...words: string[]): unknown {
  const parsed = parseCommand(commands, words);
  return parsed.kind === 'run' ? [parsed.given.positionals, Object.fromEntries(parsed.given.options)] : parsed.text;
}

test('options in all their forms', () => {
  const pub = ['topic', 'pub', '/x', 'std_msgs/msg/Float64', 'data: -1'];
  assert.deepEqual(given(...pub, '-r', '10', '-1'), [pub.slice(2), { rate: '10', once: '' }]);
  assert.deepEqual(given(...pub, '-r10', '--times=3'), [pub.slice(2), { rate: '10', times: '3' }]);
  assert.deepEqual(given('param', 'set', '/n', 'x', '-1.5'), [['/n', 'x', '-1.5'], {}]);
  assert.deepEqual(given('param', 'set', '/n', 'x', '--', '--flag'), [['/n', 'x', '--flag'], {}]);
  assert.deepEqual(given('topic', 'echo', '/x', '--qos-reliability', 'best_effort'), [['/x'], { 'qos-reliability': 'best_effort' }]);
});

test('lists of words, and options that may stand alone', () => {
  assert.deepEqual(given('bag', 'record', '-o', 'run', '/a', '/b'), [['/a', '/b'], { output: 'run' }]);
  assert.deepEqual(given('bag', 'record', '--topics', '/a', '/b', '-o', 'run'), [[], { topics: '/a /b', output: 'run' }]);
  assert.deepEqual(given('bag', 'play', 'run', '--clock', '--remap', '/a:=/b', '/c:=/d'), [['run'], { clock: '40', remap: '/a:=/b /c:=/d' }]);
  assert.deepEqual(given('bag', 'play', 'run', '--clock', '100'), [['run'], { clock: '100' }]);
  assert.deepEqual(given('bag', 'play', 'run', '--clock=5', '-l'), [['run'], { clock: '5', loop: '' }]);
  assert.match(String(given('bag', 'play', 'run', '--topics')), /argument --topics: expected at least one argument$/);
  assert.match(String(given('bag', 'play', 'run', '--topics', '-l')), /argument --topics: expected at least one argument$/);
  assert.match(String(given('bag', 'record', '-h')), /^usage: ros2 bag record \[-h\] .*\[--topics Topic \[Topic \.\.\.\]\].* \[Topic \.\.\.\]\n/);
});

test('short options of two letters are no option with a value', () => {
  assert.deepEqual(given('doctor', '-rf'), [[], { 'report-failed': '' }]);
  assert.deepEqual(given('wtf', '-iw', '-ep'), [[], { 'include-warnings': '', 'exclude-packages': '' }]);
  assert.match(String(given('doctor', '-rx')), /argument --report\/-r: ignored explicit argument 'x'$/);
});

test("what stands behind the program is the program's", () => {
  const words = ['--ros-args', '-r', '__ns:=/left', '-p', 'speed:=-1', '--', '-h'];
  assert.deepEqual(given('run', 'demo', 'talker', ...words), [['demo', 'talker', ...words], {}]);
  assert.deepEqual(given('run', 'demo', 'talker'), [['demo', 'talker'], {}]);
  assert.match(String(given('run', '-h')), /^usage: ros2 run \[-h\] package_name executable_name \.\.\.\n/);
  assert.match(String(given('run', 'demo')), /the following arguments are required: executable_name$/);
  assert.match(String(given('run', '--prefix', 'gdb', 'demo', 'talker')), /unrecognized arguments: --prefix$/);
});

test('options that may be given several times', () => {
  const load = ['component', 'load', '/box', 'demo', 'demo::Talker'];
  assert.deepEqual(given(...load, '-p', 'a:=1', '-r', 'x:=y', '-p', 'b:=[2, 3]'), [load.slice(2), { 'parameter': 'a:=1\nb:=[2, 3]', 'remap-rule': 'x:=y' }]);
});

test("a file of parameters: nested names, the wildcard when asked for, the node's own count", () => {
  const file =
    "/**:\n  ros__parameters: {speed: 1, name: all}\n/robot:\n  ros__parameters:\n    speed: 2.5\n    limits: {low: [1, 2], high: {x: '3'}}\n    flag: true\n";
  assert.deepEqual(parametersOfFile(file, '/robot', false), [
    { name: 'speed', value: { type: 3, double_value: 2.5 } },
    { name: 'limits.low', value: { type: 7, integer_array_value: [1n, 2n] } },
    { name: 'limits.high.x', value: { type: 4, string_value: '3' } },
    { name: 'flag', value: { type: 1, bool_value: true } },
  ]);
  assert.deepEqual(parametersOfFile(file, '/robot', true).map(({ name }) => name), ['speed', 'name', 'limits.low', 'limits.high.x', 'flag']);
  assert.deepEqual(parametersOfFile('robot: {ros__parameters: {a: x}}', '/robot', false), [{ name: 'a', value: { type: 4, string_value: 'x' } }]);
  for (
    const [text, pattern] of [
      ['/other: {ros__parameters: {a: 1}}', /does not contain parameters for \/robot, only for nodes: \/other$/],
      ['/robot: {parameters: {a: 1}}', /Invalid structure of parameter file for node \/robot/],
      ['[1, 2', /./],
      ['5', /no parameters/],
      [`/robot: {ros__parameters: ${'{a: '.repeat(60)}1${'}'.repeat(60)}}`, /nested deeper/],
    ] as const
  ) assert.throws(() => parametersOfFile(text, '/robot', false), pattern, text);
});

test('what is wrong is told as argparse tells it', () => {
  for (
    const [words, pattern] of [
      [['topic', 'echo'], /error: the following arguments are required: topic_name$/],
      [['topic', 'echo', '/x', 'T', 'more'], /error: unrecognized arguments: more$/],
      [['topic', 'echo', '/x', '--nope'], /error: unrecognized arguments: --nope$/],
      [['topic', 'echo', '/x', '--field'], /error: argument --field: expected one argument$/],
      [['topic', 'hz', '/x', '-w', '0'], /argument --window\/-w: '0' is not a number above 0$/],
      [['topic', 'echo', '/x', '--qos-history', 'all'], /invalid choice: 'all' \(choose from 'keep_last', 'keep_all'\)$/],
      [['topic', 'list', '--verbose=1'], /ignored explicit argument '1'$/],
      [['topic', 'ecko'], /invalid choice: 'ecko'/],
      [['topik'], /invalid choice: 'topik'/],
    ] as const
  ) {
    const parsed = parseCommand(commands, words);
    assert.equal(parsed.kind, 'wrong', words.join(' '));
    assert.match(parsed.kind === 'wrong' ? parsed.text : '', pattern);
  }
});

test('help for all, for a group, for a command', () => {
  for (
    const [words, pattern] of [
      [[], /^usage: ros2 \[-h\] <command> \.\.\.\n[^]* {2}topic +list, info, type, find, echo, hz, bw, delay, pub\n/],
      [['topic'], /^usage: ros2 topic \[-h\] <command>[^]* {2}echo +Output messages from a topic\n/],
      [['topic', 'pub', '--help'], /^usage: ros2 topic pub \[-h\] \[--rate N\].* topic_name message_type \[values\]\n[^]* {2}--once, -1 /],
    ] as const
  ) {
    const parsed = parseCommand(commands, words);
    assert.equal(parsed.kind, 'help');
    assert.match(parsed.kind === 'help' ? parsed.text : '', pattern);
  }
});

test('no two commands share their words, no two options a name', () => {
  assert.equal(new Set(commands.map(({ words }) => words.join(' '))).size, commands.length);
  for (const { words, options } of commands) {
    const names = options.flatMap((option) => option.names);
    assert.equal(new Set(names).size, names.length, words.join(' '));
  }
});

const qos = {
  reliability: 'reliable',
  durability: 'volatile',
  history: 'keep_last',
  depth: 10,
  liveliness: 'automatic',
  deadlineNs: 0,
  lifespanNs: 0,
  leaseNs: 0,
} as const;
const endpoint = (name: string, type: string) => ({ name, type, hash: '', qos, gid: '00'.repeat(16) });
const graph: GraphView = {
  nodes: [{
    name: '/box',
    process: 'component_container-1',
    publishers: [],
    subscriptions: [],
    clients: [],
    actionServers: [],
    actionClients: [],
    services: ['load_node', 'unload_node', 'list_nodes'].map((verb) => endpoint(`/box/_container/${verb}`, 'x')),
  }, {
    name: '/talker',
    process: 'talker-1',
    publishers: [endpoint('/chatter', 'std_msgs/msg/String'), endpoint('/count/_action/feedback', 'x')],
    subscriptions: [],
    services: [endpoint('/add', 'demo/srv/Add')],
    clients: [],
    actionServers: [{ name: '/count', type: 'demo/action/Count' }],
    actionClients: [],
  }, { name: '/_ros2wasm_page', process: undefined, publishers: [], subscriptions: [], services: [], clients: [], actionServers: [], actionClients: [] }],
};
const known = {
  graph,
  interfaces: ['demo/action/Count', 'demo/srv/Add', 'std_msgs/msg/Int8', 'std_msgs/msg/String'],
  programs: [
    { package: 'demo', executable: 'talker' },
    { package: 'demo', executable: 'listener' },
    { package: 'turtlesim', executable: 'draw_square' },
  ],
  launches: {
    launchFile: { package: 'demo', file: 'src/demo/launch/demo.launch.py' },
    launch: { data: '', evaluator: '', notes: [], decided: false, reran: false, arguments: [{ name: 'speed', value: '', description: '', choices: [] }] },
  },
};

test('completion offers what may stand there', () => {
  for (
    const [line, choices] of [
      ['ro', ['ros2']],
      ['ros2 to', ['topic']],
      ['ros2 topic e', ['echo']],
      ['ros2 topic echo ', ['/chatter']],
      ['ros2 topic echo --on', ['--once']],
      ['ros2 topic echo --qos-history ', ['keep_all', 'keep_last']],
      ['ros2 topic echo --field data /c', ['/chatter']],
      ['ros2 topic pub /chatter ', ['std_msgs/msg/String']],
      ['ros2 topic pub /new std_msgs/msg/I', ['std_msgs/msg/Int8']],
      ['ros2 node info ', ['/box', '/talker']],
      ['ros2 service call ', ['/add']],
      ['ros2 service call /add ', ['demo/srv/Add']],
      ['ros2 action send_goal /count ', ['demo/action/Count']],
      ['ros2 interface show std', ['std_msgs/msg/Int8', 'std_msgs/msg/String']],
      ['ros2 topic pub /chatter std_msgs/msg/String ', []],
      ['ros2 run ', ['demo', 'turtlesim']],
      ['ros2 run d', ['demo']],
      ['ros2 run demo ', ['listener', 'talker']],
      ['ros2 run demo talker ', []],
      ['ros2 pkg executables t', ['turtlesim']],
      ['ros2 component list ', ['/box']],
      ['ros2 launch ', ['demo']],
      ['ros2 launch demo ', ['demo.launch.py']],
      ['ros2 launch other ', []],
      ['ros2 doc', ['doctor']],
      ['ros2 doctor --re', ['--report', '--report-failed']],
      ['ros2 wtf -i', ['-iw']],
      ['ros2 launch demo demo.launch.py sp', ['speed:=']],
      ['ros2 launch demo demo.launch.py speed:=1 ', ['speed:=']],
      ['ls ', []],
    ] as const
  ) {
    assert.deepEqual(complete(line, known).choices, choices, line);
  }
  // Choices that need a question to a node, or the definitions.
  assert.deepEqual(
    ['ros2 param get talker ', 'ros2 topic pub /t std_msgs/Int8 ', 'ros2 service call /add demo/srv/Add ', 'ros2 action send_goal /c demo/action/Count ',
      'ros2 param get ', 'ros2 topic pub /t std_msgs/msg/Int8 -', 'ls '].map(wanted),
    [
      { kind: 'parameters', node: '/talker' },
      { kind: 'prototype', type: 'std_msgs/msg/Int8' },
      { kind: 'prototype', type: 'demo/srv/Add_Request' },
      { kind: 'prototype', type: 'demo/action/Count_Goal' },
      undefined,
      undefined,
      undefined,
    ],
  );
  assert.deepEqual(complete('ros2 param set /talker sp', { ...known, told: ['speed', 'other', 'spin'] }).choices, ['speed', 'spin']);
  assert.deepEqual(complete('ros2 topic echo /ch', known), { word: '/ch', start: 16, choices: ['/chatter'] });
});

test('values as Python writes them', () => {
  assert.deepEqual(["a'b", 'a"b', `'"`, 'x\n\t\\', 'grüezi 🐢', '\u0007'].map(reprText), [`"a'b"`, `'a"b'`, `'\\'"'`, `'x\\n\\t\\\\'`, "'grüezi 🐢'",
    "'\\x07'"]);
  assert.deepEqual([1, 0.1, 1e16, 1e-5, -0, NaN, Infinity].map(reprFloat), ['1.0', '0.1', '1e+16', '1e-05', '-0.0', 'nan', 'inf']);
  const shape = [
    { name: 'on', type: 'bool', isArray: false, shape: null },
    { name: 'data', type: 'float64', isArray: true, shape: null },
    { name: 'at', type: 'geometry_msgs/msg/Point', isArray: false, shape: [{ name: 'x', type: 'float64', isArray: false, shape: null }] },
  ];
  assert.equal(reprMessage('demo/msg/Mix', shape, { on: true, data: Float64Array.of(1, 2.5), at: { x: 3 } }),
    'demo.msg.Mix(on=True, data=[1.0, 2.5], at=geometry_msgs.msg.Point(x=3.0))');
});

test('parameters: types from what was typed, values as Python prints them, files', () => {
  assert.deepEqual(parameterValue('5', 5n), { type: 2, integer_value: 5n });
  assert.deepEqual(parameterValue('5.0', 5), { type: 3, double_value: 5 });
  assert.deepEqual(parameterValue('[1, 2]', [1n, 2n]), { type: 7, integer_array_value: [1n, 2n] });
  assert.deepEqual(parameterValue('[1, a]', [1n, 'a']), { type: 4, string_value: '[1, a]' });
  assert.equal(pythonValue({ type: 8, double_array_value: Float64Array.of(1, 2) }), "array('d', [1.0, 2.0])");
  assert.equal(pythonValue({ type: 1, bool_value: true }), 'True');
  const text = dumpText('/a/node', new Map<string, Readonly<Record<string, unknown>>>([
    ['x.y', { type: 2, integer_value: 1n }],
    ['x.a', { type: 4, string_value: 'yes' }],
    ['b', { type: 9, string_array_value: [] }],
  ]));
  assert.equal(text, "/a/node:\n  ros__parameters:\n    b: []\n    x:\n      a: 'yes'\n      y: 1");
});
