// `ros2wasm pack` on real packages through the real compiler: kinds of link, caching, same bytes, interruption.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { chmodSync, existsSync, mkdirSync, readFileSync, readdirSync, symlinkSync, watch } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';

import { CLI, PackWorkspace, finished, runProgram } from '../support/pack_workspace.ts';

const THROWING = `#include <cstdio>
#include <stdexcept>
#include <string>
struct Guard { ~Guard() { std::puts("unwound"); } };
int risky(int i) { Guard guard; if (i > 0) throw std::runtime_error("number " + std::to_string(i)); return i; }
int main() {
  for (int i = 0; i < 2; ++i) {
    try { risky(i); std::puts("fine"); }
    catch (const std::logic_error &) { std::puts("wrong catch"); }
    catch (const std::exception & e) { std::printf("caught %s in %s\\n", e.what(), __FILE__); }
  }
}
`;
const THROWING_SAYS = 'unwound\nfine\nunwound\ncaught number 1 in ./src/single.cpp\n';
const THREADED = `#include <cstdio>
#include <thread>
int main() { std::thread t([] { std::puts("in a thread"); }); t.join(); }
`;
/** Uses std::thread in a function that nobody calls: no reason for threads. */
const UNUSED_THREAD = `#include <cstdio>
#include <thread>
static void never() { std::thread([] {}).join(); }
int main(int argc, char **) { std::puts("alone"); if (argc < 0) { (void)never; } }
`;

const workspaces: PackWorkspace[] = [];
function workspace(): PackWorkspace {
  const made = new PackWorkspace();
  workspaces.push(made);
  return made;
}
after(() => {
  for (const one of workspaces) one.close();
});

function demo(): PackWorkspace {
  const ws = workspace();
  ws.addPackage('shapes', {}, {
    cmake: `add_library(shapes SHARED src/shapes.cpp)
target_include_directories(shapes PUBLIC $<BUILD_INTERFACE:\${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include/shapes>)
install(DIRECTORY include/ DESTINATION include/shapes)
install(TARGETS shapes EXPORT export_shapes ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
ament_export_targets(export_shapes HAS_LIBRARY_TARGET)
`,
  });
  ws.write('src/shapes/include/shapes/area.hpp', 'namespace shapes { int area(int a, int b); }\n');
  ws.write('src/shapes/src/shapes.cpp', '#include "shapes/area.hpp"\nint shapes::area(int a, int b) { return a * b; }\n');
  ws.addPackage('demo', { single: THROWING, threaded: THREADED, unused: UNUSED_THREAD }, {
    cmake: 'find_package(Threads REQUIRED)\ntarget_link_libraries(threaded Threads::Threads)\ntarget_link_libraries(unused pthread)\n',
  });
  ws.addPackage('user', { area: '#include <cstdio>\n#include <shapes/area.hpp>\nint main() { std::printf("%d\\n", shapes::area(6, 7)); }\n' }, {
    depends: ['shapes'],
    cmake: 'find_package(shapes REQUIRED)\nament_target_dependencies(area shapes)\n',
  });
  return ws;
}

const first = demo();

test('a folder without a manifest packs, and every program is linked as it needs', async () => {
  const packed = await first.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, /every program runs once: shapes|every program runs once: demo\/single, demo\/threaded, demo\/unused, user\/area/);
  const site = JSON.parse(first.read('site/site.json').toString()) as { nodes: { id: string; threads: boolean; }[]; };
  assert.deepEqual(site.nodes.map((n) => [n.id, n.threads]), [
    ['single-1', false],
    ['threaded-2', true],
    ['unused-3', false],
    ['area-4', false],
  ]);
  assert.deepEqual(runProgram(first.read('site/programs/demo/single.wasm')), { output: THROWING_SAYS, code: 0 });
  assert.equal(runProgram(first.read('site/programs/user/area.wasm')).output, '42\n');
  assert.equal(runProgram(first.read('site/programs/demo/unused.wasm')).output, 'alone\n');
  const threaded = new WebAssembly.Module(first.read('site/programs/demo/threaded.wasm'));
  const imports = WebAssembly.Module.imports(threaded);
  assert.ok(imports.some((i) => i.kind === 'memory'), 'a program with threads imports its memory');
  assert.ok(imports.some((i) => i.name === '__pthread_create_js'));
});

test('programs carry neither names nor paths of this machine', () => {
  for (const [path, bytes] of first.files('site')) {
    assert.ok(!bytes.includes(first.root), path);
    if (!path.endsWith('.wasm')) continue;
    const module = new WebAssembly.Module(Buffer.from(bytes, 'latin1'));
    for (const section of ['name', 'producers', 'sourceMappingURL']) {
      assert.equal(WebAssembly.Module.customSections(module, section).length, 0, `${path}: ${section}`);
    }
  }
  const builds = join(first.root, 'cache/ros2wasm/build');
  const built = join(builds, readdirSync(builds)[0] ?? '', 'built');
  const demoBuild = readdirSync(built).find((name) => name.startsWith('demo-')) ?? '';
  assert.ok(existsSync(join(built, demoBuild, 'lib/demo/single.names')), 'names are kept for crash reports');
});

test('`ros2wasm run` names the functions of a program that traps', async () => {
  const ws = workspace();
  ws.addPackage('falls', {
    deep: `#include <cstdio>
namespace falls { int ratio(const char *, volatile int a, volatile int b) { return a / b; } }
static int (*volatile divide)(const char *, int, int) = falls::ratio;
int main(int argc, char **) { return divide("x", argc, argc - argc); }
`,
  });
  assert.equal((await ws.run(['pack'])).code, 0);
  const ended = await ws.run(['run', 'site']);
  assert.equal(ended.code, 1);
  assert.match(ended.stderr, /\[deep-1\] error\[R2W0701\]: divide by zero\n {2}at falls::ratio\(char const\*, int, int\) \(0x[0-9a-f]+\)\n/);
});

test('a warm pack starts no tool and gives the same bytes', async () => {
  const before = first.files('site');
  const poisoned = join(first.root, 'poisoned');
  mkdirSync(poisoned);
  for (const tool of ['cmake', 'ninja', 'em++', 'emcc', 'python3', 'node']) {
    first.write(`poisoned/${tool}`, '#!/bin/sh\nexit 99\n');
    chmodSync(join(poisoned, tool), 0o755);
  }
  // The compiler is known by its place: keep that, poison what would be run.
  const real = (process.env['PATH'] ?? '').split(':').find((folder) => existsSync(join(folder, 'em++'))) ?? '';
  const tools = join(first.root, 'tools');
  mkdirSync(tools);
  symlinkSync(join(real, 'em++'), join(tools, 'em++'));
  symlinkSync(join(real, 'emcc'), join(tools, 'emcc'));
  const packed = await first.run(['pack'], { PATH: `${tools}:${poisoned}` });
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, /nothing to build/);
  assert.deepEqual(first.files('site'), before);
});

test('only what changed, and what needs it, is built again', async () => {
  first.write('src/shapes/src/shapes.cpp', '#include "shapes/area.hpp"\nint shapes::area(int a, int b) { return a * b + 1; }\n');
  const packed = await first.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, /built shapes, user\n/);
  assert.equal(runProgram(first.read('site/programs/user/area.wasm')).output, '43\n');
});

test('another place and another cache give the same bytes', async () => {
  const second = demo();
  second.write('src/shapes/src/shapes.cpp', '#include "shapes/area.hpp"\nint shapes::area(int a, int b) { return a * b + 1; }\n');
  for (const ws of [first, second]) {
    ws.write('workspace.yaml',
      'schema: 1\nname: lab\npackages: [src/*]\nlaunch:\n  - {package: user, executable: area}\n  - {package: demo, executable: threaded}\n');
    const packed = await ws.run(['pack', '-o', 'lab_site']);
    assert.equal(packed.code, 0, packed.stderr);
  }
  assert.deepEqual(second.files('lab_site'), first.files('lab_site'));
});

test('mistakes of packages that do not need each other come at once, and the old site stays', async () => {
  const before = first.files('lab_site');
  const good = first.read('src/demo/src/single.cpp').toString();
  first.write('src/demo/src/single.cpp', 'int main() { return undeclared; }\n');
  first.write('src/user/src/area.cpp', 'int nowhere();\nint main() { return nowhere(); }\n');
  const packed = await first.run(['pack', '-o', 'lab_site']);
  assert.equal(packed.code, 1);
  assert.match(packed.stderr, /error\[R2W0502\]: package `demo` does not compile: use of undeclared identifier 'undeclared'/);
  assert.match(packed.stderr, /error\[R2W0504\]: nothing defines `nowhere\(\)`, which `area` of package `user` needs/);
  assert.match(packed.stderr, /`area\.cpp\.o` refers to it/);
  assert.deepEqual(first.files('lab_site'), before);
  first.write('src/demo/src/single.cpp', good);
});

test('Ctrl-C ends the compilers, exits with 130 and leaves the old site', async () => {
  const ws = workspace();
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  assert.equal((await ws.run(['pack'])).code, 0);
  const before = ws.files('site');
  // A build command that tells its process id and would go on for ever.
  mkdirSync(join(ws.root, 'signs'));
  ws.addPackage('slow', {}, {
    cmake:
      `add_custom_target(wait ALL COMMAND sh -c "echo $$ > ${ws.root}/signs/new && mv ${ws.root}/signs/new ${ws.root}/signs/pid && exec sleep 100000" VERBATIM)\n`,
  });
  const seen = new Promise<void>((resolve) => {
    const watcher = watch(join(ws.root, 'signs'), { persistent: false }, () => {
      if (!existsSync(join(ws.root, 'signs/pid'))) return;
      watcher.close();
      resolve();
    });
  });
  const child = ws.start(['pack']);
  const end = finished(child);
  await Promise.race([seen, once(child, 'exit').then(() => {
    throw new Error('pack ended early');
  })]);
  child.kill('SIGINT');
  const result = await end;
  assert.equal(result.code, 130, result.stderr);
  assert.match(result.stderr, /R2W0903/);
  const pid = ws.read('signs/pid').toString().trim();
  // A zombie that nobody collected yet has ended too.
  const stat = existsSync(`/proc/${pid}/stat`) ? readFileSync(`/proc/${pid}/stat`, 'utf8') : '(sh) Z';
  assert.match(stat, /\) [ZX]/, 'the build command is gone');
  assert.deepEqual(ws.files('site'), before);
});

test('site: exceptions: standard translates the programs', async () => {
  const ws = workspace();
  ws.addPackage('demo', { single: THROWING });
  ws.write('workspace.yaml', 'schema: 1\nname: lab\npackages: [src/*]\nsite: {exceptions: standard}\nlaunch:\n  - {package: demo, executable: single}\n');
  const packed = await ws.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
  const program = ws.read('site/programs/demo/single.wasm');
  assert.deepEqual(runProgram(program), { output: THROWING_SAYS, code: 0 });
  ws.write('workspace.yaml', 'schema: 1\nname: lab\npackages: [src/*]\nlaunch:\n  - {package: demo, executable: single}\n');
  assert.equal((await ws.run(['pack', '-o', 'older'])).code, 0);
  assert.notDeepEqual(ws.read('older/programs/demo/single.wasm'), program);
});

test('an installed program finds its data and packs', async () => {
  const ws = workspace();
  const build = dirname(CLI);
  const installed = await finished(spawn('cmake', ['--install', build, '--prefix', join(ws.root, 'usr')], { stdio: ['ignore', 'pipe', 'pipe'] }));
  assert.equal(installed.code, 0, installed.stderr);
  ws.addPackage('demo', { single: THROWING }, { cmake: 'find_package(ament_cmake_ros REQUIRED)\n' });
  const packed = await finished(spawn(join(ws.root, 'usr/bin/ros2wasm'), ['pack', 'src', '-o', 'site'], {
    cwd: ws.root,
    env: { ...process.env, XDG_CACHE_HOME: join(ws.root, 'cache') },
    stdio: ['ignore', 'pipe', 'pipe'],
  }));
  assert.equal(packed.code, 0, packed.stderr);
  assert.deepEqual(runProgram(ws.read('site/programs/demo/single.wasm')), { output: THROWING_SAYS, code: 0 });
});

test('--plan writes nothing, --locked holds what was written', async () => {
  const ws = workspace();
  ws.addPackage('demo', { single: THROWING });
  const planned = await ws.run(['pack', '--plan']);
  assert.equal(planned.code, 0, planned.stderr);
  assert.match(planned.stdout, /programs\/demo\/single\.wasm {2}\(program of single-1\)/);
  assert.deepEqual(readdirSync(ws.root).sort(), ['cache', 'src']);
  assert.equal((await ws.run(['pack'])).code, 0);
  const locked = await ws.run(['pack', '--locked']);
  assert.equal(locked.code, 0, locked.stderr);
  ws.write('src/demo/package.xml', ws.read('src/demo/package.xml').toString().replace('<test_depend>', '<depend>std_msgs</depend>\n  <test_depend>'));
  const refused = await ws.run(['pack', '--locked']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0320\]/);
});

// Guarantee, robust: a CMake package is built again when what a link leads to, out of the workspace, has changed
test('a header that a link out of the workspace leads to', async () => {
  const [ws, other] = [workspace(), workspace()];
  ws.addPackage('linked', { hello: '#include <cstdio>\n#include "../words/word.h"\nint main() { std::puts(WORD); }\n' });
  mkdirSync(join(other.root, 'words'));
  symlinkSync(join(other.root, 'words'), join(ws.root, 'src/linked/words'));
  for (const word of ['one', 'two']) {
    other.write('words/word.h', `#define WORD "${word}"\n`);
    const packed = await ws.run(['pack']);
    assert.equal(packed.code, 0, packed.stderr);
    assert.match((await ws.run(['run', 'site'])).stdout, new RegExp(`\\] ${word}$`, 'm'));
  }
});
