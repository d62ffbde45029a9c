// The interface definitions say what ROS 2 Jazzy's say: same constants, fields, defaults and order.

// Compatibility, works: all 692 interface definitions, CDR as on the wire of ROS 2, type hashes
// (RIHS01)

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, test } from 'node:test';

import { parse as parseWithFoxglove } from '@foxglove/rosmsg';

import { isPrimitive, parseInterface, typeParts } from './definition_parser.ts';
import type { Section } from './definition_parser.ts';
import { REPOSITORY, interfaceFiles } from './interface_files.ts';

// Digests of definitions in normal form, taken once from facts about upstream's packages.
const DIGESTS = {
  'ROS 2': { count: 233, digest: 'a279b66321a7604046d056aa78df0a565fec5a040d367bdc052c3a714192c342' },
  'packages that many use with it': { count: 459, digest: 'e968bde6dc9853a8dc9200438609e25efe566579429070749ee2da906304ddd0' },
} as const;
const USED_WITH_IT = new Set([
  'ackermann_msgs',
  'action_tutorials_interfaces',
  'apriltag_msgs',
  'bond',
  'can_msgs',
  'control_msgs',
  'controller_manager_msgs',
  'dwb_msgs',
  'gazebo_msgs',
  'geographic_msgs',
  'gps_msgs',
  'irobot_create_msgs',
  'map_msgs',
  'moveit_msgs',
  'nav2_msgs',
  'nav_2d_msgs',
  'object_recognition_msgs',
  'octomap_msgs',
  'pal_statistics_msgs',
  'pcl_msgs',
  'ros_gz_interfaces',
  'rosbag2_interfaces',
  'simulation_interfaces',
  'test_msgs',
  'topic_tools_interfaces',
  'turtlebot3_msgs',
  'vision_msgs',
]);

interface NormalSection {
  readonly constants: readonly (readonly string[])[];
  readonly fields: readonly (readonly string[])[];
}
type NormalForm = Record<string, NormalSection | Record<string, NormalSection>>;

function normalSection(section: Section): NormalSection {
  return {
    constants: section.constants.map((c) => [c.type, c.name, c.value]),
    fields: section.fields.map((f) => f.defaultValue === undefined ? [f.type, f.name] : [f.type, f.name, f.defaultValue]),
  };
}

const files = interfaceFiles();
const normal: NormalForm = {};
for (const file of files) {
  const sections = [...parseInterface(file.kind, file.text)].map(
    ([name, section]) => [name, normalSection(section)] as const,
  );
  const first = sections[0];
  assert.ok(first !== undefined);
  normal[file.type] = file.kind === 'msg' ? first[1] : Object.fromEntries(sections);
}

describe('interface definitions', () => {
  for (const [whose, { count, digest }] of Object.entries(DIGESTS)) {
    test(`those of ${whose} are the ones that the digest was made of`, () => {
      const chosen = Object.entries(normal).filter(([type]) => USED_WITH_IT.has(type.split('/')[0] ?? '') === (whose !== 'ROS 2'));
      assert.equal(chosen.length, count);
      const found = createHash('sha256').update(JSON.stringify(Object.fromEntries(chosen))).digest('hex');
      assert.equal(found, digest, 'a constant, field, default or the order of some differs');
    });
  }

  test('each begins with its purpose', () => {
    for (const file of files) assert.match(file.text, /^# \S.*[.:]?\n/, file.type);
  });

  test('each refers to types that exist, in packages that its package.xml and CMakeLists.txt name', () => {
    const known = new Set(files.map((file) => file.type));
    for (const file of files) {
      const folder = join(REPOSITORY, 'runtime/packages/interfaces', file.package);
      const manifest = readFileSync(join(folder, 'package.xml'), 'utf8');
      const recipe = readFileSync(join(folder, 'CMakeLists.txt'), 'utf8');
      assert.ok(recipe.includes(`"${file.kind}/${file.name}.${file.kind}"`), `${file.type} is not built`);
      if (file.kind === 'action') assert.ok(manifest.includes('<depend>action_msgs</depend>'), `${file.package} has actions`);
      for (const section of parseInterface(file.kind, file.text).values()) {
        for (const field of section.fields) {
          const { base } = typeParts(field.type);
          if (isPrimitive(base)) continue;
          const [pkg, name] = base.includes('/') ? base.split('/') : [file.package, base];
          assert.ok(known.has(`${pkg}/msg/${name}`), `${file.type}: ${field.type}`);
          if (pkg === file.package) continue;
          assert.ok(manifest.includes(`<depend>${pkg}</depend>`), `${file.package} needs ${pkg}`);
          assert.ok(recipe.includes(`find_package(${pkg} REQUIRED)`), `${file.package} needs ${pkg}`);
        }
      }
    }
  });

  test('viewers read them the same way', () => {
    for (const file of files) {
      for (const [name, section] of parseInterface(file.kind, file.text)) {
        const texts = file.text.split(/^---$/m);
        const index = [...parseInterface(file.kind, file.text).keys()].indexOf(name);
        const theirs = parseWithFoxglove(texts[index] ?? '', { ros2: true, skipTypeFixup: true });
        const fields = theirs[0]?.definitions ?? [];
        assert.deepEqual(
          fields.filter((field) => field.isConstant !== true).map((field) => field.name),
          section.fields.map((field) => field.name),
          file.type,
        );
        assert.deepEqual(
          fields.filter((field) => field.isConstant === true).map((field) => field.name),
          section.constants.map((constant) => constant.name),
          file.type,
        );
      }
    }
  });
});

describe('versions', () => {
  const versions = JSON.parse(readFileSync(join(REPOSITORY, 'runtime', 'versions.json'), 'utf8')) as {
    packages: Record<string, { version: string; }>;
  };

  test('every interface package has the version that versions.json names', () => {
    for (const pkg of new Set(files.map((file) => file.package))) {
      const manifest = readFileSync(join(REPOSITORY, 'runtime/packages/interfaces', pkg, 'package.xml'), 'utf8');
      assert.equal(/<version>(.*)<\/version>/.exec(manifest)?.[1], versions.packages[pkg]?.version, pkg);
    }
  });
});
