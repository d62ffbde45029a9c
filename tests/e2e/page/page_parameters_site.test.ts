// The panel of parameters on a packed site with a C++ node and a Python node, in Chromium on both links: values, ranges,
// refusals of both, what the terminal sets, and a node that is stopped and started.

// Compatibility, works: parameters of C++ and Python nodes shown and set on the page, with types, ranges, descriptions and
// the node's refusal

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { packedInBrowser } from '../support/packed_in_browser.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 400_000 };
const packed = packedInBrowser((workspace) => {
  workspace.copyPackages('command_robot');
  workspace.addPythonPackage('tuned_py', {
    tuned: `import rclpy
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.node import Node


class Tuned(Node):

    def __init__(self):
        super().__init__('tuned')
        limits = IntegerRange(from_value=0, to_value=10, step=1)
        self.declare_parameter('gain', 3, ParameterDescriptor(description='Gain of the loop', integer_range=[limits]))
        self.declare_parameter('names', ['left', 'right'])
        self.declare_parameter('serial', 'A7', ParameterDescriptor(read_only=True))
        self.add_on_set_parameters_callback(self.check)

    def check(self, parameters):
        for parameter in parameters:
            if parameter.name == 'gain' and parameter.value == 7:
                return SetParametersResult(successful=False, reason='seven is taken')
        return SetParametersResult(successful=True)


def main():
    rclpy.init()
    rclpy.spin(Tuned())
`,
  });
  workspace.write('workspace.yaml', `schema: 1
name: parameters
packages: [src/*]
launch:
  - {package: command_robot, executable: robot}
  - {package: tuned_py, executable: tuned}
`);
});

const says = (page: Page, label: string, text: string): Promise<unknown> =>
  page.waitForFunction(
    ([of, wanted]) => document.querySelector<HTMLInputElement>(`input[type="text"][aria-label="${of}"]`)?.value === wanted,
    [label, text] as const,
    { timeout: 120_000 },
  );

for (const link of played('port', 'shared')) {
  test(`${link}: parameters of a C++ and a Python node`, watchdog, () =>
    withTabs(packed.browser, packed.site, link, async (open) => {
      const layout = { row: [{ column: ['nodes', 'terminal'] }, 'parameters'] };
      const page = await open(`#layout=${encodeURIComponent(JSON.stringify(layout))}`);
      page.setDefaultTimeout(120_000);
      const set = async (label: string, text: string): Promise<void> => {
        const field = page.getByRole('textbox', { name: label, exact: true });
        await field.fill(text);
        await field.press('Enter');
      };
      await says(page, 'speed of /robot', '1.5');
      await says(page, 'gain of /tuned', '3');
      await says(page, 'arm.lengths of /robot', '[1.0, 0.5]');
      await says(page, 'names of /tuned', '["left", "right"]');
      await shows(page, 'How fast it may go');
      await shows(page, 'from 0.0 to 2.0');
      await shows(page, 'Gain of the loop');
      await set('speed of /robot', '9');
      await shows(page, 'The node refused 9.0: ');
      await says(page, 'speed of /robot', '1.5');
      await set('gain of /tuned', '7');
      await shows(page, 'The node refused 7: seven is taken');
      await says(page, 'gain of /tuned', '3');
      await set('gain of /tuned', '8');
      await says(page, 'gain of /tuned', '8');
      const slider = page.getByRole('slider', { name: 'gain of /tuned' });
      await slider.focus();
      await page.keyboard.press('ArrowRight');
      await says(page, 'gain of /tuned', '9');
      assert.equal(await page.getByRole('textbox', { name: 'serial of /tuned' }).getAttribute('readonly'), '');
      // The panel follows values that others set, and others see values that are set here.
      const type = async (line: string): Promise<void> => {
        await page.waitForSelector('.terminal-input input:not([readonly])');
        await page.locator('.terminal-input input').fill(line);
        await page.locator('.terminal-input input').press('Enter');
      };
      await type('ros2 param set /robot label green');
      await says(page, 'label of /robot', 'green');
      await type('ros2 param get /tuned gain');
      await shows(page, 'Integer value is: 9');
      // A node that is started again says what it has then.
      await page.getByRole('button', { name: 'Stop robot', exact: true }).click();
      await shows(page, 'has gone; the last known values');
      await says(page, 'label of /robot', 'green');
      await page.getByRole('button', { name: 'Start robot', exact: true }).click();
      await says(page, 'label of /robot', 'blue');
    }));
}
