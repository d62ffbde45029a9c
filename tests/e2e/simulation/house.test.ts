// Example 08, packed: its checks, a way around the house along its walls by the lidar, and one around the line by the camera, all
// without a browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { packExample } from '../support/example_site.ts';
import { Scratch, runCli } from '../support/served_site.ts';

const EXAMPLE = fileURLToPath(new URL('../../../examples/08_house', import.meta.url));
const watchdog = { timeout: 300_000 };
const scratch = new Scratch();
let site: string;

before(async () => {
  site = await packExample(scratch, '08_house');
}, watchdog);
after(() => scratch[Symbol.dispose]());

/** How long a node says that its way around was. */
const metres = (output: string): number => Number(/once around: ([\d.]+) m/.exec(output)?.[1] ?? assert.fail(output));

test('its checks pass', watchdog, async () => {
  const run = await runCli(['run', site, '--stepped', '--checks']);
  assert.equal(run.code, 0, run.output + run.errors);
  assert.match(run.output + run.errors, /3 of 3 checks passed/);
  let rest = run.output;
  for (const line of readFileSync(join(EXAMPLE, 'expected.txt'), 'utf8').trimEnd().split('\n')) {
    const found = new RegExp(line).exec(rest);
    assert.ok(found, `${line} not in\n${rest}`);
    rest = rest.slice(found.index);
  }
});

test('it goes around both rooms along their walls', watchdog, async () => {
  const run = await runCli(['run', site, 'wall:=true', '--stepped', '--for', '250s', '--until', 'once around']);
  assert.equal(run.code, 0, run.output + run.errors);
  // The rooms have 28 m of walls, furniture not counted, and it stays half a metre away from them.
  const way = metres(run.output);
  assert.ok(way > 25 && way < 40, String(way));
});

test('it goes around the line that its camera sees', watchdog, async () => {
  const run = await runCli(['run', site, 'line:=true', 'x:=2.0', 'y:=-1.7', '--stepped', '--for', '120s', '--until', 'once around']);
  assert.equal(run.code, 0, run.output + run.errors);
  // An ellipse with half axes of 1.25 and 1.7 m has 9.3 m.
  const way = metres(run.output);
  assert.ok(Math.abs(way - 9.3) < 0.6, String(way));
});
