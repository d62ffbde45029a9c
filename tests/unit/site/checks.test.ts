// The checks of a site: what each kind sees on both links and in a stepped run, what is told when one fails, and the
// report for CI.

// Compatibility, works: `checks:` of a manifest, in the page and with `ros2wasm run --checks --junit`

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { checkLine, junitXml } from '../../../runtime/site/checks/check_report.ts';
import { runChecks } from '../../../runtime/site/checks/check_run.ts';
import { checkTitle, meets, valueAt } from '../../../runtime/site/checks/check_words.ts';
import type { CheckView } from '../../../runtime/site/contract/site_checks.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { makeFolder, withSession } from './site_fixture.ts';

const script = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
const watchdog = { timeout: 240_000 };
const folders: string[] = [];

after(() => {
  for (const folder of folders) rmSync(folder, { recursive: true });
});

type Json = Readonly<Record<string, unknown>>;

function withChecks(folder: string, checks: readonly Json[]): string {
  folders.push(folder);
  const file = join(folder, 'site.json');
  const site = JSON.parse(readFileSync(file, 'utf8')) as Json;
  writeFileSync(file, JSON.stringify({ ...site, checks: checks.map((check) => ({ within_ms: 120_000, ...check })) }));
  return folder;
}

function run(args: readonly string[]): Promise<{ readonly code: number | null; readonly out: string; readonly err: string; }> {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, [script, ...args], { stdio: ['ignore', 'pipe', 'pipe'] });
    let [out, err] = ['', ''];
    child.stdout.on('data', (bytes: Buffer) => (out += bytes.toString()));
    child.stderr.on('data', (bytes: Buffer) => (err += bytes.toString()));
    child.on('close', (code) => resolve({ code, out, err }));
  });
}

const ways: Readonly<Record<string, readonly string[]>> = {
  shared: ['--link', 'shared'],
  port: ['--link', 'port'],
  stepped: ['--stepped', '--seed', '1'],
};

for (const [way, args] of Object.entries(ways)) {
  test(`${way}: all of a node that ends at once is seen, from its first message and line on`, watchdog, async () => {
    const site = withChecks(makeFolder([{ program: 'burst.c' }]), [
      { kind: 'message', topic: '/burst', field: 'data', equals: 'one' },
      { kind: 'message', topic: '/burst', field: 'data', matches: '^t.o$' },
      { kind: 'message', topic: '/burst', field: 'data', equals: 'three' },
      { kind: 'rate', topic: '/burst' },
      { kind: 'log', log: '^said one$' },
      { kind: 'log', node: 'burst-1', log: 'said three' },
      { kind: 'state', node: 'burst-1', state: 'running' },
      { kind: 'exit_code', node: 'burst-1', exit_code: 7 },
    ]);
    const { code, err } = await run([site, '--checks', ...args]);
    assert.equal(code, 0, err);
    assert.match(err, /^8 of 8 checks passed$/m);
    assert.match(err, /^\[check\] passed: \/burst: data is like \/\^t\.o\$\/ \(\u2018two\u2019\)$/m);
  });

  test(`${way}: a rate that comes, and one that does not`, watchdog, async () => {
    const junit = join(makeFolder([]), 'checks.xml');
    const site = withChecks(makeFolder([{ program: 'talker.c' }]), [
      { kind: 'rate', topic: '/chatter', above: 2, below: 500 },
      { kind: 'rate', topic: '/chatter', above: 5000, within_ms: 4000, title: 'far <too> fast' },
      { kind: 'rate', topic: '/nowhere', within_ms: 500 },
      { kind: 'message', topic: '/chatter', field: 'date', equals: 1, within_ms: 3000 },
      { kind: 'log', log: 'never', within_ms: 1000, source: { file: 'workspace.yaml', line: 7, column: 3 } },
      { kind: 'state', node: 'talker-1', state: 'crashed', within_ms: 500 },
      { kind: 'parameter', node: '/nobody', parameter: 'x', equals: 1, within_ms: 600 },
    ]);
    const { code, err } = await run([site, '--checks', '--junit', junit, ...args]);
    assert.equal(code, 1, err);
    assert.match(err, /^1 of 7 checks passed$/m);
    assert.match(err, /passed: \/chatter above 2 Hz and below 500 Hz \(\d+(\.\d+)? Hz\)/);
    assert.match(err, /failed: far <too> fast\n {2}= seen: .+\n {2}= within: 4\.000 s of the site's time/);
    assert.match(err, /failed: a message on \/nowhere\n {2}= seen: no message/);
    assert.match(err, /failed: a node prints \/never\/\n {2}--> workspace\.yaml:7:3\n {2}= seen: .+/);
    assert.match(err, /failed: talker-1 crashes\n {2}= seen: it (starts|runs)/);
    // Where time does not depend on how busy the machine is.
    if (way === 'stepped') {
      assert.match(err, /= seen: a message of type std_msgs\/msg\/String without date/);
      assert.match(err, /= seen: \d+ lines, the last \u2018Publishing/);
      assert.match(err, /= seen: 50 Hz/);
    }
    assert.match(err, /= seen: no such node/);
    const xml = readFileSync(junit, 'utf8');
    assert.match(xml, /<testsuite name="test" tests="7" failures="6" /);
    assert.match(xml, /name="far &lt;too&gt; fast"/);
  });
}

test('every stepped run of a seed decides at the same times', watchdog, async () => {
  const site = withChecks(makeFolder([{ program: 'talker.c' }]), [
    { kind: 'log', log: 'World: 20' },
    { kind: 'message', topic: '/chatter', field: 'data', matches: ': 33$' },
    { kind: 'rate', topic: '/chatter', above: 49, below: 51 },
    { kind: 'log', log: 'no', within_ms: 90_000 },
  ]);
  const decided = async (): Promise<Json[]> => {
    const { code, out, err } = await run([site, '--checks', '--stepped', '--json']);
    assert.equal(code, 1, err);
    const events = out.trim().split('\n').map((line) => JSON.parse(line) as Json).filter(({ event }) => event === 'check')
      .sort((a, b) => Number(a['index']) - Number(b['index']));
    assert.equal(events.length, 4, `${out}\n${err}`);
    return events;
  };
  const [first, second] = await Promise.all([decided(), decided()]);
  // Lines are told with the frames of the page, which are not of the site's time.
  const plain = (events: readonly Json[]): unknown[] => events.slice(1, 3).map(({ state, afterMs, seen }) => ({ state, afterMs, seen }));
  assert.deepEqual(plain(first), plain(second));
  assert.equal(first[3]?.['state'], 'failed');
  assert.equal(first[3]?.['afterMs'], 90_000);
});

test('a site without checks says so (R2W0720), and --junit needs --checks', watchdog, async () => {
  const folder = withChecks(makeFolder([{ program: 'exits.c' }]), []);
  const { code, err } = await run([folder, '--checks']);
  assert.equal(code, 1);
  assert.match(err, /error\[R2W0720\]: the site has no checks/);
  assert.equal((await run([folder, '--junit', 'x.xml'])).code, 2);
});

test('the time is over for what is not decided when the run is', watchdog, async () => {
  const site = withChecks(makeFolder([{ program: 'talker.c' }]), [{ kind: 'log', log: 'never' }]);
  const { code, err } = await run([site, '--checks', '--for', '500ms']);
  assert.equal(code, 1);
  assert.match(err, /failed: a node prints \/never\//);
});

test('again() forgets what was seen and looks at what comes', watchdog, async () => {
  await withSession([{ program: 'talker.c' }], async (plain) => {
    const session = Object.assign(plain, {
      site: {
        ...plain.site,
        checks: [
          { title: '', aim: { kind: 'log', log: "World: 1'" } as const, withinMs: 600_000 },
          { title: '', aim: { kind: 'log', log: 'World: \\d+' } as const, withinMs: 600_000 },
        ],
      },
    });
    const checks = await runChecks(session);
    session.useChecks(checks);
    const until = (done: (views: readonly CheckView[]) => boolean): Promise<void> =>
      new Promise((resolve) => {
        if (done(checks.views())) resolve();
        else {
          const off = checks.onChange((views) => {
            if (!done(views)) return;
            off();
            resolve();
          });
        }
      });
    assert.deepEqual(checks.views().map(({ state, seen }) => [state, seen]), [['waiting', 'no line'], ['waiting', 'no line']]);
    session.startAll();
    await until((views) => views.every(({ state }) => state === 'passed'));
    await new Promise((resolve) => session.console('talker-1').onLines(resolve));
    session.console('talker-1').clear();
    checks.again();
    await until(([, other]) => other?.state === 'passed');
    assert.equal(checks.views()[0]?.state, 'waiting');
    checks.end();
    assert.equal(checks.views()[0]?.state, 'failed');
    // One alone: the other keeps its verdict.
    const [kept, once] = checks.views();
    // Lines that the console still shows count, so it is cleared.
    session.console('talker-1').clear();
    checks.again(1);
    assert.equal(checks.views()[1]?.afterMs, undefined);
    await until(([, other]) => other?.state === 'passed');
    assert.deepEqual(checks.views()[0], kept);
    assert.notEqual(checks.views()[1], once);
    // And the one that cannot pass fails when its time is over.
    checks.again(0);
    assert.equal(checks.views()[0]?.state, 'waiting');
    assert.equal(checks.views()[1]?.state, 'passed');
    checks.end();
    assert.equal(checks.views()[0]?.state, 'failed');
  });
});

test('what is found while another check is told is told once', watchdog, async () => {
  await withSession([{ program: 'talker.c' }], async (plain) => {
    const log = plain.console('talker-1');
    // Lines as before the page draws: they are there, and nobody is told.
    const quiet = { lines: () => log.lines(), onLines: () => () => undefined };
    const session = Object.assign(plain, {
      console: () => quiet,
      site: {
        ...plain.site,
        checks: [
          { title: '', aim: { kind: 'rate', topic: '/nowhere' } as const, withinMs: 600_000 },
          { title: '', aim: { kind: 'log', log: "World: 1'" } as const, withinMs: 600_000 },
        ],
      },
    });
    const checks = await runChecks(session);
    session.useChecks(checks);
    const told: string[][] = [];
    checks.onChange((views) => told.push(views.map(({ state }) => state)));
    session.startAll();
    await new Promise<void>((resolve) => {
      const off = log.onLines((lines) => {
        if (!lines.some(({ text }) => text.includes("World: 1'"))) return;
        off();
        resolve();
      });
    });
    assert.deepEqual(told, []);
    checks.end();
    assert.deepEqual(told, [['failed', 'passed']]);
  });
});

test('values are what they must be', () => {
  assert.equal(meets(5, { above: 4, below: 6 }), true);
  assert.equal(meets(5n, { above: 5 }), false);
  assert.equal(meets('5', { above: 4 }), false);
  assert.equal(meets(NaN, { below: 1 }), false);
  assert.equal(meets(Math.fround(0.1), { equals: 0.1 }), true);
  assert.equal(meets(7n, { equals: 7 }), true);
  assert.equal(meets(7n, { equals: 7.5 }), false);
  assert.equal(meets('a', { equals: 'a', matches: '^b' }), false);
  assert.equal(meets(true, { equals: true }), true);
  assert.equal(valueAt({ a: { b: [1, { c: 3 }] } }, 'a.b[1].c'), 3);
  assert.equal(valueAt({ r: new Float32Array([1, 2]) }, 'r[1]'), 2);
  assert.equal(valueAt({ r: [] }, 'r.length.x'), undefined);
  for (const path of ['__proto__', 'constructor', 'a.constructor', 'r[9]']) assert.equal(valueAt({ a: {}, r: [1] }, path), undefined);
});

test('site.json with a broken check is refused', () => {
  const site = (check: Json): unknown => ({ schema: 1, protocol: 1, nodes: [], checks: [{ within_ms: 1, ...check }] });
  for (
    const check of [
      { kind: 'sight' },
      { kind: 'log', log: '(' },
      { kind: 'log', log: 'a', node: 'nobody' },
      { kind: 'rate' },
      { kind: 'message', topic: '/a', field: 'x', equals: [1] },
      { kind: 'state', node: 'x', state: 'fine' },
    ]
  ) assert.throws(() => readSite(site(check)), { code: 'R2W0700' });
});

test('hostile words stay words, in XML and on the terminal', () => {
  const view: CheckView = {
    title: '"><script>&\u0000\ud800',
    state: 'failed',
    seen: '\u001b[2J</failure>\n\u0007',
    withinMs: 1000,
    source: { file: 'a"b.yaml', line: 1, column: 1 },
  };
  const xml = junitXml('a&b', [view, { ...view, state: 'passed', afterMs: 1500 }]);
  assert.doesNotMatch(xml, /<script>|\u0000|\u001b|\u0007|[\ud800-\udfff]/u);
  assert.match(xml, /name="&quot;&gt;&lt;script&gt;&amp;\ufffd\ufffd" file="a&quot;b.yaml" line="1" time="0.000"/);
  assert.match(xml, /seen: \ufffd\[2J&lt;\/failure&gt;&#10;\ufffd"/);
  assert.match(xml, /<testsuites tests="2" failures="1" errors="0" skipped="0" time="1.500">/);
  assert.doesNotMatch(checkLine(view).replaceAll('\n', ''), /[\u0000-\u001f]/);
  assert.equal(checkTitle({ title: '', aim: { kind: 'exit_code', node: 'a-1', exitCode: 0 } }), 'a-1 ends with code 0');
});
