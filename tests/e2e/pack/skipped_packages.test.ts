// A course repository of which some packages cannot be built: the others are packed, and the same again from the lock
// alone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const HELLO = { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' };
let ws: PackWorkspace;

before(() => {
  ws = new PackWorkspace();
  ws.addPackage('good', HELLO);
  ws.addPackage('sim', HELLO, { depends: ['webots_ros2_driver'], cmake: 'find_package(webots_ros2_driver REQUIRED)\n' });
  ws.addPackage('lab', HELLO, { depends: ['sim'] });
  ws.addPackage('mapper', HELLO, { cmake: 'find_package(slam_of_nobody REQUIRED)\n' });
});

after(() => ws.close());

const WARNINGS = [
  /warning\[R2W0519\]: package `sim` is skipped: no channel has `webots_ros2_driver`, which it needs\n --> src\/sim\/package\.xml:\d+:/,
  /warning\[R2W0514\]: package `lab` is skipped: it needs `sim`, which is skipped\n/,
  /warning\[R2W0519\]: package `mapper` is skipped: it asks CMake for `slam_of_nobody`, which is not there\n/,
];

test('what can be built is packed, and what is skipped is said', async () => {
  const packed = await ws.run(['pack', '-o', 'site']);
  assert.equal(packed.code, 0, packed.stderr);
  for (const warning of WARNINGS) assert.match(packed.stderr, warning);
  assert.match(packed.stderr, /every program runs once: good\/hello\n/);
  assert.match(readFileSync(join(ws.root, 'ros2wasm.lock'), 'utf8'), /\nabsent:\n {2}- ros-jazzy-webots-ros2-driver\npackages:/);
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

test('a node of what is skipped is an error at its line', async () => {
  ws.addPackage('good', HELLO);
  ws.write('workspace.yaml',
    'schema: 1\nname: course\npackages: [src/*]\nlaunch:\n  - {package: good, executable: hello}\n  - {package: mapper, executable: hello}\n');
  const refused = await ws.run(['pack', '-o', 'site']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr,
    /error\[R2W0401\]: package `mapper` is skipped: it asks CMake for `slam_of_nobody`, which is not there \(src\/mapper\/CMakeLists\.txt:5\)\n --> workspace\.yaml:6:15\n/);
});

/** A workspace of its own, with one package that names two things that nobody has. */
async function packedWith(programs: Readonly<Record<string, string>>, cmake: string,
  more: readonly string[] = []): Promise<{ code: number | null; stderr: string; said: string; }>
{
  const lacking = new PackWorkspace();
  try {
    lacking.addPackage('typo', programs, { depends: ['std_mgs', 'liblidar0-dev'], cmake });
    lacking.write('src/typo/parts/CMakeLists.txt', 'find_package(lidar REQUIRED)\n');
    for (const name of more) lacking.addPackage(name, HELLO);
    const { code, stderr } = await lacking.run(['pack', '-o', 'site']);
    const ran = code === 0 ? await lacking.run(['run', 'site', '--for', '60s']) : undefined;
    return { code, stderr, said: ran?.stdout ?? '' };
  } finally {
    lacking.close();
  }
}
const MISSING = [
  / no channel has `std_mgs`, and the workspace has not either\n +--> src\/typo\/package\.xml:9:11\n/,
  / no channel has `liblidar0-dev`, and the workspace has not either\n +--> src\/typo\/package\.xml:10:11\n/,
];

test('a name that CMake is never asked for is a warning, and the package is built and runs', async () => {
  const { code, stderr, said } = await packedWith(HELLO, '');
  assert.equal(code, 0, stderr);
  for (const missing of MISSING) assert.match(stderr, new RegExp(`warning\\[R2W0513\\]:${missing.source}`));
  assert.match(stderr, /= why: what names it is built without it: nothing there asks for it\n/);
  assert.match(said, /^\[hello-1\] hello$/m);
});

test('all names are told when CMake asks for one after all', async () => {
  const parts = 'add_subdirectory(parts)\n';
  const alone = await packedWith(HELLO, parts);
  assert.equal(alone.code, 1);
  for (const missing of MISSING) assert.match(alone.stderr, new RegExp(`error\\[R2W0513\\]:${missing.source}`));
  assert.match(alone.stderr, /error\[R2W0507\]: package `typo` asks CMake for `lidar`, which is not there\n/);
  const beside = await packedWith(HELLO, parts, ['good']);
  assert.equal(beside.code, 0, beside.stderr);
  assert.match(beside.stderr,
    /warning\[R2W0519\]: package `typo` is skipped: no channel has `std_mgs`, `liblidar0-dev`, which it needs\n --> src\/typo\/package\.xml:9:11\n/);
  assert.match(beside.stderr, /= why: package `typo` asks CMake for `lidar`, which is not there\n/);
  assert.match(beside.said, /^\[hello-1\] hello$/m);
});

test('and when a source includes what it would bring', async () => {
  const scan = { scan: '#include <lidar.h>\nint main() {}\n' };
  const alone = await packedWith(scan, '');
  assert.equal(alone.code, 1);
  for (const missing of MISSING) assert.match(alone.stderr, new RegExp(`error\\[R2W0513\\]:${missing.source}`));
  assert.match(alone.stderr, /error\[R2W0502\]: package `typo` does not compile: 'lidar\.h' file not found\n/);
  // A package of which something remains is packed without the program.
  const rest = await packedWith({ ...scan, ...HELLO }, '');
  assert.equal(rest.code, 0, rest.stderr);
  assert.match(rest.stderr, /warning\[R2W0522\]: [^\n]*`scan`/);
  for (const missing of MISSING) assert.match(rest.stderr, new RegExp(`warning\\[R2W0513\\]:${missing.source}`));
});
