// Where `ros2wasm pack` writes: disks that are full or read-only, a folder that is not a site, Ctrl-C at every step. The
// old site is untouched each time, and nothing is left beside it.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { chmodSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { CLI, type Finished, PackWorkspace, finished } from '../support/pack_workspace.ts';

let ws: PackWorkspace;
let old: Map<string, string>;

before(async () => {
  ws = new PackWorkspace();
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  ws.write('out/README', 'a neighbour of the site');
  const packed = await ws.run(['pack', '-o', 'out/site']);
  assert.equal(packed.code, 0, packed.stderr);
  // Every later site differs from the old one.
  ws.write('workspace.yaml', 'schema: 1\nname: another\npackages: [src/*]\nlaunch:\n  - {package: quick, executable: hello}\n');
  old = ws.files('out/site');
});

after(() => ws.close());

/** Runs the program through a command that takes it as its last arguments. */
function through(command: readonly string[], args: readonly string[], environment: Readonly<Record<string, string>> = {}): Promise<Finished> {
  const [name = '', ...rest] = command;
  return finished(spawn(name, [...rest, CLI, ...args], {
    cwd: ws.root,
    env: { ...process.env, XDG_CACHE_HOME: join(ws.root, 'cache'), ...environment },
    stdio: ['ignore', 'pipe', 'pipe'],
  }));
}

function expectUntouched(): void {
  assert.deepEqual(ws.files('out/site'), old);
  assert.deepEqual(readdirSync(join(ws.root, 'out')).sort(), ['README', 'site'], 'nothing is left beside the site');
}

/** Files may not grow beyond this, as on a disk that becomes full. */
function limited(kilobytes: number): readonly string[] {
  return ['bash', '-c', `ulimit -f ${kilobytes}; exec "$@"`, 'limited'];
}

/** Root may write everywhere, unless it gives this up. */
const unprivileged = process.getuid?.() === 0 ? ['setpriv', '--bounding-set', '-dac_override'] : ['env'];

// Guarantee, robust: a disk that becomes full: a clear error, and the old site stays
test('a disk that becomes full while the site is written', async () => {
  const packed = await through(limited(16), ['pack', '-o', 'out/site']);
  assert.equal(packed.code, 3, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0211\]: cannot write `.*out\/\.site-new-\w+\/[\w.]+`\n {3}= why: File too large/);
  expectUntouched();
});

test('a disk that becomes full while packages are fetched leaves nothing that could be taken for whole', async () => {
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' }, { depends: ['std_msgs'] });
  const packed = await through(limited(16), ['pack', '-o', 'out/site'], { XDG_CACHE_HOME: join(ws.root, 'full_cache') });
  assert.equal(packed.code, 3, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0211\]: cannot write `.*full_cache.*`\n {3}= why: File too large/);
  expectUntouched();
  assert.deepEqual(readdirSync(join(ws.root, 'full_cache/ros2wasm/environments')).filter((name) => name !== 'unfinished'), []);
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
});

// Guarantee, robust: a place that may only be read: a clear error, and the old site stays
for (const [what, folder] of [['the folder beside the site', 'out'], ['the whole place', 'out/site']] as const) {
  test(`read-only: ${what}`, async () => {
    chmodSync(join(ws.root, folder), 0o555);
    chmodSync(join(ws.root, 'out'), 0o555);
    try {
      const packed = await through(unprivileged, ['pack', '-o', 'out/site']);
      assert.equal(packed.code, 3, packed.stderr);
      assert.match(packed.stderr, /error\[R2W0211\]: cannot write `.*out`\n {3}= why: Permission denied/);
      expectUntouched();
    } finally {
      chmodSync(join(ws.root, 'out'), 0o755);
      chmodSync(join(ws.root, folder), 0o755);
    }
  });
}

// Guarantee, robust: a folder that is not a site is never replaced
test('a folder that is not a site of ours', async () => {
  const packed = await ws.run(['pack', '-o', 'out']);
  assert.equal(packed.code, 1, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0601\]: `out` exists and is not a site made by ros2wasm/);
  expectUntouched();
});

// Guarantee, robust: Ctrl-C at every step: the old site, or the new one, whole
test('Ctrl-C at every step: the old site, or the new one, whole', async () => {
  const told = await ws.run(['pack', '--json', '-o', 'elsewhere']);
  assert.equal(told.code, 0, told.stderr);
  const fresh = ws.files('elsewhere');
  const steps = new Set(Array.from(told.stderr.matchAll(/"event":"progress","step":"(\w+)"/g), ([, step]) => step));
  for (const step of ['solve', 'index', 'build', 'plan', 'emit']) assert.ok(steps.has(step), `a step ${step}`);
  let interrupted = 0;
  for (const step of steps) {
    const child = ws.start(['pack', '--json', '-o', 'out/site']);
    let seen = '';
    let sent = false;
    child.stderr?.on('data', (text: Buffer) => {
      seen += String(text);
      if (!sent && seen.includes(`"step":"${step}"`)) sent = child.kill('SIGINT');
    });
    const { code, stderr } = await finished(child);
    if (code === 0) {
      // The signal came when all was done.
      assert.deepEqual(ws.files('out/site'), fresh, `after ${step}`);
      assert.equal((await ws.run(['pack', '-o', 'out/site'])).code, 0);
      old = ws.files('out/site');
      continue;
    }
    interrupted += 1;
    assert.equal(code, 130, stderr);
    assert.match(stderr, /R2W0903/);
    expectUntouched();
  }
  assert.ok(interrupted > 0, 'the signal came in time at least once');
});
