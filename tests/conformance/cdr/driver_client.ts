// Sends requests to the conformance driver and reads its answers; see driver.cpp for the form.
import { spawnSync } from 'node:child_process';
import { closeSync, openSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export interface DriverType {
  readonly name: string;
  readonly hash: string;
}

export interface Request {
  readonly operation: 'l' | 'f' | 'd' | 'h';
  readonly type: number;
  readonly bytes: Uint8Array;
}

export interface Answer {
  readonly json: unknown;
  readonly bytes: Uint8Array;
}

export function seedBytes(seed: number): Uint8Array {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setUint32(0, seed, true);
  return bytes;
}

function encode(requests: readonly Request[]): Buffer {
  return Buffer.concat(
    requests.flatMap(({ operation, type, bytes }) => {
      const head = Buffer.alloc(9);
      head.write(operation, 0, 'latin1');
      head.writeUInt32LE(type, 1);
      head.writeUInt32LE(bytes.length, 5);
      return [head, bytes];
    }),
  );
}

function decode(data: Buffer): Answer[] {
  const answers: Answer[] = [];
  let at = 0;
  const part = (): Buffer => {
    const size = data.readUInt32LE(at);
    at += 4 + size;
    return data.subarray(at - size, at);
  };
  while (at < data.length) {
    const json: unknown = JSON.parse(part().toString('utf8'));
    answers.push({ json, bytes: Uint8Array.from(part()) });
  }
  return answers;
}

/** A driver program: a .wasm file, run in Node.js, or a native one. */
export class Driver {
  readonly #command: readonly string[];
  readonly #scratch: string;

  constructor(program: string) {
    const runner = join(dirname(fileURLToPath(import.meta.url)), 'wasi_main.ts');
    this.#command = program.endsWith('.wasm')
      ? [process.execPath, '--no-warnings', runner, program]
      : [program];
    this.#scratch = `${program}.${process.pid}`;
  }

  /** Answers come in the order of the requests. Throws with the driver's words when it stops. */
  ask(requests: readonly Request[]): Answer[] {
    const input = `${this.#scratch}.in`;
    const output = `${this.#scratch}.out`;
    writeFileSync(input, encode(requests));
    const [stdin, stdout] = [openSync(input, 'r'), openSync(output, 'w')];
    const [program = '', ...rest] = this.#command;
    const done = spawnSync(program, rest, { stdio: [stdin, stdout, 'pipe'], encoding: 'utf8' });
    closeSync(stdin);
    closeSync(stdout);
    if (done.status !== 0) throw new Error(`driver ended with ${done.status ?? done.signal}: ${done.stderr}`);
    const answers = decode(readFileSync(output));
    if (answers.length !== requests.length) throw new Error('an answer is missing');
    return answers;
  }

  types(): DriverType[] {
    const [answer] = this.ask([{ operation: 'l', type: 0, bytes: new Uint8Array() }]);
    return answer?.json as DriverType[];
  }
}
