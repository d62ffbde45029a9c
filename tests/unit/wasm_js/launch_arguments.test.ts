import assert from 'node:assert/strict';
import { test } from 'node:test';
import { givenInAddress, readGiven, shownArguments } from '../../../runtime/wasm_js/launch_arguments.ts';
import { evaluateLaunch } from '../../../runtime/wasm_js/launch_evaluation.ts';
import { SiteError } from '../../../runtime/wasm_js/site_error.ts';
import { isGiven, launchLink, valuesOf } from '../../../runtime/ui/model/launch_link.ts';

const argument = (name: string, usual: string | undefined, value = usual ?? '', choices: readonly string[] = []) =>
  ({ name, value, description: '', choices, ...(usual === undefined ? {} : { default: usual, packed: usual }) });

test('an address and a command line give the same', () => {
  assert.deepEqual([...givenInAddress('?robot:=a%20b&seed=3&empty:=&x:=1:=2')], [['robot', 'a b'], ['empty', ''], ['x', '1:=2']]);
  assert.deepEqual([...readGiven(['robot:=a b', 'empty:=', 'x:=1', 'x:=1:=2'])], [['robot', 'a b'], ['empty', ''], ['x', '1:=2']]);
  assert.deepEqual([...givenInAddress('?seed=3')], []);
});

test('R2W0730: what is no launch argument', () => {
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
    const { files } = JSON.parse(question) as { files: Record<string, string> };
    return files['share/p/a'] === undefined ? { needs: ['share/p/a'] } : { nodes: [], text: files['share/p/a'] };
  };
  const answer = await evaluateLaunch(evaluate, '{}', { given: {} }, ['share/p/a'], (path) => {
    asked.push(path);
    return Promise.resolve('what a says');
  });
  assert.equal(answer['text'], 'what a says');
  assert.deepEqual(asked, ['share/p/a']);
});
