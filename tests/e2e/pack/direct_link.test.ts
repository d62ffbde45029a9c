// Programs linked without the compiler's driver are those that it links, singly and with threads; with `--quick` they run.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { nightlyTest } from '../../support/nightly.ts';
import { CLI, PackWorkspace } from '../support/pack_workspace.ts';

const SINGLE = '#include <iostream>\n#include <string>\nint main() { std::cout << std::string("single") << std::endl; }\n';
/** The C library without threads has no pthread_getschedparam. */
const THREADED = `#include <pthread.h>
#include <cstdio>
#include <thread>
int main() {
  int found = 0;
  std::thread([&] {
    int policy = -1;
    sched_param parameters{};
    (void)pthread_getschedparam(pthread_self(), &policy, &parameters);
    found = 42;
  }).join();
  std::printf("threaded %d\\n", found);
}
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace();
  workspace.addPackage('programs', { single: SINGLE, threaded: THREADED });
  workspace.write('workspace.yaml', `schema: 1
name: programs
packages: [src/*]
launch:
  - {package: programs, executable: single}
  - {package: programs, executable: threaded}
`);
});
after(() => workspace.close());

for (const how of ['--quick', '--release']) {
  const options = how === '--quick' ? [how] : [];
  test(`programs linked without the driver run, also with what only the library for threads has (${how})`, { timeout: 240_000 }, async () => {
    const packed = await workspace.run(['pack', ...options, '--output', 'site']);
    assert.equal(packed.code, 0, packed.stderr);
    const ran = await workspace.run(['run', 'site', '--for', '60s']);
    assert.equal(ran.code, 0, `${ran.stdout}${ran.stderr}`);
    assert.match(ran.stdout, /\] single$/m);
    assert.match(ran.stdout, /\] threaded 42$/m);
  });
}

/** Exports of the driver's program that no loader of ours calls. */
const FOR_JAVASCRIPT = ['emscripten_main_thread_process_queued_calls', 'setThrew'];
/** Imports, which the loader has, for arguments that the program never passes: seeing that takes most of -O2's time. */
const FOR_TIMED_WAITS = ['clock_gettime', 'real_timeout'];

nightlyTest('a program linked without the driver is the one that the driver links', { timeout: 240_000 }, async () => {
  const run = (command: string, args: readonly string[], calls: string): void => {
    const done = spawnSync(command, args, {
      cwd: workspace.root,
      encoding: 'utf8',
      env: { ...process.env, ROS2WASM_TOOL_CALLS: calls, ROS2WASM_QUICK_LINK: '', EMCC_DEBUG: '0' },
    });
    assert.equal(done.status, 0, `${done.stdout}${done.stderr}`);
  };
  const calls = join(workspace.root, 'calls');
  for (const name of ['single', 'threaded']) {
    run('em++', ['-O2', '-fwasm-exceptions', '-pthread', '-c', `src/programs/src/${name}.cpp`, '-o', `${name}.o`], '');
    run(CLI, ['link-program', '--', 'em++', `${name}.o`, '-o', `by_driver/${name}.wasm`], '');
    run(CLI, ['link-program', '--', 'em++', `${name}.o`, '-o', `directly/${name}.wasm`], calls);
    const [ours, theirs] = await Promise.all(['directly', 'by_driver'].map(async (folder) => {
      const bytes = workspace.read(`${folder}/${name}.wasm`);
      const module = await WebAssembly.compile(new Uint8Array(bytes));
      const names = (all: readonly { name: string; }[]): string[] => all.map((one) => one.name).sort();
      // Names are kept apart from programs.
      const size = WebAssembly.Module.customSections(module, 'name').reduce((rest, section) => rest - section.byteLength, bytes.length);
      return { size, imports: names(WebAssembly.Module.imports(module)), exports: names(WebAssembly.Module.exports(module)) };
    }));
    assert.ok(ours !== undefined && theirs !== undefined);
    assert.deepEqual(ours.imports.filter((one) => theirs.imports.includes(one) || !FOR_TIMED_WAITS.includes(one)), theirs.imports);
    assert.deepEqual(theirs.exports.filter((one) => !ours.exports.includes(one) && !FOR_JAVASCRIPT.includes(one)), []);
    // Only the passes of -O2 that pay (direct_link.cpp). This program is mostly the C++ library; ROS programs come out smaller.
    assert.ok(ours.size < theirs.size * 1.15, `${String(ours.size)} bytes, the driver's has ${String(theirs.size)}`);
  }
  const kept = readdirSync(calls).filter((name) => !name.endsWith('.o'));
  assert.equal(kept.length, 2, 'what the driver said of either kind of link');
});
