// The files of a site as a program's imports see them.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { ErrorCode } from '../../../runtime/protocol/generated/constants.ts';
import { ProgramMemory } from '../../../runtime/wasm_js/program_memory.ts';
import { fileImports } from '../../../runtime/wasm_js/site_files.ts';

const files = { prefix: '/opt/ros/jazzy', place: 'http://host/site/', files: [['share/demo/a.txt', 3], ['share/demo/gone.txt', 1]] } as const;

function imports(asked: string[]) {
  const memory = new ProgramMemory(new WebAssembly.Memory({ initial: 1 }));
  const answer = (place: string, path: string): Uint8Array | undefined => {
    asked.push(`${place}${path}`);
    return path.endsWith('a.txt') ? new Uint8Array([1, 2, 3]) : undefined;
  };
  const { file_list: list, file_read: read } = fileImports(files, answer, () => memory);
  const call = (path: string, size: number): number => {
    const bytes = memory.encode(path);
    memory.u8.set(bytes, 0);
    return (read as (...args: number[]) => number)(0, bytes.length, 1000, size);
  };
  return { memory, list: list as (buffer: number, capacity: number) => number, read: call };
}

test('the list is written where it fits, else its size is told', () => {
  const { memory, list } = imports([]);
  const size = list(0, 0);
  assert.equal(memory.u32(0), 0);
  assert.equal(list(0, size), size);
  assert.equal(memory.u32(0), 2);
  assert.equal(memory.u32(4), 3);
  assert.equal(memory.text(12, memory.u32(8)), '/opt/ros/jazzy/share/demo/a.txt');
});

test('only files of the list are asked for, and only whole ones are given', () => {
  const asked: string[] = [];
  const { memory, read } = imports(asked);
  assert.equal(read('/opt/ros/jazzy/share/demo/a.txt', 3), 3);
  assert.deepEqual([...memory.slice(1000, 3)], [1, 2, 3]);
  assert.equal(read('/opt/ros/jazzy/share/demo/a.txt', 2), ErrorCode.unsupported);
  assert.equal(read('/opt/ros/jazzy/share/demo/gone.txt', 1), ErrorCode.unsupported);
  assert.deepEqual(asked, ['a.txt', 'a.txt', 'gone.txt'].map((name) => `http://host/site/share/demo/${name}`));
  assert.equal(read('/opt/ros/jazzy/share/demo/../../../site.json', 3), ErrorCode.unsupported);
  assert.equal(read('http://elsewhere/a.txt', 3), ErrorCode.unsupported);
  assert.equal(asked.length, 3);
});
