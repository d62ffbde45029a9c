// The text panel in Chromium: a lab sheet with math, images and links that act; and one that means harm.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';

const DRAWING = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="20"><rect width="40" height="20" fill="#2450b2"/></svg>';

const SHEET = `# Lab 1: a wheel

The speed is $v = \\omega r$, at most $v_{max}$, and

$$\\frac{a}{b} = \\sqrt{2}$$

![the arm](arm%201.svg) ![a logo](../logo.svg "Logo") ![elsewhere](https://web.example/x.png)

1. [Start the talker](ros2wasm:start?node=talker), or [stop it](ros2wasm:stop?node=/talker).
2. [Plot it](ros2wasm:open?panel=plot&paths=/topic.data&seconds=10).
3. [Say hello](<ros2wasm:publish?topic=/topic&type=std_msgs/msg/String&value={data: hello}>) or [nonsense](ros2wasm:publish?topic=/topic&type=no/msg/Such).
4. See [below](#what-to-see), [the web](https://web.example/), [nowhere](javascript:alert(1)).

- [x] read this
- [ ] do it

| node | rate |
| --- | ---: |
| \`talker\` | 2 Hz & more |

## What to see

\`\`\`
[INFO] a line that is long enough to go past the end of a narrow column, and then some more
\`\`\`
`;

const HOSTILE = `# <img src=x onerror="document.title='owned'">

<script>document.title = 'owned'</script>

<iframe src="https://web.example/"></iframe>

[click](javascript:document.title='owned') [data](data:text/html,<script>1</script>) [v](vbscript:x)

![x](javascript:document.title='owned') ![x" onerror="document.title='owned'](a.png)

$\\href{javascript:document.title='owned'}{x}$ $\\url{https://web.example}$ $\\includegraphics{https://web.example/a.png}$ $\\style{background:url(https://web.example)}{x}$

<ros2wasm:eval?x=1> [act](ros2wasm:eval?code=1) ![act](ros2wasm:run?line=clear) <img src="ros2wasm:stop?node=talker">
`;

let stage: PageStage;

function put(sheet: string): void {
  mkdirSync(join(stage.folder, 'text/lab'), { recursive: true });
  writeFileSync(join(stage.folder, 'text/lab/README.md'), sheet);
  writeFileSync(join(stage.folder, 'text/lab/arm 1.svg'), DRAWING);
  writeFileSync(join(stage.folder, 'text/logo.svg'), DRAWING);
}

before(async () => {
  stage = await PageStage.open();
});

after(() => stage.close());

test('a lab sheet stands beside its machine: math, images, tables, links that act', async () => {
  put(SHEET);
  await stage.on('sheet', {}, async (page) => {
    const text = page.locator('.text');
    await text.getByRole('heading', { name: 'Lab 1: a wheel' }).waitFor();
    await text.locator('math mfrac').waitFor();
    assert.ok(((await text.locator('math mfrac').boundingBox())?.height ?? 0) > 15);
    // An index hangs below its line, whatever fonts there are.
    const bottoms = await text.locator('math msub > mi:first-child, math msub > mrow > mrow').evaluateAll((parts) =>
      parts.map((part) => part.getBoundingClientRect().bottom)
    );
    assert.ok((bottoms[1] ?? 0) > (bottoms[0] ?? 0) + 1, String(bottoms));
    for (const name of ['the arm', 'a logo']) {
      const image = text.getByRole('img', { name });
      await image.scrollIntoViewIfNeeded();
      await page.waitForFunction(
        (alt) => document.querySelector<HTMLImageElement>(`img[alt="${alt}"]`)?.naturalWidth === 40,
        name,
      );
    }
    await text.locator('.text-missing').getByText('elsewhere').waitFor();
    await text.getByText('2 Hz & more').waitFor();
    await text.getByRole('button', { name: 'stop it' }).click();
    await page.getByRole('status').getByText('Stopped /talker').waitFor();
    await text.getByRole('button', { name: 'Start the talker' }).click();
    await page.getByRole('status').getByText('Started /talker').waitFor();
    assert.deepEqual(await page.evaluate(() => fake.asked), ['stop talker-1', 'start talker-1']);
    // A message that a link publishes goes over the graph.
    await page.evaluate(() => {
      const heard: string[] = [];
      Object.assign(globalThis, { heardTexts: heard });
      fake.node().subscription('/topic', 'std_msgs/msg/String', {}, (bytes) => heard.push(new TextDecoder().decode(bytes.subarray(8, -1))));
    });
    await text.getByRole('button', { name: 'Say hello' }).click();
    await page.getByRole('status').getByText('Published on /topic').waitFor();
    await page.waitForFunction(() => (globalThis as unknown as { heardTexts: string[]; }).heardTexts.join() === 'hello');
    await text.getByRole('button', { name: 'nonsense' }).click();
    await page.getByRole('status').getByText('Not done: the site has no definition of no/msg/Such').waitFor();
    // The plot opens beside the text, once for each state.
    await text.getByRole('button', { name: 'Plot it' }).click();
    await page.getByRole('button', { name: 'Remove /topic.data' }).waitFor();
    await text.getByRole('button', { name: 'Plot it' }).click();
    assert.equal(await page.getByRole('tab', { name: /^Plot/ }).count(), 1);
    assert.equal(await text.isVisible(), true);
    await text.getByRole('link', { name: 'below' }).click();
    await page.waitForFunction(() => document.activeElement?.textContent === 'What to see');
    assert.equal(await text.getByRole('link', { name: 'nowhere' }).count(), 0);
    assert.equal(await text.getByRole('link', { name: 'the web' }).getAttribute('rel'), 'noopener noreferrer');
  });
});

const LAB = `# Lab 2

[add](<ros2wasm:call?name=/add&value={a: 2, b: 40}>) [add nothing](<ros2wasm:call?name=/add&value={c: 1}>) [nobody](ros2wasm:call?name=/none)
[count](<ros2wasm:goal?name=/count&value={to: 3}>)
[look at all](ros2wasm:check) [look at one](<ros2wasm:check?name=/topic above 1 Hz>) [look at none](ros2wasm:check?name=x)
[hold](ros2wasm:pause) [step](ros2wasm:step?ms=20) [go on](ros2wasm:resume)
[list](<ros2wasm:run?line=ros2 service list -t>) [again](<ros2wasm:run?line=ros2 node list>) [two lines](<ros2wasm:run?line=ros2 node list%0Aros2 topic list>)
`;

test('links of a lab sheet call, send goals, look at checks, hold time and run commands', async () => {
  put(LAB);
  await stage.on('lab', {}, async (page) => {
    const text = page.locator('.text');
    const said = page.locator('.text-said');
    const click = (name: string): Promise<void> => text.getByRole('button', { name, exact: true }).click();
    await click('add');
    await said.getByText('Reply of /add:').waitFor();
    assert.equal(await said.innerText(), 'Reply of /add:\nsum: 42');
    await click('add nothing');
    await said.getByText(/^Not done: .*c/).waitFor();
    await click('nobody');
    await said.getByText('Not done: no node offers /none').waitFor();
    await click('count');
    await said.getByText('Goal of /count: ').waitFor();
    await click('look at all');
    await said.getByText('Looking: /topic above 1 Hz (nothing)').waitFor();
    assert.equal(await said.locator('*').count(), 0);
    // The verdict is shown beside the link.
    await page.evaluate(() => {
      const checks = fake.checks as unknown as { set: (views: unknown[]) => void; views: () => object[]; };
      checks.set(checks.views().map((view, index) => (index === 0 ? { ...view, state: 'passed', seen: '2 Hz' } : view)));
    });
    await said.getByText('Passed: /topic above 1 Hz (2 Hz)').waitFor();
    await click('look at one');
    await said.getByText(/^Looking: \/topic above 1 Hz \(nothing\)$/).waitFor();
    await click('look at none');
    await said.getByText('This site has no check \u201cx\u201d.').waitFor();
    await click('hold');
    await click('step');
    await said.getByText('Time went on by 20 ms.').waitFor();
    await click('go on');
    assert.deepEqual(await page.evaluate(() => fake.time.asked), ['pause', 'step 20000000', 'resume']);
    await click('list');
    const output = page.getByRole('log', { name: 'Output of the commands' });
    await output.getByText('/add [demo/srv/Add]').waitFor();
    assert.equal(await output.getByText('$ ros2 service list -t').count(), 1);
    await click('again');
    await output.getByText('$ ros2 node list').waitFor();
    assert.equal(await page.getByRole('tab', { name: /^Terminal/ }).count(), 1);
    // One that would run more than it shows means nothing.
    assert.equal(await text.getByRole('button', { name: 'two lines' }).getAttribute('aria-disabled'), 'true');
    assert.match(await page.title(), /^Talker and listener/);
  });
});

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the text, ${colorScheme}`, async () => {
    put(SHEET);
    await stage.on('sheet', { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await page.locator('math mfrac').waitFor();
      await expectAccessible(page);
    });
  });
}

test('the text fits a phone', async () => {
  put(SHEET);
  await stage.on('sheet', { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await page.locator('math mfrac').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    const over = await page.locator('.text').evaluate((text) => text.scrollWidth - text.clientWidth);
    assert.ok(over <= 0, `${over} px too wide`);
  });
});

// Guarantee, hostile input: lab sheets: nothing in a hostile Markdown text acts, loads or is
// injected
test('nothing in a hostile text acts, loads or is injected', async () => {
  put(HOSTILE);
  await stage.on('sheet', {}, async (page) => {
    const text = page.locator('.text');
    await text.getByText("document.title = 'owned'").waitFor();
    await text.locator('math, code').first().waitFor();
    assert.equal(await text.locator('script, iframe, img, [style], [onerror], [href^="javascript" i], [href^="data" i]').count(), 0);
    assert.equal(await text.locator('math [href], math mglyph, math img').count(), 0);
    await text.getByRole('button', { name: 'act' }).click({ force: true });
    for (const link of await text.getByRole('link').all())
      assert.match((await link.getAttribute('href')) ?? '', /^(https?|mailto):/);
    assert.match(await page.title(), /^Talker and listener/);
    assert.deepEqual(await page.evaluate(() => fake.asked), []);
  });
});
