// The events that poll_oneoff returns, and the effect of a stop on a wait for standard input.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { WaitResult } from '../../../runtime/protocol/generated/constants.ts';
import { SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { SiteClock } from '../../../runtime/site/bus/clock.ts';
import { ProgramMemory } from '../../../runtime/site/program/program_memory.ts';
import { SharedLink } from '../../../runtime/site/bus/shared_link.ts';
import { inputReader } from '../../../runtime/site/program/standard_input.ts';
import { type Arrival, wasiImports } from '../../../runtime/site/program/wasi.ts';

const kinds = { clock: 0, read: 1, write: 2 } as const;
type Kind = keyof typeof kinds;
const success = 0;
const output = 1024;
const done = 2048;

/** The kinds of the events that poll_oneoff returns for the kinds in `asked`. */
async function told(asked: readonly Kind[], arrival: Arrival, slept: WaitResult, later: boolean): Promise<Kind[]> {
  const memory = new ProgramMemory(new WebAssembly.Memory({ initial: 1 }));
  asked.forEach((kind, i) => {
    memory.set(48 * i, 100 + i);
    memory.u8[48 * i + 8] = kinds[kind];
    memory.set(48 * i + 16, kind === 'read' ? 0 : 1);
    if (kind === 'clock') memory.setI64(48 * i + 24, 1_000_000n);
  });
  const wasi = wasiImports({
    memory: () => memory,
    arguments: [],
    environment: {},
    clock: new SiteClock(),
    random: () => undefined,
    write: () => undefined,
    leave: () => assert.fail(),
    input: { read: () => assert.fail(), arrives: () => later ? Promise.resolve(arrival) : arrival },
    files: () => ({}),
    sleep: () => later ? Promise.resolve(slept) : slept,
  });
  const poll = wasi['poll_oneoff'] as (...args: readonly number[]) => number | Promise<number>;
  assert.equal(await poll(0, output, asked.length, done), success);
  return Array.from({ length: memory.u32(done) }, (_, i) => {
    const kind = asked[memory.u32(output + 32 * i) - 100];
    assert.ok(kind !== undefined);
    assert.equal(memory.u8[output + 32 * i + 10], kinds[kind]);
    return kind;
  });
}

test('poll_oneoff tells what came, the time when it is over, and nothing at a stop', async () => {
  const { woken, stop } = WaitResult;
  for (const later of [false, true]) {
    assert.deepEqual(await told(['read', 'clock'], 'input', woken, later), ['read']);
    assert.deepEqual(await told(['read', 'clock'], 'timeout', woken, later), ['clock']);
    assert.deepEqual(await told(['read', 'clock'], 'stop', woken, later), []);
    assert.deepEqual(await told(['read'], 'stop', woken, later), []);
    assert.deepEqual(await told(['read', 'write'], 'timeout', woken, later), ['write']);
    assert.deepEqual(await told(['clock'], 'input', woken, later), ['clock']);
    assert.deepEqual(await told(['clock'], 'input', stop, later), []);
  }
});

test('a wait for input says whether its time is over or a stop came', () => {
  const broker = new SharedBroker({ ceiling: 64 << 20 });
  const participant = broker.bus.claimParticipant();
  const input = inputReader(new SharedLink({ bus: broker.bus, participant, mayBlock: true }), 'n');
  assert.equal(input.arrives(0), 'timeout');
  broker.bus.requestStop(participant);
  assert.equal(input.arrives(60_000), 'stop');
  assert.equal(input.arrives(0), 'timeout', 'a stop is told once');
});
