// Compiler warnings are printed in full and counted, also when ninja or the cache had nothing to compile.

// Compatibility, differs: `-Werror` of a package -> its warnings are warnings, since the site's compiler has others than the
// one that its authors have; `-Werror=NAME` counts
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const HEADER = 'inline int half(int given, int forgotten) { return given / 2; }\n';
const MAIN = '#include <cstdio>\n#include "half.hpp"\nint main() { std::printf("%d\\n", half(2, 1)); }\n';
const WARNING = /warning\[R2W0525\]: unused parameter 'forgotten' \[-Wunused-parameter\]\n {1,2}--> src\/lab\/src\/half\.hpp:1:32\n/g;
let ws: PackWorkspace;

before(() => {
  ws = new PackWorkspace();
  ws.addPackage('lab', { one: MAIN, two: MAIN }, {
    cmake: 'target_compile_options(one PRIVATE -Wall -Wextra)\ntarget_compile_options(two PRIVATE -Wall -Wextra -Werror)\n',
  });
  ws.write('src/lab/src/half.hpp', HEADER);
});
after(() => ws.close());

interface Event {
  readonly event: string;
  readonly code?: string;
  readonly item?: string;
  readonly warnings?: number;
  readonly text?: string;
}

test('each once, with how many there are', async () => {
  const built = await ws.run(['build', '--json']);
  assert.equal(built.code, 0, built.stderr);
  const events = built.stderr.trim().split('\n').map((line) => JSON.parse(line) as Event);
  assert.equal(events.filter((one) => one.code === 'R2W0525').length, 1);
  assert.ok(events.some((one) => one.event === 'progress' && one.item === 'lab' && one.warnings === 1), built.stderr);
  assert.ok(events.some((one) => one.text === 'compiler warnings: 1 in lab'), built.stderr);
});

test('from the cache too, and after a change of another file', async () => {
  const again = await ws.run(['build']);
  assert.equal(again.stderr.match(WARNING)?.length, 1, again.stderr);
  assert.match(again.stderr, /compiler warnings: 1 in lab \(as it was built before\)\n/);
  ws.write('src/lab/src/two.cpp', 'int main() {}\n');
  const changed = await ws.run(['build']);
  assert.equal(changed.stderr.match(WARNING)?.length, 1, changed.stderr);
  assert.match(changed.stderr, /compiler warnings: 1 in lab\n/);
});

test('--quiet leaves them out', async () => {
  const quiet = await ws.run(['build', '--quiet']);
  assert.equal(quiet.code, 0);
  assert.equal(quiet.stderr, '');
});

test('they are gone when they are mended', async () => {
  ws.write('src/lab/src/half.hpp', HEADER.replace('forgotten', ''));
  const mended = await ws.run(['build']);
  assert.equal(mended.code, 0);
  assert.doesNotMatch(mended.stderr, /R2W0525|warnings/);
});
