// Which files of a Python program are handed over, when, and how often.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { mostFileBytes, OutputGate } from '../../../runtime/site/program/output_gate.ts';
import { type WatchedSystem, watchOutput } from '../../../runtime/site/python/python_output.ts';
import { WrittenFiles } from '../../../runtime/site/program/written_files.ts';

function world() {
  const sizes = new Map<string, number>();
  const said: string[] = [];
  const time = { ms: 0 };
  const size = (path: string): number => {
    const found = sizes.get(path);
    if (found === undefined) throw new Error('no such file');
    return found;
  };
  const system: WatchedSystem = {
    trackingDelegate: {},
    stat: (path) => ({ size: size(path) }),
    readFile: (path) => new Uint8Array(size(path)),
  };
  const gate = new OutputGate({ home: '/home/user/', now: () => time.ms, refused: (path) => said.push(`${path} refused`) });
  const { rest } = watchOutput(system, gate, (path, bytes) => said.push(`${path} ${bytes.length}`));
  const write = (path: string, bytes: number): void => {
    sizes.set(path, bytes);
    system.trackingDelegate.onWriteToFile?.(path);
    system.trackingDelegate.onCloseFile?.(path);
  };
  return { system, sizes, said, time, rest, write };
}

test('a file that is closed often is handed over once a second, and at the end', () => {
  const { said, time, rest, write } = world();
  for (let i = 1; i <= 5; i += 1) {
    write('/home/user/log.csv', i);
    time.ms += 400;
  }
  assert.deepEqual(said, ['/home/user/log.csv 1', '/home/user/log.csv 4']);
  rest();
  rest();
  assert.deepEqual(said.slice(2), ['/home/user/log.csv 5']);
});

test('files elsewhere, hidden ones, bags and those that were only read are not handed over', () => {
  const { system, said, rest, write } = world();
  for (const path of ['/tmp/a', '/home/user2/a', '/home/user/.a', '/home/user/b/.c/d', '/home/user/x.mcap']) write(path, 1);
  system.trackingDelegate.onCloseFile?.('/home/user/read');
  rest();
  assert.deepEqual(said, []);
});

test('a large file is refused once; one that is gone is nothing, and one that was moved is what it is now', () => {
  const { system, sizes, said, time, rest, write } = world();
  write('/home/user/large', mostFileBytes + 1);
  time.ms = 5000;
  write('/home/user/large', mostFileBytes + 2);
  system.trackingDelegate.onWriteToFile?.('/home/user/gone');
  system.trackingDelegate.willDeletePath?.('/home/user/gone');
  sizes.set('/home/user/new', 3);
  system.trackingDelegate.onWriteToFile?.('/home/user/old');
  system.trackingDelegate.onMovePath?.('/home/user/old', '/home/user/new');
  rest();
  assert.deepEqual(said, ['/home/user/large refused', '/home/user/new 3']);
});

test('of a file that nobody has taken the newest is kept, and each bag', () => {
  const files = new WrittenFiles(10);
  const add = (path: string, size: number): void => files.add({ node: 'a', path, content: new Blob([new Uint8Array(size)]) });
  for (const size of [8, 9]) add('/home/user/log.csv', size);
  for (const size of [0, 1]) add('/home/user/x.mcap', size);
  assert.deepEqual(files.take().map(({ path, content }) => `${path} ${content.size}`), ['/home/user/log.csv 9', '/home/user/x.mcap 0', '/home/user/x.mcap 1']);
});
