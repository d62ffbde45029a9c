// The files of a site as a program's imports see them.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { ErrorCode } from '../../../runtime/protocol/generated/constants.ts';
import { OutputGate } from '../../../runtime/site/program/output_gate.ts';
import { ProgramMemory } from '../../../runtime/site/program/program_memory.ts';
import { fileImports } from '../../../runtime/site/program/site_files.ts';
import { placeOf, WrittenFiles } from '../../../runtime/site/program/written_files.ts';

const files = { prefix: '/opt/ros/jazzy', place: 'http://host/site/', files: [['share/demo/a.txt', 3], ['share/demo/gone.txt', 1]] } as const;

function imports(asked: string[]) {
  const memory = new ProgramMemory(new WebAssembly.Memory({ initial: 1 }));
  const answer = (place: string, path: string): Uint8Array | undefined => {
    asked.push(`${place}${path}`);
    return path.endsWith('a.txt') ? new Uint8Array([1, 2, 3]) : undefined;
  };
  const given: (readonly [string, Uint8Array])[] = [];
  const gate = new OutputGate({ home: '/home/user/', now: () => 0, refused: () => undefined });
  const { file_list: list, file_read: read, file_give: give, file_closed: closed } = fileImports(files, answer, () => memory, (...file) => given.push(file),
    gate);
  const call = (path: string, size: number): number => {
    const bytes = memory.encode(path);
    memory.u8.set(bytes, 0);
    return (read as (...args: number[]) => number)(0, bytes.length, 1000, size);
  };
  return {
    memory,
    given,
    gate,
    closed: closed as (...args: number[]) => number,
    give: give as (...args: number[]) => void,
    list: list as (buffer: number, capacity: number) => number,
    read: call,
  };
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

test('a file that a program gives away is copied', () => {
  const { memory, given, give } = imports([]);
  memory.u8.set([...memory.encode('/home/user/bag'), 1, 2, 3], 0);
  give(0, 14, 14, 3);
  memory.u8.fill(9, 0, 20);
  assert.deepEqual(given, [['/home/user/bag', new Uint8Array([1, 2, 3])]]);
});

test('a file that a program closes is taken now and then, and at the end', () => {
  const { memory, given, gate, closed } = imports([]);
  memory.u8.set([...memory.encode('/home/user/a.csv'), 1, 2, 3], 0);
  assert.equal(closed(0, 16, 16, 2), 1);
  assert.equal(closed(0, 16, 16, 3), 0);
  assert.equal(closed(1, 15, 16, 3), 1);
  gate.end();
  assert.equal(closed(0, 16, 16, 3), 1);
  assert.deepEqual(given, [['/home/user/a.csv', new Uint8Array([1, 2])], ['/home/user/a.csv', new Uint8Array([1, 2, 3])]]);
});

test('files that programs have written are kept until they are taken, and not without end', () => {
  const written = new WrittenFiles(5);
  let told = 0;
  const stop = written.onChange(() => {
    told += 1;
  });
  const add = (path: string, size: number): void => written.add({ node: 'recorder-1', path, content: new Blob([new Uint8Array(size)]) });
  const taken = (): string[] => written.take().map(({ path }) => path);
  add('a', 2);
  assert.deepEqual([taken(), taken()], [['a'], []]);
  add('b', 2);
  add('c', 2);
  add('d', 2);
  assert.deepEqual(taken(), ['c', 'd']);
  add('e', 6);
  assert.deepEqual(taken(), []);
  assert.equal(told, 5);
  stop();
  add('f', 1);
  assert.equal(told, 5);
});

test('the path that a program gives leads to its own folder', () => {
  const place = (path: string): string => placeOf({ node: 'recorder-1', path }).join('/');
  assert.equal(place('/home/user/my_bag/my_bag_0.mcap'), 'recorder-1/my_bag/my_bag_0.mcap');
  assert.equal(place('/tmp/x'), 'recorder-1/tmp/x');
  assert.equal(place('/home/user/../../etc/./x'), 'recorder-1/etc/x');
  assert.equal(place('C:\\x\n\u0000'), 'recorder-1/C__x__');
});
