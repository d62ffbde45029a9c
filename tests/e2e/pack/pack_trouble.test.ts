// Problems that a tool meets in years of use: very many packages and files, compilers that die, clocks that jump, other
// packs at the same time, an end without warning. The result is right or a clear error, and the old output stays intact.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { lutimesSync, readFileSync, readdirSync, utimesSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { nightly } from '../../support/nightly.ts';
import { CLI, type Finished, PackWorkspace, finished } from '../support/pack_workspace.ts';

const watchdog = { timeout: 300_000 };
const PACKAGES = nightly ? 1_000 : 200;
const FILES = nightly ? 10_000 : 2_000;
const hello = '#include <cstdio>\nint main() { std::puts("hello"); }\n';
let ws: PackWorkspace;
const others: PackWorkspace[] = [];

before(async () => {
  ws = new PackWorkspace();
  ws.addPackage('quick', { hello });
  manifest(ws, 'quick', 'hello');
  const packed = await ws.run(['pack', '-o', 'out/site']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);

after(() => {
  for (const one of [ws, ...others]) one.close();
});

function another(): PackWorkspace {
  const made = new PackWorkspace();
  others.push(made);
  return made;
}

function manifest(of: PackWorkspace, name: string, program: string): void {
  of.write('workspace.yaml', `schema: 1
name: trouble
packages: [src/*]
launch:
  - {package: ${name}, executable: ${program}}
`);
}

/** Two manifests of one package, for two sites. */
function twoManifests(): void {
  for (const name of ['first', 'second'])
    ws.write(`${name}.yaml`, `schema: 1\nname: ${name}\npackages: [src/quick]\nlaunch:\n  - {package: quick, executable: hello}\n`);
}

async function expectPacked(of: PackWorkspace, args: readonly string[], environment: Readonly<Record<string, string>> = {}): Promise<string> {
  const packed = await of.run(['--json', 'pack', ...args], environment);
  assert.equal(packed.code, 0, packed.stderr);
  return (JSON.parse(packed.stdout) as { sha256: string; }).sha256;
}

async function expectPrinted(of: PackWorkspace, site: string, line: RegExp): Promise<void> {
  const run = await of.run(['run', site, '--for', '60s']);
  assert.match(run.stdout + run.stderr, line);
}

/** Seconds that something takes. */
async function seconds(what: () => Promise<unknown>): Promise<number> {
  const began = performance.now();
  await what();
  return (performance.now() - began) / 1000;
}

// Guarantee, robust: a workspace of 1,000 packages, in C++, Python and interfaces, that need each other
test(`${PACKAGES} packages`, watchdog, async () => {
  const many = another();
  const count = PACKAGES;
  const name = (i: number): string => `p${String(i).padStart(4, '0')}`;
  const kinds = { python: 12, interfaces: count - 2, program: count - 1 };
  for (let i = 0; i < count; i += 1) {
    const needs = i === 0 ? [] : [name(Math.floor(i / 2))];
    if (i === kinds.program) needs.push(name(kinds.interfaces));
    const kind = i < kinds.python ? 'ament_python' : 'ament_cmake';
    many.write(`src/${name(i)}/package.xml`, `<package format="3"><name>${name(i)}</name><version>1.0.0</version><description>one of many</description>
<maintainer email="someone@example.org">Someone</maintainer><license>MIT</license>${
      i === kinds.interfaces
        ? `
<buildtool_depend>rosidl_default_generators</buildtool_depend><depend>std_msgs</depend>
<member_of_group>rosidl_interface_packages</member_of_group>`
        : ''
    }${i < kinds.python ? '<depend>rclpy</depend>' : ''}
${needs.map((need) => `<depend>${need}</depend>`).join('')}<export><build_type>${kind}</build_type></export></package>
`);
    if (i < kinds.python) {
      many.write(`src/${name(i)}/setup.py`, `from setuptools import setup\nsetup(name='${name(i)}', version='1.0.0', packages=['${name(i)}'])\n`);
      many.write(`src/${name(i)}/${name(i)}/__init__.py`, `number = ${i}\n`);
    } else if (i < kinds.interfaces) {
      many.write(`src/${name(i)}/CMakeLists.txt`,
        `cmake_minimum_required(VERSION 3.8)\nproject(${name(i)} NONE)\ninstall(FILES package.xml DESTINATION share/${name(i)})\n`);
    }
  }
  many.write(`src/${name(kinds.interfaces)}/msg/Count.msg`, 'uint32 number\n');
  many.write(`src/${name(kinds.interfaces)}/CMakeLists.txt`, `cmake_minimum_required(VERSION 3.8)
project(${name(kinds.interfaces)})
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(\${PROJECT_NAME} msg/Count.msg)
ament_package()
`);
  many.addPackage(name(kinds.program), {
    say: `#include <cstdio>\n#include <${name(kinds.interfaces)}/msg/count.hpp>
int main() { ${name(kinds.interfaces)}::msg::Count one; one.number = ${count}; std::printf("one of %u\\n", one.number); }\n`,
  }, {
    depends: [name(kinds.interfaces), name(Math.floor(kinds.program / 2))],
    cmake: `find_package(${name(kinds.interfaces)} REQUIRED)\ntarget_link_libraries(say \${${name(kinds.interfaces)}_TARGETS})\n`,
  });
  manifest(many, name(kinds.program), 'say');
  const took = await seconds(() => expectPacked(many, ['-o', 'site']));
  assert.ok(took < 200, `${took} s`); // some 35 on two cores that do nothing else
  await expectPrinted(many, 'site', new RegExp(`one of ${count}`));
  const lazy = await seconds(() => expectPacked(many, ['-o', 'site']));
  assert.ok(lazy < took / 4, `nothing to build: ${lazy} s of ${took}`);
});

// Guarantee, robust: 10,000 files in the share of one package, with spaces and letters of other scripts in their names
test(`${FILES} files`, watchdog, async () => {
  const many = another();
  const path = (i: number): string => `ordner ${Math.floor(i / 100)}/Datei é ${i} δ.txt`;
  for (let i = 0; i < FILES; i += 1) many.write(`src/data/files/${path(i)}`, `number ${i}`);
  many.addPackage('data', {
    say: `#include <ament_index_cpp/get_package_share_directory.hpp>
#include <fstream>
#include <iostream>
#include <rclcpp/rclcpp.hpp>
int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  std::ifstream file(ament_index_cpp::get_package_share_directory("data") + "/files/${path(FILES - 124)}");
  std::cout << "it has: " << file.rdbuf() << std::endl;
}
`,
  }, {
    depends: ['ament_index_cpp', 'rclcpp'],
    cmake:
      'find_package(ament_index_cpp REQUIRED)\nfind_package(rclcpp REQUIRED)\nament_target_dependencies(say ament_index_cpp rclcpp)\ninstall(DIRECTORY files DESTINATION share/data)\n',
  });
  manifest(many, 'data', 'say');
  const took = await seconds(() => expectPacked(many, ['-o', 'site']));
  assert.ok(took < 120, `${took} s`); // some 10 on two cores that do nothing else
  assert.ok(many.read('site/site.json').includes(path(0)));
  await expectPrinted(many, 'site', new RegExp(`it has: number ${FILES - 124}`));
  const verified = await many.run(['verify', 'site']);
  assert.equal(verified.code, 0, verified.stderr);
});

/** Ids of the compilers that this process started by way of others. */
function compilers(root: number): number[] {
  const listed = spawnSync('ps', ['-e', '-o', 'pid=,ppid=,comm='], { encoding: 'utf8' }).stdout;
  const rows = Array.from(listed.matchAll(/^ *(\d+) +(\d+) +(.*)$/gm), ([, pid, parent, name]) => ({ pid: Number(pid), parent: Number(parent), name }));
  const ours = new Set([root]);
  for (let before = 0; before !== ours.size;) {
    before = ours.size;
    for (const { pid, parent } of rows) if (ours.has(parent)) ours.add(pid);
  }
  return rows.flatMap(({ pid, name = '' }) => (ours.has(pid) && name.startsWith('clang') ? [pid] : []));
}

async function expectUntouched(what: () => Promise<void>): Promise<void> {
  const old = ws.files('out/site');
  await what();
  assert.deepEqual(ws.files('out/site'), old);
  assert.deepEqual(readdirSync(join(ws.root, 'out')), ['site'], 'nothing is left beside the site');
}

// Guarantee, robust: a compiler without memory, or killed for lack of it: a clear error (R2W0521), and the old site stays
test('a compiler that may have no more memory', watchdog, () =>
  expectUntouched(async () => {
    ws.addPackage('large', { large: 'extern const char large[1u << 30] = {1};\nint main() { return large[4]; }\n' });
    const args = ['-c', 'ulimit -v 600000; exec "$@"', 'limited', CLI, 'pack', '-o', 'out/site'];
    const packed: Finished = await finished(spawn('bash', args, {
      cwd: ws.root,
      env: { ...process.env, XDG_CACHE_HOME: join(ws.root, 'cache') },
      stdio: ['ignore', 'pipe', 'pipe'],
    }));
    assert.equal(packed.code, 3, packed.stderr);
    assert.match(packed.stderr,
      /error\[R2W0521\]: out of memory: package `large` does not compile: CMakeFiles\/large\.dir\/src\/large\.cpp\.o\n {3}= why: a tool of the compiler had not enough memory\n/);
    assert.doesNotMatch(packed.stderr, /Stack dump/);
  }));

test('a compiler that is killed', watchdog, () =>
  expectUntouched(async () => {
    ws.addPackage('large', {
      large:
        'constexpr int spin(int n) { int s = 0; for (int i = 0; i < n; ++i) s += i & 3; return s; }\nconstexpr int kept = spin(2000000000);\nint main() { return kept; }\n',
    }, { cmake: 'target_compile_options(large PRIVATE -fconstexpr-steps=2147483647)\n' });
    const child = ws.start(['--json', 'pack', '-o', 'out/site']);
    let killed = 0;
    const search = setInterval(() => {
      // The file itself, not what cmake tries: that is short.
      for (const pid of compilers(child.pid ?? 0)) {
        try {
          if (!readFileSync(`/proc/${pid}/cmdline`, 'utf8').includes('large.cpp')) continue;
          process.kill(pid, 'SIGKILL');
          killed += 1;
        } catch { /* it has ended */ }
      }
    }, 50);
    const packed = await finished(child);
    clearInterval(search);
    assert.ok(killed > 0);
    assert.equal(packed.code, 3, packed.stderr);
    assert.match(packed.stderr, /R2W0521.*out of memory: package `large` does not compile/);
    assert.match(packed.stderr, /was killed \(SIGKILL\), as systems do when memory runs out/);
  }));

// Guarantee, robust: a clock that jumps, by decades, and files from its past and future: what changed is built, what did not is not
test('a clock that jumps', watchdog, async () => {
  const jumping = another();
  jumping.addPackage('quick', { hello });
  manifest(jumping, 'quick', 'hello');
  const packed = async (time: string): Promise<{ sha256: string; built: boolean; }> => {
    // The program's clock and that of all that it starts; times of files as they are.
    const { code, stdout, stderr } = await finished(spawn('faketime', ['-f', `@${time}`, CLI, '--json', 'pack', '-o', 'site'], {
      cwd: jumping.root,
      env: { ...process.env, NO_FAKE_STAT: '1', XDG_CACHE_HOME: join(jumping.root, 'cache') },
      stdio: ['ignore', 'pipe', 'pipe'],
    }));
    assert.equal(code, 0, stderr);
    return { sha256: (JSON.parse(stdout) as { sha256: string; }).sha256, built: /built quick/.test(stderr) };
  };
  const future = await packed('2037-12-30 12:00:00');
  assert.ok(future.built);
  const past = await packed('1999-12-31 23:59:59');
  assert.deepEqual(past, { sha256: future.sha256, built: false });
  // Written later than all that was made of it, and with a time from long before.
  const source = jumping.write('src/quick/src/hello.cpp', hello.replace('hello', 'changed'));
  utimesSync(source, new Date('1990-01-01'), new Date('1990-01-01'));
  const changed = await packed('2000-01-01 00:00:00');
  assert.ok(changed.built && changed.sha256 !== future.sha256);
  await expectPrinted(jumping, 'site', /changed/);
  for (const entry of readdirSync(jumping.root, { recursive: true, withFileTypes: true })) {
    const file = join(entry.parentPath, entry.name);
    lutimesSync(file, new Date('2037-01-01'), new Date('2037-01-01'));
  }
  jumping.write('src/quick/src/hello.cpp', hello);
  const again = await expectPacked(jumping, ['-o', 'site']);
  assert.equal(again, future.sha256);
});

// Guarantee, robust: packs at once into one place: each is whole, and the site is that of one of them
test('packs at once into one place', watchdog, async () => {
  twoManifests();
  const first = await expectPacked(ws, ['first.yaml', '-o', 'out/site']);
  const second = await expectPacked(ws, ['second.yaml', '-o', 'elsewhere']);
  assert.notEqual(first, second);
  for (let round = 0; round < 3; round += 1) {
    const packs = [1, 2, 3, 4].map((i) => ws.run(['pack', i % 2 === 0 ? 'first.yaml' : 'second.yaml', '-o', 'out/site']));
    for (const { code, stderr } of await Promise.all(packs)) assert.ok(code === 0 || /^error\[R2W\d{4}\]/m.test(stderr), stderr);
    const verified = await ws.run(['verify', 'out/site', '--json']);
    assert.equal(verified.code, 0, verified.stdout + verified.stderr);
    assert.ok([first, second].some((sha256) => verified.stdout.includes(sha256)), verified.stdout);
    assert.deepEqual(readdirSync(join(ws.root, 'out')), ['site']);
  }
});

// Guarantee, robust: `pack` killed (SIGKILL) at every step: the old site, or the new one, whole; the next pack cleans up
test('killed at every step', watchdog, async () => {
  twoManifests();
  const second = await expectPacked(ws, ['second.yaml', '-o', 'elsewhere']);
  const fresh = ws.files('elsewhere');
  const first = await expectPacked(ws, ['first.yaml', '-o', 'out/site']);
  const old = ws.files('out/site');
  assert.notEqual(first, second);
  // A comment changes no site, but the package is built again.
  const touched = (note: string): string => ws.write('src/quick/src/hello.cpp', `// ${note}\n${hello}`);
  touched('first');
  const told = await ws.run(['--json', 'pack', 'second.yaml', '-o', 'elsewhere']);
  const steps = [...new Set(Array.from(told.stderr.matchAll(/"event":"progress","step":"(\w+)"/g), ([, step]) => step))];
  for (const step of ['solve', 'build', 'plan', 'emit']) assert.ok(steps.includes(step), `${step} of ${steps.join()}`);
  let killed = 0;
  for (const step of steps) {
    touched(`until ${step}`);
    const child = ws.start(['--json', 'pack', 'second.yaml', '-o', 'out/site']);
    child.stderr?.on('data', (text: Buffer) => {
      if (String(text).includes(`"step":"${step}"`)) child.kill('SIGKILL');
    });
    const { code } = await finished(child);
    if (code === null) killed += 1;
    const now = ws.files('out/site');
    assert.ok([old, fresh].some((whole) => JSON.stringify([...whole]) === JSON.stringify([...now])), `after ${step}`);
    assert.equal(await expectPacked(ws, ['first.yaml', '-o', 'out/site']), first);
    assert.deepEqual(readdirSync(join(ws.root, 'out')), ['site'], `after ${step}`);
  }
  assert.ok(killed > 2, `${killed} of ${steps.length}`);
});
