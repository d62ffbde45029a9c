// Figure panels of the page, with a program that speaks to them as the backend of matplotlib does: through the surfaces of
// ros2wasm_figures. The backend itself is tested with Debian's matplotlib (tests/figures).
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';
import { expectAccessible } from '../support/page_stage.ts';
import { shows, withTabs } from '../support/site_tabs.ts';

const watchdog = { timeout: 240_000 };
const OUTPUT = resolve(import.meta.dirname, '../../output');

const SKETCH = `import json

import rclpy
from ros2wasm.side_node import has_page
from ros2wasm_figures.surface import desk


def draw(surface, width, height):
    """Red on the left, blue on the right."""
    row = b'\\xc8\\x10\\x10\\xff' * (width // 2) + b'\\x10\\x10\\xc8\\xff' * (width - width // 2)
    surface.show(row * height, width, height)


def main():
    try:
        import tkinter
    except ImportError as error:
        print(error)
    print('page', has_page())
    # As figures are: before rclpy.init(), which is the program's own affair.
    surface = desk.open('figure_1')
    rclpy.init()
    node = rclpy.create_node('sketch')
    say = node.get_logger().info
    surface.tell(title='My sketch', tools=True, mode='none', back=False, forward=True, message='')
    draw(surface, 200, 100)
    while rclpy.ok():
        desk.wait(0.05)
        while surface.events:
            event = surface.events.popleft()
            if event.get('mouse') in ('move', 'enter', 'leave'):
                surface.tell(message=f'x={event["x"]}')
                continue
            say('heard ' + json.dumps(event))
            if event.get('tool') == 'zoom':
                surface.tell(mode='zoom', cursor='crosshair', rubberband=[50, 20, 150, 80])
            elif event.get('tool') == 'save':
                surface.give('../My sketch', b'a picture', 'png')
            elif 'size' in event:
                draw(surface, *event['size'])
            elif event.get('close'):
                surface.close()
                say('closed')
                return
`;

const workspace = new PackWorkspace();
after(() => workspace.close());

before(async () => {
  mkdirSync(OUTPUT, { recursive: true });
  workspace.write('src/art/package.xml', `<package format="3">
  <name>art</name>
  <version>1.0.0</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
  <depend>rclpy</depend>
  <depend>ros2wasm_figures</depend>
  <export><build_type>ament_python</build_type></export>
</package>
`);
  workspace.write('src/art/setup.py', `from setuptools import setup
setup(name='art', version='1.0.0', packages=['art'], entry_points={'console_scripts': ['sketch = art.sketch:main']})
`);
  workspace.write('src/art/setup.cfg', '[develop]\nscript_dir=$base/lib/art\n[install]\ninstall_scripts=$base/lib/art\n');
  workspace.write('src/art/art/__init__.py', '');
  workspace.write('src/art/art/sketch.py', SKETCH);
  workspace.write('workspace.yaml', 'schema: 1\nname: art\npackages: [src/*]\nlaunch:\n  - {package: art, executable: sketch}\n');
  const packed = await workspace.run(['pack', '--offline']);
  assert.equal(packed.code, 0, packed.stderr);
});

test('a program knows that a headless run has no page', watchdog, async () => {
  const ran = await workspace.run(['run', 'site', '--for', '60s', '--until', 'page False']);
  assert.equal(ran.code, 0, ran.stderr);
  assert.match(ran.stdout, /No module named 'tkinter': a page has no windows for it\. Pictures are shown by cv2\.imshow, matplotlib/);
});

// Compatibility, works: Python: a Figure panel for each figure: picture, title, toolbar, mouse, keys, files to save; closing
// the panel closes the figure
test('a figure opens a panel, and what a visitor does there comes to the program', watchdog, async () => {
  const browser = await chromium.launch(chromiumOptions());
  try {
    await withTabs(browser, join(workspace.root, 'site'), 'shared', async (open) => {
      const page = await open('');
      page.setDefaultTimeout(60_000);
      const panel = page.locator('.panel-figure');
      const canvas = panel.getByRole('img', { name: 'My sketch' });
      await canvas.waitFor();
      await panel.getByText('My sketch').first().waitFor();
      const colours = () =>
        canvas.evaluate((element: HTMLCanvasElement) => {
          const context = element.getContext('2d')!;
          return [element.width, element.height, ...context.getImageData(0, 0, 1, 1).data,
            ...context.getImageData(element.width - 1, element.height - 1, 1, 1).data];
        });
      assert.deepEqual(await colours(), [200, 100, 200, 16, 16, 255, 16, 16, 200, 255]);

      const view = panel.getByRole('application');
      const box = (await view.boundingBox())!;
      await page.mouse.move(Math.floor(box.x + box.width / 2 - 60), Math.floor(box.y + box.height / 2 + 20));
      await panel.locator('.figure-message', { hasText: 'x=40' }).waitFor();
      await page.mouse.down();
      await page.mouse.up();
      await page.mouse.wheel(0, 100);
      await view.press('Control+ArrowLeft');
      await panel.getByRole('button', { name: 'Zoom to a rectangle' }).click();
      await panel.getByRole('button', { name: 'Zoom to a rectangle', pressed: true }).waitFor();
      assert.equal(await panel.getByRole('button', { name: 'Previous view' }).getAttribute('aria-disabled'), 'true');
      const band = (await panel.locator('.figure-band').boundingBox())!;
      assert.deepEqual([band.width, band.height, Math.round(band.x + 50 - box.x - box.width / 2)], [100, 60, 0]);
      const saved = page.waitForEvent('download');
      await panel.getByRole('button', { name: 'Save the figure' }).click();
      const file = await saved;
      assert.equal(file.suggestedFilename(), '_My sketch.png');
      assert.equal(readFileSync(await file.path(), 'utf8'), 'a picture');
      await panel.getByRole('button', { name: 'as large as the panel' }).click();
      await page.waitForFunction((width) => document.querySelector<HTMLCanvasElement>('.figure-canvas')!.width === width, Math.round(box.width));
      await expectAccessible(page);
      await page.screenshot({ path: join(OUTPUT, 'figure_panel.png') });

      await page.getByRole('button', { name: 'Close Figure' }).click();
      await page.getByRole('menuitem', { name: 'Close Figure' }).click();
      await page.locator('.panel-nodes').getByText('Finished, code 0').waitFor();
      await page.getByRole('tab', { name: 'Consoles' }).click();
      await shows(page, 'closed');
      const text = await page.locator('.panel-console').innerText();
      const heard = [...text.matchAll(/heard (\{.*\})/g)].map(([, event]) => JSON.parse(event!) as Readonly<Record<string, unknown>>);
      const place = { x: 40, y: 70, modifiers: [] };
      assert.deepEqual(heard.filter((event) => event['size'] === undefined), [
        { mouse: 'press', ...place, button: 0, double: false },
        { mouse: 'release', ...place, button: 0 },
        { mouse: 'scroll', ...place, step: -1 },
        { key: 'press', name: 'Control', modifiers: ['ctrl'] },
        { key: 'press', name: 'ArrowLeft', modifiers: ['ctrl'] },
        { key: 'release', name: 'ArrowLeft', modifiers: ['ctrl'] },
        { key: 'release', name: 'Control', modifiers: [] },
        { tool: 'zoom' },
        { tool: 'save' },
        { close: true },
      ]);
      assert.deepEqual(heard.find((event) => event['size'] !== undefined), { size: [Math.round(box.width), Math.round(box.height)] });
    });
  } finally {
    await browser.close();
  }
});
