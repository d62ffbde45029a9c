// The trace of a headless run: in its file at once, with the hash that the page would tell.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { MessageTrace } from '../../../runtime/site/program/message_trace.ts';
import { TraceFile } from '../../../runtime/site/program/trace_file.ts';

const message = { name: '/chatter', sequence: '1', stamp: '1700000000000000000', bytes: 4, hash: '00ff' };

test('lines are in the file as they come, and the hash is that of the file', () => {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-trace-'));
  const path = join(folder, 'trace');
  try {
    writeFileSync(path, 'an older and longer trace, of which nothing is to be left'.repeat(20));
    const file = new TraceFile(path);
    const page = new MessageTrace();
    for (const node of ['talker-1', 'zürich-2']) {
      file.add(node, message);
      const line = page.add(node, message);
      assert.ok(readFileSync(path, 'utf8').endsWith(line));
    }
    const { messages, sha256 } = file.close();
    assert.equal(messages, 2);
    assert.equal(sha256, page.sha256());
    assert.equal(sha256, createHash('sha256').update(readFileSync(path)).digest('hex'));
  } finally {
    rmSync(folder, { recursive: true });
  }
});
