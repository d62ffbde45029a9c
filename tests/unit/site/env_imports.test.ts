// Calls that no browser can answer fail, and the node's console says so once.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { SiteClock } from '../../../runtime/site/bus/clock.ts';
import { envImports } from '../../../runtime/site/program/env_imports.ts';
import { ProgramMemory } from '../../../runtime/site/program/program_memory.ts';

const unused = (): never => {
  throw new Error('not called here');
};

test('a call that is not there fails with ENOSYS and is told once, system() with its command', () => {
  const memory = new ProgramMemory(new WebAssembly.Memory({ initial: 1 }));
  memory.u8.set(new TextEncoder().encode('clear'), 64);
  const lines: string[] = [];
  const env = envImports({
    memory: () => memory,
    exports: unused,
    startThread: unused,
    leave: unused,
    farewell: () => undefined,
    threaded: false,
    clock: new SiteClock(),
    random: unused,
    program: 'lab',
    detach: unused,
    tell: (line) => lines.push(line),
  }) as Record<string, (...args: number[]) => number>;
  assert.equal(env['__syscall_socket']?.(2, 1, 0), -52);
  assert.equal(env['__syscall_socket']?.(2, 2, 0), -52);
  assert.equal(env['system']?.(64), -1);
  assert.equal(env['system']?.(0), 0, 'there is no shell');
  assert.deepEqual(lines, [
    'R2W0761: socket() failed: a browser has no such thing (ros2wasm explain R2W0761)',
    'R2W0761: system("clear") failed: a browser has no such thing (ros2wasm explain R2W0761)',
  ]);
});
