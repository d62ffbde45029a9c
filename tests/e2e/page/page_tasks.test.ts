// The panel of tasks in Chromium: states, hints before solutions, what is kept over visits, by keyboard and on a phone.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { PageStage, expectAccessible, phone } from '../support/page_stage.ts';
import type { FakeTasks } from '../../unit/ui/fake_session.ts';

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
const SCENE = `tasks#layout=${encodeURIComponent(JSON.stringify({ row: ['tasks', 'console'], sizes: [1, 1] }))}`;

let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

test('a task says what is seen, shows its hint and then its solution, and is kept when it is done', () =>
  stage.on(SCENE, {}, async (page) => {
    const rows = page.locator('.task');
    await rows.nth(2).waitFor();
    await page.getByText('0 of 3 tasks done').waitFor();
    assert.match(await rows.nth(0).innerText(), /Open.*Pass x = 9.*Not seen yet.*Seen: no message.*Already so before you began.*Show hint$/s);
    await page.getByText('What you do counts from your first step').waitFor();
    // The solution comes after the hint.
    assert.equal(await page.getByRole('button', { name: 'Show solution: Drive the turtle' }).count(), 0);
    const hint = page.getByRole('button', { name: 'Show hint: Drive the turtle' });
    await hint.focus();
    await page.keyboard.press('Enter');
    await page.getByRole('group', { name: 'Hint: Drive the turtle' }).getByText('Teleop').waitFor();
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    await page.getByRole('group', { name: 'Solution: Drive the turtle' }).getByText('ros2 topic pub').waitFor();
    await page.screenshot({ path: join(OUTPUT, 'tasks.png') });
    await expectAccessible(page);
    // A link in a task acts as in the lab sheet.
    await page.locator('.task .text-action').click();
    await page.locator('.panel-tasks .text-said:not(:empty)').waitFor();
    await page.evaluate(() => {
      const tasks = fake.tasks as FakeTasks;
      tasks.acted();
      tasks.set(tasks.views().map((view, at) => (at > 0 ? view : {
        ...view,
        done: true,
        checks: view.checks.map((check) => ({ ...check, state: 'passed' as const, seen: '9.1' })),
      })));
    });
    await page.getByText('1 of 3 tasks done').waitFor();
    await page.getByRole('status').getByText('Task done: Drive the turtle').waitFor({ state: 'attached' });
    assert.equal(await page.getByText('What you do counts from your first step').count(), 0);
    assert.notEqual(await page.title(), 'owned');
    // At the next visit it is still done; forgetting asks first.
    await page.reload();
    await page.getByText('1 of 3 tasks done').waitFor();
    await page.getByText('Seen at an earlier visit').first().waitFor();
    await page.getByRole('button', { name: 'Forget what was done here' }).click();
    await page.getByRole('button', { name: 'Keep it' }).click();
    await page.getByRole('button', { name: 'Forget what was done here' }).click();
    await expectAccessible(page);
    await page.getByRole('button', { name: 'Forget it' }).click();
    await page.getByText('0 of 3 tasks done').waitFor();
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing, ${colorScheme}`, () =>
    stage.on(SCENE, { colorScheme }, async (page) => {
      await page.locator('.task').nth(2).waitFor();
      await expectAccessible(page);
    }));
}

test('a phone shows the tasks, and a site without tasks says so', async () => {
  const layout = encodeURIComponent(JSON.stringify('tasks'));
  await stage.on(`tasks#layout=${layout}`, phone, async (page) => {
    await page.locator('.task').nth(2).waitFor();
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > document.documentElement.clientWidth);
    assert.equal(wide, false);
    await page.getByRole('button', { name: 'Show hint: Drive the turtle' }).click();
    await page.getByRole('group', { name: 'Hint: Drive the turtle' }).waitFor();
    await expectAccessible(page);
  });
  await stage.on(`empty#layout=${layout}`, {}, async (page) => {
    await page.getByText('This workspace asks for nothing').waitFor();
  });
});
