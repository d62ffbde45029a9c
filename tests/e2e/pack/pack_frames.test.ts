// Libraries of Python nodes through pack and run: transforms, filters, YAML, messages as text, angles.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { played } from '../../support/nightly.ts';
import { PackWorkspace, finished } from '../support/pack_workspace.ts';

// Compatibility, works: `tf_transformations`, and transforms3d (Debian's 0.4, for numpy 2); held against each other in all 24 sequences of axes

// Compatibility, works: `scipy.spatial.transform`: `Rotation` and `Slerp`, held against transforms3d and tf_transformations

// Compatibility, differs: SciPy -> of its modules a site has `spatial.transform` alone, without `RotationSpline` and groups of symmetries

const PROGRAMS = ['drive', 'follow', 'wait', 'turns', 'rotations', 'scipy_rotations'];
const MANIFEST = `schema: 1
name: frames
distro: jazzy
packages: [src/*]
launch:
${PROGRAMS.map((program) => `  - {package: frames_py, executable: ${program}}`).join('\n')}
`;
const wanted = [
  /^\[drive-1\] .*\[driver\]: notes: It never turns\.$/,
  /^\[follow-2\] .*\[follower\]: at first: LookupException: "map" passed to lookupTransform argument target_frame does not exist\. $/,
  /^\[follow-2\] .*\[follower\]: awaited laser at height 0\.25$/,
  /^\[follow-2\] .*\[follower\]: the wall is at 10\.000 0\.25 of map True$/,
  /^\[follow-2\] .*\[follower\]: as text z: 0\.25\}$/,
  /^\[wait-3\] waited for map, 0\.25$/,
  /^\[wait-3\] in vain: "wheel" passed to lookupTransform argument source_frame does not exist\. $/,
  /^\[wait-3\] a later time is waited for True$/,
  /^\[wait-3\] frames \['Frame base exists with parent map\.', 'Frame laser exists with parent base\.'\]$/,
  /^\[turns-4\] 24 sequences of axes$/,
  /^\[turns-4\] matrices hold$/,
  /^\[turns-4\] map cloud \[\[1\.0, -2\.0, 100\.0\], \[10\.0, -20\.0, 70\.0\]\] \[1\.0, 2\.0, 0\.0\]$/,
  /^\[rotations-5\] 24 sequences agree$/,
  /^\[rotations-5\] two libraries agree$/,
  /^\[scipy_rotations-6\] 24 sequences of scipy agree$/,
  /^\[scipy_rotations-6\] three libraries agree$/,
];

let workspace: PackWorkspace;
let packed: Awaited<ReturnType<PackWorkspace['run']>>;
before(async () => {
  workspace = new PackWorkspace('shared');
  workspace.copyPackages('frames_py');
  workspace.write('workspace.yaml', MANIFEST);
  packed = await workspace.run(['pack']);
  assert.equal(packed.code, 0, packed.stderr);
});
after(() => workspace.close());

test('what Python imports comes along, also from packages of other names', () => {
  const fix = /= fix: add `(.*)` to package\.xml/.exec(packed.stderr)?.[1] ?? '';
  assert.deepEqual(fix.match(/(?<=<depend>)[^<]+/g)?.sort(), [
    'ament_index_python',
    'python3-numpy',
    'python3-scipy',
    'python3-transforms3d',
    'sensor_msgs_py',
    'std_msgs',
    'tf2_ros_py',
    'tf2_sensor_msgs',
  ]);
  const site = JSON.parse(workspace.read('site/site.json').toString()) as {
    readonly nodes: readonly { readonly id: string; readonly python: { readonly archives: readonly string[]; }; }[];
  };
  const withNumpy = site.nodes.filter((node) => node.python.archives.includes('python/numpy.zip')).map((node) => node.id);
  assert.deepEqual(withNumpy, ['turns-4', 'rotations-5', 'scipy_rotations-6']);
});

for (const link of played('port', 'shared')) {
  test(`they run on the ${link} link`, async () => {
    const child = workspace.start(['run', 'site', '--link', link, '--for', '180s']);
    let said = '';
    let stopped = false;
    child.stdout?.on('data', (bytes: Buffer) => {
      said += bytes.toString();
      const lines = said.split('\n');
      if (stopped || !wanted.every((line) => lines.some((one) => line.test(one)))) return;
      stopped = true; // once: another one is for who is in a hurry
      child.kill('SIGINT');
    });
    const ran = await finished(child);
    const lines = ran.stdout.split('\n');
    assert.deepEqual(wanted.filter((line) => !lines.some((one) => line.test(one))), [], `${ran.stderr}\n${ran.stdout.slice(-6000)}`);
    assert.equal(ran.code, 130, ran.stderr);
  });
}
