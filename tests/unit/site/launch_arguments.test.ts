import assert from 'node:assert/strict';
import { test } from 'node:test';
import { givenInAddress, readGiven, shownArguments } from '../../../runtime/site/contract/launch_arguments.ts';
import { evaluateLaunch } from '../../../runtime/site/launch/launch_evaluation.ts';
import { protocolVersion } from '../../../runtime/protocol/generated/constants.ts';
import { askWithPython } from '../../../runtime/site/workers/launch_worker.ts';
import type { WorkerReport } from '../../../runtime/site/workers/worker_messages.ts';
import type { Platform, WorkerEvents, WorkerHandle } from '../../../runtime/site/workers/platform.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { runTexts } from '../../../runtime/site/ui/texts_run.ts';
import { isGiven, launchLink, valuesOf } from '../../../runtime/site/ui/model/launch_link.ts';

const argument = (name: string, usual: string | undefined, value = usual ?? '', choices: readonly string[] = []) => ({
  name,
  value,
  description: '',
  choices,
  ...(usual === undefined ? {} : { default: usual, packed: usual }),
});

test('an address and a command line give the same', () => {
  assert.deepEqual([...givenInAddress('?robot:=a%20b&seed=3&empty:=&x:=1:=2')], [['robot', 'a b'], ['empty', ''], ['x', '1:=2']]);
  assert.deepEqual([...readGiven(['robot:=a b', 'empty:=', 'x:=1', 'x:=1:=2'])], [['robot', 'a b'], ['empty', ''], ['x', '1:=2']]);
  assert.deepEqual([...givenInAddress('?seed=3')], []);
});

test('R2W0730: what is not a launch argument', () => {
  for (const word of ['robot', ':=x', 'robot=x'])
    assert.throws(() => readGiven([word]), (error) => error instanceof SiteError && error.code === 'R2W0730');
});

test('a link has what differs from the values without it, and keeps what else it had', () => {
  const all = [argument('robot', 'a'), argument('speed', '1.0'), argument('must', undefined, 'x')];
  const values = new Map([['robot', 'a'], ['speed', '2 & 3'], ['must', 'x']]);
  const link = launchLink('https://example.org/site/?old:=1&graph=g&nodes=n-1#layout=x', all, values);
  assert.equal(link, 'https://example.org/site/?graph=g&speed:=2%20%26%203&must:=x#layout=x');
  assert.deepEqual([...givenInAddress(new URL(link).search)], [['speed', '2 & 3'], ['must', 'x']]);
  assert.equal(isGiven(link), true);
  assert.equal(isGiven(launchLink(link, [], new Map())), false);
});

test('a link has what differs from what the site was packed with, be it the default', () => {
  const all = [{ ...argument('robot', 'a'), packed: 'b' }];
  const link = (robot: string): string => launchLink('https://example.org/', all, new Map([['robot', robot]]));
  assert.equal(link('b'), 'https://example.org/');
  assert.equal(link('a'), 'https://example.org/?robot:=a');
});

test('what can be chosen from: choices, and truths as the file writes them', () => {
  assert.deepEqual(valuesOf(argument('x', 'a', 'a', ['a', 'b'])), ['a', 'b']);
  assert.deepEqual(valuesOf(argument('x', 'True')), ['True', 'False']);
  assert.deepEqual(valuesOf(argument('x', 'true', 'false')), ['true', 'false']);
  assert.equal(valuesOf(argument('x', 'true', '1')), undefined);
  assert.equal(valuesOf(argument('x', '1')), undefined);
});

test('a list without arguments', () => {
  assert.equal(shownArguments([]), "Arguments (pass arguments as '<name>:=<value>'):\n\n  No arguments.");
  assert.match(shownArguments([argument('q', "it's")]), /\(default: 'it\\'s'\)/);
});

test('R2W0733: a launch file that asks for more and more files', async () => {
  let count = 0;
  const asksOn = (): unknown => ({ needs: [`share/p/${count += 1}.yaml`] });
  await assert.rejects(
    evaluateLaunch(asksOn, '{}', { given: {} }, [], () => Promise.resolve('')),
    (error) => error instanceof SiteError && error.code === 'R2W0733',
  );
  assert.equal(count, 200);
});

test('files are fetched once, and handed on', async () => {
  const asked: string[] = [];
  const evaluate = (question: string): unknown => {
    const { files } = JSON.parse(question) as { files: Record<string, string>; };
    return files['share/p/a'] === undefined ? { needs: ['share/p/a'] } : { nodes: [], text: files['share/p/a'] };
  };
  const answer = await evaluateLaunch(evaluate, '{}', { given: {} }, ['share/p/a'], (path) => {
    asked.push(path);
    return Promise.resolve('what a says');
  });
  assert.equal(answer['text'], 'what a says');
  assert.deepEqual(asked, ['share/p/a']);
});

const siteOfPython = readSite({
  schema: 1,
  protocol: protocolVersion,
  nodes: [],
  files: [],
  launch_file: {
    data: 'launch.json',
    evaluator: 'launch_evaluator.wasm',
    arguments: [],
    python: { tried: ['mode'], program: 'pyodide/pyodide.asm.wasm', archives: [] },
  },
});

/** A platform whose worker says what `reports` does, and notes its end. */
function workerPlatform(reports: readonly WorkerReport[], failed?: string): { platform: Platform; ended: () => number; } {
  let ended = 0;
  const platform = {
    place: '/site',
    compile: async () => new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0)),
    bytes: async () => new ArrayBuffer(0),
    startWorker: (_name: string, events: WorkerEvents): WorkerHandle => ({
      post: () => {
        for (const one of reports) events.report(one);
        if (failed !== undefined) events.failed(failed);
      },
      terminate: async () => {
        ended += 1;
      },
    }),
  } as unknown as Platform;
  return { platform, ended: () => ended };
}

function askPython(platform: Platform): Promise<unknown> {
  assert.ok(siteOfPython.launch);
  return askWithPython(siteOfPython, siteOfPython.launch, '{}', '"given":{}}', platform);
}

test('what Python answers in its worker is the answer, and the worker ends', async () => {
  const { platform, ended } = workerPlatform([{ t: 'running' }, { t: 'launch', answer: { nodes: [] } }]);
  assert.deepEqual(await askPython(platform), { nodes: [] });
  assert.equal(ended(), 1);
});

test('R2W0416: a launch file that does not end is stopped after a minute', async (context) => {
  context.mock.timers.enable({ apis: ['setTimeout'] });
  const { platform, ended } = workerPlatform([{ t: 'running' }]);
  const asked = askPython(platform);
  asked.catch(() => undefined);
  for (let i = 0; i < 100; i += 1) await Promise.resolve();
  context.mock.timers.tick(59_999);
  assert.equal(ended(), 0);
  context.mock.timers.tick(1);
  await assert.rejects(asked, (error) => error instanceof SiteError && error.code === 'R2W0416');
  assert.equal(ended(), 1);
});

test('R2W0733: Python that does not start, or dies', async () => {
  for (const { platform, ended } of [workerPlatform([{ t: 'launch', failed: 'no memory' }]), workerPlatform([], 'the worker ended')]) {
    await assert.rejects(askPython(platform), (error) => error instanceof SiteError && error.code === 'R2W0733');
    assert.equal(ended(), 1);
  }
});

test('what site.json says of Python', () => {
  assert.deepEqual(siteOfPython.launch?.python, { tried: ['mode'], program: 'pyodide/pyodide.asm.wasm', archives: [] });
  const said = (python: Record<string, unknown>): string => runTexts.launch.python({ tried: [], ...python });
  assert.match(said({ program: 'p' }), /asked of it again, in this page/);
  assert.match(said({ tried: ['mode', 'robot'] }), /packed for each value of mode, robot; with other values/);
  assert.match(said({}), /stays as it was packed/);
  for (const python of [3, { archives: ['../up'] }, { program: 7 }, { tried: [1] }]) {
    const launch = { data: 'launch.json', evaluator: 'e.wasm', arguments: [], python };
    assert.throws(() => readSite({ schema: 1, protocol: protocolVersion, nodes: [], files: [], launch_file: launch }), SiteError);
  }
});
