// The generated C++ type support and the npm packages agree on the bytes of every interface, in both
// directions; and no damaged buffer harms the C++ code.

// Compatibility, works: all 692 interface definitions, CDR as on the wire of ROS 2, type hashes
// (RIHS01)

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { MessageReader, MessageWriter } from '@foxglove/rosmsg2-serialization';

import { REPOSITORY, interfaceFiles } from '../interfaces/interface_files.ts';
import { Driver, seedBytes } from './driver_client.ts';
import type { DriverType, Request } from './driver_client.ts';
import { definitionsFor, schemasOf } from './schemas.ts';
import { Random, encode, plain, randomMessage } from './values.ts';

const BUILD = process.env['ROS2WASM_BUILD'] ?? join(REPOSITORY, 'build');
const WORK = process.env['ROS2WASM_CHANNEL_WORK'] ?? join(BUILD, 'channel-work');
const OUT = join(BUILD, 'conformance-cdr');
const ROUNDS = 3;

/** The tree of one compiler: the one that was used last would do as well, there is mostly one. */
function workshop(): string {
  const [first] = readdirSync(WORK).filter((name) => existsSync(join(WORK, name, 'prefix'))).sort();
  assert.ok(first !== undefined, `no channel was built in ${WORK}`);
  return join(WORK, first);
}

const HERE = dirname(fileURLToPath(import.meta.url));
const files = [...interfaceFiles(), ...interfaceFiles(HERE, ['edge_interfaces'])];
const schemas = schemasOf(files);
// A type with a wstring inside is compared with the encoder of ros2wasm only: the npm packages refuse it.
const hasWideText = (type: string): boolean => definitionsFor(schemas, type).some((one) => one.definitions.some((field) => field.type === 'wstring'));

let wasm: Driver;
let native: Driver;
let types: DriverType[] = [];

before(() => {
  const script = join(HERE, 'make_driver.py');
  const made = spawnSync('python3', [script, '--work', workshop(), '--out', OUT], { encoding: 'utf8' });
  assert.equal(made.status, 0, made.stderr);
  wasm = new Driver(join(OUT, 'driver.wasm'));
  native = new Driver(join(OUT, 'driver'));
  types = wasm.types();
});

describe('CDR', () => {
  test('every message and every part of a service or action has type support', () => {
    assert.deepEqual(types.map((type) => type.name), [...schemas.keys()].sort());
    assert.deepEqual(native.types(), types);
    for (const type of types) assert.match(type.hash, /^RIHS01_[0-9a-f]{64}$/);
  });

  test('what C++ writes, others read and write again', () => {
    const answers = wasm.ask(
      types.flatMap((_, index) =>
        Array.from({ length: ROUNDS }, (__, round) => ({
          operation: 'f' as const,
          type: index,
          bytes: seedBytes(index * 100 + round),
        }))
      ),
    );
    answers.forEach((answer, at) => {
      const type = types[Math.floor(at / ROUNDS)]?.name ?? '';
      const value = answer.json as Parameters<typeof encode>[2];
      assert.deepEqual(encode(schemas, type, value, true), answer.bytes, type);
      if (hasWideText(type)) return;
      const definitions = definitionsFor(schemas, type);
      const decoded: unknown = new MessageReader(definitions).readMessage(answer.bytes);
      assert.deepEqual(plain(schemas, type, decoded), value, type);
      assert.deepEqual(new MessageWriter(definitions).writeMessage(decoded), answer.bytes, type);
    });
  });

  for (const little of [true, false]) {
    test(`what others write ${little ? 'little' : 'big'}-endian, C++ reads and writes again`, () => {
      const sent = types.flatMap((type, index) =>
        Array.from({ length: ROUNDS }, (_, round) => {
          const value = randomMessage(schemas, type.name, new Random(index * 1000 + round));
          return { type: type.name, index, value, little: encode(schemas, type.name, value, true) };
        })
      );
      const answers = wasm.ask(
        sent.map(({ type, index, value }) => ({
          operation: 'd',
          type: index,
          bytes: encode(schemas, type, value, little),
        })),
      );
      answers.forEach((answer, at) => {
        const message = sent[at];
        assert.ok(message !== undefined);
        const { type } = message;
        if (!hasWideText(type)) {
          const theirs = new MessageWriter(definitionsFor(schemas, type)).writeMessage(message.value);
          assert.deepEqual(theirs, message.little, `${type}: the encoders of this test differ`);
        }
        assert.deepEqual(answer.json, plain(schemas, type, message.value), type);
        assert.deepEqual(answer.bytes, message.little, type);
      });
    });
  }

  test('the vectors of the specification', () => {
    const vectors: readonly (readonly [string, string, unknown])[] = [
      ['std_msgs/msg/String', '000100000f00000048656c6c6f20576f726c643a203100', { data: 'Hello World: 1' }],
      ['std_msgs/msg/String', '000100000100000000', { data: '' }],
      ['std_msgs/msg/Int32', '00010000feffffff', { data: -2 }],
      ['std_msgs/msg/Int32', '00000000fffffffe', { data: -2 }],
      ['std_msgs/msg/Int32', '0001abcdfeffffff', { data: -2 }],
    ];
    const answers = wasm.ask(
      vectors.map(([type, hex]) => ({
        operation: 'd' as const,
        type: types.findIndex((one) => one.name === type),
        bytes: Uint8Array.from(Buffer.from(hex, 'hex')),
      })),
    );
    answers.forEach((answer, at) => assert.deepEqual(answer.json, vectors[at]?.[2], vectors[at]?.[1] ?? ''));
    const twist = types.findIndex((one) => one.name === 'geometry_msgs/msg/Twist');
    const [filled] = wasm.ask([{ operation: 'f', type: twist, bytes: seedBytes(1) }]);
    assert.equal(filled?.bytes.length, 52);
  });

  test('bounds hold when reading', () => {
    const type = 'rcl_interfaces/msg/ParameterDescriptor';
    const value = randomMessage(schemas, type, new Random(5));
    const range = { from_value: 0, to_value: 1, step: 0 };
    const index = types.findIndex((one) => one.name === type);
    const answers = wasm.ask(
      [1, 2].map((count): Request => {
        const message = { ...value, floating_point_range: Array.from({ length: count }, () => range) };
        return { operation: 'd', type: index, bytes: encode(schemas, type, message, true) };
      }),
    );
    assert.notEqual(answers[0]?.json, null);
    assert.equal(answers[1]?.json, null);
  });

  for (const [kind, driver] of [['native, with address checks', () => native], ['wasm', () => wasm]] as const) {
    test(`damaged buffers: cut at every length, altered, random (${kind})`, () => {
      const answers = driver().ask(
        types.map((_, index) => ({ operation: 'h', type: index, bytes: seedBytes(index + 1) })),
      );
      const counts = answers.map((answer) => answer.json as { tried: number; accepted: number; });
      assert.ok(counts.every((one) => one.tried >= 90));
    });
  }
});
