// The .deb and the tarball that `./dev package` makes: the same bytes each time, and what the .deb says of itself.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { nightlyTest } from '../../support/nightly.ts';
import { CLI, finished } from '../support/pack_workspace.ts';

const watchdog = { timeout: 900_000 };
const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-package-'));
const buildTree = dirname(CLI);
const epoch = '1750000000';

async function made(name: string, zone: string): Promise<string> {
  const out = join(folder, name);
  const { code, stdout, stderr } = await finished(spawn('bash', [
    '-c',
    'umask 022 && exec cpack --config CPackConfig.cmake -B "$1"',
    'cpack',
    out,
  ], { cwd: buildTree, env: { ...process.env, SOURCE_DATE_EPOCH: epoch, TZ: zone }, stdio: ['ignore', 'pipe', 'pipe'] }));
  assert.equal(code, 0, stdout + stderr);
  rmSync(join(out, '_CPack_Packages'), { recursive: true });
  return out;
}

function output(command: string, ...args: readonly string[]): string {
  return execFileSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 26 });
}

let packages: string;
let deb: string;

before(async () => {
  packages = await made('first', 'UTC');
  const one = (ending: string): string => {
    const [name, ...more] = readdirSync(packages).filter((file) => file.endsWith(ending));
    assert.ok(name !== undefined && more.length === 0, ending);
    return join(packages, name);
  };
  deb = one('.deb');
}, watchdog);

after(() => rmSync(folder, { recursive: true, force: true }));

// Guarantee, ci: `./dev package` makes the same .deb and the same tarball again, in another time zone and later
nightlyTest('the same bytes', watchdog, async () => {
  const again = await made('second', 'Asia/Tokyo');
  assert.deepEqual(readdirSync(again), readdirSync(packages));
  for (const name of readdirSync(packages))
    assert.ok(readFileSync(join(again, name)).equals(readFileSync(join(packages, name))), name);
});

// Guarantee, ci: the .deb names every library that the program is linked with, recommends what compiles workspaces, has the
// license, and nothing in it belongs to whoever made it
test('what the .deb says of itself', watchdog, () => {
  const field = (name: string): string[] => output('dpkg-deb', '--field', deb, name).trim().split(/, */);
  const depends = field('Depends').map((one) => one.split(' ')[0]);
  const needed = [...output('objdump', '-p', CLI).matchAll(/^ +NEEDED +(\S+)$/gm)].map((match) => match[1] ?? '');
  assert.ok(needed.length > 8);
  for (const library of needed) {
    const owners = output('dpkg', '-S', `*/${library}`).split('\n').map((line) => line.split(':')[0]);
    assert.ok(owners.some((owner) => depends.includes(owner)), `${library} of ${owners.join()} is in ${depends.join()}`);
  }
  const recommends = field('Recommends');
  for (const one of ['emscripten', 'cmake', 'ninja-build', 'nodejs (>= 22.13)']) assert.ok(recommends.includes(one), one);
  const lines = output('dpkg-deb', '--contents', deb).trim().split('\n');
  assert.ok(lines.some((line) => line.endsWith(' ./usr/share/doc/ros2wasm/copyright')));
  for (const line of lines) {
    assert.match(line, /^[-dl]rw[x-]r-[x-]r-[x-] root\/root |^l/, line);
    assert.ok(!line.includes('/node_modules/') && !line.includes('/tests/'), line);
  }
  assert.deepEqual(readFileSync(resolve('LICENSE')),
    execFileSync('bash', ['-c', 'dpkg-deb --fsys-tarfile "$1" | tar -xO ./usr/share/doc/ros2wasm/copyright', 'tar', deb]));
});
