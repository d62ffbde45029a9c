// The commands that launch files start: the same ones here and where the site is packed.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { commands } from '../../../runtime/site/ros2cli/table.ts';

test('ros2_command.cpp knows those of two words', () => {
  const text = readFileSync(join(import.meta.dirname, '../../../bundler/launch/ros2_command.cpp'), 'utf8');
  const [, table = ''] = /kRos2Verbs\[\] = \{([^;]*)\};/.exec(text) ?? [];
  const packed = [...table.matchAll(/\{"(\w+)", "(\w+)"\}/g)].map(([, group, verb]) => `${group} ${verb}`);
  assert.deepEqual(packed, commands.filter(({ words }) => words.length === 2).map(({ words }) => words.join(' ')).sort());
});
