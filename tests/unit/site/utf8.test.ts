// Text from bytes: the same as TextDecoder makes of them.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { seededRandom } from '../../../runtime/site/contract/seeded_random.ts';
import { decodeUtf8 } from '../../../runtime/site/contract/utf8.ts';

const platform = new TextDecoder('utf-8', { ignoreBOM: true });

test('all sequences of up to three bytes near the borders, right and wrong ones, become what TextDecoder makes of them', () => {
  const borders = [
    0x00,
    0x41,
    0x7f,
    0x80,
    0x8f,
    0x90,
    0x9f,
    0xa0,
    0xbf,
    0xc0,
    0xc1,
    0xc2,
    0xdf,
    0xe0,
    0xe1,
    0xec,
    0xed,
    0xee,
    0xef,
    0xf0,
    0xf1,
    0xf3,
    0xf4,
    0xf5,
    0xff,
  ];
  for (const a of borders) {
    for (const b of borders) {
      for (const c of borders) {
        for (const bytes of [[a], [a, b], [a, b, c], [a, b, c, 0x80], [a, b, c, 0x41]].map((list) => new Uint8Array(list))) {
          assert.equal(decodeUtf8(bytes), platform.decode(bytes), bytes.toString());
        }
      }
    }
  }
});

test('long texts, with pairs across the borders of the pieces they are made in', () => {
  for (const before of [0, 1, 1022, 1023, 1024, 70_000]) {
    const text = `${'x'.repeat(before)}\u{1f916}é€\u{1f916}`;
    assert.equal(decodeUtf8(new TextEncoder().encode(text)), text);
  }
});

test('random bytes', () => {
  const random = seededRandom(7, 'utf8');
  const bytes = new Uint8Array(20_000);
  for (let round = 0; round < 20; round += 1) {
    random(bytes);
    assert.equal(decodeUtf8(bytes), platform.decode(bytes));
  }
});
