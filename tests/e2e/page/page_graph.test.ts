// The graph in Chromium: what is drawn, chosen, opened and saved; rates; keyboard, zoom; and that it stands still.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { Page } from 'playwright-core';
import type { GraphEndpointView, GraphNodeView } from '../../../runtime/site/contract/session.ts';
import { PageStage, expectAccessible, focused, phone } from '../support/page_stage.ts';

declare global {
  // Set by page_fake.tsx in the scene "graph".
  var robotNodes: () => readonly GraphNodeView[];
  var setNodes: (nodes: readonly GraphNodeView[]) => void;
  var graphNode: (name: string, process: string, has?: Partial<GraphNodeView>) => GraphNodeView;
  var endpoint: (name: string, type: string) => GraphEndpointView;
}

const OUTPUT = fileURLToPath(new URL('../../output', import.meta.url));
let stage: PageStage;

before(async () => {
  stage = await PageStage.open();
  mkdirSync(OUTPUT, { recursive: true });
});

after(() => stage.close());

const withGraph = (state: unknown = null, scene = 'graph'): string =>
  `${scene}#layout=${
    encodeURIComponent(
      JSON.stringify({ row: ['nodes', { tabs: [state === null ? 'graph' : { graph: state }, 'topics', 'console'] }], sizes: [1, 3], shown: 'graph' }),
    )
  }`;

const boxes = (page: Page): Promise<string[]> =>
  page.locator('.graph-box').evaluateAll((all) => all.map((each) => each.getAttribute('aria-label') ?? '').sort());

const box = (page: Page, name: string) => page.locator(`.graph-box[aria-label^="${name}"]`);

/** Where a box stands in the drawing, whatever part of it is seen. */
const placeOf = (page: Page, name: string): Promise<readonly (string | null)[]> =>
  box(page, name).locator('rect').evaluate((rect) => ['x', 'y'].map((key) => rect.getAttribute(key)));

test('nodes, topics and actions are drawn without what is hidden, with live rates', () =>
  stage.on(withGraph(), {}, async (page) => {
    await box(page, 'Node /robot/laser').waitFor();
    assert.deepEqual(await boxes(page), [
      'Action /navigate',
      'Node /mission',
      'Node /planner',
      'Node /robot/diff_drive',
      'Node /robot/laser',
      'Node /safety',
      'Topic /robot/cmd_vel, 12.0 Hz',
      'Topic /robot/odom, 29.9 Hz',
      'Topic /robot/scan, 10.0 Hz',
      'Topic /tf',
    ]);
    assert.deepEqual(await page.locator('.graph-group-name').allTextContents(), ['/robot']);
    // The rate of one publisher is on its wire; the rate of two is on the wire to the reader.
    assert.deepEqual((await page.locator('.graph-rate').allTextContents()).sort(), ['10.0 Hz', '12.0 Hz', '29.9 Hz']);
    await page.evaluate(() => fake.setTopics([{ name: '/robot/scan', type: 'sensor_msgs/msg/LaserScan', rateHz: 5 }]));
    await page.locator('.graph-rate').getByText('5.00 Hz').waitFor();
    await box(page, 'Topic /robot/odom').and(page.locator('[aria-label="Topic /robot/odom"]')).waitFor();
    await page.screenshot({ path: join(OUTPUT, 'graph.png') });
    await page.getByRole('checkbox', { name: 'Hidden' }).check();
    await box(page, 'Node /_ros2wasm_page').waitFor();
    for (const name of ['Topic /rosout', 'Topic /navigate/_action/feedback']) await box(page, name).waitFor();
    await page.getByRole('checkbox', { name: 'Groups' }).uncheck();
    await page.locator('.graph-group').waitFor({ state: 'detached' });
    // The options are stored, as in a link.
    await page.reload();
    await box(page, 'Node /_ros2wasm_page').waitFor();
    assert.equal(await page.locator('.graph-group').count(), 0);
  }));

test('nodes only: topics and actions are words on the wires, and open as boxes do', () =>
  stage.on(withGraph({ mode: 'nodes' }), {}, async (page) => {
    await box(page, 'Node /mission').waitFor();
    assert.equal(await page.locator('.graph-topic, .graph-action').count(), 0);
    assert.deepEqual((await page.locator('.graph-words').evaluateAll((all) => all.map((each) => each.getAttribute('aria-label') ?? ''))).sort(), [
      'Action /navigate',
      'Topic /robot/cmd_vel, 12.0 Hz',
      'Topic /robot/cmd_vel, 12.0 Hz',
      'Topic /robot/odom, 29.9 Hz',
      'Topic /robot/scan, 10.0 Hz',
      'Topic /robot/scan, 10.0 Hz',
    ]);
    await page.screenshot({ path: join(OUTPUT, 'graph_nodes.png') });
    await page.locator('.graph-words[aria-label="Action /navigate"]').click();
    const details = page.getByRole('region', { name: 'Details of /navigate' });
    await details.getByRole('button', { name: '/planner' }).click();
    await page.getByRole('region', { name: 'Details of /planner' }).waitFor();
    await page.getByRole('combobox', { name: 'What is drawn' }).selectOption('topics');
    await box(page, 'Topic /robot/scan').waitFor();
  }));

test('services are drawn when they are asked for, but for those that every node has', () =>
  stage.on(withGraph(), {}, async (page) => {
    await box(page, 'Node /planner').waitFor();
    await page.evaluate(() => {
      setNodes([
        graphNode('/asker', 'asker-1', { clients: [endpoint('/add', 'demo/srv/Add')] }),
        graphNode('/adder', 'adder-1', {
          services: [endpoint('/add', 'demo/srv/Add'), endpoint('/adder/get_parameters', 'rcl_interfaces/srv/GetParameters')],
        }),
      ]);
    });
    await box(page, 'Node /adder').waitFor();
    assert.equal(await page.locator('.graph-service').count(), 0);
    await page.getByRole('checkbox', { name: 'Services' }).check();
    await box(page, 'Service /add').waitFor();
    assert.equal(await page.locator('.graph-service').count(), 1);
    assert.equal(await page.locator('.graph-wire-service').count(), 2);
    await page.screenshot({ path: join(OUTPUT, 'graph_services.png') });
    await box(page, 'Service /add').click();
    const details = page.getByRole('region', { name: 'Details of /add' });
    await details.getByText('Clients', { exact: true }).waitFor();
    await expectAccessible(page);
    await details.getByRole('button', { name: '/adder' }).click();
    await page.getByRole('region', { name: 'Details of /adder' }).getByRole('button', { name: '/add', exact: true }).waitFor();
    // The options are stored, as in a link.
    await page.reload();
    await box(page, 'Node /planner').waitFor();
    assert.equal(await page.getByRole('checkbox', { name: 'Services' }).isChecked(), true);
  }));

test('what is chosen shows its details, and opens its console or topic', () =>
  stage.on(withGraph(), {}, async (page) => {
    await box(page, 'Node /planner').click();
    const details = page.getByRole('region', { name: 'Details of /planner' });
    for (const title of ['Publishes', 'Subscribes to', 'Offers services', 'Action servers']) await details.getByText(title, { exact: true }).waitFor();
    await details.getByRole('button', { name: '/robot/scan' }).click();
    const topic = page.getByRole('region', { name: 'Details of /robot/scan' });
    await topic.getByText('sensor_msgs/msg/LaserScan, 10.0 Hz, 14.8 kB/s, 812 messages').waitFor();
    await topic.getByRole('button', { name: 'Show in Topics' }).click();
    await page.locator('.topic-open').getByText('/robot/scan').waitFor();
    await page.getByRole('tab', { name: 'Graph' }).click();
    // Chosen once more, it opens.
    await box(page, 'Node /robot/laser').click();
    await page.getByRole('region', { name: 'Details of /robot/laser' }).waitFor();
    await box(page, 'Node /robot/laser').click();
    await page.locator('.tile-title').getByText('/robot/laser').waitFor();
    await page.getByRole('tab', { name: 'Graph' }).click();
    await box(page, 'Topic /robot/odom').click();
    await page.getByRole('button', { name: 'Close the details' }).click();
    await page.locator('.graph-details').waitFor({ state: 'detached' });
  }));

test('what comes and goes moves nothing else', () =>
  stage.on(withGraph(), {}, async (page) => {
    await box(page, 'Node /planner').waitFor();
    const names = await boxes(page);
    const places = async (): Promise<unknown> => Promise.all(names.map((name) => placeOf(page, name)));
    const first = await places();
    await page.evaluate(() => setNodes(robotNodes().filter(({ name }) => name !== '/safety')));
    await box(page, 'Node /safety').waitFor({ state: 'detached' });
    await page.evaluate(() => setNodes([...robotNodes(), graphNode('/watch', 'watch-6', { subscriptions: [endpoint('/tf', 'tf2_msgs/msg/TFMessage')] })]));
    await box(page, 'Node /watch').waitFor();
    assert.deepEqual(await places(), first);
    // A click does not move it either, a drag does.
    const all = page.locator('.graph-all');
    const before = await all.getAttribute('transform');
    const room = (await page.locator('.graph-drawing').boundingBox()) ?? assert.fail();
    await page.mouse.click(room.x + 20, room.y + 20);
    assert.equal(await all.getAttribute('transform'), before);
    await page.mouse.move(room.x + 20, room.y + 20);
    await page.mouse.down();
    await page.mouse.move(room.x + 90, room.y + 60, { steps: 4 });
    await page.mouse.up();
    assert.notEqual(await all.getAttribute('transform'), before);
    await page.getByRole('button', { name: 'Show the whole graph' }).click();
    assert.equal(await all.getAttribute('transform'), before);
    await page.mouse.move(room.x + 20, room.y + 20);
    await page.mouse.wheel(0, -300);
    await page.waitForFunction((from) => document.querySelector('.graph-all')?.getAttribute('transform') !== from, before);
    const zoomed = await all.getAttribute('transform');
    await page.getByRole('button', { name: 'Lay out or save the graph' }).click();
    await page.getByRole('menuitem', { name: 'Lay out again' }).click();
    await page.waitForFunction((from) => document.querySelector('.graph-all')?.getAttribute('transform') !== from, zoomed);
    const again = await all.getAttribute('transform');
    await page.getByRole('button', { name: 'Show the whole graph' }).click();
    assert.equal(await all.getAttribute('transform'), again);
  }));

test('a pointer that was lifted outside drags nothing, and a click without a pointer counts after a drag', () =>
  stage.on(withGraph(), {}, async (page) => {
    await box(page, 'Node /planner').waitFor();
    const all = page.locator('.graph-all');
    const room = (await page.locator('.graph-drawing').boundingBox()) ?? assert.fail();
    const before = await all.getAttribute('transform');
    await page.mouse.move(room.x + 1, room.y + 40);
    await page.mouse.down();
    await page.mouse.move(room.x - 40, room.y + 40);
    await page.mouse.up();
    await page.mouse.move(room.x + 90, room.y + 60, { steps: 4 });
    assert.equal(await all.getAttribute('transform'), before);
    await page.mouse.down();
    await page.mouse.move(room.x + 20, room.y + 20, { steps: 4 });
    await page.mouse.up();
    assert.notEqual(await all.getAttribute('transform'), before);
    await box(page, 'Node /robot/laser').dispatchEvent('click');
    await page.getByRole('region', { name: 'Details of /robot/laser' }).waitFor();
  }));

test('by keyboard: one stop, arrow keys from box to box, Enter chooses, plus zooms', () =>
  stage.on(withGraph(), {}, async (page) => {
    await box(page, 'Node /mission').waitFor();
    assert.equal(await page.locator('.graph-drawing [tabindex="0"]').count(), 1);
    await page.getByRole('button', { name: 'Lay out or save the graph' }).focus();
    await page.keyboard.press('Tab');
    const first = await focused(page);
    assert.match(first, /^Node /);
    await page.keyboard.press('End');
    assert.notEqual(await focused(page), first);
    await page.keyboard.press('Home');
    assert.equal(await focused(page), first);
    const left = (): Promise<number> => page.evaluate(() => document.activeElement?.getBoundingClientRect().left ?? 0);
    const start = await left();
    await page.keyboard.press('ArrowRight');
    assert.notEqual(await focused(page), first);
    assert.ok((await left()) > start);
    assert.notEqual(await page.evaluate(() => getComputedStyle(document.activeElement ?? document.body).outlineStyle), 'none');
    const all = page.locator('.graph-all');
    const before = await all.getAttribute('transform');
    await page.keyboard.press('+');
    assert.notEqual(await all.getAttribute('transform'), before);
    await page.keyboard.press('0');
    assert.equal(await all.getAttribute('transform'), before);
    // Far in, the box that has the focus comes into sight.
    for (let i = 0; i < 8; i += 1) await page.keyboard.press('+');
    await page.keyboard.press('End');
    await page.waitForFunction(() => {
      const [box, room] = [document.activeElement, document.querySelector('.graph-drawing')].map((each) => each?.getBoundingClientRect());
      return box !== undefined && room !== undefined && box.left < room.right && box.right > room.left && box.top < room.bottom && box.bottom > room.top;
    });
    const name = /^\w+ (\S+?),?( |$)/.exec(await focused(page))?.[1] ?? '';
    await page.keyboard.press('Enter');
    await page.getByRole('region', { name: `Details of ${name}`, exact: true }).waitFor();
  }));

test('a filter shows the part that is meant', () =>
  stage.on(withGraph(), {}, async (page) => {
    await page.getByRole('searchbox', { name: 'Filter the graph' }).fill('ODOM');
    await box(page, 'Node /mission').waitFor({ state: 'detached' });
    assert.deepEqual(await boxes(page), ['Node /planner', 'Node /robot/diff_drive', 'Topic /robot/odom, 29.9 Hz']);
    await page.getByRole('searchbox', { name: 'Filter the graph' }).fill('nowhere');
    await page.getByText('Nothing in the graph matches the filter.').waitFor();
  }));

test('the drawing is saved as SVG that stands by itself, in light colours', () =>
  stage.on(withGraph(), { colorScheme: 'dark' }, async (page) => {
    await box(page, 'Node /planner').waitFor();
    await page.getByRole('button', { name: 'Lay out or save the graph' }).click();
    const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('menuitem', { name: 'Save the drawing (SVG)' }).click()]);
    const svg = await readFile(await file.path(), 'utf8');
    assert.match(svg, /^<svg [^>]*viewBox=/);
    assert.doesNotMatch(svg, /class=|style=|tabindex|aria-/);
    const seen = await page.evaluate((text) => {
      const whole = new DOMParser().parseFromString(text, 'image/svg+xml');
      return {
        faults: whole.querySelectorAll('parsererror').length,
        texts: [...whole.querySelectorAll('text')].map((each) => each.textContent),
        ground: whole.querySelector('rect')?.getAttribute('fill'),
        filled: [...whole.querySelectorAll('path')].every((each) => each.hasAttribute('stroke') && each.hasAttribute('fill')),
      };
    }, svg);
    assert.equal(seen.faults, 0);
    assert.equal(seen.ground, 'rgb(255, 255, 255)');
    assert.equal(seen.filled, true);
    for (const text of ['/robot', 'laser', 'scan', '/planner', '10.0 Hz']) assert.ok(seen.texts.includes(text), text);
  }));

test('hostile names are drawn as text', () =>
  stage.on(withGraph({ hidden: true }, 'hostile'), {}, async (page) => {
    await box(page, 'Node /<img src=x').click();
    await page.getByRole('region', { name: /^Details of \/<img/ }).waitFor();
    assert.notEqual(await page.title(), 'owned');
    assert.equal(await page.locator('.panel-graph img, .panel-graph script').count(), 0);
    assert.deepEqual((await page.locator('.graph-topic text').allTextContents()).filter((text) => /\u202e|\u0000/.test(text)), []);
    await page.getByRole('button', { name: 'Lay out or save the graph' }).click();
    const [file] = await Promise.all([page.waitForEvent('download'), page.getByRole('menuitem', { name: 'Save the drawing (SVG)' }).click()]);
    const svg = await readFile(await file.path(), 'utf8');
    const faults = await page.evaluate((text) => {
      const whole = new DOMParser().parseFromString(text, 'image/svg+xml');
      return whole.querySelectorAll('parsererror, img, script').length;
    }, svg);
    assert.equal(faults, 0);
  }));

test('an empty graph says so', () =>
  stage.on(withGraph(null, 'empty'), {}, async (page) => {
    await page.getByText('No nodes in the graph yet.').waitFor();
  }));

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds nothing in the graph, ${colorScheme}`, () =>
    stage.on(withGraph({ mode: 'nodes' }), { colorScheme, reducedMotion: 'reduce' }, async (page) => {
      await box(page, 'Node /planner').click();
      await page.getByRole('region', { name: 'Details of /planner' }).waitFor();
      await expectAccessible(page);
      await page.getByRole('combobox', { name: 'What is drawn' }).selectOption('topics');
      await box(page, 'Topic /robot/scan').click();
      await expectAccessible(page);
    }));
}

test('the graph fits a phone', () =>
  stage.on(withGraph(), { ...phone, viewport: { width: 320, height: 568 } }, async (page) => {
    await box(page, 'Node /planner').waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    assert.ok(((await page.locator('.graph-drawing').boundingBox())?.height ?? 0) >= 120);
    await page.screenshot({ path: join(OUTPUT, 'graph_phone.png') });
    await box(page, 'Node /planner').click();
    await page.getByRole('region', { name: 'Details of /planner' }).waitFor();
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 320);
    await expectAccessible(page);
  }));
