// git and patch accept the text of "Copy as patch", and it changes the packed files into those that the visitor sees.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { type ChangedFile, makePatch } from '../../../runtime/site/ui/model/patch.ts';

const tools: readonly (readonly string[])[] = [['git', 'apply', '--whitespace=nowarn', '-'], ['patch', '-p1', '--binary', '--posix'], ['patch', '-p1',
  '--binary']];

/** The texts of the files after a tool has applied the patch. */
function applied(files: readonly ChangedFile[], [tool = '', ...args]: readonly string[]): (string | undefined)[] {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-patch-'));
  try {
    for (const { path, before } of files) {
      mkdirSync(dirname(join(folder, path)), { recursive: true });
      writeFileSync(join(folder, path), before);
    }
    // Not within some repository around it.
    execFileSync(tool, args, {
      cwd: folder,
      input: makePatch(files),
      env: { ...process.env, GIT_CEILING_DIRECTORIES: dirname(folder) },
      stdio: ['pipe', 'ignore', 'pipe'],
    });
    return files.map(({ path }) => readFileSync(join(folder, path), 'utf8'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function check(files: readonly ChangedFile[], which = tools): void {
  for (const tool of which) assert.deepEqual(applied(files, tool), files.map(({ after }) => after), `${tool.join(' ')}\n${makePatch(files)}`);
}

const lines = (count: number, change: (n: number) => string = (n) => `line ${n}`): string => Array.from({ length: count }, (_, i) => `${change(i)}\n`).join('');

// Compatibility, works: a patch of the page is taken by `git apply` and `patch -p1`
test('changes at the begin, in the middle, at the end; far apart and close together', () => {
  const path = 'src/demo/demo/talker.py';
  const before = lines(60);
  for (const changed of [[0], [59], [30], [3, 50], [10, 15, 19], [0, 7, 14, 59]]) {
    check([{ path, before, after: lines(60, (n) => (changed.includes(n) ? `other ${n}` : `line ${n}`)) }]);
    check([{ path, before, after: lines(60, (n) => (changed.includes(n) ? `line ${n}\nmore\nmore` : `line ${n}`)) }]);
    check([{ path, before, after: before.split('\n').filter((_, n) => !changed.includes(n)).join('\n') }]);
  }
});

test('ends without a newline, other ends of lines, files that become empty or were so', () => {
  const of = (before: string, after: string): ChangedFile[] => [{ path: 'a/b.py', before, after }];
  check(of('one\ntwo', 'one\ntwo\n'));
  check(of('one\ntwo\n', 'one\ntwo'));
  check(of('one\ntwo', 'one\nthree'));
  check(of('one\r\ntwo\r\n', 'one\r\nthree\r\n'));
  check(of('a\rb\u2028c\n', 'a\rB\u2028c\n'));
  // GNU patch removes a file that becomes empty, unless it is to follow POSIX.
  check(of('one\n', ''), tools.slice(0, 2));
  assert.equal(makePatch(of('same\n', 'same\n')), '');
});

test('several files, with names that would break a patch', () => {
  const files = ['src/a b/c d.py', 'src/ä/ö.py', 'src/q"uote/t\tab.py', 'src/new\nline/--- a.py', 'src/back\\slash.py']
    .map((path, n) => ({ path, before: lines(9), after: lines(9, (i) => (i === n ? 'changed' : `line ${i}`)) }));
  check(files, tools.filter((tool) => !tool.includes('--posix')));
});

test('random texts', () => {
  let seed = 7;
  const random = (below: number): number => {
    seed = (seed * 1_103_515_245 + 12_345) % 2_147_483_648;
    return Math.floor((seed / 2_147_483_648) * below);
  };
  const text = (): string => Array.from({ length: random(30) }, () => 'abc'[random(3)]).join('\n') + (random(2) === 0 ? '\n' : '');
  for (let i = 0; i < 40; i += 1) {
    const [before, after] = [text() || 'x', text() || 'y'];
    if (before !== after) check([{ path: 'x.py', before, after }], tools.slice(0, 1));
  }
});

test('texts that have nothing in common are replaced as a whole, in no time', () => {
  const begin = performance.now();
  const patch = makePatch([{ path: 'x.py', before: lines(20_000), after: lines(20_000, (n) => `other ${n}`) }]);
  assert.equal(patch.split('\n').length, 40_000 + 3 + 1);
  assert.ok(performance.now() - begin < 5_000);
});
