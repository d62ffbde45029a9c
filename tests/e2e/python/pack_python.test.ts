// Python packages through pack and run, as their users write them: ament_python and mixed ones in one site.

import assert from 'node:assert/strict';
import { cpSync, readFileSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';

import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import type { SiteSources } from '../../../runtime/site/contract/site_sources.ts';
import { SourceFiles } from '../../../runtime/site/python/source_files.ts';
import { PackWorkspace, finished } from '../support/pack_workspace.ts';

const PACKAGES = resolve(import.meta.dirname, '../../packages');
const MANIFEST = `schema: 1
name: both
distro: jazzy
packages: [src/*]
launch:
  - {package: chatter_py, executable: count, remappings: {chatter: counted}}
  - {package: chatter_py, executable: hear, name: ears, remappings: {chatter: counted}}
  - {package: chatter_py, executable: threads}
  - {package: mixed_nodes, executable: sensor}
  - {package: mixed_nodes, executable: judge.py}
`;

interface Python {
  readonly entry: string;
  readonly archives: readonly string[];
}

interface Site {
  readonly nodes: readonly { readonly id: string; readonly kind: string; readonly python?: Python; }[];
  readonly files: readonly { readonly path: string; }[];
  readonly sources?: SiteSources;
}

let workspace: PackWorkspace;
before(async () => {
  workspace = new PackWorkspace();
  for (const name of ['chatter_py', 'mixed_nodes']) cpSync(join(PACKAGES, name), join(workspace.root, 'src', name), { recursive: true });
  workspace.write('workspace.yaml', MANIFEST);
  // Cache and site lie in a project of npm whose scripts are modules, which Pyodide's are not.
  workspace.write('package.json', '{"type": "module"}\n');
  const packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  // numpy, which package.xml forgets
  assert.match(packed.stderr, /warning\[R2W0515\]: package `mixed_nodes` uses a package .*\n --> src\/mixed_nodes\/scripts\/judge.py:3:8/);
});
after(() => workspace.close());

const site = (folder: string): Site => JSON.parse(workspace.read(`${folder}/site.json`).toString()) as Site;
const pythonFiles = (of: Site): string[] => of.files.map((file) => file.path).filter((path) => /^(python|pyodide)/.test(path));

test('entry points and scripts are programs of kind python', () => {
  assert.deepEqual(site('site').nodes.map((node) => [node.id, node.kind, node.python?.entry]), [
    ['count-1', 'python', 'lib/chatter_py/count'],
    ['hear-2', 'python', 'lib/chatter_py/hear'],
    ['threads-3', 'python', 'lib/chatter_py/threads'],
    ['sensor-4', 'cpp', undefined],
    ['judge.py-5', 'python', 'lib/mixed_nodes/judge.py'],
  ]);
  assert.deepEqual(pythonFiles(site('site')), [
    'pyodide/pyodide-lock.json',
    'pyodide/pyodide.asm.js',
    'pyodide/pyodide.asm.wasm',
    'pyodide/pyodide.js',
    'pyodide/python_stdlib.zip',
    'python/channels.zip',
    'python/numpy.zip',
    'python/workspace.zip',
    'python_worker.js',
  ]);
});

test('compiled modules come to those who import them', () => {
  const common = ['python/channels.zip', 'python/workspace.zip'];
  const archives = site('site').nodes.map((node) => node.python?.archives);
  assert.deepEqual(archives, [common, common, common, undefined, [...common, 'python/numpy.zip']]);
});

test('site.json names the sources of modules and scripts, and the page finds their text', async () => {
  const sources = readSite(site('site')).sources;
  assert.ok(sources);
  const places = new Map(sources.files.map(({ path, file }) => [path, file]));
  assert.equal(places.get('lib/python3.12/site-packages/chatter_py/count.py'), 'src/chatter_py/chatter_py/count.py');
  assert.equal(places.get('lib/mixed_nodes/judge.py'), 'src/mixed_nodes/scripts/judge.py');
  assert.equal(places.get('lib/chatter_py/count'), undefined);
  const texts = { get: () => undefined, set: () => false, onChange: () => () => undefined };
  const read = new SourceFiles(sources, texts, async () => new Blob([workspace.read(`site/${sources.archive}`)]));
  for (const { path, file } of sources.files) assert.equal(await read.packed(path), workspace.read(file).toString());
});

test('they run: entry points, scripts, messages of the package itself, share files, both languages', async () => {
  const wanted = [
    /^\[hear-2\] .*\[ears\]: heard <Python counts \d+>$/m,
    /^\[threads-3\] slept True True$/m,
    /^\[judge\.py-5\] .*\[judge\]: left: 1 of 3 above 2\.5$/m,
  ];
  const child = workspace.start(['run', 'site', '--for', '120s']);
  let said = '';
  child.stdout?.on('data', (bytes: Buffer) => {
    said += bytes.toString();
    if (!child.killed && wanted.every((line) => line.test(said))) child.kill('SIGINT');
  });
  const ran = await finished(child);
  assert.equal(ran.code, 130, `${ran.stderr}\n${ran.stdout.slice(-4000)}`);
});

test('commands of ros2 wait for nodes whose interpreter is loading', async () => {
  const info = await workspace.run(['ros2', 'site', 'topic', 'info', '/counted']);
  assert.match(info.stdout, /^Publisher count: 1\nSubscription count: 1$/m, info.stderr);
  const node = await workspace.run(['ros2', 'site', 'node', 'info', '/ears']);
  assert.match(node.stdout, /^ {2}Subscribers:\n(?: {4}.*\n)*? {4}\/counted: /m, node.stderr);
  const echo = await workspace.run(['ros2', 'site', 'topic', 'echo', '/counted', '--once']);
  assert.equal(echo.code, 0, echo.stderr);
  const called = await workspace.run(['ros2', 'site', 'service', 'call', '/ears/get_parameters', 'rcl_interfaces/srv/GetParameters',
    '{names: [use_sim_time]}']);
  assert.match(called.stdout, /bool_value=False/, called.stderr);
});

test('example 07 shows what it promises', async () => {
  const example = resolve(import.meta.dirname, '../../../examples/07_python');
  cpSync(example, join(workspace.root, 'example'), { recursive: true });
  const packed = await workspace.run(['pack', 'example/workspace.yaml', '-o', 'example_site']);
  assert.equal(packed.code, 0, packed.stderr);
  const ran = await workspace.run(['run', 'example_site', '--for', '120s', '--until', 'I heard: .* [1-9]']);
  assert.equal(ran.code, 0, ran.stderr);
  const wanted = readFileSync(join(example, 'expected.txt'), 'utf8').trimEnd().split('\n').join('\n(?:.*\n)*');
  assert.match(ran.stdout, new RegExp(wanted));
});

test('packing again runs no setup.py and gives the same bytes', async () => {
  const before = workspace.files('site');
  const again = await workspace.run(['pack']);
  assert.match(again.stderr, /nothing to build: 2 packages are as before/);
  assert.deepEqual([...workspace.files('site')], [...before]);
});

test('a site without Python nodes has nothing of Python, whatever the workspace has', async () => {
  workspace.write('compiled.yaml', MANIFEST.replace(/^ {2}- .*(chatter_py|judge).*\n/gm, ''));
  const packed = await workspace.run(['pack', 'compiled.yaml', '-o', 'compiled']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.equal(site('compiled').nodes.length, 1);
  assert.deepEqual(pythonFiles(site('compiled')), []);
  assert.equal(site('compiled').sources, undefined);
  rmSync(join(workspace.root, 'compiled'), { recursive: true });
});

test('a Python program of a package that knows no ROS runs', async () => {
  const write = (path: string, text: string): string => workspace.write(`plain/src/plain_py/${path}`, text);
  write('package.xml', `<?xml version="1.0"?>
<package format="3"><name>plain_py</name><version>0.1.0</version><description>No node</description>
<maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license>
<export><build_type>ament_python</build_type></export></package>
`);
  write('setup.py', `from setuptools import setup
setup(name='plain_py', version='0.1.0', packages=['plain_py'],
      data_files=[('share/ament_index/resource_index/packages', ['resource/plain_py']), ('share/plain_py', ['package.xml'])],
      entry_points={'console_scripts': ['shapes = plain_py.shapes:main']})
`);
  write('setup.cfg', '[develop]\nscript_dir=$base/lib/plain_py\n[install]\ninstall_scripts=$base/lib/plain_py\n');
  write('resource/plain_py', '');
  write('plain_py/__init__.py', '');
  write('plain_py/shapes.py', "def main():\n    print('no node here', sum(range(5)))\n");
  workspace.write('plain/workspace.yaml', 'schema: 1\nname: plain\npackages: [src/*]\nlaunch:\n  - {package: plain_py, executable: shapes}\n');
  const packed = await workspace.run(['pack', 'plain/workspace.yaml', '-o', 'plain_site']);
  assert.equal(packed.code, 0, packed.stderr);
  const ran = await workspace.run(['run', 'plain_site', '--for', '120s']);
  assert.equal(ran.code, 0, ran.stderr);
  assert.match(ran.stdout, /^\[shapes-1\] no node here 10$/m);
});
