// A page on another origin, which is not isolated, shows the turtle simulator in a frame and drives it by messages.
// Guarantee, hostile input: a link to a site and a page around it may set arguments, values and what is shown: they never run code, and the
// page around it acts only when the manifest lists its origin
import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { type Browser, type Frame, type Page, chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { EmbeddingPage, ask, type Reply } from '../support/embedding_page.ts';
import { Scratch, ServedSite, runCli } from '../support/served_site.ts';

const SHOTS = process.env['ROS2WASM_SCREENSHOTS'];
const EXAMPLE = fileURLToPath(new URL('../../../examples/03_turtlesim', import.meta.url));

const scratch = new Scratch();
let browser: Browser;
/** Listed by the site; and one that is not. */
let course: EmbeddingPage;
let stranger: EmbeddingPage;
let site: ServedSite;

interface Heard {
  readonly event: string;
  readonly topic?: string;
  readonly message?: Readonly<Record<string, unknown>>;
  readonly state?: { readonly nodes: readonly { readonly id: string; readonly state: string; }[]; };
}

/** Waits until the page around the frame has heard such an event. */
function heard(page: Page, event: string, test: string): Promise<Heard> {
  return page
    .waitForFunction(
      ([name, body]) =>
        (globalThis as unknown as { heard: Heard[]; }).heard.findLast(
          (one) => one.event === name && Boolean(new Function('one', `return ${body}`)(one)),
        ),
      [event, test],
    )
    .then((handle) => handle.jsonValue() as Promise<Heard>);
}

async function visit(parent: EmbeddingPage, rest = '&panel=turtlesim'): Promise<{ page: Page; frame: Frame; }> {
  const { page, frame } = await parent.open(browser, `${site.url}?embed=1${rest}`, { width: 640, height: 460 });
  await heard(page, 'ready', 'true');
  return { page, frame };
}

async function done(page: Page, order: Readonly<Record<string, unknown>>): Promise<unknown> {
  const reply = await ask(page, order);
  assert.equal(reply.ok, true, JSON.stringify(reply));
  return reply.result;
}

async function refused(page: Page, order: Readonly<Record<string, unknown>>): Promise<string> {
  const reply = await ask(page, order);
  assert.equal(reply.ok, false, JSON.stringify(reply));
  return `${reply.error?.code ?? ''}: ${reply.error?.message ?? ''}`;
}

before(async () => {
  if (SHOTS !== undefined) mkdirSync(SHOTS, { recursive: true });
  [course, stranger] = await Promise.all([EmbeddingPage.serve(), EmbeddingPage.serve()]);
  const workspace = join(scratch.path, 'workspace');
  cpSync(EXAMPLE, workspace, { recursive: true });
  const manifest = join(workspace, 'workspace.yaml');
  writeFileSync(manifest, `${readFileSync(manifest, 'utf8')}\nsite:\n  embed: [${course.origin}]\n`);
  const packed = await runCli(['pack', manifest, '-o', join(scratch.path, 'site')]);
  assert.equal(packed.code, 0, packed.errors);
  site = await ServedSite.start([join(scratch.path, 'site'), '--port', '0']);
  browser = await chromium.launch(chromiumOptions());
}, { timeout: 600_000 });

after(async () => {
  await browser.close();
  await site[Symbol.asyncDispose]();
  await course.close();
  await stranger.close();
  scratch[Symbol.dispose]();
});

describe('a page that the manifest lists', { timeout: 300_000 }, () => {
  test('hears, publishes, calls, sets, stops and starts', async () => {
    const { page, frame } = await visit(course);
    assert.equal(await page.evaluate(() => crossOriginIsolated), false);
    const hello = await done(page, { do: 'hello' }) as Readonly<Record<string, unknown>>;
    assert.equal(hello['may'], 'act');
    assert.equal(hello['link'], 'port');
    await done(page, { do: 'watch' });
    await heard(page, 'state', 'one.state.nodes.every((node) => node.state === "running")');
    await done(page, { do: 'subscribe', topic: '/turtle1/pose', rate: 20 });
    const begin = (await heard(page, 'message', 'one.topic === "/turtle1/pose"')).message;
    assert.equal(typeof begin?.['x'], 'number');
    await done(page, { do: 'publish', topic: '/turtle1/cmd_vel', type: 'geometry_msgs/msg/Twist', message: { linear: { x: 2 }, angular: { z: 1 } } });
    await heard(page, 'message', `one.message.x > ${Number(begin?.['x']) + 0.5}`);
    const spawned = await done(page, { do: 'call', service: '/spawn', type: 'turtlesim/srv/Spawn', request: { x: 2, y: 2, name: 'friend' } });
    assert.deepEqual(spawned, { name: 'friend' });
    await done(page, { do: 'set_parameter', node: '/turtlesim', name: 'background_r', value: 200 });
    if (SHOTS !== undefined) await page.screenshot({ path: `${SHOTS}/embed_turtlesim.png` });
    const [{ id } = assert.fail()] = ((await done(page, { do: 'state' })) as { nodes: { id: string; }[]; }).nodes;
    await done(page, { do: 'stop', node: id });
    await heard(page, 'state', `one.state.nodes.find((node) => node.id === "${id}").state !== "running"`);
    await done(page, { do: 'start', node: id });
    await heard(page, 'state', `one.state.nodes.find((node) => node.id === "${id}").state === "running"`);
    const checks = await done(page, { do: 'run_checks' }) as { title: string; state: string; }[];
    assert.equal(checks.length, 3);
    assert.ok(checks.every(({ state }) => state !== 'waiting'));
    await done(page, { do: 'unsubscribe', subscription: 1 });
    assert.equal(await frame.locator('header').count(), 0);
    await page.context().close();
  });

  test('is told what does not come about, with a code', async () => {
    const { page } = await visit(course);
    assert.match(await refused(page, { do: 'start', node: 'nobody' }), /^R2W0753: there is no node `nobody`/);
    assert.match(await refused(page, { do: 'publish', topic: '/a', type: 'no_msgs/msg/None' }), /^R2W0753: .*no_msgs/);
    assert.match(await refused(page, { do: 'publish', topic: 'bad name', type: 'geometry_msgs/msg/Twist' }), /^R2W0715: /);
    const misfit = { do: 'publish', topic: '/turtle1/cmd_vel', type: 'geometry_msgs/msg/Twist', message: { linear: { x: 'fast' } } };
    assert.match(await refused(page, misfit), /^R2W0753: linear\.x/);
    assert.match(await refused(page, { do: 'call', service: '/none', type: 'std_srvs/srv/Empty', timeout_ms: 200 }), /^R2W0716: /);
    assert.match(await refused(page, { do: 'set_parameter', node: '/turtlesim', name: 'background_r', value: 'red' }), /^R2W0753: /);
    assert.match(await refused(page, { do: 'unsubscribe', subscription: 99 }), /^R2W0753: /);
    assert.match(await refused(page, { do: 'eval', code: '1' }), /^R2W0750: /);
    for (let i = 0; i < 16; i += 1) await done(page, { do: 'subscribe', topic: `/t${i}` });
    assert.match(await refused(page, { do: 'subscribe', topic: '/one_more' }), /^R2W0752: /);
    await page.context().close();
  });

  test('a flood is refused, and the site goes on', async () => {
    const { page } = await visit(course);
    const replies = await page.evaluate(async () => {
      const told: Reply[] = [];
      const { ask } = globalThis as unknown as { ask: (order: unknown) => Promise<Reply>; };
      for (let i = 0; i < 5000; i += 1) void ask({ do: 'state' }).then((reply) => told.push(reply));
      await new Promise((go) => setTimeout(go, 3000));
      return told;
    });
    const codes = replies.map((reply) => reply.error?.code ?? 'ok');
    assert.ok(codes.includes('R2W0752'), String(codes.length));
    // Not each of the flood has an answer.
    assert.ok(replies.length < 1000, String(replies.length));
    await done(page, { do: 'state' });
    await page.context().close();
  });
});

describe('any other page', { timeout: 300_000 }, () => {
  test('sees the state of the nodes, and acts on nothing', async () => {
    const { page, frame } = await visit(stranger);
    assert.equal((await done(page, { do: 'hello' }) as { may: string; }).may, 'read');
    await done(page, { do: 'watch' });
    await heard(page, 'state', 'one.state.nodes.every((node) => node.state === "running")');
    const acts: readonly Readonly<Record<string, unknown>>[] = [
      { do: 'stop' },
      { do: 'start' },
      { do: 'restart' },
      { do: 'publish', topic: '/turtle1/cmd_vel', type: 'geometry_msgs/msg/Twist' },
      { do: 'subscribe', topic: '/rosout' },
      { do: 'unsubscribe', subscription: 1 },
      { do: 'call', service: '/clear', type: 'std_srvs/srv/Empty' },
      { do: 'set_parameter', node: '/turtlesim', name: 'background_r', value: 1 },
      { do: 'checks' },
      { do: 'run_checks' },
    ];
    for (const act of acts) assert.match(await refused(page, act), new RegExp(`^R2W0751: the page ${stranger.origin} may look`));
    const state = await done(page, { do: 'state' }) as { nodes: { state: string; }[]; };
    assert.ok(state.nodes.every((node) => node.state === 'running'));
    // Not from a window that is not around the frame, whatever its origin.
    await frame.evaluate(() => window.postMessage({ ros2wasm: 1, id: 1, do: 'stop' }, '*'));
    const again = await done(page, { do: 'state' }) as { nodes: { state: string; }[]; };
    assert.ok(again.nodes.every((node) => node.state === 'running'));
    await page.context().close();
  });

  test('asks how high the frame should be, and nothing scrolls in one of that height', async () => {
    const { page, frame } = await visit(stranger, '&panel=text');
    await frame.getByRole('heading', { name: 'Drive a turtle' }).waitFor();
    const { height } = await done(page, { do: 'height' }) as { height: number; };
    assert.ok(height > 460 && height < 3000, String(height));
    await page.evaluate((px) => document.querySelector('iframe')!.setAttribute('height', String(px)), height);
    await frame.waitForFunction((px) => innerHeight === px, height);
    assert.deepEqual(await done(page, { do: 'height' }), { height });
    assert.ok(await frame.locator('.text').evaluate((text) => text.scrollHeight === text.clientHeight));
    await page.context().close();
  });

  test('text of a link and of messages runs nothing', async () => {
    const code = '<img src=x onerror="document.title=1">${alert(1)}javascript:alert(1)';
    const hostile = `&panel=${encodeURIComponent(code)},console#layout=${encodeURIComponent(JSON.stringify({ console: { text: code } }))}`;
    const { page, frame } = await visit(course, hostile);
    const errors: string[] = [];
    page.on('pageerror', (error) => errors.push(error.message));
    page.on('dialog', (dialog) => errors.push(dialog.message()));
    await done(page, { do: 'publish', topic: '/said', type: 'std_msgs/msg/String', message: { data: code } });
    await refused(page, { do: 'start', node: code });
    await refused(page, { do: 'publish', topic: code, type: code });
    assert.equal(await frame.locator('img[src="x"]').count(), 0);
    assert.deepEqual(errors, []);
    await page.context().close();
  });

  test('a page without embed=1 answers nobody', async () => {
    const { page, frame } = await course.open(browser, site.url);
    await frame.locator('header').waitFor();
    const silent = await page.evaluate(() => {
      const { ask } = globalThis as unknown as { ask: (order: unknown) => Promise<unknown>; };
      return Promise.race([ask({ do: 'hello' }), new Promise((go) => setTimeout(() => go('silent'), 1500))]);
    });
    assert.equal(silent, 'silent');
    await page.context().close();
  });
});
