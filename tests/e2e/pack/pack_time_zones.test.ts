// Time zones of `zoneinfo`: the channel has them, and a site that imports the module carries them; others do not. Without such a channel
// the pack says so.

// Compatibility, works: `zoneinfo` with the time zones of Debian, in sites whose Python nodes import it

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

let workspace: PackWorkspace;

before(() => {
  workspace = new PackWorkspace('shared');
});

after(() => rmSync(workspace.root, { recursive: true }));

function write(tell: string): void {
  workspace.write('workspace.yaml', 'schema: 1\nname: lab\ndistro: jazzy\npackages: [src/*]\nlaunch:\n  - {package: clock_py, executable: tell}\n');
  workspace.addPythonPackage('clock_py', { tell });
}

test('a node knows the time of day of a city', { timeout: 300_000 }, async () => {
  write(`from datetime import datetime, timezone
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError, available_timezones


def main():
    print(datetime(2025, 7, 1, 12, tzinfo=timezone.utc).astimezone(ZoneInfo('Europe/Berlin')), ZoneInfo('UTC'), ZoneInfo('US/Pacific'))
    print(len(available_timezones()) > 400, 'posix/UTC' in available_timezones())
    try:
        ZoneInfo('Europe/Nowhere')
    except ZoneInfoNotFoundError as error:
        print(error)
`);
  const packed = await workspace.run(['pack', 'workspace.yaml']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.doesNotMatch(packed.stderr, /R2W0526/);
  const { stdout } = await workspace.run(['run', 'site']);
  assert.match(stdout, /2025-07-01 14:00:00\+02:00 UTC US\/Pacific\n.*True False\n.*'?No time zone found with key Europe\/Nowhere/);
});

test('who does not import it carries no time zones', { timeout: 300_000 }, async () => {
  write('import datetime\n\n\ndef main():\n    print(datetime.UTC)\n');
  const { code, stderr } = await workspace.run(['pack', 'workspace.yaml']);
  assert.equal(code, 0, stderr);
  assert.doesNotMatch(workspace.read('ros2wasm.lock').toString(), /tzdata/);
});

test('an import that a program can do without brings none, and the pack says what comes of it', { timeout: 300_000 }, async () => {
  write('def main():\n    from zoneinfo import ZoneInfo\n    print(ZoneInfo)\n');
  const { code, stderr } = await workspace.run(['pack', 'workspace.yaml', '--plan']);
  assert.equal(code, 0, stderr);
  assert.match(stderr, /warning\[R2W0526\]: `zoneinfo` can be imported, but does not work in a site\n --> src\/clock_py\/clock_py\/tell\.py:2:/);
});
