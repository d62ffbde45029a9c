// The parts of a signature beside a site that the page reads, and texts that it does not accept as a signature.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { claimedSignature } from '../../../runtime/site/ui/model/signature.ts';

function signature(id: readonly number[], comment: string, kind = 'ED'): string {
  const bytes = String.fromCharCode(...Buffer.from(kind), ...id) + 's'.repeat(64);
  return `untrusted comment: of a test\n${btoa(bytes)}\ntrusted comment: ${comment}\n${btoa('o'.repeat(64))}\n`;
}

test('the id is as minisign writes it, the comment as it stands', () => {
  const text = signature([0x14, 0x3e, 0xee, 0x20, 0xd4, 0x79, 0x44, 0x0b], 'Lab 3 <b>');
  assert.deepEqual(claimedSignature(text), { keyId: 'B4479D420EE3E14', comment: 'Lab 3 <b>' });
});

test('what was cut, is another kind, too long or holds control characters is not a signature', () => {
  const id = [1, 2, 3, 4, 5, 6, 7, 8];
  const whole = signature(id, 'ok');
  for (let length = 0; length < whole.indexOf('trusted comment: ', 30) + 17; length += 1)
    assert.equal(claimedSignature(whole.slice(0, length)), null, String(length));
  for (const text of [signature(id, 'ok', 'Ed'), signature(id, 'red \u001b[31m'), signature(id, 'x'.repeat(20_000)), '<!doctype html>\n'])
    assert.equal(claimedSignature(text), null);
});
