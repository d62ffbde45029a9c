// A lab with tasks as a student has it: nothing passes by itself, what is done stays, a course's page shows it, and what is
// handed in is what `ros2wasm grade` reads.

// Guarantee, verified: what a student hands in is signed in the browser; `ros2wasm grade` refuses it when a byte was changed, or when it is of another site
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { type Browser, chromium, type Page } from 'playwright-core';
import { type StaticServer, serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { expectAccessible } from '../support/page_stage.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 400_000 };
const hostile = '<img src=x onerror=alert(1)> "quoted" & so on';
let workspace: PackWorkspace;
let browser: Browser;
let served: StaticServer;

const manifest = (name: string): string =>
  `schema: 1
name: ${name}
title: The lab ${name}
distro: jazzy
dependencies: [turtlesim]
launch: [{package: turtlesim, executable: turtlesim_node}]
tasks:
  - title: Tell where the turtle is
    checks: [{topic: /turtle1/pose}]
  - title: Drive to the right
    text: Pass *x = 7*.
    checks: [{topic: /turtle1/pose, field: x, above: 7}]
    hint: Use the terminal.
    solution: "\`ros2 topic pub\`"
  - title: ${JSON.stringify(hostile)}
    checks: [{topic: /nowhere}]
`;

before(async () => {
  workspace = new PackWorkspace('shared');
  for (const name of ['one', 'two']) workspace.write(`${name}/workspace.yaml`, manifest(name));
  workspace.write('course.yaml', 'schema: 1\nname: robots\ntitle: Robots & more\nlabs: [one, two]\n');
  const { code, stderr } = await workspace.run(['pack', 'course.yaml', '-o', 'course']);
  assert.equal(code, 0, stderr);
  served = await serveFolder(join(workspace.root, 'course'), { isolated: true });
  browser = await chromium.launch(chromiumOptions());
}, watchdog);

after(async () => {
  await browser.close();
  await served.close();
  workspace.close();
});

const layout = `#layout=${encodeURIComponent(JSON.stringify({ row: ['tasks', { column: ['terminal', 'checks'] }] }))}`;

/** The words of each task's state and of its checks. */
async function words(page: Page): Promise<readonly string[]> {
  return page.locator('.task').evaluateAll((rows) => rows.map((row) => (row as HTMLElement).innerText.replaceAll(/\s+/g, ' ')));
}

async function handIn(page: Page, name: string, to: string): Promise<void> {
  const coming = page.waitForEvent('download');
  await page.getByLabel('Your name').fill(name);
  await page.getByRole('button', { name: 'Save the file to hand in' }).click();
  await (await coming).saveAs(join(workspace.root, to));
}

test('a student does tasks, comes back, and hands in', watchdog, async () => {
  const context = await browser.newContext({ acceptDownloads: true });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);
  const dialogs: string[] = [];
  page.on('dialog', (dialog) => {
    dialogs.push(dialog.message());
    void dialog.dismiss();
  });
  try {
    // The list knows of nothing that is done.
    await page.goto(served.url);
    await page.getByText('The whole course: 0 of 6 tasks done').waitFor();
    await expectAccessible(page);
    await page.goto(`${served.url}one/index.html${layout}`);
    await page.getByText('Already so before you began').waitFor();
    assert.match((await words(page))[0] ?? '', /Open.*Already so before you began/);
    await page.getByText('0 of 3 tasks done').waitFor();
    // Looking is not an act.
    await page.getByRole('button', { name: 'Show hint: Drive to the right' }).click();
    await page.getByRole('group', { name: 'Hint: Drive to the right' }).waitFor();
    assert.match((await words(page))[0] ?? '', /Already so before you began/);
    const input = page.locator('.panel-terminal input');
    await input.fill('ros2 topic pub --times 3 /turtle1/cmd_vel geometry_msgs/msg/Twist "{linear: {x: 2.0}}"');
    await input.press('Enter');
    await page.getByText('2 of 3 tasks done').waitFor();
    await expectAccessible(page);
    await handIn(page, 'Ada', 'ada.json');
    await page.reload();
    await page.getByText('2 of 3 tasks done').waitFor();
    // At a visit nothing passes by itself either: what is kept is of the last one.
    assert.match((await words(page))[1] ?? '', /Done.*Seen at an earlier visit/);
    await page.goto(served.url);
    await page.getByText('2 of 3 tasks done in this browser', { exact: true }).waitFor();
    await page.getByText('0 of 3 tasks done in this browser', { exact: true }).waitFor();
    await page.getByText('The whole course: 2 of 6 tasks done').waitFor();
    await handIn(page, 'Ada', 'ada_course.json');
    await handIn(page, 'Bob', 'bob.json');
    assert.deepEqual(dialogs, []);
  } finally {
    await context.close();
  }
  const graded = await workspace.run(['--json', 'grade', 'ada.json', 'ada_course.json', '--site', 'course']);
  assert.equal(graded.code, 0, graded.stderr);
  const [lab, course] = JSON.parse(graded.stdout) as readonly Readonly<Record<string, unknown>>[];
  assert.equal(lab?.['student'], 'Ada');
  assert.equal(course?.['course'], 'Robots & more');
  assert.equal(lab['key'], course['key'], 'one browser');
  const labs = course['labs'] as readonly { readonly title: string; readonly tasks: readonly Readonly<Record<string, string>>[]; }[];
  assert.deepEqual(labs.map(({ title, tasks }) => [title, tasks.map((task) => 'done_at' in task)]), [
    ['The lab one', [true, true, false]],
    ['The lab two', [false, false, false]],
  ]);
  assert.equal(labs[0]?.tasks[2]?.['title'], hostile);
  assert.ok('hint_at' in (labs[0]?.tasks[1] ?? {}));
  const table = await workspace.run(['grade', 'ada.json', 'bob.json', '--site', 'course/one', '--site', 'course/two']);
  assert.equal(table.code, 0, table.stderr);
  assert.match(table.stdout, /^Ada +The lab one +2\/3 +1 +0 +20/m);
  assert.match(table.stderr, /warning\[R2W0673\]: 2 students have handed in from one browser/);
});

test('what was changed, is of another site or is no such file is refused, the rest is shown', watchdog, async () => {
  const text = readFileSync(join(workspace.root, 'ada.json'), 'utf8');
  writeFileSync(join(workspace.root, 'changed.json'), text.replace('Ada', 'Eve'));
  writeFileSync(join(workspace.root, 'none.json'), '{}');
  const graded = await workspace.run(['grade', 'changed.json', 'ada.json', 'none.json', '--csv']);
  assert.equal(graded.code, 1);
  assert.match(graded.stderr, /error\[R2W0671\]: `changed\.json` was changed after it was signed/);
  assert.match(graded.stderr, /error\[R2W0670\]: `none\.json` is not a file that a student hands in/);
  assert.match(graded.stdout, /^student,course,lab,task.*\n"Ada","","The lab one","Tell where the turtle is","20/);
  const other = await workspace.run(['grade', 'ada.json', '--site', 'course/two']);
  assert.equal(other.code, 1);
  assert.match(other.stderr, /error\[R2W0672\]: `ada\.json` is of another site: `The lab one`/);
  assert.equal(other.stdout, '');
});
