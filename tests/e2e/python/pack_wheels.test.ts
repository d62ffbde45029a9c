// Dependencies of Python nodes other than ROS packages, through pack and run: wheels that the manifest names by file and by URL,
// and `noarch: python` packages of a channel.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const MAKE_WHEEL = resolve(import.meta.dirname, '../../support/make_wheel.py');
const PROGRAM = `from importlib import metadata

import gears
import parts
import rclpy
from springs import STIFFNESS
import kinetics.arm
import dampers


def main():
    rclpy.init()
    node = rclpy.create_node('plan')
    versions = [metadata.version(name) for name in ('parts', 'Gear_Box', 'kinetics')]
    node.get_logger().info(f'{parts.double(21)} {gears.TEETH} {kinetics.arm.REACH} {STIFFNESS} {dampers.SOFT} {versions}')
    rclpy.shutdown()
`;

interface Site {
  readonly nodes: readonly { readonly python?: { readonly archives: readonly string[]; }; }[];
}

let workspace: PackWorkspace;
let server: Server;
let served = '';

function makeWheel(name: string, version: string, members: Readonly<Record<string, string>>, requires: readonly string[] = []): string {
  const words = [...requires.flatMap((one) => ['--requires', one]), ...Object.entries(members).map(([path, text]) => `${path}=${text}`)];
  return execFileSync('python3', [MAKE_WHEEL, join(workspace.root, 'wheels'), name, version, ...words], { encoding: 'utf8' }).trim();
}

/** A package as conda has it for any Python. */
async function addNoarch(name: string, files: Readonly<Record<string, string>>): Promise<void> {
  for (const [path, text] of Object.entries(files)) workspace.write(`stage/${name}/site-packages/${path}`, text);
  const metadata = { name, version: '3.1', build: '0', subdir: 'noarch', noarch: 'python', license: 'MIT', depends: ['python >=3.8'] };
  workspace.write(`stage/${name}.json`, JSON.stringify(metadata));
  const added = await workspace.run(['channel', 'add', 'mine', '--prefix', `stage/${name}`, '--metadata', `stage/${name}.json`]);
  assert.equal(added.code, 0, added.stderr);
}

function manifest(sha256: string): string {
  return `schema: 1
name: arm
channels: [./mine, embedded]
dependencies: [dampers]
packages: [src/*]
python:
  wheels:
    - file: wheels/parts-1.2-py3-none-any.whl
    - {url: ${served}/Gear_Box-2.0-py3-none-any.whl, sha256: ${sha256}}
launch:
  - {package: arm, executable: plan}
`;
}

let gearHash = '';
before(async () => {
  workspace = new PackWorkspace();
  gearHash = makeWheel('Gear_Box', '2.0', { 'gears/__init__.py': 'TEETH = 12\n' });
  makeWheel('parts', '1.2', { 'parts/__init__.py': 'from .sums import double\n', 'parts/sums.py': 'def double(x):\n    return 2 * x\n' }, ['gear-box>=2',
    'PyYAML', 'moon (>=1)', 'windows_only; sys_platform == "win32"', 'tester; extra == "test"']);
  const gears = readFileSync(join(workspace.root, 'wheels/Gear_Box-2.0-py3-none-any.whl'));
  server = createServer((_, response) => response.end(gears));
  await new Promise<void>((done) => {
    server.listen(0, '127.0.0.1', done);
  });
  served = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  const info = 'kinetics-3.1.dist-info/METADATA';
  await addNoarch('kinetics', {
    'kinetics/__init__.py': '',
    'kinetics/arm.py': 'REACH = 0.7\n',
    [info]: 'Metadata-Version: 2.1\nName: kinetics\nVersion: 3.1\n',
  });
  await addNoarch('springs', { 'springs.py': 'STIFFNESS = 40\n' });
  await addNoarch('dampers', { 'dampers.py': 'SOFT = True\n' });
  const indexed = await workspace.run(['channel', 'index', 'mine']);
  assert.equal(indexed.code, 0, indexed.stderr);
  workspace.write('src/arm/package.xml', `<package format="3">
  <name>arm</name>
  <version>1.2.3</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <depend>rclpy</depend>
  <depend>python3-kinetics</depend>
  <depend>python3-parts</depend>
  <export><build_type>ament_python</build_type></export>
</package>
`);
  workspace.write('src/arm/setup.py', `from setuptools import setup
setup(name='arm', version='1.2.3', packages=['arm'], entry_points={'console_scripts': ['plan = arm.plan:main']})
`);
  workspace.write('src/arm/setup.cfg', '[develop]\nscript_dir=$base/lib/arm\n[install]\ninstall_scripts=$base/lib/arm\n');
  workspace.write('src/arm/arm/__init__.py', '');
  workspace.write('src/arm/arm/plan.py', PROGRAM);
  workspace.write('workspace.yaml', manifest(gearHash));
});
after(() => {
  server.close();
  workspace.close();
});

test('wheels and packages for any Python are packed, and what a wheel asks for in vain is told', async () => {
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  const warnings = packed.stderr.match(/warning\[.*/g) ?? [];
  assert.deepEqual(warnings.sort(), [
    'warning[R2W0515]: package `arm` uses packages that its package.xml does not name',
    'warning[R2W0520]: the wheel of `parts` asks for `moon >=1`, which the site has not',
  ]);
  assert.match(packed.stderr, /<depend>python3-springs<\/depend><depend>python3-dampers<\/depend>/);
  const lock = workspace.read('ros2wasm.lock').toString();
  assert.match(lock, /^wheels:\n {2}- name: gear-box\n {4}version: "2.0"\n {4}url: .*\n {4}sha256: [0-9a-f]{64}\n {4}size: \d+\n {2}- name: parts\n/m);
  assert.match(lock, / {2}- name: pyyaml\n/);
  const site = JSON.parse(workspace.read('site/site.json').toString()) as Site;
  assert.deepEqual(site.nodes[0]?.python?.archives, ['python/channels.zip', 'python/wheels.zip', 'python/workspace.zip']);
});

// Compatibility, works: Python: wheels that the manifest names by file or by address (importlib.metadata knows them)
// Compatibility, works: Python: `noarch: python` packages of conda channels, by rosdep key, by module, by name
test('a node imports them, and importlib.metadata knows them', async () => {
  const ran = await workspace.run(['run', 'site', '--for', '120s', '--until', 'plan\\]: ']);
  assert.equal(ran.code, 0, ran.stderr);
  assert.match(ran.stdout, /\[plan\]: 42 12 0\.7 40 True \['1\.2', '2\.0', '3\.1'\]/);
});

test('a lock with its wheels packs to the same bytes without a network', async () => {
  const before = workspace.files('site');
  const again = await workspace.run(['pack', '--frozen', '--offline']);
  assert.equal(again.code, 0, again.stderr);
  assert.deepEqual([...workspace.files('site')], [...before]);
});

test('an import that a wheel cannot meet is told with its place', async () => {
  const old = workspace.read('wheels/parts-1.2-py3-none-any.whl');
  makeWheel('parts', '1.2', { 'parts/__init__.py': 'try:\n    import faster\nexcept ImportError:\n    pass\nfrom moon import phase\n' });
  const locked = await workspace.run(['pack', '--locked']);
  assert.match(locked.stderr, /error\[R2W0320\][^]*the wheel of `parts` is another one: it was 1\.2 with sha256/);
  const frozen = await workspace.run(['pack', '--frozen']);
  assert.match(frozen.stderr, /error\[R2W0311\]: the wheel of `parts` is another one/);
  const packed = await workspace.run(['pack', '-o', 'other']);
  assert.equal(packed.code, 1, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0518\]: no package of the site has the module `moon`\n +--> parts-1\.2-py3-none-any\.whl\/parts\/__init__\.py:5:6/);
  assert.match(packed.stderr, /`py3-none-any` can be named under `python: wheels:`/);
  assert.doesNotMatch(packed.stderr, /faster/);
  workspace.write('wheels/parts-1.2-py3-none-any.whl', '');
  const broken = await workspace.run(['check']);
  assert.match(broken.stderr, /error\[R2W0221\][^]*--> workspace\.yaml:8:13/);
  rmSync(join(workspace.root, 'wheels/parts-1.2-py3-none-any.whl'));
  const gone = await workspace.run(['check']);
  assert.match(gone.stderr, /error\[R2W0210\][^]*--> workspace\.yaml:8:13/);
  workspace.write('wheels/parts-1.2-py3-none-any.whl', old.toString('latin1'));
});

test('an address that has something else is refused', async () => {
  workspace.write('workspace.yaml', manifest('0'.repeat(64)));
  const packed = await workspace.run(['pack', '-o', 'other']);
  assert.equal(packed.code, 3, packed.stderr);
  assert.match(packed.stderr, /error\[R2W0220\]: the wheel `Gear_Box-2\.0-py3-none-any\.whl` is not the one that was asked for/);
});
