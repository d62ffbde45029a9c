// A course repository of which some packages cannot be built: the others are packed, and the same again from the lock
// alone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PackWorkspace } from './pack_workspace.ts';

const HELLO = { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' };
let ws: PackWorkspace;

before(() => {
  ws = new PackWorkspace();
  ws.addPackage('good', HELLO);
  ws.addPackage('sim', HELLO, { depends: ['gazebo_ros'] });
  ws.addPackage('lab', HELLO, { depends: ['sim'] });
  ws.addPackage('mapper', HELLO, { cmake: 'find_package(slam_of_nobody REQUIRED)\n' });
});

after(() => ws.close());

const WARNINGS = [
  /warning\[R2W0519\]: package `sim` is left out: no channel has `gazebo_ros`, which it needs\n --> src\/sim\/package\.xml:\d+:/,
  /warning\[R2W0514\]: package `lab` is left out: it needs `sim`, which is left out\n/,
  /warning\[R2W0519\]: package `mapper` is left out: it asks CMake for `slam_of_nobody`, which is not there\n/,
];

test('what can be built is packed, and what is left out is said', async () => {
  const packed = await ws.run(['pack', '-o', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  for (const warning of WARNINGS) assert.match(packed.stderr, warning);
  assert.match(packed.stderr, /every program runs once: good\/hello\n/);
  assert.match(readFileSync(join(ws.root, 'ros2wasm.lock'), 'utf8'), /\nabsent:\n {2}- ros-jazzy-gazebo-ros\npackages:/);
});

test('--frozen leaves out the same, and a dependency that came later is an error', async () => {
  const first = ws.files('site');
  const frozen = await ws.run(['pack', '--frozen', '-o', 'site']);
  assert.equal(frozen.code, 0, frozen.stderr);
  for (const warning of WARNINGS) assert.match(frozen.stderr, warning);
  assert.deepEqual(ws.files('site'), first);
  ws.addPackage('good', HELLO, { depends: ['came_later'] });
  const refused = await ws.run(['pack', '--frozen', '-o', 'site']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0311\]: .*good\/package\.xml asks for `ros-jazzy-came-later`/);
});

test('a node of what is left out is an error at its line', async () => {
  ws.addPackage('good', HELLO);
  ws.write('workspace.yaml', 'schema: 1\nname: course\npackages: [src/*]\nlaunch:\n  - {package: good, executable: hello}\n  - {package: mapper, executable: hello}\n');
  const refused = await ws.run(['pack', '-o', 'site']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0401\]: package `mapper` is left out of the site\n --> workspace\.yaml:6:15\n/);
  assert.match(refused.stderr, /= why: it asks CMake for `slam_of_nobody`, which is not there\n/);
});
