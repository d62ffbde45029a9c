// The expressions that `--filter` of ros2 topic echo and hz accepts: Python's expressions over m, and how they fail.

// Compatibility, differs: `--filter EXPR` of `ros2 topic echo` and `ros2 topic hz` -> the expressions of Python that are made of fields,
// indices, numbers, texts, comparisons, arithmetic, `and`, `or`, `not`, `in`, `x if c else y`, `abs`, `all`, `any`, `bool`, `float`,
// `int`, `len`, `max`, `min`, `round`, `str`, `sum` and five methods of texts; what else Python has is refused. A number that is whole is
// an int and a float alike (`str(1.0)` is `1`)

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CommandError } from '../../../runtime/site/ros2cli/command.ts';
import { filterOf } from '../../../runtime/site/ros2cli/filter_expression.ts';

const MESSAGE = {
  data: 'Hello World: 12',
  count: 12,
  big: 2n ** 62n,
  on: true,
  empty: '',
  ranges: Float32Array.of(0.5, 2, Number.POSITIVE_INFINITY),
  names: ['left', 'right'],
  none: [],
  pose: { position: { x: 1.5, y: -2 } },
};

test('expressions are true where Python says so', () => {
  for (
    const [text, expected] of [
      ['m.count == 12', true],
      ['m.count > 12', false],
      ['m.count % 5 == 2', true],
      ['-7 // 2 == -4', true],
      ['-7 % 3 == 2', true],
      ["'World' in m.data", true],
      ["'x' not in m.data", true],
      ['"Hello World: 12" == m.data', true],
      ["m.data.startswith('Hello')", true],
      ["m.data.lower().endswith('12')", true],
      ['m.on', true],
      ['not m.on', false],
      ['not not m.on', true],
      ['m.on == 1', true],
      ['m.empty', false],
      ['m.none', false],
      ['len(m.none) == 0 and len(m.names) == 2', true],
      ['m.pose.position.x > 1 and m.pose.position.y < 0', true],
      ['1 < m.pose.position.x < 2', true],
      ['1 < m.pose.position.x < 1.2', false],
      ['m.ranges[0] < 1 or m.ranges[99] < 1', true],
      ['m.ranges[-1] > 1e9', true],
      ['min(m.ranges) == 0.5', true],
      ['max(1, 3, 2) == 3', true],
      ["m.names[1] == 'right'", true],
      ["'left' in m.names", true],
      ['m.count in [1, 12]', true],
      ['abs(m.pose.position.y) == 2', true],
      ['2 ** 3 ** 2 == 512', true],
      ['-2 ** 2 == -4', true],
      ['(1 + 2) * 3 == 9', true],
      ['int(m.data[-2] + m.data[-1]) == 12', true],
      ['m.big > 4e18', true],
      ['m.big == m.big', true],
      ['m.count if m.on else 0', true],
      ["'no' if not m.on else ''", false],
      ['m.count is not None', true],
      ['round(2.4) == 2 and str(True) == "True"', true],
      ['True and False or True', true],
      ['sum([1, 2]) == 3 and any([0, 1]) and not all([0, 1])', true],
    ] as const
  )
    assert.equal(filterOf(text)(MESSAGE), expected, text);
});

test('what Python refuses is refused, with its name', () => {
  for (
    const [text, pattern] of [
      ['m.count ==', /^SyntaxError: unexpected end/],
      ['m.count = 1', /^SyntaxError: invalid syntax/],
      ['1 2', /^SyntaxError: invalid syntax at '2'/],
      ['', /^SyntaxError/],
      ['x > 1', /^NameError: name 'x' is not defined/],
      ['__import__("os")', /^NameError: name '__import__'/],
      ['constructor', /^NameError/],
      ['m.none[', /^SyntaxError/],
      ['lambda: 1', /^SyntaxError/],
      [`${'('.repeat(500)}1`, /^SyntaxError: too many nested/],
    ] as const
  )
    assert.throws(() => filterOf(text), { message: pattern }, text);
  for (
    const [text, pattern] of [
      ['m.nothing', /^AttributeError: the message has no attribute 'nothing'/],
      ['m.constructor', /^AttributeError/],
      ['m.__proto__', /^AttributeError/],
      ['m.ranges.map(1)', /^AttributeError: a list has no method 'map'/],
      ['m.data.count', /^AttributeError/],
      ['m.ranges[3]', /^IndexError/],
      ['m.count / 0', /^ZeroDivisionError/],
      ['m.data > 1', /^TypeError: a str is not a number/],
      ['len(3)', /^TypeError/],
      ['m.count[0]', /^TypeError/],
    ] as const
  )
    assert.throws(() => filterOf(text)(MESSAGE), { message: pattern }, text);
});

// Each was evaluated by CPython; what sum() makes of doubles is that of 3.12, which ROS 2 Jazzy has.
test('numbers, texts and operators are as CPython has them', () => {
  for (
    const text of [
      'round(0.5) == 0',
      'round(1.5) == 2',
      'round(2.5) == 2',
      'round(-2.5) == -2',
      'round(2.675, 2) == 2.67',
      'round(0.125, 2) == 0.12',
      'round(0.375, 2) == 0.38',
      'round(12345, -2) == 12300',
      'round(15, -1) == 20',
      'round(25, -1) == 20',
      'round(-25, -1) == -20',
      'round(1234.5678, -2) == 1200',
      'round(1e300, -400) == 0',
      'round(1.5, None) == 2',
      'round(1e22) == 1e22',
      'round(5e-324, 5) == 0',
      'round(1.005, 2) == 1',
      'round(True) == 1',
      "int('12') == 12",
      "int(' -1_000 ') == -1000",
      "int('ff', 16) == 255",
      "int('0x1F', 16) == 31",
      'int(-2.7) == -2',
      'int() == 0',
      "int('9007199254740993') == 9007199254740993",
      "float('1e3') == 1000",
      "float(' -.5 ') == -0.5",
      "float('inf') > 1e308",
      "float('-Infinity') < 0",
      "float('nan') != float('nan')",
      "float('1_0.5') == 10.5",
      'max([1, 3, 2]) == 3',
      "max('abc') == 'c'",
      "max('b', 'a') == 'b'",
      'min(2, 1) == 1',
      'max(True, 0) == True',
      'sum([]) == 0',
      'sum([1, 2], 10) == 13',
      'sum([0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1]) == 1',
      'sum([True, True]) == 2',
      'abs(-3) == 3',
      'abs(True) == 1',
      "len('😀') == 1",
      '-7 // 2 == -4',
      '7 // -2 == -4',
      '-7 % 3 == 2',
      '7 % -3 == -2',
      '-7.5 % 2 == 0.5',
      '5.5 // 2 == 2',
      '-1 % 1e20 == 1e20',
      '0.3 % 0.1 < 0.1',
      '1 // 0.1 == 9',
      "7 // float('inf') == 0",
      "-7 // float('inf') == -1",
      "(0 or 'x') == 'x'",
      "('' or 0 or None) == None",
      "(1 and 'y') == 'y'",
      '(0 and 1) == 0',
      '(3 or 1 // 0) == 3',
      '1 < 2 < 3',
      'not (1 < 3 < 2)',
      '1 < 2 > 1 == 1',
      'not (2 < 1 < 1 // 0)',
      '1 == True != 2',
      "'  x '.strip() == 'x'",
      "'xxaxx'.strip('x') == 'a'",
      "'abc'.startswith('')",
      "not 'abc'.endswith('abcd')",
      '9007199254740993 != 9007199254740992',
      '9007199254740993 % 2 == 1',
      '2 ** 0.5 > 1.41',
      '2 ** -1 == 0.5',
      "str(None) == 'None'",
      `str([1, 'a']) == "[1, 'a']"`,
      "str(float('inf')) == 'inf'",
      "bool('') == False",
      '1 in [True]',
    ]
  )
    assert.equal(filterOf(text)(MESSAGE), true, text);
});

test('errors are those of CPython, by their names', () => {
  for (
    const [text, name] of [
      ["int('x')", 'ValueError'],
      ["int('')", 'ValueError'],
      ["int('1.5')", 'ValueError'],
      ["int('12', 2)", 'ValueError'],
      ["int(float('nan'))", 'ValueError'],
      ["int(float('inf'))", 'OverflowError'],
      ["float('x')", 'ValueError'],
      ["float('0x10')", 'ValueError'],
      ["float('')", 'ValueError'],
      ['max([])', 'ValueError'],
      ['min([])', 'ValueError'],
      ['max(3)', 'TypeError'],
      ["sum(['a'])", 'TypeError'],
      ["sum('ab')", 'TypeError'],
      ["abs('x')", 'TypeError'],
      ['abs()', 'TypeError'],
      ['len(3)', 'TypeError'],
      ['len(1, 2)', 'TypeError'],
      ["round(float('nan'))", 'ValueError'],
      ["round(float('inf'))", 'OverflowError'],
      ['round(1, 1.5)', 'TypeError'],
      ["round('x')", 'TypeError'],
      ["3 in 'abc'", 'TypeError'],
      ["'abc'.startswith(3)", 'TypeError'],
      ["'abc'.lower(1)", 'TypeError'],
      ['0 ** -1', 'ZeroDivisionError'],
      ['(-8) ** 0.5 < 1', 'TypeError'],
      ['10.0 ** 400', 'OverflowError'],
      ['1 % 0', 'ZeroDivisionError'],
      ["'a' < 1", 'TypeError'],
      ["'abc'[3]", 'IndexError'],
      ['[1][1.5]', 'TypeError'],
      ['all(3)', 'TypeError'],
      ['float([1])', 'TypeError'],
      ['05 == 5', 'SyntaxError'],
      [String.raw`'\x4' == 'A'`, 'SyntaxError'],
      [String.raw`'\U00110000' == 'A'`, 'SyntaxError'],
    ] as const
  )
    assert.throws(() => filterOf(text)(MESSAGE), (error) => error instanceof CommandError && error.message.startsWith(`${name}: `), text);
});

// The right sides are what CPython 3.12 makes of the left ones.
test('escapes, the order of texts and the texts of numbers are those of Python', () => {
  for (
    const text of [
      String.raw`'\x41' == 'A'`,
      String.raw`'\101' == 'A'`,
      String.raw`'\u00e9' == 'é'`,
      String.raw`len('\U0001F600') == 1`,
      String.raw`'\d' == '\\d'`,
      String.raw`'\r\a' == '\x0d\x07'`,
      String.raw`'it\'s' == "it's"`,
      String.raw`'😀' > '\uffff'`,
      "'a' < 'ab'",
      "not 'b' < 'ab'",
      "'ab' <= 'ab'",
      "str(1e16) == '1e+16'",
      "str(1e-5) == '1e-05'",
      "str(1.5e-7) == '1.5e-07'",
      "str(0.0001) == '0.0001'",
      "str(1e100) == '1e+100'",
      "str(-2.5) == '-2.5'",
      "str(123456789012345680.0) == '1.2345678901234568e+17'",
      "str(-0.0) == '-0.0'",
      '00 == 0',
    ]
  )
    assert.equal(filterOf(text)(MESSAGE), true, text);
});

test('lists of a million are reckoned with, and nothing but a CommandError comes out', () => {
  const size = 1_000_000;
  const data = Float64Array.from({ length: size }, (_, i) => i % 1000);
  const message = { data, names: Array.from({ length: size }, () => 'a'), counts: new BigInt64Array(size).fill(2n ** 62n) };
  for (
    const text of [
      'max(m.data) == 999',
      'min(m.data) == 0',
      `len(m.data) == ${size}`,
      'sum(m.data) == 499500000',
      'not all(m.data)',
      'any(m.data)',
      '1e9 not in m.data',
      'm.data[-1] == 999',
      "max(m.names) == 'a'",
      `sum(m.counts) == 4611686018427387904 * ${size}`,
      'm.data == m.data',
      'max(m.counts) == 4611686018427387904',
    ]
  )
    assert.equal(filterOf(text)(message), true, text);
  const broken = {
    get data(): never {
      throw new RangeError('out of memory');
    },
  };
  assert.throws(() => filterOf('m.data')(broken), (error) => error instanceof CommandError && error.message === 'RangeError: out of memory');
});

test('expressions and texts that are made to take long end soon', () => {
  const began = performance.now();
  for (const text of [`1${'**1'.repeat(20_000)}`, `1${' if 1 else 1'.repeat(20_000)}`, `${'('.repeat(20_000)}1`, `1${' + 1'.repeat(200_000)}`])
    assert.throws(() => filterOf(text)({}), CommandError, text.slice(0, 20));
  const digits = '7'.repeat(100_000);
  for (
    const [text, data, pattern] of [
      ['float(m.data)', `${digits}x`, /^ValueError: could not convert/],
      ['int(m.data)', digits, /^ValueError: Exceeds the limit \(4300 digits\)/],
      ['int(m.data, 16)', digits.repeat(10), /^MemoryError/],
    ] as const
  )
    assert.throws(() => filterOf(text)({ data }), (error) => error instanceof CommandError && pattern.test(error.message), text);
  assert.equal(filterOf('float(m.data) > 0 and int(m.data) > 0')({ data: '7'.repeat(300) }), true);
  assert.equal(filterOf("float('1_0.5e1') == 105 and float('.5') == 0.5 and float('5.') == 5")({}), true);
  assert.ok(performance.now() - began < 10_000);
});
