// Compiled Python libraries, through pack and run: wheels for the interpreter of sites, libraries by Pyodide's lock, and the
// shared libraries that they need. The distribution is made by tests/support/make_python_libraries.py; numpy in it is npm's.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };
const MAKE = resolve(import.meta.dirname, '../../support/make_python_libraries.py');
const ABI = 'cp312-cp312-pyodide_2024_0_wasm32';
const PLAN = `import gearbox
import numpy
import rclpy


def main():
    import springs
    rclpy.init()
    node = rclpy.create_node('plan')
    node.get_logger().info(f'plan says {gearbox.teeth(3)} {gearbox.LENGTH} {springs.stiffness(2)} {numpy.arange(4).sum()}')
    rclpy.spin(node)
`;
/** It needs nothing of the libraries. */
const IDLE = `import rclpy


def main():
    rclpy.init()
    node = rclpy.create_node('idle')
    node.get_logger().info('idle says nothing')
    rclpy.spin(node)
`;

interface Site {
  readonly nodes: readonly { readonly python: { readonly archives: readonly string[]; readonly libraries?: readonly string[]; }; }[];
}

let made = '';
before(() => {
  made = mkdtempSync(join(tmpdir(), 'ros2wasm-libraries-'));
  execFileSync('python3', [MAKE, made, '--numpy'], { stdio: ['ignore', 'ignore', 'inherit'] });
});
after(() => {
  rmSync(made, { recursive: true });
});

function addArm(workspace: PackWorkspace, depends: readonly string[], modules: Readonly<Record<string, string>>, setup = ''): void {
  workspace.write('src/arm/package.xml', `<package format="3">
  <name>arm</name>
  <version>1.2.3</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
${depends.map((one) => `  <depend>${one}</depend>\n`).join('')}  <export><build_type>ament_python</build_type></export>
</package>
`);
  const scripts = Object.keys(modules).map((one) => `'${one} = arm.${one}:main'`).join(', ');
  workspace.write('src/arm/setup.py', `from setuptools import setup
setup(name='arm', version='1.2.3', packages=['arm'], ${setup}entry_points={'console_scripts': [${scripts}]})
`);
  workspace.write('src/arm/setup.cfg', '[develop]\nscript_dir=$base/lib/arm\n[install]\ninstall_scripts=$base/lib/arm\n');
  workspace.write('src/arm/arm/__init__.py', '');
  for (const [name, text] of Object.entries(modules)) workspace.write(`src/arm/arm/${name}.py`, text);
}

function writeManifest(workspace: PackWorkspace, python: string, programs: readonly string[]): void {
  const nodes = programs.map((one) => `  - {package: arm, executable: ${one}}\n`).join('');
  workspace.write('workspace.yaml', `schema: 1\nname: arm\npackages: [src/*]\npython: ${python}\nlaunch:\n${nodes}`);
}

async function withWorkspace(use: (workspace: PackWorkspace) => Promise<void>): Promise<void> {
  const workspace = new PackWorkspace();
  try {
    cpSync(made, join(workspace.root, 'index'), { recursive: true });
    await use(workspace);
  } finally {
    workspace.close();
  }
}

function siteOf(workspace: PackWorkspace, folder = 'site'): Site {
  return JSON.parse(workspace.read(`${folder}/site.json`).toString()) as Site;
}

// Compatibility, works: Python: compiled libraries of Pyodide's distribution, found by the modules that programs import and by
// rosdep keys, with what they need; from its address, a mirror or a folder
// Compatibility, works: Python: version wishes of setup.py, requirements.txt and `python: packages:` are compared with what there is
test('imports are resolved by the lock, locked, packed for those who import them, and run in Node.js and Chromium', watchdog,
  () =>
    withWorkspace(async (workspace) => {
      addArm(workspace, ['rclpy', 'python3-numpy', 'python3-springs'], { plan: PLAN, idle: IDLE }, "install_requires=['gear-box>=3', 'rods'], ");
      writeManifest(workspace, '{index: index, lock: index/pyodide-lock.json}', ['plan', 'idle']);
      const packed = await workspace.run(['pack']);
      assert.equal(packed.code, 0, packed.stderr);
      assert.deepEqual(packed.stderr.match(/warning\[.*/g), ['warning[R2W0247]: a site has `gear-box` 2.0, and not `gear-box>=3`']);
      const lock = workspace.read('ros2wasm.lock').toString();
      assert.match(lock, new RegExp(`^python_index: index\nlibraries:\n {2}- name: gear-box\n {4}version: "2.0"\n {4}file: gear_box-2.0-${ABI}.whl\n`
        + ' {4}sha256: [0-9a-f]{64}\n {4}depends:\n {6}- rods\n {6}- teeth\n {2}- name: rods\n', 'm'));
      assert.match(lock, / {2}- name: teeth\n {4}version: "1\.0"\n {4}file: teeth-1\.0\.zip\n/);
      const [plan, idle] = siteOf(workspace).nodes;
      const common = ['python/channels.zip', 'python/workspace.zip'];
      const own = ['rods', 'teeth', 'gear-box', 'springs'].map((one) => `python/libraries/${one}.zip`);
      assert.deepEqual(plan?.python.archives, [...common, 'python/numpy.zip', ...own]);
      const ofSprings = ['libwire.so', 'libcoil.so'].map((one) => `lib/python3.12/site-packages/springs.libs/${one}`);
      assert.deepEqual(plan.python.libraries, ['lib/libteeth.so', ...ofSprings]);
      assert.deepEqual([idle?.python.archives, idle?.python.libraries], [common, undefined]);

      const ran = await workspace.run(['run', 'site', '--for', '120s', '--until', 'plan says']);
      assert.equal(ran.code, 0, ran.stderr);
      assert.match(ran.stdout, /plan says 51 5 80 6/);
      const browser = await chromium.launch(chromiumOptions());
      try {
        await withTabs(browser, join(workspace.root, 'site'), 'shared', async (open) => {
          await shows(await open(''), 'plan says 51 5 80 6');
        });
      } finally {
        await browser.close();
      }

      const bytes = workspace.files('site');
      const again = await workspace.run(['pack', '--frozen', '--offline']);
      assert.equal(again.code, 0, again.stderr);
      assert.deepEqual([...workspace.files('site')], [...bytes]);
      workspace.write('ros2wasm.lock', lock.replace(/ {2}- name: springs\n(?: {4}.*\n)+/, ''));
      const locked = await workspace.run(['pack', '--locked']);
      assert.match(locked.stderr, /error\[R2W0320\][^]*the Python library `springs` would be new/);
      const frozen = await workspace.run(['pack', '--frozen']);
      assert.match(frozen.stderr, /error\[R2W0311\]: the Python library `springs` would be new[^]*fix: ros2wasm lock/);
    }));

test('files come from a mirror, stay in the cache, and are what the lock says', watchdog, () =>
  withWorkspace(async (workspace) => {
    addArm(workspace, ['rclpy', 'python3-numpy', 'python3-springs'], { plan: PLAN });
    const host = await serveFolder(join(workspace.root, 'index'));
    const index = host.url.replace(/\/$/, '');
    writeManifest(workspace, `{index: "${index}", lock: index/pyodide-lock.json}`, ['plan']);
    // Without a network: one error for all, and the lock is written.
    const offline = await workspace.run(['pack', '--offline']);
    assert.equal(offline.code, 3, offline.stderr);
    assert.equal(offline.stderr.match(/error\[/g)?.length, 1);
    assert.match(offline.stderr, /error\[R2W0246\]: 4 Python libraries are not on this machine/);
    for (const one of ['`gear-box` 2.0 is gear_box-2.0', '`rods` 3.0 is rods-3.0', '`springs` 1.1', '`teeth` 1.0 is teeth-1.0.zip'])
      assert.ok(offline.stderr.includes(one), one);
    assert.match(offline.stderr, /fix: ros2wasm cache fetch ros2wasm\.lock/);
    assert.deepEqual(host.requests, []);
    // Other bytes under the same name.
    const wheel = join(workspace.root, 'index', `gear_box-2.0-${ABI}.whl`);
    const good = readFileSync(wheel);
    writeFileSync(wheel, Buffer.concat([good, Buffer.from('more')]));
    const other = await workspace.run(['pack']);
    assert.equal(other.code, 3, other.stderr);
    assert.match(other.stderr, /error\[R2W0220\]: the Python library `gear_box-2\.0-.*` is not the one that was asked for/);
    writeFileSync(wheel, good);
    const fetched = await workspace.run(['cache', 'fetch', 'ros2wasm.lock']);
    assert.equal(fetched.code, 0, fetched.stderr);
    await host.close();
    const packed = await workspace.run(['pack', '--offline']);
    assert.equal(packed.code, 0, packed.stderr);
    const verified = await workspace.run(['cache', 'verify']);
    assert.equal(verified.code, 0, verified.stdout);
  }));

// Compatibility, works: Python: wheels with compiled modules for Pyodide 0.27 (`cp312-cp312-pyodide_2024_0_wasm32`, `abi3`) that the manifest names
test("compiled wheels that the manifest names are taken, and what the manifest asks for takes the place of the channel's", watchdog,
  () =>
    withWorkspace(async (workspace) => {
      addArm(workspace, ['rclpy', 'python3-numpy'], { plan: PLAN, idle: IDLE });
      const wheels = `[{file: index/gear_box-2.0-${ABI}.whl}, {file: index/springs-1.1-cp39-abi3-pyodide_2024_0_wasm32.whl}]`;
      writeManifest(workspace, `{index: index, wheels: ${wheels}}`, ['plan', 'idle']);
      const lacks = await workspace.run(['pack']);
      assert.match(lacks.stderr, /error\[R2W0245\]: the compiled module `gearbox\/_gear\..*so` of `gear_box-2\.0-.*` is not one that a site may load/);
      assert.match(lacks.stderr, /why: it needs `libteeth\.so`, which no library of the site has/);
      writeManifest(workspace, `{index: index, lock: index/pyodide-lock.json, packages: [teeth, numpy==2.0.1], wheels: ${wheels}}`, ['plan', 'idle']);
      const packed = await workspace.run(['pack']);
      assert.equal(packed.code, 0, packed.stderr);
      assert.doesNotMatch(packed.stderr, /R2W0247/);
      const [plan] = siteOf(workspace).nodes;
      assert.ok(plan?.python.archives.includes('python/libraries/numpy.zip'));
      assert.ok(!workspace.files('site').has('python/numpy.zip'));
      const ran = await workspace.run(['run', 'site', '--for', '120s', '--until', 'plan says']);
      assert.match(ran.stdout, /plan says 51 5 80 6/, ran.stderr);
      writeManifest(workspace, '{index: index, lock: index/pyodide-lock.json, packages: [gearbocks]}', ['plan']);
      const unknown = await workspace.run(['pack']);
      assert.match(unknown.stderr, /error\[R2W0127\]: Pyodide's distribution has no library `gearbocks`\n +--> workspace\.yaml:4/);
    }));

// Guarantee, hostile input: compiled modules of Python libraries that are cut, lie about their memory, import from the page or bring
// JavaScript are refused when the site is packed
test('a library with a module that a site must not load is refused', watchdog, () =>
  withWorkspace(async (workspace) => {
    addArm(workspace, ['rclpy'], { plan: `import cut\nimport liar\nimport outsider\n${IDLE}` });
    writeManifest(workspace, '{index: index, lock: index/pyodide-lock.json}', ['plan']);
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 1, packed.stderr);
    assert.deepEqual(packed.stderr.match(/error\[R2W0245\][^`]*`[^`]*`|why: it .*/g), [
      'error[R2W0245]: the compiled module `cut.abi3.so`',
      'why: it is not a whole WebAssembly module',
      'error[R2W0245]: the compiled module `liar.abi3.so`',
      'why: it has more data than the memory that its section `dylink.0` asks for',
      'error[R2W0245]: the compiled module `outsider.abi3.so`',
      'why: it imports `fetch` from `window`, which no interpreter of a site has',
    ]);
  }));

test('a notebook has its libraries, and the sources of a site those that it was packed from', watchdog, () =>
  withWorkspace(async (workspace) => {
    addArm(workspace, ['rclpy'], { idle: IDLE });
    const cell = { cell_type: 'code', source: 'import gearbox\ngearbox.teeth(3)', metadata: {}, outputs: [], execution_count: null };
    workspace.write('lab.ipynb', JSON.stringify({ nbformat: 4, nbformat_minor: 5, metadata: {}, cells: [cell] }));
    writeManifest(workspace, '{index: index, lock: index/pyodide-lock.json}', ['idle']);
    workspace.write('workspace.yaml', `${workspace.read('workspace.yaml').toString()}ui: {notebook: lab.ipynb}\nsite: {sources: true}\n`);
    const packed = await workspace.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
    const site = JSON.parse(workspace.read('site/site.json').toString()) as {
      readonly notebook: { readonly archives: readonly string[]; readonly libraries: readonly string[]; };
    };
    assert.deepEqual(site.notebook.archives.slice(-3), ['rods', 'teeth', 'gear-box'].map((one) => `python/libraries/${one}.zip`));
    assert.deepEqual(site.notebook.libraries, ['lib/libteeth.so']);
    const rebuilt = await workspace.run(['rebuild', 'site', '--offline']);
    assert.equal(rebuilt.code, 0, rebuilt.stderr);
  }));

const TURN = `import rclpy
from scipy.spatial.transform import Rotation


def main():
    rclpy.init()
    rclpy.create_node('turn').get_logger().info(f'turned {Rotation.from_euler("z", 90, degrees=True).as_matrix().round(3).tolist()}')
`;

// Compatibility, works: Python: workspaces that need nothing of Pyodide's distribution are packed as without it; `index: none` leaves it out
test("the channel's part of a library stays as long as it is enough", watchdog, () =>
  withWorkspace(async (workspace) => {
    addArm(workspace, ['rclpy', 'python3-scipy'], { turn: TURN });
    writeManifest(workspace, '{index: none}', ['turn']);
    const without = await workspace.run(['pack', '--offline']);
    assert.equal(without.code, 0, without.stderr);
    const bytes = workspace.files('site');
    bytes.delete('site.json');
    writeManifest(workspace, '{}', ['turn']);
    const packed = await workspace.run(['pack', '--offline']);
    assert.equal(packed.code, 0, packed.stderr);
    assert.doesNotMatch(workspace.read('ros2wasm.lock').toString(), /libraries:/);
    for (const [path, text] of bytes) {
      if (path.startsWith('python/') || path.startsWith('pyodide/')) assert.deepEqual(workspace.files('site').get(path), text, path);
    }
    // More than the part has: the distribution's.
    workspace.write('src/arm/arm/turn.py', `from scipy import optimize\n${TURN}`);
    const more = await workspace.run(['pack', '--offline']);
    assert.equal(more.code, 3, more.stderr);
    assert.match(more.stderr,
      /error\[R2W0246\]: 2 Python libraries are not on this machine\n += why: `openblas` 0\.3\.26 is openblas-0\.3\.26\.zip\n += why: `scipy` 1\.14\.1/);
    assert.match(more.stderr, /they come from https:\/\/cdn\.jsdelivr\.net\/pyodide\/v0\.27\.8\/full\//);
    const lock = workspace.read('ros2wasm.lock').toString();
    assert.match(lock, / {2}- name: scipy\n {4}version: 1\.14\.1\n {4}file: scipy-1\.14\.1-cp312-cp312-pyodide_2024_0_wasm32\.whl\n {4}sha256: 997c50a6/);
    assert.match(lock, / {2}- name: numpy\n {4}version: 2\.0\.1\n {4}build:/);
    workspace.write('src/arm/arm/turn.py', `import scipy.optimize\n${TURN}`);
    writeManifest(workspace, '{index: none}', ['turn']);
    const none = await workspace.run(['pack', '--offline']);
    assert.match(none.stderr, /error\[R2W0518\]: `scipy\.optimize` is not there/);
  }));
