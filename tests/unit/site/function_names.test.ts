// Names in crash reports: which functions a report asks for, how their names read, and what damaged names do.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { functionNames, functionsIn, withNames } from '../../../runtime/site/program/function_names.ts';

const report = 'unreachable\n  at (wasm-function[200]:0x1a)\n  at (wasm-function[3]:0xff)\n  at main (0x1)';

function leb(value: number): number[] {
  return value < 128 ? [value] : [(value & 127) | 128, ...leb(value >>> 7)];
}

function sized(bytes: readonly number[]): number[] {
  return [...leb(bytes.length), ...bytes];
}

const text = (value: string): number[] => sized([...new TextEncoder().encode(value)]);

/** A name section: a module name, then the functions. */
function section(functions: readonly (readonly [number, string])[]): number[] {
  const names = functions.flatMap(([index, name]) => [...leb(index), ...text(name)]);
  return [0, ...sized(text('program')), 1, ...sized([...leb(functions.length), ...names])];
}

function moduleOf(contents: readonly number[]): Uint8Array<ArrayBuffer> {
  return new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 0, ...sized([...text('name'), ...contents])]);
}

test('a report tells the numbers of its functions', () => {
  assert.deepEqual([...functionsIn(report)], [200, 3]);
  assert.equal(functionsIn('divide by zero').size, 0);
});

test('only what is wanted gets a name, in the words of C++', () => {
  const string = 'std::__2::basic_string<char, std::__2::char_traits<char>, std::__2::allocator<char> >';
  const bytes = new Uint8Array(section([[0, 'main'], [3, `tell(${string} const&)`], [200, 'x'.repeat(5000)]]));
  const names = functionNames(bytes, new Set([3, 200]));
  assert.deepEqual([...names.keys()], [3, 200]);
  assert.equal(names.get(3), 'tell(std::string const&)');
  assert.equal(names.get(200)?.length, 160);
});

test('numbers become names where there are any', async () => {
  assert.equal(await withNames(report, moduleOf(section([[3, 'outer()']]))),
    'unreachable\n  at (wasm-function[200]:0x1a)\n  at outer() (0xff)\n  at main (0x1)');
});

test('damaged names leave the report as it was', async () => {
  const whole = moduleOf(section([[3, 'outer()']]));
  for (const bytes of [new Uint8Array(), whole.slice(0, 8), moduleOf([1, 200, 1, 255, 255, 255, 255, 15, 3, 90])]) {
    assert.equal(await withNames(report, bytes), report);
  }
  for (let length = 0; length < whole.length; length += 1) {
    assert.equal(typeof await withNames(report, whole.slice(0, length)), 'string');
  }
});
