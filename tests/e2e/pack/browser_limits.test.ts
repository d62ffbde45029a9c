// A program that needs what no browser has is skipped when its package has others, now and from the cache; what only
// a library of the compiler refers to is packed; and calls that fail say so in the node's console.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Workshop } from '../../scoreboard/site.ts';
import { CLI, PackWorkspace } from '../support/pack_workspace.ts';

const HELLO = '#include <cstdio>\n#include <cstdlib>\nint main() { std::printf("hello %d\\n", std::system("ls -l")); }\n';
const UDP = '#include <sys/socket.h>\nint open_port() { return socket(AF_INET, SOCK_DGRAM, 0); }\n';
const WARNING =
  /warning\[R2W0523\]: `udp` of package `course` is skipped: it needs sockets, which no browser has\n {3}= why: udp\.cpp of libport\.a refers to `socket`\n/;
let ws: PackWorkspace;

before(() => {
  ws = new PackWorkspace();
  ws.write('src/course/src/port/udp.cpp', UDP);
  ws.addPackage('course', {
    hello: HELLO,
    udp: 'int open_port();\nint main() { return open_port(); }\n',
    // Has the name of a function of sockets, and is none.
    mine: '#include <cstdio>\nextern "C" int bind(int a, int b) { return a + b; }\nint main() { std::printf("%d\\n", bind(1, 2)); }\n',
  }, { cmake: 'add_library(port src/port/udp.cpp)\ntarget_link_libraries(udp port)\ntarget_link_libraries(hello port)\n' });
  ws.write('workspace.yaml',
    'schema: 1\nname: course\npackages: [src/*]\nlaunch:\n  - {package: course, executable: hello}\n  - {package: course, executable: mine}\n');
});
after(() => ws.close());

test('the others are packed, and the warnings come from the cache too', async () => {
  for (const note of [/built course/, /nothing to build/]) {
    const packed = await ws.run(['pack', '-o', 'site']);
    assert.equal(packed.code, 0, packed.stderr);
    assert.match(packed.stderr, WARNING);
    assert.match(packed.stderr, /warning\[R2W0524\]: `hello` of package `course` asks for a shell, which no browser has\n/);
    assert.match(packed.stderr, note);
  }
});

test('a quick link finds the same', async () => {
  const packed = await ws.run(['pack', '--quick', '-o', 'quick']);
  assert.equal(packed.code, 0, packed.stderr);
  assert.match(packed.stderr, WARNING);
});

test('a call that fails is in the console', async () => {
  const ran = await ws.run(['run', 'site', '--for', '60s', '--until', 'hello -1']);
  assert.equal(ran.code, 0, ran.stderr);
  assert.match(ran.stdout, /\[hello-1\] R2W0761: system\("ls -l"\) failed: a browser has no such thing/);
});

test('the score board has a row for it', async () => {
  const course = { name: 'course', folder: join(ws.root, 'src/course'), language: 'cpp', needs: [] } as const;
  const built = await new Workshop(CLI, join(ws.root, 'board'), new Map([['course', course]]), []).build('course');
  assert.ok('executables' in built, JSON.stringify(built));
  assert.deepEqual(built.executables, ['hello', 'mine']);
  assert.deepEqual([...built.leftOut], [['udp', { code: 'R2W0523', reason: 'skipped: it needs sockets (udp.cpp of libport.a refers to `socket`)' }]]);
});
