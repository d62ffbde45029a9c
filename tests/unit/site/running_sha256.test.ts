// The hash of pieces is that of all bytes at once.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { test } from 'node:test';

import { RunningSha256 } from '../../../runtime/site/contract/running_sha256.ts';

const sha256 = (bytes: Uint8Array): string => createHash('sha256').update(bytes).digest('hex');

test('a running SHA-256 is that of all bytes so far, wherever the pieces end', () => {
  const bytes = Uint8Array.from({ length: 1000 }, (_, i) => (i * 167 + (i >> 3)) & 255);
  for (const piece of [1, 3, 55, 56, 63, 64, 65, 128, 1000]) {
    const running = new RunningSha256();
    assert.equal(running.hex(), sha256(new Uint8Array()));
    for (let at = 0; at < bytes.length; at += piece) {
      running.add(bytes.subarray(at, at + piece));
      assert.equal(running.hex(), sha256(bytes.subarray(0, at + piece)));
    }
  }
});
