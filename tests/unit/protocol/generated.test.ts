// The generated constants are those of constants.json, in all three languages.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { BusEndpoint, BusSizes, EndpointDescLayout, SampleInfoLayout } from '../../../runtime/protocol/generated/constants.ts';

test('the generated files are current', () => {
  const script = fileURLToPath(new URL('../../../runtime/protocol/generate.mjs', import.meta.url));
  const { status, stderr } = spawnSync(process.execPath, [script, '--check'], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
});

test('layouts have the sizes that the specification names', () => {
  assert.equal(SampleInfoLayout.size, 64);
  assert.equal(EndpointDescLayout.size, 112);
  // Strings of an endpoint end before its slot does; the cursor pairs end before the strings.
  assert.ok(BusEndpoint.hashBytes + 80 <= BusSizes.endpoint);
  assert.ok(4 * (BusEndpoint.inlineTable + 2 * BusEndpoint.inlineEntries) <= BusEndpoint.nameBytes);
  assert.equal(BusSizes.endpoint % 64, 0);
});
