// The bus's own atomic accesses do what Atomics do, and threads that grow the memory see each other's pages.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { once } from 'node:events';
import { Worker } from 'node:worker_threads';
import { Bus, createBus } from '../../../runtime/site/bus/bus.ts';
import { atomicsOf } from '../../../runtime/site/bus/bus_atomics.ts';

test('each access gives what Atomics give, and wraps as they do', () => {
  const memory = new WebAssembly.Memory({ initial: 1, maximum: 2, shared: true });
  const own = atomicsOf(memory);
  assert.equal(atomicsOf(memory), own);
  const words = new Int32Array(memory.buffer);
  const peer = new Int32Array(new SharedArrayBuffer(16));
  const word = 1000;
  for (const value of [0, 1, -1, 0x7fffffff, -0x80000000, 0x80000000, 5e9, 12345]) {
    own.store(word, value);
    Atomics.store(peer, 0, value);
    assert.equal(own.load(word), Atomics.load(peer, 0));
    for (const operation of ['add', 'sub', 'or', 'exchange'] as const) {
      assert.equal(own[operation](word, value), Atomics[operation](peer, 0, value), operation);
      assert.equal(words[word], peer[0], operation);
    }
    for (const expected of [words[word] ?? 0, 17]) {
      assert.equal(own.compareExchange(word, expected, value ^ 3), Atomics.compareExchange(peer, 0, expected, value ^ 3));
      assert.equal(words[word], peer[0], 'compareExchange');
    }
  }
  assert.equal(own.size(), 1);
  memory.grow(1);
  assert.equal(own.size(), 2);
  // Out of bounds is an error, never memory of others.
  assert.throws(() => own.load(1 << 16), WebAssembly.RuntimeError);
  assert.throws(() => own.store(-1, 1), WebAssembly.RuntimeError);
});

test('pages that another thread has made the memory grow by are reached', async () => {
  const bus = createBus({ ceiling: 64 << 20 });
  const other = new Worker(`
    const { workerData, parentPort } = require('node:worker_threads');
    import(workerData.module).then(({ Bus }) => {
      const bus = new Bus(workerData.memory);
      const page = bus.allocate(4000, 7);
      bus.u8[bus.pageOffset(page + 3999) + 4095] = 99;
      parentPort.postMessage(page);
      parentPort.close();
    });
  `, { eval: true, workerData: { module: new URL('../../../runtime/site/bus/bus.ts', import.meta.url).href, memory: bus.memory } });
  const [page] = (await once(other, 'message')) as [number];
  const last = bus.pageOffset(page + 3999) + 4095;
  bus.reach(last + 1);
  assert.equal(bus.u8[last], 99);
  assert.ok(bus.usage().total > 4000);
  assert.equal(new Bus(bus.memory).u8[last], 99);
});
