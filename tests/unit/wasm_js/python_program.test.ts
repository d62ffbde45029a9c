// How a Python program's end reads when Python itself could not go on.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { failure } from '../../../runtime/wasm_js/python_program.ts';

function deeper(): number {
  return 1 + deeper();
}

test('a full stack is not taken for a lack of memory', () => {
  let caught: unknown;
  try {
    deeper();
  } catch (error) {
    caught = error;
  }
  assert.deepEqual(failure(caught), { kind: 'crash', code: 'R2W0701', message: 'the stack is full: too deep a recursion?' });
  assert.equal((failure(new RangeError('could not allocate memory')) as { code: string }).code, 'R2W0710');
  assert.deepEqual(failure('gone'), { kind: 'crash', code: 'R2W0701', message: 'gone' });
});
