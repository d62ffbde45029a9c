// Clock and calendar functions of programs with threads.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { civilTime, formatTime, timeImports } from '../../../runtime/site/program/env_time.ts';
import { SiteClock } from '../../../runtime/site/bus/clock.ts';
import { ProgramMemory } from '../../../runtime/site/program/program_memory.ts';

const leapDay = Date.UTC(2024, 1, 29, 13, 5, 9) / 1000;

test('civil time is UTC and knows leap days', () => {
  assert.deepEqual(civilTime(leapDay), { sec: 9, min: 5, hour: 13, mday: 29, mon: 1, year: 124, wday: 4, yday: 59 });
  assert.deepEqual(civilTime(-1).year, 69);
});

test('strftime writes what C writes', () => {
  const time = civilTime(leapDay);
  assert.equal(formatTime('%c|%F %T|%D|%j|%I:%M %p|%u%w|%U %W|%%|%e', time),
    'Thu Feb 29 13:05:09 2024|2024-02-29 13:05:09|02/29/24|060|01:05 PM|44|08 09|%|29');
  assert.equal(formatTime('%s %Q', time), `${leapDay} %Q`);
});

test("the functions work on a program's memory", () => {
  const memory = new ProgramMemory(new WebAssembly.Memory({ initial: 1 }));
  const imports = timeImports(() => memory, new SiteClock()) as Record<string, (...args: number[]) => number>;
  memory.set(8, leapDay);
  imports['_localtime_js']?.(8, 64);
  assert.equal(memory.u32(64 + 20), 124);
  memory.u8.set(new TextEncoder().encode('%H:%M'), 256);
  assert.equal(imports['strftime']?.(512, 6, 256, 64), 5);
  assert.equal(memory.cString(512), '13:05');
  assert.equal(imports['strftime']?.(512, 5, 256, 64), 0, 'no room for the end');
  assert.equal(imports['_mktime_js']?.(64), leapDay);
  assert.equal(imports['clock_gettime']?.(0, 16), 0);
  assert.ok(Math.abs(memory.u32(16) - Date.now() / 1000) < 100);
  assert.ok(memory.u32(20) < 1e9);
});
