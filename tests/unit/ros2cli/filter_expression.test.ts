// What `--filter` of ros2 topic echo and hz takes: Python's expressions over m, and how they fail.

// Compatibility, differs: `--filter EXPR` of `ros2 topic echo` and `ros2 topic hz` -> the expressions of Python that are made of fields,
// indices, numbers, texts, comparisons, arithmetic, `and`, `or`, `not`, `in`, `x if c else y`, `abs`, `all`, `any`, `bool`, `float`,
// `int`, `len`, `max`, `min`, `round`, `str`, `sum` and five methods of texts; what else Python has is refused

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { filterOf } from '../../../runtime/ros2cli/filter_expression.ts';

const kMessage = {
  data: 'Hello World: 12', count: 12, big: 2n ** 62n, on: true, empty: '', ranges: Float32Array.of(0.5, 2, Number.POSITIVE_INFINITY),
  names: ['left', 'right'], none: [], pose: { position: { x: 1.5, y: -2 } },
};

test('expressions are true where Python says so', () => {
  for (const [text, expected] of [
    ['m.count == 12', true], ['m.count > 12', false], ['m.count % 5 == 2', true], ['-7 // 2 == -4', true], ['-7 % 3 == 2', true],
    ["'World' in m.data", true], ["'x' not in m.data", true], ['"Hello World: 12" == m.data', true], ["m.data.startswith('Hello')", true],
    ["m.data.lower().endswith('12')", true], ['m.on', true], ['not m.on', false], ['not not m.on', true], ['m.on == 1', true], ['m.empty', false],
    ['m.none', false], ['len(m.none) == 0 and len(m.names) == 2', true], ['m.pose.position.x > 1 and m.pose.position.y < 0', true],
    ['1 < m.pose.position.x < 2', true], ['1 < m.pose.position.x < 1.2', false], ['m.ranges[0] < 1 or m.ranges[99] < 1', true],
    ['m.ranges[-1] > 1e9', true], ['min(m.ranges) == 0.5', true], ['max(1, 3, 2) == 3', true], ["m.names[1] == 'right'", true],
    ["'left' in m.names", true], ['m.count in [1, 12]', true], ['abs(m.pose.position.y) == 2', true], ['2 ** 3 ** 2 == 512', true],
    ['-2 ** 2 == -4', true], ['(1 + 2) * 3 == 9', true], ["int(m.data[-2] + m.data[-1]) == 12", true], ['m.big > 4e18', true],
    ['m.big == m.big', true], ["m.count if m.on else 0", true], ["'no' if not m.on else ''", false], ['m.count is not None', true],
    ['round(2.4) == 2 and str(True) == "True"', true], ['True and False or True', true], ['sum([1, 2]) == 3 and any([0, 1]) and not all([0, 1])', true],
  ] as const)
    assert.equal(filterOf(text)(kMessage), expected, text);
});

test('what Python refuses is refused, with its name', () => {
  for (const [text, pattern] of [
    ['m.count ==', /^SyntaxError: unexpected end/], ['m.count = 1', /^SyntaxError: invalid syntax/], ['1 2', /^SyntaxError: invalid syntax at '2'/],
    ['', /^SyntaxError/], ['x > 1', /^NameError: name 'x' is not defined/], ['__import__("os")', /^NameError: name '__import__'/],
    ['constructor', /^NameError/], ['m.none[', /^SyntaxError/], ['lambda: 1', /^SyntaxError/], [`${'('.repeat(500)}1`, /^SyntaxError: too many nested/],
  ] as const)
    assert.throws(() => filterOf(text), { message: pattern }, text);
  for (const [text, pattern] of [
    ['m.nothing', /^AttributeError: the message has no attribute 'nothing'/], ['m.constructor', /^AttributeError/], ['m.__proto__', /^AttributeError/],
    ['m.ranges.map(1)', /^AttributeError: a list has no method 'map'/], ['m.data.count', /^AttributeError/], ['m.ranges[3]', /^IndexError/],
    ['m.count / 0', /^ZeroDivisionError/], ["m.data > 1", /^TypeError: a str is no number/], ['len(3)', /^TypeError/], ['m.count[0]', /^TypeError/],
  ] as const)
    assert.throws(() => filterOf(text)(kMessage), { message: pattern }, text);
});
