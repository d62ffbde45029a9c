// A package of which one program includes what nothing gives: its others are packed (R2W0522), now and from the cache.
// Any other mistake, and a package of which nothing would remain, are errors as ever.
//
// Compatibility, differs: a program that includes a header which neither its package, nor what that asks for, nor a channel has -> it is left
// out with a warning that names header, file and line (R2W0522), the rest of its package is built; a manifest that names it is refused with R2W0405
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, beforeEach, test } from 'node:test';
import { Workshop } from '../../scoreboard/site.ts';
import { CLI, PackWorkspace } from '../support/pack_workspace.ts';

const HELLO = '#include <cstdio>\nint main() { std::puts("hello"); }\n';
const WEB = '#include <cstdio>\n#include "webthing/server.h"\nint main() {}\n';
const WARNING =
  /warning\[R2W0522\]: `web` of package `course` is skipped: nothing gives the header `webthing\/server\.h`\n --> src\/course\/src\/web\.cpp:2:10\n/;
let ws: PackWorkspace;

before(() => {
  ws = new PackWorkspace();
});

beforeEach(() => {
  ws.addPackage('course', { hello: HELLO, web: WEB });
});

after(() => ws.close());

function launch(executable: string): void {
  ws.write('workspace.yaml', `schema: 1\nname: course\npackages: [src/*]\nlaunch:\n  - {package: course, executable: ${executable}}\n`);
}

test('the other programs are built, and the warning comes from the cache too', async () => {
  launch('hello');
  for (const note of [/built course/, /nothing to build/]) {
    const packed = await ws.run(['pack', '-o', 'site']);
    assert.equal(packed.code, 0, packed.stderr);
    assert.match(packed.stderr, WARNING);
    assert.match(packed.stderr, note);
  }
});

test('who starts it is told the header, the file and the line', async () => {
  launch('web');
  const refused = await ws.run(['pack', '-o', 'site']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0405\]: `web` of package `course` is not a program that a site can run\n/);
  assert.match(refused.stderr, /it needs the header `webthing\/server\.h` \(src\/web\.cpp:2\), which no site has/);
});

test('with another mistake beside it the package fails whole', async () => {
  ws.addPackage('course', { hello: HELLO.replace('std::puts', 'std::putz'), web: WEB });
  launch('hello');
  const refused = await ws.run(['build']);
  assert.equal(refused.code, 1);
  assert.match(refused.stderr, /error\[R2W0502\]: .*'putz'/);
  assert.match(refused.stderr, /error\[R2W0502\]: .*'webthing\/server\.h' file not found/);
  assert.doesNotMatch(refused.stderr, /R2W0522/);
});

test('so does a package of which no program remains, a library that lacks a header, and a header of its own', async () => {
  launch('hello');
  const fails = async (programs: Readonly<Record<string, string>>, cmake = ''): Promise<void> => {
    ws.addPackage('course', programs, { cmake });
    const refused = await ws.run(['build']);
    assert.equal(refused.code, 1);
    assert.match(refused.stderr, /error\[R2W0502\]: package `course` does not compile: '[a-z_/.]+' file not found/);
    assert.doesNotMatch(refused.stderr, /R2W0522/);
  };
  await fails({ web: WEB });
  await fails({ hello: HELLO, web: WEB }, 'add_library(part src/web.cpp)\n');
  await fails({ hello: HELLO, web: WEB.replace('webthing/', 'course/') });
  await fails({ hello: HELLO, web: WEB.replace('webthing/', 'std_msgs/msg/') });
});

test('the score board has a row for it', async () => {
  const course = { name: 'course', folder: join(ws.root, 'src/course'), language: 'cpp', needs: [] } as const;
  const built = await new Workshop(CLI, join(ws.root, 'board'), new Map([['course', course]]), []).build('course');
  assert.ok('executables' in built, JSON.stringify(built));
  assert.deepEqual(built.executables, ['hello']);
  assert.deepEqual([...built.leftOut], [['web', { code: 'R2W0522', reason: 'skipped: it needs the header `webthing/server.h` (src/web.cpp:2)' }]]);
});
