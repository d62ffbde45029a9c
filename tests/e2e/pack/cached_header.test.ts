// The header of rclcpp that is kept compiled: nobody can tell, but by the time.
import assert from 'node:assert/strict';
import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { nightlyTest } from '../../support/nightly.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const NODE = `#include "rclcpp/rclcpp.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("kept");
  RCLCPP_INFO(node->get_logger(), "in line %d of %s", __LINE__, __FILE__);
}
`;

let workspace: PackWorkspace;
before(() => {
  workspace = new PackWorkspace();
  const programs = { node: NODE, careful: `#define CAREFUL\n${NODE}` };
  workspace.addPackage('kept', programs, {
    depends: ['rclcpp'],
    cmake: 'find_package(rclcpp REQUIRED)\nament_target_dependencies(node rclcpp)\nament_target_dependencies(careful rclcpp)\n',
  });
  workspace.write('workspace.yaml', `schema: 1
name: kept
packages: [src/*]
launch:
  - {package: kept, executable: node}
  - {package: kept, executable: careful}
`);
});
after(() => workspace.close());

const plain = { CMAKE_CXX_COMPILER_LAUNCHER: '/usr/bin/env' };
const quick = { CMAKE_CXX_COMPILER_LAUNCHER: '' };

function keptHeaders(cache = 'cache'): string[] {
  const files = readdirSync(join(workspace.root, cache), { recursive: true, encoding: 'utf8' });
  return files.filter((file) => file.endsWith('.pch')).map((file) => join(workspace.root, cache, file));
}

async function pack(output: string, environment: Readonly<Record<string, string>>): Promise<void> {
  const packed = await workspace.run(['pack', '--quick', '--output', output], environment);
  assert.equal(packed.code, 0, packed.stderr);
}

test('programs are the same with the kept header and without', { timeout: 240_000 }, async () => {
  await pack('plain', { ...plain, XDG_CACHE_HOME: join(workspace.root, 'other_cache') });
  assert.deepEqual(keptHeaders('other_cache'), []);
  await pack('quick', quick);
  assert.equal(keptHeaders().length, 1);
  assert.deepEqual(workspace.files('quick/programs'), workspace.files('plain/programs'));
});

test('a mistake is told as the compiler tells it', { timeout: 240_000 }, async () => {
  workspace.write('src/kept/src/node.cpp', NODE.replace('make_shared', 'make_shard'));
  const failed = await workspace.run(['pack', '--quick', '--output', 'quick'], quick);
  assert.equal(failed.code, 1, failed.stderr);
  assert.match(failed.stderr, /R2W0502.*make_shard/);
  assert.match(failed.stderr, /src\/kept\/src\/node\.cpp:5:20/);
  assert.doesNotMatch(failed.stderr, /pch/);
});

nightlyTest('a kept header that is damaged does no harm and is made anew', { timeout: 240_000 }, async () => {
  const [header] = keptHeaders();
  writeFileSync(header!, 'not a header');
  workspace.write('src/kept/src/node.cpp', `${NODE}// once more\n`);
  await pack('quick', quick);
  assert.deepEqual(keptHeaders(), []);
  workspace.write('src/kept/src/node.cpp', `${NODE}// and again\n`);
  await pack('quick', quick);
  assert.equal(keptHeaders().length, 1);
});
