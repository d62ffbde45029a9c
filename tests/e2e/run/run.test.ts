// `ros2wasm run` on a packed site, as CI users call it: exit codes, output, Ctrl-C; and `ros2wasm init`,
// whose workspace packs and runs at once.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { expectedLines, packExample } from '../support/example_site.ts';
import { CLI, Scratch, runCli } from '../support/served_site.ts';

const WATCHDOG = { timeout: 600_000 };
const LOG_LINE = /^\[(talker-1|listener-2)\] \[INFO\] \[\d+\.\d{9}\] \[minimal_(publisher|subscriber)\]: .+$/;

const scratch = new Scratch();
let site: string;

before(async () => {
  site = await packExample(scratch);
}, WATCHDOG);

after(() => scratch[Symbol.dispose]());

describe('run', WATCHDOG, () => {
  for (const link of ['shared', 'port']) {
    test(`ends with 0 when a line matches, on the ${link} link`, async () => {
      const args = ['run', site, '--until', "I heard: 'Hello, world! 2'", '--for', '60s'];
      const ended = await runCli([...args, '--link', link]);
      assert.equal(ended.code, 0, ended.errors);
      const lines = ended.output.trimEnd().split('\n');
      for (const line of lines) assert.match(line, LOG_LINE);
      let from = 0;
      for (const expected of expectedLines()) {
        const found = lines.findIndex((line, at) => at >= from && expected.test(line));
        assert.ok(found >= from, `${expected} is not among the lines from ${from}:\n${ended.output}`);
        from = found + 1;
      }
      assert.match(lines.at(-1) ?? '', /^\[listener-2\].*I heard: 'Hello, world! 2'$/);
    });
  }

  // Guarantee, ci: `ros2wasm run --checks` decides what the manifest states, headless, and writes it as JUnit XML
  for (const way of [['--link', 'shared'], ['--link', 'port'], ['--stepped']]) {
    test(`--checks ends with 0 when all that the manifest lists was seen, ${way.join(' ')}`, async () => {
      const junit = join(scratch.path, `checks${way.join('')}.xml`);
      const ended = await runCli(['run', site, '--junit', junit, ...way]);
      assert.equal(ended.code, 0, ended.errors);
      assert.match(ended.errors, /^\[check\] passed: \/topic: data is like \/\^Hello, world! 2\$\/ /m);
      assert.match(ended.errors, /^\[check\] passed: The listener hears the talker /m);
      assert.match(ended.errors, /^4 of 4 checks passed$/m);
      assert.match(readFileSync(junit, 'utf8'), /<testsuite name="talker_listener" tests="4" failures="0" /);
    });
  }

  test('ends with 1 when the time is over and nothing matched', async () => {
    const ended = await runCli(['run', site, '--until', 'never said', '--for', '700ms']);
    assert.equal(ended.code, 1);
  });

  test('ends with 0 when it only had to run for a time', async () => {
    assert.equal((await runCli(['run', site, '--for', '700ms'])).code, 0);
  });

  test('--json prints one object a line', async () => {
    const ended = await runCli(['--json', 'run', site, '--until', 'I heard', '--for', '60s']);
    assert.equal(ended.code, 0, ended.errors);
    const events = ended.output
      .trimEnd()
      .split('\n')
      .map((line) => JSON.parse(line) as { event: string; node?: string; met?: boolean; });
    assert.ok(events.some(({ event, node }) => event === 'line' && node === 'listener-2'));
    assert.deepEqual(events.at(-1), { event: 'end', met: true });
  });

  for (const signal of ['SIGINT', 'SIGTERM'] as const) {
    test(`${signal} reaches the nodes and ends it with 130`, async () => {
      const child = spawn(CLI, ['run', site], { stdio: ['ignore', 'pipe', 'inherit'] });
      const code = await new Promise<number | null>((resolve, reject) => {
        let output = '';
        child.stdout.on('data', (chunk: Buffer) => {
          const heard = output.includes('I heard');
          output += chunk.toString();
          if (!heard && output.includes('I heard')) child.kill(signal);
        });
        child.on('error', reject);
        child.on('close', resolve);
      });
      assert.equal(code, 130);
    });
  }
});

describe('init', WATCHDOG, () => {
  const templates = {
    cpp: '\\[listener\\]: I heard',
    python: '\\[listener\\]: I heard',
    mixed: '\\[monitor\\]: 0\\.\\d+ is above 0\\.5',
    course: '\\[odometer\\]: the turtle went 2\\.\\d units',
    // In theory 400: the mean of 2000 walkers strays from that by 9 or so.
    paper: '\\[walk\\]: after 400 steps the mean squared distance is (3[6-9]|4[0-3])\\d\\.\\d\\d',
  };
  for (const [template, seen] of Object.entries(templates)) {
    test(`a new workspace of template ${template} packs, runs at once and passes its checks`, async () => {
      const folder = join(scratch.path, `my_${template}`);
      assert.equal((await runCli(['init', template, folder])).code, 0);
      const out = join(scratch.path, `${template}_site`);
      const packed = await runCli(['pack', folder, '-o', out]);
      assert.equal(packed.code, 0, packed.errors);
      // The paper's author is left to be filled in, which is all there is to say.
      assert.deepEqual(packed.errors.match(/R2W\d+/g) ?? [], template === 'paper' ? ['R2W0125'] : []);
      const ended = await runCli(['run', out, '--until', seen, '--for', '120s']);
      assert.equal(ended.code, 0, `${ended.output}${ended.errors}`);
      const checked = await runCli(['run', out, '--checks', '--stepped']);
      assert.equal(checked.code, 0, `${checked.output}${checked.errors}`);
      assert.match(checked.errors, /^\[check\] passed: /m);
    });
  }

  test('the manifest for a colcon workspace packs as it is', async () => {
    const folder = join(scratch.path, 'colcon');
    assert.equal((await runCli(['init', 'cpp', folder])).code, 0);
    const manifest = join(scratch.path, 'colcon.yaml');
    const made = await runCli(['init', '--from', folder, '-o', manifest]);
    assert.equal(made.code, 0, made.errors);
    const packed = await runCli(['pack', manifest, '--plan']);
    assert.equal(packed.code, 0, packed.errors);
    assert.match(packed.output, /programs\/pubsub\/talker\.wasm/);
    assert.match(packed.output, /programs\/pubsub\/listener\.wasm/);
  });
});
