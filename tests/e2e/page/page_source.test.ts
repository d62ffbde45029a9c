// Sources of Python nodes in Chromium, on a real site: read, changed, applied by a restart, kept over a reload, reset;
// tracebacks that lead there; on both links.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, chromium, type Page } from 'playwright-core';
import { played } from '../../support/nightly.ts';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { expectAccessible } from '../support/page_stage.ts';
import { makeSite } from '../support/runtime_site.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const watchdog = { timeout: 240_000 };
const sitePackages = 'lib/python3.12/site-packages';
const words = 'def greeting():\n    return "packed words"\n';
const talk = `import rclpy
from std_msgs.msg import String
from lab_py.words import greeting


def main():
    rclpy.init()
    node = rclpy.create_node('talker')
    out = node.create_publisher(String, 'chatter', 10)
    node.create_timer(0.2, lambda: out.publish(String(data=greeting())))
    rclpy.spin(node)


main()
`;
const hear = `import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('listener')
node.get_logger().info('all ears')
node.create_subscription(String, 'chatter', lambda message: print('heard', message.data), 10)
rclpy.spin(node)
`;
const files: readonly (readonly [installed: string, file: string, text: string])[] = [
  [`${sitePackages}/lab_py/words.py`, 'src/lab_py/lab_py/words.py', words],
  ['lib/lab_py/talk.py', 'src/lab_py/scripts/talk.py', talk],
  ['lib/lab_py/hear.py', 'src/lab_py/scripts/hear.py', hear],
  ['lib/lab_py/odd.py', 'src/<img src=x onerror="document.title=\'owned\'">/o"dd.py', '# </style><script>document.title = "owned"</script>\n'],
];
let installed = '';
let site = '';
let browser: Browser | undefined;
const hosts: StaticServer[] = [];

before(async () => {
  installed = mkdtempSync(join(tmpdir(), 'ros2wasm-lab-'));
  for (const [path, , text] of files) {
    mkdirSync(dirname(join(installed, path)), { recursive: true });
    writeFileSync(join(installed, path), text);
  }
  const interfaces = {
    'builtin_interfaces/msg/Time': 'int32 sec\nuint32 nanosec\n',
    'std_msgs/msg/String': 'string data\n',
    'rcl_interfaces/msg/Log': 'builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\nstring function\nuint32 line\n',
  };
  site = makeSite([], { 'interfaces.json': JSON.stringify(interfaces) }, {}, {
    nodes: ['talk', 'hear'].map((name) => ({ entry: `lib/lab_py/${name}.py`, executable: name })),
    packages: { [join(installed, 'lib')]: 'lib' },
    sources: files.map(([path, file, text]) => ({ path, file, sha256: createHash('sha256').update(text).digest('hex') })),
  });
  browser = await chromium.launch(chromiumOptions());
  mkdirSync(OUTPUT, { recursive: true });
});

after(async () => {
  await browser?.close();
  for (const host of hosts) await host.close();
  for (const folder of [installed, site]) if (folder !== '') rmSync(folder, { recursive: true });
});

/** A visit that fails on any complaint of the browser, its policy's too. */
async function visit(isolated: boolean, state: object, use: (page: Page, address: string) => Promise<void>, below: unknown = 'console'): Promise<void> {
  assert.ok(browser);
  const host = await serveFolder(site, { isolated });
  hosts.push(host);
  const context = await browser.newContext({
    serviceWorkers: 'block',
    viewport: { width: 1280, height: 800 },
    permissions: ['clipboard-read', 'clipboard-write'],
  });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(100_000);
    const troubles: string[] = [];
    page.on('console', (message) => {
      if (/^(error|warning)$/.test(message.type()) && !message.text().startsWith('Service Worker registration blocked')) troubles.push(message.text());
    });
    page.on('pageerror', (error) => troubles.push(error.message));
    const layout = { row: ['nodes', { column: [{ source: state }, below] }], sizes: [1, 3] };
    const address = `${host.url}#layout=${encodeURIComponent(JSON.stringify(layout))}`;
    await page.goto(address);
    await use(page, address);
    assert.deepEqual(troubles, []);
    assert.notEqual(await page.title(), 'owned');
  } finally {
    await context.close();
  }
}

const consoleOf = (page: Page, name: string) => page.getByRole('log', { name: new RegExp(name) });
const editorOf = (page: Page) => page.getByRole('textbox', { name: /^Source of/ });

/** Types over the whole text. */
async function write(page: Page, text: string): Promise<void> {
  await editorOf(page).click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

for (const [link, isolated] of played(['shared', true], ['port', false])) {
  // Compatibility, works: the source of a Python node is changed in the page and runs at once, is kept by the browser, and reset
  test(`what is changed is what runs, until it is reset, ${link} link`, watchdog, () =>
    visit(isolated, { file: 'words.py' }, async (page) => {
      await consoleOf(page, 'hear').getByText('heard packed words').first().waitFor();
      await editorOf(page).getByText('packed words').waitFor();
      await page.getByText('/talk runs it as packed.').waitFor();
      await write(page, words.replace('packed', 'my own'));
      await page.keyboard.press('Control+s');
      await consoleOf(page, 'hear').getByText('heard my own words').first().waitFor();
      await page.getByText('/talk runs it changed.').waitFor();
      const badge = page.getByRole('button', { name: 'changed', exact: true });
      assert.match(await badge.getAttribute('title') ?? '', /src\/lab_py\/lab_py\/words\.py$/);
      assert.equal(await badge.count(), 1);

      // A mistake is marked at its line, and said below the editor with what the node printed, until it is mended.
      await write(page, `${words}\n\ndef broken(:\n    pass\n`);
      await page.keyboard.press('Control+s');
      await page.locator('.source-trouble').getByText(/^\/talk, line 5: SyntaxError/).waitFor();
      assert.match(await page.locator('.source-editor .cm-trouble').innerText(), /def broken/);
      assert.match(await page.locator('.source-output').innerText(), /SyntaxError/);
      await expectAccessible(page);
      if (isolated) await page.screenshot({ path: join(OUTPUT, 'source_trouble.png') });
      await write(page, words.replace('packed', 'my own'));
      await page.keyboard.press('Control+s');
      await page.locator('.source-trouble').waitFor({ state: 'detached' });
      await page.getByText('/talk runs it changed.').waitFor();

      await page.reload();
      await consoleOf(page, 'hear').getByText('heard my own words').first().waitFor();
      assert.equal(await consoleOf(page, 'hear').getByText('heard packed words').count(), 0);
      await editorOf(page).getByText('my own words').waitFor();
      await page.getByRole('button', { name: 'Copy as patch' }).click();
      assert.equal(await page.evaluate(() => navigator.clipboard.readText()), [
        '--- a/src/lab_py/lab_py/words.py',
        '+++ b/src/lab_py/lab_py/words.py',
        '@@ -1,2 +1,2 @@',
        ' def greeting():',
        '-    return "packed words"',
        '+    return "my own words"',
        '',
      ].join('\n'));
      await page.getByRole('button', { name: 'About this page', exact: true }).click();
      await page.getByRole('button', { name: 'report' }).click();
      const hash = (text: string): string => createHash('sha256').update(text).digest('hex');
      const report = await page.evaluate(() => navigator.clipboard.readText());
      assert.ok(
        report.includes(`changed sources:\n  src/lab_py/lab_py/words.py: packed sha256 ${hash(words)}, here ${hash(words.replace('packed', 'my own'))}\n`),
        report,
      );
      await page.keyboard.press('Escape');

      await page.getByRole('button', { name: 'Reset' }).click();
      await page.getByText('/talk runs it as packed.').waitFor();
      await page.waitForFunction(() => (document.querySelector('[aria-label*="hear"][role="log"]')?.textContent ?? '').endsWith('heard packed words'));
      assert.equal(await badge.count(), 0);

      // A refused text is not applied, and can be reset.
      await write(page, `#${'x'.repeat(200_000)}`);
      await page.keyboard.press('Control+s');
      await page.getByText('This is more than the browser keeps of a site').first().waitFor();
      assert.equal(await page.getByText('Restarted:').count(), 0);
      await page.getByRole('button', { name: 'Reset' }).click();
      await editorOf(page).getByText('packed words').waitFor();
      await page.locator('button[aria-disabled=true]', { hasText: 'Reset' }).waitFor();
    }));
}

// Compatibility, works: a place in a Python traceback in a console leads to its line of the source
test('an error shows as natively, its place leads to the line, and the mended file starts the node again', watchdog,
  () =>
    visit(true, { file: 'talk.py' }, async (page) => {
      await consoleOf(page, 'hear').getByText('heard packed words').first().waitFor();
      await page.getByRole('combobox', { name: 'File' }).selectOption('src/lab_py/lab_py/words.py');
      await editorOf(page).getByText('packed words').waitFor();
      await write(page, 'def greeting()\n    return 1\n');
      await page.getByRole('button', { name: 'Apply and restart' }).click();
      const talk = consoleOf(page, 'talk');
      await talk.getByText("SyntaxError: expected ':'").waitFor();
      await talk.getByText(/^ +def greeting\(\)$/).waitFor();
      // The other file of the traceback.
      await talk.getByRole('button', { name: 'File "/ros/lib/lab_py/talk.py", line 3' }).click();
      await page.getByRole('textbox', { name: 'Source of src/lab_py/scripts/talk.py' }).waitFor();
      await page.waitForFunction(() => {
        const root = document.querySelector('.source-editor')?.shadowRoot;
        return root?.activeElement !== null && root?.querySelector('.cm-activeLine')?.textContent === 'from lab_py.words import greeting';
      });
      await talk.getByRole('button', { name: /words\.py", line 1$/ }).click();
      await page.getByRole('textbox', { name: /words\.py/ }).waitFor();
      await write(page, words.replace('packed', 'mended'));
      await page.keyboard.press('Control+s');
      await consoleOf(page, 'hear').getByText('heard mended words').first().waitFor();
      // An exception while it runs.
      await write(page, 'def greeting():\n    return 1 / 0\n');
      await page.keyboard.press('Control+s');
      await talk.getByText('ZeroDivisionError: division by zero').waitFor();
      await talk.getByRole('button', { name: /words\.py", line 2$/ }).click();
      await page.screenshot({ path: join(OUTPUT, 'source_traceback.png') });
    }));

test('a line of /rosout leads to where it was logged', watchdog, () =>
  visit(true, { file: 'talk.py' }, async (page) => {
    const log = page.getByRole('log', { name: 'Log' });
    await log.getByText(/^\[INFO\] \[\d+\.\d{9}\] \[listener\]: all ears {2}\[File .*\.py", line 6, in <module>\]$/).waitFor();
    await log.getByRole('button', { name: 'File "/ros/lib/lab_py/hear.py", line 6' }).click();
    await page.getByRole('textbox', { name: 'Source of src/lab_py/scripts/hear.py' }).waitFor();
    await page.waitForFunction(() => document.querySelector('.source-editor')?.shadowRoot?.querySelector('.cm-activeLine')?.textContent.includes('all ears'));
    await page.screenshot({ path: join(OUTPUT, 'log_places.png') });
  }, { log: { places: 'shown' } }));

test('keyboard, hostile names, links, a narrow page, axe-core in both themes', watchdog,
  () =>
    visit(true, { file: 'src/no/such.py' }, async (page, address) => {
      await page.getByText('This site has no source src/no/such.py.').waitFor();
      await page.getByRole('combobox', { name: 'File' }).selectOption(files[3]?.[1] ?? '');
      await editorOf(page).getByText('</style><script>').waitFor();
      await write(page, 'print("<b>")\n');
      await page.getByText('Changed.').waitFor();
      await page.getByText('No node has read this file.').waitFor();
      // Tab indents, and does not trap.
      await page.keyboard.press('Tab');
      await page.keyboard.press('Escape');
      await page.keyboard.press('Tab');
      await page.waitForFunction(() => document.activeElement?.classList.contains('source-editor') === false);
      // The search covers all files, and changed ones in their current form.
      const search = page.getByRole('searchbox', { name: 'Search all files' });
      const hits = page.getByRole('group', { name: 'Lines that have the text' });
      await search.fill('print(');
      await hits.getByText('2 lines have it.').waitFor();
      await hits.getByText('print("<b>")').waitFor();
      await search.fill('create_publisher');
      await hits.getByText('1 line has it.').waitFor();
      await hits.getByRole('button', { name: 'src/lab_py/scripts/talk.py:9' }).click();
      await page.waitForFunction(() => document.querySelector<HTMLSelectElement>('.panel-source select')?.value.endsWith('talk.py'));
      await editorOf(page).getByText('create_publisher').waitFor();
      await search.fill('nowhere to be found');
      await hits.getByText('No file has this text.').waitFor();
      await search.fill('print(');
      await page.getByRole('combobox', { name: 'File' }).selectOption(files[3]?.[1] ?? '');
      for (const colorScheme of ['light', 'dark'] as const) {
        await page.emulateMedia({ colorScheme });
        await page.screenshot({ path: join(OUTPUT, `source_${colorScheme}.png`) });
        await expectAccessible(page);
      }
      await page.getByRole('button', { name: 'Layout of the page' }).click();
      await page.getByRole('menuitem', { name: 'Copy a link to this view' }).click();
      await page.waitForFunction(() => location.hash.includes('changed='));
      const link = page.url();
      // By somebody who has not changed anything.
      await page.evaluate(() => localStorage.clear());
      await page.goto('about:blank');
      await page.goto(link);
      await page.getByText(/Who made this link had changed sources, which are not in it: src\/<img src=x/).waitFor();
      await editorOf(page).getByText('</style><script>').waitFor();
      // Entries that another site on the same host may have stored there.
      await page.evaluate((path) => {
        for (const [key, value] of [['lib/lab_py/talk.py', '{"of":1}'], ['lib/lab_py/hear.py', 'no JSON'], [path, '{"of":"another","text":"old"}']] as const) {
          localStorage.setItem(`ros2wasm.source ${new URL('.', location.href).pathname} ${key}`, value);
        }
      }, files[0]?.[0] ?? '');
      await page.goto('about:blank');
      await page.goto(address.replace(encodeURIComponent('src/no/such.py'), 'words.py'));
      await page.getByText('You changed this file when the site had another version of it.').waitFor();
      await consoleOf(page, 'hear').getByText('heard packed words').first().waitFor();
      await page.getByRole('button', { name: 'Take my text over' }).click();
      await editorOf(page).getByText('old', { exact: true }).waitFor();
      await page.setViewportSize({ width: 320, height: 640 });
      await page.getByRole('tab', { name: 'Source' }).click();
      await editorOf(page).getByText('old', { exact: true }).waitFor();
      await page.screenshot({ path: join(OUTPUT, 'source_phone.png') });
      await page.waitForFunction(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth);
      await expectAccessible(page);
    }));

// Compatibility, works: what the first pages of a lab sheet ask a student to type
test('the terminal goes through a lab sheet', watchdog, () =>
  visit(true, { file: 'words.py' }, async (page) => {
    await editorOf(page).getByText('packed words').waitFor();
    const panel = page.locator('.panel-terminal');
    const input = panel.getByRole('textbox', { name: 'Command' });
    /** Gives the lines that it prints. */
    const type = async (line: string): Promise<readonly string[]> => {
      await panel.locator('.terminal-input input:not([readonly])').waitFor();
      await input.fill('clear');
      await input.press('Enter');
      await panel.locator('.lines-empty').waitFor();
      await input.fill(`${line}; echo that was all`);
      await input.press('Enter');
      await panel.getByText('that was all', { exact: true }).waitFor();
      return (await panel.locator('.line').allInnerTexts()).slice(1, -1);
    };
    assert.match((await type('source /opt/ros/jazzy/setup.bash && printenv | grep ROS_DISTRO')).at(-1) ?? '', /^ROS_DISTRO=/);
    assert.deepEqual(await type('cd ~/ros2_ws/src/lab_py && ls && pwd'), ['lab_py  scripts', '/home/user/ros2_ws/src/lab_py']);
    assert.deepEqual(await type('cat scripts/hear.py | head -n 2'), hear.split('\n').slice(0, 2));
    assert.deepEqual(await type('grep -rn "rclpy.spin" . | wc -l'), ['2']);
    // The nodes are about to come.
    while (!(await type('ros2 topic list')).includes('/chatter'));
    assert.deepEqual(await type('mkdir -p ~/notes && ros2 topic list | sort > ~/notes/topics.txt && grep chatter ~/notes/topics.txt'), ['/chatter']);
    assert.ok((await type('cd ~/ros2_ws/src && ros2 pkg create --build-type ament_python my_package && ls my_package')).at(-1)?.includes('setup.py'));
    assert.match((await type('cd ~/ros2_ws && colcon build && . install/setup.bash'))[0] ?? '', /C\+\+ is built where the site is packed/);
    assert.deepEqual(await type('ros2 daemon stop; ros2 daemon start'), ['The daemon has been stopped', 'The daemon has been started']);
    assert.equal((await type('ros2 topic echo /chatter | grep data | head -n 2')).length, 2);
    // A file reads as the student has changed it.
    await write(page, words.replace('packed', 'my own'));
    await page.keyboard.press('Control+s');
    await page.getByText('/talk runs it changed.').waitFor();
    assert.deepEqual(await type('cat src/lab_py/lab_py/words.py | grep own'), ['    return "my own words"']);
    await type('nano src/lab_py/scripts/hear.py');
    await page.getByRole('textbox', { name: /^Source of src\/lab_py\/scripts\/hear\.py/ }).waitFor();
    await expectAccessible(page);
  }, 'terminal'));
