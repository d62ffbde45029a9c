// The same workspace gives the same site, byte for byte, whatever the machine around it is like: each test changes
// some things and packs with a cache of its own. Where a byte differs, `ros2wasm diff` says which.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { chmodSync, cpSync, existsSync, lutimesSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { CLI, type Finished, PackWorkspace, finished } from '../support/pack_workspace.ts';

let original: PackWorkspace;
let sha256: string;
const places: string[] = [];

const files: Readonly<Record<string, string>> = {
  'src/tools/package.xml': `<package format="3">
  <name>tools</name><version>0.3.0</version><description>A program and a library</description>
  <maintainer email="someone@example.org">Someone</maintainer><license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend><depend>std_msgs</depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
`,
  'src/tools/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(tools)
find_package(ament_cmake REQUIRED)
add_library(words src/b.cpp src/a.cpp)
add_executable(say src/say.cpp)
target_link_libraries(say words)
add_executable(both src/both.cpp)
find_package(Threads REQUIRED)
target_link_libraries(both Threads::Threads)
install(TARGETS say both DESTINATION lib/\${PROJECT_NAME})
install(DIRECTORY config DESTINATION share/\${PROJECT_NAME})
ament_package()
`,
  'src/tools/src/a.cpp': 'const char* a() { return __FILE__; }\n',
  'src/tools/src/b.cpp':
    '#include <map>\n#include <string>\nstd::map<std::string, int> counts;\nconst char* a();\nconst char* b() { return ++counts[a()] > 1 ? a() : "b"; }\n',
  'src/tools/src/say.cpp': '#include <cassert>\n#include <cstdio>\nconst char* b();\nint main(int n, char**) { assert(n > 0); std::puts(b()); }\n',
  'src/tools/src/both.cpp': '#include <cstdio>\n#include <thread>\nint main() { std::thread([] { std::puts(__FILE__); }).join(); }\n',
  'src/tools/config/z.yaml': 'last: 1\n',
  'src/tools/config/a.yaml': 'first: 1\n',
  'src/words/package.xml': `<package format="3">
  <name>words</name><version>0.3.0</version><description>A node in Python</description>
  <maintainer email="someone@example.org">Someone</maintainer><license>MIT</license>
  <depend>rclpy</depend><export><build_type>ament_python</build_type></export>
</package>
`,
  'src/words/setup.py': `from glob import glob
from setuptools import find_packages, setup
setup(name='words', version='0.3.0', packages=find_packages(), data_files=[
    ('share/ament_index/resource_index/packages', ['resource/words']),
    ('share/words', ['package.xml']), ('share/words/data', glob('data/*'))],
    entry_points={'console_scripts': ['speak = words.speak:main']})
`,
  'src/words/setup.cfg': '[develop]\nscript_dir=$base/lib/words\n[install]\ninstall_scripts=$base/lib/words\n',
  'src/words/resource/words': '',
  'src/words/words/__init__.py': '',
  'src/words/words/speak.py': 'import rclpy\n\n\ndef main():\n    rclpy.init()\n    print("spoken")\n',
  'src/words/data/two.txt': '2',
  'src/words/data/one.txt': '1',
  'workspace.yaml': `schema: 1
name: same
packages: [src/*]
launch:
  - {package: tools, executable: say}
  - {package: tools, executable: both}
  - {package: words, executable: speak}
`,
};

before(async () => {
  original = new PackWorkspace();
  for (const [path, text] of Object.entries(files)) original.write(path, text);
  const packed = await original.run(['--json', 'pack']);
  assert.equal(packed.code, 0, packed.stderr);
  sha256 = (JSON.parse(packed.stdout) as { sha256: string; }).sha256;
});

after(() => {
  original.close();
  for (const place of places) {
    spawnSync('chmod', ['-R', 'u+rwx', place]);
    rmSync(place, { recursive: true, force: true });
  }
});

/** A copy of the sources, written in the order of `paths`, without lock and cache. */
function copy(name = 'copy', paths: readonly string[] = Object.keys(files)): string {
  const place = mkdtempSync(join(tmpdir(), 'ros2wasm-same-'));
  places.push(place);
  const root = join(place, name);
  for (const path of paths) {
    mkdirSync(dirname(join(root, path)), { recursive: true });
    writeFileSync(join(root, path), files[path] ?? '');
  }
  return root;
}

interface Surroundings {
  readonly root: string;
  /** The differences from the first pack. */
  readonly changes: readonly string[];
  /** Goes before the program. */
  readonly through?: readonly string[];
  readonly args?: readonly string[];
  readonly environment?: Readonly<Record<string, string>>;
  readonly cache?: string;
}

/** The differences that all tests together have tried, and the number of packs with a cold and with a warm cache. */
const changed = new Set<string>();
const packs = { cold: 0, warm: 0 };

function pack({ root, through = [], args = [], environment = {}, cache = join(root, '../cache') }: Omit<Surroundings, 'changes'>): Promise<Finished> {
  const [name = '', ...rest] = [...through, CLI, 'pack', '-o', '../site', ...args];
  return finished(spawn(name, rest, {
    cwd: root,
    env: { ...process.env, XDG_CACHE_HOME: cache, ...environment },
    stdio: ['ignore', 'pipe', 'pipe'],
  }));
}

/** Packs, and compares with the first site by the tool that users have for that. */
async function same(surroundings: Surroundings): Promise<void> {
  const isWarm = existsSync(join(surroundings.cache ?? join(surroundings.root, '../cache'), 'ros2wasm'));
  const packed = await pack(surroundings);
  assert.equal(packed.code, 0, packed.stderr);
  const site = join(surroundings.root, '../site');
  const compared = await original.run(['diff', 'site', site]);
  assert.equal(`${compared.stdout}${compared.stderr}`, `the same site, sha256 ${sha256}\n`);
  const verified = await original.run(['verify', site, '--hash', sha256]);
  assert.equal(verified.code, 0, verified.stderr);
  const lock = (root: string): string => readFileSync(join(root, 'ros2wasm.lock'), 'utf8');
  assert.equal(lock(surroundings.root), lock(original.root));
  for (const change of surroundings.changes) changed.add(change);
  packs[isWarm ? 'warm' : 'cold'] += 1;
}

// Guarantee, same bytes: packed again
test('packed again, warm', () => same({ root: original.root, changes: ['cache'], cache: join(original.root, 'cache') }));

// Guarantee, same bytes: in another folder, with a space and letters of other scripts in its name, cold and warm
//
// Guarantee, robust: spaces and letters of other scripts in the paths of a workspace
test('another folder, with a space and letters of other scripts in its name, cold and then warm', async () => {
  const root = copy('Über uns/κόσμος');
  // One folder deeper: the site lies beside it.
  await same({ root, changes: ['directory'], cache: join(root, '../../cache') });
  await same({ root, changes: ['directory'], cache: join(root, '../../cache') });
});

// Guarantee, same bytes: with another umask, language, time zone, home, user and host name, and on one processor
test("another umask, language, time zone, home, user's name and host, and one processor", () => {
  const root = copy();
  const home = join(root, '../home');
  mkdirSync(home);
  return same({
    root,
    changes: ['user', 'umask', 'locale', 'time zone', 'host', 'home', 'core count'],
    through: ['sh', '-c', 'umask 077; exec taskset -c 0 "$@"', 'masked'],
    args: ['-j', '1'],
    environment: {
      LANG: 'tr_TR.UTF-8',
      LC_ALL: 'C',
      LANGUAGE: 'tr',
      TZ: 'Pacific/Kiritimati',
      HOME: home,
      USER: 'somebody',
      LOGNAME: 'somebody',
      HOSTNAME: 'elsewhere',
    },
  });
});

// Guarantee, same bytes: with environment variables that compilers, Python and CMake heed, and with more compilers at once
test('variables that compilers, Python and CMake heed, and more compilers than processors', () =>
  same({
    root: copy(),
    changes: ['environment', 'compilers at once'],
    args: ['-j', '7'],
    environment: {
      CFLAGS: '-O0 -DNDEBUG',
      CXXFLAGS: '-O0 -g -DNDEBUG',
      LDFLAGS: '-Wl,--strip-all',
      CPATH: '/nowhere',
      MAKEFLAGS: '-k',
      EMCC_CFLAGS: '-DOTHER',
      PYTHONPATH: '/nowhere',
      PYTHONHASHSEED: '7',
      SOURCE_DATE_EPOCH: '1',
      CMAKE_BUILD_TYPE: 'Debug',
      CMAKE_GENERATOR: 'Unix Makefiles',
      AMENT_PREFIX_PATH: '/nowhere',
    },
  }));

// Guarantee, same bytes: with files written in another order, with times long ago and to come, and with a clock that is years ahead
test('files written in another order, with times long ago and to come', () => {
  const root = copy('copy', Object.keys(files).reverse());
  let year = 0;
  for (const entry of readdirSync(root, { recursive: true, withFileTypes: true })) {
    year += 1;
    const time = new Date(Date.UTC(year % 2 === 0 ? 1981 : 2037, 0, 1 + year));
    (entry.isDirectory() ? utimesSync : lutimesSync)(join(entry.parentPath, entry.name), time, time);
  }
  // The clock stands elsewhere, too, for the program and all that it starts.
  return same({
    root,
    changes: ['clock', 'file system order', 'times of files'],
    through: ['faketime', '-f', '@2031-02-03 04:05:06'],
    environment: { NO_FAKE_STAT: '1' },
  });
});

// Guarantee, same bytes: from a folder that may only be read, with files that anyone may run
test('a folder that may only be read, with files that anyone may run', () => {
  const root = copy();
  cpSync(join(original.root, 'ros2wasm.lock'), join(root, 'ros2wasm.lock'));
  for (const entry of readdirSync(root, { recursive: true, withFileTypes: true }))
    chmodSync(join(entry.parentPath, entry.name), 0o555);
  chmodSync(root, 0o555);
  return same({ root, changes: ['rights of files'], args: ['--locked'] });
});

// Guarantee, same bytes: with a cache that another workspace and a broken pack have used
test('a cache that another workspace and a broken pack have used', async () => {
  const other = copy('other');
  writeFileSync(join(other, 'src/tools/src/a.cpp'), 'int broken() { return undeclared; }\n');
  const cache = join(other, '../cache');
  assert.equal((await pack({ root: other, cache })).code, 1);
  await same({ root: copy(), changes: ['cache state'], cache });
});

// Guarantee, same bytes: under more than ten changes of surroundings in all, several times with an empty cache and with a full one
test('at least ten changes, twice cold and twice warm', () => {
  for (const one of ['directory', 'user', 'umask', 'locale', 'time zone', 'clock', 'core count', 'file system order', 'cache state', 'environment'])
    assert.ok(changed.has(one), one);
  assert.ok(changed.size >= 10 && packs.cold >= 2 && packs.warm >= 2, `${changed.size} ${JSON.stringify(packs)}`);
});
