// `pack --quick`: programs linked without the compiler's driver run, singly and with threads.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from './pack_workspace.ts';

const SINGLE = '#include <cstdio>\nint main() { std::puts("single"); }\n';
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

test('programs linked quickly run, also with what only the library for threads has', { timeout: 240_000 }, async () => {
  const packed = await workspace.run(['pack', '--quick', '--output', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  const ran = await workspace.run(['run', 'site', '--for', '60s']);
  assert.equal(ran.code, 0, `${ran.stdout}${ran.stderr}`);
  assert.match(ran.stdout, /\] single$/m);
  assert.match(ran.stdout, /\] threaded 42$/m);
});
