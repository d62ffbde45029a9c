import assert from 'node:assert/strict';
import { test } from 'node:test';
import { keyText } from '../../../runtime/site/ui/model/terminal_keys.ts';

const plain = { ctrlKey: false, altKey: false, metaKey: false };

test('keys that are no text are what a terminal sends for them; text, Tab and shortcuts are left to the page', () => {
  const sent = (key: string, held: Partial<typeof plain> = {}): string | undefined => keyText({ key, ...plain, ...held });
  assert.deepEqual(['Enter', 'ArrowLeft', 'Delete', 'Escape'].map((key) => sent(key)), ['\n', '\u001b[D', '\u001b[3~', '\u001b']);
  assert.deepEqual(['a', ' ', 'Tab', 'Shift', 'F5'].map((key) => sent(key)), Array(5).fill(undefined));
  assert.deepEqual([sent('c', { ctrlKey: true }), sent('D', { ctrlKey: true }), sent('1', { ctrlKey: true })], ['\u0003', '\u0004', undefined]);
  assert.equal(sent('ArrowLeft', { altKey: true }), undefined);
  assert.equal(sent('c', { ctrlKey: true, metaKey: true }), undefined);
});
