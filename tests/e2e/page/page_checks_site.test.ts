// Checks of parameters on a packed site with a C++ node and a Python node: in Chromium on both links, and in a run
// without a browser. One of them is not met and says what the parameter is.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { played } from '../../support/nightly.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
/** Checks that pass: the check, its words on the page, and the value that is seen. */
const met: readonly (readonly [check: string, words: string, seen: string])[] = [
  ['{node: /robot, parameter: speed, equals: 1.5}', '/robot: parameter speed is 1.5', '1.5'],
  ['{node: /robot, parameter: speed, above: 1, below: 2}', '/robot: parameter speed is above 1 and below 2', '1.5'],
  ['{node: /robot, parameter: label, equals: blue}', '/robot: parameter label is \u2018blue\u2019', '\u2018blue\u2019'],
  ["{node: /robot, parameter: label, matches: '^bl'}", '/robot: parameter label is like /^bl/', '\u2018blue\u2019'],
  ["{node: /robot, parameter: arm.lengths, equals: '[1.0, 0.5]'}", '/robot: parameter arm.lengths is \u2018[1.0, 0.5]\u2019', '\u2018[1.0, 0.5]\u2019'],
  ['{node: /robot, parameter: arm.joints, matches: elbow}', '/robot: parameter arm.joints is like /elbow/', '\u2018[base, elbow]\u2019'],
  ['{node: /tuned, parameter: gain, equals: 3}', '/tuned: parameter gain is 3', '3'],
  ['{node: /tuned, parameter: gain, above: 2, below: 10}', '/tuned: parameter gain is above 2 and below 10', '3'],
  ['{node: /tuned, parameter: active, equals: true}', '/tuned: parameter active is true', 'true'],
  ["{node: /tuned, parameter: steps, equals: '[4, -5]'}", '/tuned: parameter steps is \u2018[4, -5]\u2019', '\u2018[4, -5]\u2019'],
  ["{node: /tuned, parameter: flags, equals: '[true, false]'}", '/tuned: parameter flags is \u2018[true, false]\u2019', '\u2018[true, false]\u2019'],
  ["{node: /tuned, parameter: raw, equals: '[1, 255]'}", '/tuned: parameter raw is \u2018[1, 255]\u2019', '\u2018[1, 255]\u2019'],
];

const packed = packedInBrowser((workspace) => {
  workspace.copyPackages('command_robot');
  workspace.addPythonPackage('tuned_py', {
    tuned: `import rclpy
from rclpy.node import Node


def main():
    rclpy.init()
    node = Node('tuned')
    node.declare_parameter('gain', 3)
    node.declare_parameter('active', True)
    node.declare_parameter('steps', [4, -5])
    node.declare_parameter('flags', [True, False])
    node.declare_parameter('raw', [b'\\x01', b'\\xff'])
    rclpy.spin(node)
`,
  });
  workspace.write('workspace.yaml', `schema: 1
name: parameters
packages: [src/*]
launch:
  - {package: command_robot, executable: robot}
  - {package: tuned_py, executable: tuned}
checks:
${met.map(([check]) => `  - ${check.slice(0, -1)}, within: 5 m}\n`).join('')}\
  - {node: /robot, parameter: label, equals: green, within: 15 s}
  - {node: /robot, parameter: colour, equals: green, within: 15 s}
ui: {layout: checks}
`);
});

for (const link of played('port', 'shared')) {
  test(`${link}: parameters of all types turn their checks green, and a wrong value is shown`, watchdog, () =>
    withTabs(packed.browser, packed.site, link, async (open) => {
      const page = await open('');
      page.setDefaultTimeout(300_000);
      await page.getByText(`${met.length} of ${met.length + 2} checks passed`).waitFor();
      const row = (words: string): Promise<string> =>
        page.locator('.check-row').filter({ hasText: words }).innerText();
      for (const [, words, seen] of met) {
        const text = await row(words);
        assert.match(text, /\bSeen\s+after /, text);
        assert.ok(text.includes(`Seen: ${seen}`), text);
      }
      await page.locator('.check-row').filter({ hasText: 'label is \u2018green\u2019' }).getByText('Not seen within 15 s').waitFor();
      assert.match(await row('label is \u2018green\u2019'), /Seen: \u2018blue\u2019/);
      await page.locator('.check-row').filter({ hasText: 'colour is' }).getByText('Not seen within 15 s').waitFor();
      assert.match(await row('colour is'), /Seen: the node has no such parameter/);
    }));
}

test('a run without a browser says the same, and ends with 1', watchdog, async () => {
  const { code, stderr } = await packed.workspace.run(['run', 'site', '--checks']);
  assert.equal(code, 1, stderr);
  for (const [, words, seen] of met) assert.ok(stderr.includes(`[check] passed: ${words} (${seen})`), `${words}\n${stderr}`);
  assert.match(stderr, /failed: \/robot: parameter label is \u2018green\u2019\n.*\n? *= seen: \u2018blue\u2019/);
  assert.match(stderr, /= seen: the node has no such parameter/);
  assert.ok(stderr.includes(`${met.length} of ${met.length + 2} checks passed`), stderr);
});
