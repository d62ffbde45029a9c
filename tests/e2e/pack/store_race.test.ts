// Packs of sites that share a store, and `--prune`, at the same time.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 240_000 };

let ws: PackWorkspace;

const manifest = (title: string): string =>
  `schema: 1
name: two
title: ${title}
distro: jazzy
packages: [src/*]
launch:
  - {package: quick, executable: hello}
`;

before(async () => {
  ws = new PackWorkspace('shared');
  ws.addPackage('quick', { hello: '#include <cstdio>\nint main() { std::puts("hello"); }\n' });
  ws.write('one.yaml', manifest('one'));
  ws.write('two.yaml', manifest('two'));
  ws.write('course.yaml', 'schema: 1\nname: labs\ntitle: Labs\nlabs:\n  - {workspace: one.yaml, name: one}\n  - {workspace: two.yaml, name: two}\n');
  const packed = await ws.run(['pack', 'course.yaml', '-o', 'course']);
  assert.equal(packed.code, 0, packed.stderr);
}, watchdog);

after(() => ws.close());

// Guarantee, hostile input: `--prune` takes nothing away that another pack of the same store has just written, and no pack fails by it
test('a pack and a pack with --prune at once', watchdog, async () => {
  for (let turn = 0; turn < 5; ++turn) {
    ws.write('two.yaml', manifest(`turn ${turn}`));
    const both = await Promise.all([ws.run(['pack', 'course.yaml', '-o', 'course']), ws.run(['pack', 'course.yaml', '-o', 'course', '--prune'])]);
    for (const { code, stderr } of both) assert.equal(code, 0, stderr);
    const verified = await ws.run(['verify', 'course']);
    assert.equal(verified.code, 0, verified.stderr);
  }
});

// Guarantee, robust: two packs to one place at once both end well, and leave one site that is whole
test('two packs to one place at once', watchdog, async () => {
  for (let turn = 0; turn < 3; ++turn) {
    const both = await Promise.all(['one', 'two'].map((name) => ws.run(['pack', `${name}.yaml`, '-o', 'site'])));
    for (const { code, stderr } of both) assert.equal(code, 0, stderr);
    const verified = await ws.run(['verify', 'site']);
    assert.equal(verified.code, 0, verified.stderr);
  }
});

// Guarantee, robust: a pack that is killed at any moment leaves the old site whole and nothing beside it after the next pack
test('packs that are killed', watchdog, async () => {
  for (let turn = 0; turn < 6; ++turn) {
    const child = ws.start(['pack', turn % 2 === 0 ? 'one.yaml' : 'two.yaml', '-o', 'site']);
    // It dies at another step each time: after so many lines of what it says.
    let lines = 0;
    child.stderr?.on('data', (text: Buffer) => {
      lines += text.toString().split('\n').length - 1;
      if (lines > turn) child.kill('SIGKILL');
    });
    await new Promise((done) => child.on('close', done));
    const verified = await ws.run(['verify', 'site']);
    assert.equal(verified.code, 0, verified.stderr);
  }
  assert.equal((await ws.run(['pack', 'one.yaml', '-o', 'site'])).code, 0);
  assert.deepEqual([...ws.files('.').keys()].filter((path) => path.includes('-new-')), []);
});
