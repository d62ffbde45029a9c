// Modules of Python that a program can import and not use in a site: the pack warns of them, with file and line.

// Compatibility, differs: subprocess, multiprocessing, sockets and what builds on them, shared libraries of ctypes -> a
// browser has none of it: the pack warns of the import with file and line, and what to do instead

import assert from 'node:assert/strict';
import { rmSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

let workspace: PackWorkspace;

before(() => {
  workspace = new PackWorkspace();
});

after(() => rmSync(workspace.root, { recursive: true }));

test('a program that starts others is packed, with a warning for each import', { timeout: 300_000 }, async () => {
  workspace.write('workspace.yaml', 'schema: 1\nname: lab\ndistro: jazzy\npackages: [src/*]\nlaunch:\n  - {package: eyes, executable: see}\n');
  workspace.addPythonPackage('eyes', {
    see: `import ctypes
import socket
from multiprocessing import Process


def main():
    import subprocess
    from urllib import parse, request
`,
  });
  const { code, stderr } = await workspace.run(['pack', 'workspace.yaml', '--plan']);
  assert.equal(code, 0, stderr);
  const told = [...stderr.matchAll(/warning\[R2W0526\]: `(.+)` can be imported, but does not work in a site\n --> src\/eyes\/eyes\/see\.py:(\d+):\d+\n/g)];
  assert.deepEqual(told.map(([, module, line]) => `${module} ${line}`), ['ctypes 1', 'socket 2', 'multiprocessing 3', 'subprocess 7', 'urllib.request 8'],
    stderr);
  assert.match(stderr, /why: a browser starts no programs: `run` and `Popen` raise OSError\n.*why: a program of the workspace can be a node/);
});
