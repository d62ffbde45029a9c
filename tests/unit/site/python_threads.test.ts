// When Python is interrupted so that another thread goes on, and when it must not be.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { PyCallable } from 'pyodide/ffi';
import { Interrupts, interrupt, sliceMs, sliceSignal, threadFunctions } from '../../../runtime/site/python/python_threads.ts';

type Functions = Readonly<Record<'unpark' | 'park', (ident: number) => void>> & { readonly begin_thread: (begin: PyCallable) => void; };

function program(stops = () => 0): { interrupts: Interrupts; functions: Functions; } {
  const interrupts = new Interrupts(stops, true);
  const functions = threadFunctions(interrupts, () => {
    interrupts.suspended = true;
  }, (error) => assert.fail(String(error))) as unknown as Functions;
  interrupts.setThreads(2);
  interrupts.threadRuns(false);
  return { interrupts, functions };
}

async function sliceOver(): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve, 3 * sliceMs));
}

test('a thread that has had its slice is interrupted', async () => {
  const { interrupts } = program();
  assert.equal(interrupts[0], 0);
  await sliceOver();
  assert.equal(interrupts[0], sliceSignal);
});

test("between a thread that lets another one go on, and that one, nobody is interrupted: Pyodide's own code runs then", async () => {
  const callable = { copy: () => callable, callPromising: async () => undefined, destroy: () => undefined } as unknown as PyCallable;
  for (const goOn of [(functions: Functions) => functions.unpark(1), (functions: Functions) => functions.begin_thread(callable)]) {
    const { interrupts, functions } = program();
    await sliceOver();
    // Its last act: it does not rest, it ends.
    goOn(functions);
    assert.equal(interrupts[0], 0);
    interrupts.threadRuns(true);
    await sliceOver();
    assert.equal(interrupts[0], sliceSignal);
  }
});

test('a stop is told to the main thread only', () => {
  let stops = 0;
  const { interrupts } = program(() => stops);
  stops = 1;
  assert.equal(interrupts[0], 0);
  interrupts.threadRuns(true);
  assert.equal(interrupts[0], interrupt);
});

test('a slice lasts 5 ms, and nobody who is alone or runs in steps has one', () => {
  const others = [new Interrupts(() => 0, true), new Interrupts(() => 0, false)] as const;
  others[1].setThreads(2);
  for (const one of others) one.threadRuns(true);
  const { interrupts } = program();
  const begun = performance.now();
  while (interrupts[0] === 0) {
    // It computes.
  }
  const took = performance.now() - begun;
  assert.ok(took >= 4.9, `${took} ms`);
  assert.equal(sliceMs, 5);
  assert.deepEqual(others.map((one) => one[0]), [0, 0]);
});
