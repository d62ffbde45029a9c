// The notebook of example 06 in Chromium: all cells run on the graph of the site, a changed one is kept, downloaded and
// reset; and outputs that mean harm.
import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import { nbformatFaults } from '../../support/nbformat_rules.ts';
import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { PageStage, expectAccessible } from '../support/page_stage.ts';
import { Scratch, runCli } from '../support/served_site.ts';

const EXAMPLE = fileURLToPath(new URL('../../../examples/06_notebook', import.meta.url));
const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));

const scratch = new Scratch();
let stage: PageStage;
let site = process.env['ROS2WASM_NOTEBOOK_SITE'] ?? '';

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
  if (site !== '') return;
  cpSync(EXAMPLE, join(scratch.path, 'example'), { recursive: true });
  site = join(scratch.path, 'site');
  const packed = await runCli(['pack', join(scratch.path, 'example/workspace.yaml'), '-o', site]);
  assert.equal(packed.code, 0, packed.errors);
});

after(async () => {
  await stage.close();
  scratch[Symbol.dispose]();
});

const cellOf = (page: Page, number: number) => page.getByRole('group', { name: new RegExp(`^Cell ${number}, `) });

async function rewrite(page: Page, number: number, code: string): Promise<void> {
  await cellOf(page, number).scrollIntoViewIfNeeded();
  await cellOf(page, number).getByRole('textbox').click();
  await page.keyboard.press('ControlOrMeta+A');
  await page.keyboard.insertText(code);
}

// Compatibility, works: notebooks: a notebook of the workspace is a panel of the page; its cells publish, subscribe and spin, blocking and
// with `await`, with the nodes of the site
// Compatibility, works: notebooks: HTML, SVG, Markdown with math; changes are kept by the browser, downloaded as nbformat 4, and reset
test('example 06: all cells run on the graph of the site', async () => {
  const served = await serveFolder(site);
  const page = await stage.browser.newPage({ viewport: { width: 1400, height: 900 }, acceptDownloads: true });
  const troubles: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') troubles.push(message.text());
  });
  page.on('pageerror', (error) => troubles.push(error.message));
  page.setDefaultTimeout(120_000);
  try {
    await page.goto(served.url);
    const notebook = page.locator('#panel-notebook');
    await notebook.getByText('Two publishers, two subscribers').waitFor();
    await page.getByText('waits for topic_a').first().waitFor();
    await notebook.getByText('Python is not started').waitFor();
    await notebook.getByRole('button', { name: 'Run all' }).click();
    // The last cell's drawing.
    await cellOf(page, 12).locator('img.value-image').waitFor();
    await notebook.getByText('Python waits').waitFor();
    assert.match(await cellOf(page, 2).locator('.outputs').innerText(), /^'lab'$/);
    assert.equal((await cellOf(page, 8).locator('.outputs').innerText()).trim(),
      'topic_a said hello a\ntopic_b said hello b\ntopic_c said relay heard hello a');
    assert.match(await cellOf(page, 10).locator('.outputs').innerText(), /^10$/);
    assert.deepEqual(await cellOf(page, 12).locator('.html tr').allInnerTexts(), ['topic\tmessages', 'topic_a\t5', 'topic_b\t0', 'topic_c\t5']);
    assert.equal(await cellOf(page, 11).locator('math mfrac').count(), 1);
    // A node of the site heard them.
    await page.getByText("heard: 'message 4'").first().waitFor();
    await page.screenshot({ path: join(OUTPUT, 'notebook_light.png'), caret: 'initial' });
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.screenshot({ path: join(OUTPUT, 'notebook_dark.png'), caret: 'initial' });
    await page.emulateMedia({ colorScheme: 'light' });
    await expectAccessible(page);

    // An endless cell is interrupted, an error names its line, and Python goes on.
    await rewrite(page, 12, 'import time\nprint("sleeps")\nwhile True: time.sleep(60)');
    await page.keyboard.press('Control+Enter');
    await cellOf(page, 12).locator('.outputs').getByText('sleeps').waitFor();
    await notebook.getByRole('button', { name: 'Interrupt' }).click();
    await cellOf(page, 12).locator('.outputs').getByText('KeyboardInterrupt').waitFor();
    assert.match(await cellOf(page, 12).locator('.printed-error').innerText(), /File "Cell \[\d+\]", line 3/);
    await rewrite(page, 12, 'while True: pass');
    await page.keyboard.press('Control+Enter');
    await notebook.getByText('Python runs a cell').waitFor();
    await notebook.getByRole('button', { name: 'Interrupt' }).click();
    await cellOf(page, 12).locator('.outputs').getByText('KeyboardInterrupt').waitFor();

    // Text with math is what it is in outputs too.
    await rewrite(page, 12, 'from IPython.display import Latex, Markdown, display\n'
      + 'display(Markdown(r"a **bold** $\\frac{1}{T}$"), Latex(r"$$\\sqrt{2}$$"))');
    await page.keyboard.press('Control+Enter');
    await cellOf(page, 12).locator('.outputs math msqrt').waitFor();
    assert.equal(await cellOf(page, 12).locator('.outputs math mfrac').count(), 1);
    assert.equal(await cellOf(page, 12).locator('.outputs strong').innerText(), 'bold');

    // Hostile outputs do nothing but stand there.
    await rewrite(page, 12, hostile);
    await page.keyboard.press('Control+Enter');
    await cellOf(page, 12).locator('.outputs').getByText('all shown').waitFor();
    assert.match(await page.title(), /^Two publishers, two subscribers/);
    assert.equal(await page.locator('script:not([src]), iframe, object, [onerror], [onclick], a[href^="javascript"]').count(), 0);
    assert.equal(await cellOf(page, 12).locator('.outputs [style*="position"], .outputs [style*="url"]').count(), 0);

    // It is kept, downloaded, and reset.
    await notebook.getByText('Kept in this browser').waitFor();
    await page.reload();
    await cellOf(page, 12).locator('.outputs').getByText('all shown').waitFor();
    const menu = notebook.getByRole('button', { name: 'Notebook', exact: true });
    await menu.click();
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('menuitem', { name: 'Download .ipynb' }).click()]);
    const file = JSON.parse(readFileSync(await download.path(), 'utf8')) as { readonly nbformat: number; readonly cells: readonly Record<string, unknown>[]; };
    assert.equal(download.suggestedFilename(), 'lab.ipynb');
    assert.equal(file.nbformat, 4);
    assert.deepEqual(nbformatFaults(file), []);
    assert.equal(file.cells.length, 12);
    assert.equal(file.cells[11]?.['id'], 'table');
    // A new cell has the keyboard at once.
    await notebook.getByRole('button', { name: 'Add a cell of code below' }).click();
    await page.locator('.cm-focused').waitFor();
    await page.keyboard.type('40 + 2');
    await page.keyboard.press('Control+Enter');
    await notebook.locator('.outputs').getByText('42', { exact: true }).waitFor();
    await menu.click();
    await page.getByRole('menuitem', { name: 'Reset to the packed one' }).click();
    await notebook.getByText('As packed').waitFor();
    assert.equal(await cellOf(page, 8).locator('.outputs').count(), 0);
    // Nothing is asked for elsewhere and no script tried to run. Some inline style is refused by the page's policy: it changes nothing.
    assert.deepEqual(troubles.filter((text) => !text.startsWith('Applying inline style')), []);
  } finally {
    await page.close();
    await served.close();
  }
});

// Compatibility, works: notebooks: images, calls of services and `input()` from cells, and all of it on pages without shared memory
test('on a page without shared memory: an image, a call of a service, input(), and what is downloaded', async () => {
  const served = await serveFolder(site);
  const context = await stage.browser.newContext({ viewport: { width: 1400, height: 900 }, acceptDownloads: true, serviceWorkers: 'block' });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  try {
    await page.goto(served.url);
    const notebook = page.locator('#panel-notebook');
    await notebook.getByText('Python is not started').waitFor();
    assert.equal(await page.evaluate(() => crossOriginIsolated), false);
    await page.getByText('waits for topic_a').first().waitFor();
    await rewrite(page, 12, several);
    await page.keyboard.press('Control+Enter');
    const outputs = cellOf(page, 12).locator('.outputs');
    await outputs.getByText('the relay has use_sim_time: False').waitFor();
    const image = outputs.locator('img.value-image');
    await image.waitFor();
    assert.match(await image.getAttribute('src') ?? '', /^data:image\/png;base64,/);
    assert.deepEqual(await image.evaluate(async (element) => {
      await (element as HTMLImageElement).decode();
      return [(element as HTMLImageElement).naturalWidth, (element as HTMLImageElement).naturalHeight];
    }), [3, 2]);
    await cellOf(page, 12).getByRole('textbox', { name: 'Who is there?' }).fill('Ada');
    await page.keyboard.press('Enter');
    await outputs.getByText('Hello Ada').waitFor();
    await notebook.getByText('Python waits').waitFor();
    await notebook.getByRole('button', { name: 'Notebook', exact: true }).click();
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('menuitem', { name: 'Download .ipynb' }).click()]);
    const file = JSON.parse(readFileSync(await download.path(), 'utf8')) as {
      readonly cells: readonly { readonly outputs?: readonly { readonly output_type: string; }[]; }[];
    };
    assert.deepEqual(nbformatFaults(file), []);
    assert.deepEqual([...new Set(file.cells[11]?.outputs?.map((output) => output.output_type))].sort(), ['display_data', 'stream']);
  } finally {
    await context.close();
    await served.close();
  }
});

test('the site of example 06 prints what its expected.txt says', async () => {
  const ran = await runCli(['run', site, '--for', '60s', '--until', 'waits for topic_a']);
  assert.equal(ran.code, 0, ran.errors);
  for (const line of readFileSync(join(EXAMPLE, 'expected.txt'), 'utf8').trimEnd().split('\n')) assert.match(ran.output, new RegExp(line));
});

const BESIDE_TERMINAL = `#layout=${encodeURIComponent(JSON.stringify({ row: ['notebook', 'terminal'], shown: 'notebook' }))}`;

// Compatibility, works: notebooks: `await client.call_async(...)`, services that a notebook answers, and `rclpy.spin(node)` until an
// interrupt, after which `rclpy.init()` begins again
for (const isolated of played(false, true)) {
  test(`${isolated ? 'shared' : 'port'}: a cell spins and answers until it is interrupted, and the next ones go on`, async () => {
    const served = await serveFolder(site, { isolated });
    const context = await stage.browser.newContext({ viewport: { width: 1400, height: 900 }, serviceWorkers: 'block' });
    const page = await context.newPage();
    page.setDefaultTimeout(120_000);
    try {
      await page.goto(`${served.url}${BESIDE_TERMINAL}`);
      const notebook = page.locator('#panel-notebook');
      await notebook.getByText('Python is not started').waitFor();
      assert.equal(await page.evaluate(() => crossOriginIsolated), isolated);
      const outputs = cellOf(page, 12).locator('.outputs');
      for (const round of ['first', 'second']) {
        await rewrite(page, 12, awaits(round));
        await page.keyboard.press('Control+Enter');
        await outputs.getByText(`${round}: the relay has use_sim_time False`).waitFor();
        await rewrite(page, 12, answers(round));
        await page.keyboard.press('Control+Enter');
        await outputs.getByText(`${round}: spins`).waitFor();
        await page.waitForSelector('.terminal-input input:not([readonly])');
        await page.getByRole('textbox', { name: 'Command' }).fill(`ros2 service call /answers rcl_interfaces/srv/GetParameters '{names: [${round}]}'`);
        await page.getByRole('textbox', { name: 'Command' }).press('Enter');
        await page.getByRole('log', { name: 'Output of the commands' }).getByText(`string_value='${round} was asked for'`).waitFor();
        await notebook.getByRole('button', { name: 'Interrupt' }).click();
        await outputs.getByText('KeyboardInterrupt').waitFor();
        await notebook.getByText('Python waits').waitFor();
      }
    } finally {
      await context.close();
      await served.close();
    }
  });
}

const awaits = (round: string): string =>
  `import rclpy
from rcl_interfaces.srv import GetParameters
if not rclpy.ok():
    rclpy.init()
lab = rclpy.create_node('lab')
client = lab.create_client(GetParameters, '/relay/get_parameters')
client.wait_for_service()
answer = await client.call_async(GetParameters.Request(names=['use_sim_time']))
print('${round}: the relay has use_sim_time', answer.values[0].bool_value)`;

const answers = (round: string): string =>
  `from rcl_interfaces.msg import ParameterValue
def answer(request, response):
    response.values = [ParameterValue(type=4, string_value=f'{name} was asked for') for name in request.names]
    return response
service = lab.create_service(GetParameters, '/answers', answer)
print('${round}: spins')
rclpy.spin(lab)`;

const several = `import rclpy, struct, zlib
from IPython.display import Image, display
from rcl_interfaces.srv import GetParameters
if not rclpy.ok():
    rclpy.init()
asking = rclpy.create_node('asking')
client = asking.create_client(GetParameters, '/relay/get_parameters')
client.wait_for_service()
future = client.call_async(GetParameters.Request(names=['use_sim_time']))
rclpy.spin_until_future_complete(asking, future)
print('the relay has use_sim_time:', future.result().values[0].bool_value)
def chunk(kind, data):
    return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
rows = b''.join(b'\\x00' + b'\\xff\\x80\\x00' * 3 for _ in range(2))
png = b'\\x89PNG\\r\\n\\x1a\\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', 3, 2, 8, 2, 0, 0, 0)) + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b'')
display(Image(data=png))
print('Hello', input('Who is there?'))`;

const hostile = `from IPython.display import HTML, SVG, Markdown, display
display(HTML("""<script>document.title = 'owned'</script><img src=x onerror="document.title='owned'">
<iframe srcdoc="<script>parent.document.title='owned'</script>"></iframe><a href="javascript:document.title='owned'">a</a>
<div style="position:fixed;background:url(https://web.example/x.png)">b</div><style>* { display: none }</style>"""))
display(SVG("<svg xmlns='http://www.w3.org/2000/svg' onload='document.title=1'><script>parent.document.title='owned'</script></svg>"))
display(Markdown("<script>document.title='owned'</script> [x](javascript:alert(1))"))
print('all shown')`;
