// The headless runner as a process: output, conditions, exit codes.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { rmSync } from 'node:fs';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { parseOptions } from '../../../runtime/site/session/headless_run.ts';
import { makeFolder } from './site_fixture.ts';

const script = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
const watchdog = { timeout: 240_000 };
const folders: string[] = [];

after(() => {
  for (const folder of folders) rmSync(folder, { recursive: true });
});

function site(...nodes: Parameters<typeof makeFolder>[0]): string {
  const folder = makeFolder(nodes);
  folders.push(folder);
  return folder;
}

interface Outcome {
  readonly code: number | null;
  readonly out: string;
  readonly err: string;
}

/** `onOutput` sees stdout so far and may send a signal. */
function run(args: readonly string[], onOutput?: (out: string, kill: (signal: NodeJS.Signals) => void) => void): Promise<Outcome> {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [script, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
    let out = '';
    let err = '';
    child.stdout.on('data', (bytes: Buffer) => {
      out += bytes.toString();
      onOutput?.(out, (signal) => child.kill(signal));
    });
    child.stderr.on('data', (bytes: Buffer) => {
      err += bytes.toString();
    });
    child.on('close', (code) => resolve({ code, out, err }));
  });
}

const chat = () => site({ program: 'talker.c' }, { program: 'listener.c' });

for (const link of ['shared', 'port']) {
  test(`${link}: --until ends with 0 at the line that fits`, watchdog, async () => {
    // The listener may print before the talker does: by its fifth message both have.
    const { code, out } = await run([chat(), '--until', 'listener-2.*World: ([5-9]|\\d\\d)', '--link', link]);
    assert.equal(code, 0);
    assert.match(out, /^\[talker-1\] Publishing: 'Hello World: 1' as 1$/m);
    assert.match(out.trimEnd().split('\n').at(-1) ?? '', /^\[listener-2\] I heard: \[Hello World: \d+\] after 1$/);
  });
}

test('--until that is not met in time, or by nodes that all ended, is 1', watchdog, async () => {
  assert.equal((await run([chat(), '--until', 'never', '--for', '300ms'])).code, 1);
  assert.equal((await run([site({ program: 'exits.c' }), '--until', 'never'])).code, 1);
});

test('--for alone is 0 unless a node fails', watchdog, async () => {
  assert.equal((await run([chat(), '--for', '0.5s'])).code, 0);
  const failed = await run([site({ program: 'throws.cpp' }, { program: 'listener.c' }), '--for', '6s']);
  assert.equal(failed.code, 1);
  assert.match(failed.err, /\[throws-1\] error\[R2W0702\]: .*\n {2}what\(\): {2}the wheel came off\n {2}--> workspace\.yaml:3:5/);
});

test('a reader that is slow gets all of it', watchdog, async () => {
  const folder = site({ program: 'talker.c' });
  const child = spawn(process.execPath, [script, folder, '--stepped', '--for', '400s', '--trace', `${folder}/trace`], { stdio: ['ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.on('exit', resolve));
  // Waits for its last line, on the other stream, while stdout has more to send than a pipe can hold.
  await new Promise<void>((resolve) => {
    let err = '';
    child.stderr.on('data', (bytes: Buffer) => {
      err += bytes.toString();
      if (err.includes('trace: ')) resolve();
    });
  });
  let out = '';
  for await (const bytes of child.stdout) out += String(bytes);
  assert.equal(await ended, 0);
  assert.match(out.trimEnd().split('\n').at(-1) ?? '', /^\[talker-1\] Publishing: 'Hello World: 2000\d' as \d+$/);
});

test('a reader that has enough ends it: without a fault, met where nothing was to be met', watchdog, async () => {
  const folder = site({ program: 'talker.c' });
  for (const [more, met] of [[[], 0], [['--until', 'never'], 1]] as const) {
    const child = spawn(process.execPath, [script, folder, ...more], { stdio: ['ignore', 'pipe', 'pipe'] });
    let err = '';
    child.stderr.on('data', (bytes: Buffer) => {
      err += bytes.toString();
    });
    child.stdout.once('data', () => child.stdout.destroy());
    assert.equal(await new Promise((resolve) => child.on('close', resolve)), met, err);
    assert.equal(err, '');
  }
});

test('without conditions it runs until all nodes ended', watchdog, async () => {
  assert.equal((await run([site({ program: 'exits.c' })])).code, 0);
  const died = await run([site({ program: 'exits.c', arguments: ['--code', '9'] })]);
  assert.equal(died.code, 1);
  assert.match(died.err, /\[exits-1\] process has died \[exit code 9\]/);
  // As natively, the lowest 8 bits count.
  assert.match((await run([site({ program: 'exits.c', arguments: ['--code', '-1'] })])).err, /\[exits-1\] process has died \[exit code 255\]/);
});

test('a node that still waits when the launch ends does not keep the run', watchdog, async () => {
  const waits = { event: 'exit', node: 'listener-2' };
  const { code, err } = await run([
    site({ program: 'exits.c', rules: { on_exit: 'shutdown' } }, { program: 'listener.c' }, { program: 'exits.c', rules: { start_on: waits } }),
  ]);
  assert.equal(code, 0, err);
  assert.match(err, /\[listener-2\] process has finished cleanly/);
  assert.doesNotMatch(err, /exits-3/);
});

test('Ctrl-C stops the nodes as SIGINT does, and is 130', watchdog, async () => {
  let sent = false;
  const { code, out } = await run([chat()], (text, kill) => {
    if (sent || !text.includes('I heard')) return;
    sent = true;
    kill('SIGINT');
  });
  assert.equal(code, 130);
  assert.match(out, /^\[talker-1\] talker stops$/m);
});

test('--json prints one event per line', watchdog, async () => {
  const { code, out } = await run([site({ program: 'echo.c' }), '--json', '--until', 'COLOUR']);
  assert.equal(code, 0);
  const events = out.trimEnd().split('\n').map((line) => JSON.parse(line) as Record<string, unknown>);
  assert.ok(events.some(({ event, node, state }) => event === 'node' && node === 'echo-1' && state === undefined));
  const line = events.find(({ text }) => text === 'COLOUR=red');
  assert.deepEqual([line?.['event'], line?.['node'], line?.['stream']], ['line', 'echo-1', 'stdout']);
  assert.deepEqual(events.at(-1), { event: 'end', met: true });
});

test('bad input is told with a code and a fix', watchdog, async () => {
  const none = await run(['/nowhere']);
  assert.equal(none.code, 1);
  assert.match(none.err, /^error\[R2W0706\]: .*site\.json[\s\S]*= fix: /);
  assert.equal((await run([])).code, 2);
  assert.equal((await run(['x', '--link', 'pigeon'])).code, 2);
  assert.equal((await run(['x', '--for', 'soon'])).code, 2);
});

test('times are read with their units', () => {
  assert.deepEqual(['5s', '250ms', '2m', '1.5s', '3'].map((text) => parseOptions(['x', '--for', text]).forMs), [5000, 250, 120_000, 1500, 3000]);
});
