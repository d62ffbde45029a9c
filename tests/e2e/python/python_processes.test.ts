// A Python program that tries to start others: none is run, also headless, where Emscripten itself would have a shell run them.

// Compatibility, differs: `os.system` -> runs nothing and says so on stderr (a command that only clears the screen: nothing is said);
// `os.popen`, `os.fork`, `os.exec...` -> OSError that says why

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { played } from '../../support/nightly.ts';
import { ownPackage } from '../../support/python_nodes.ts';
import { makeSite } from '../support/runtime_site.ts';

const watchdog = { timeout: 240_000 };
const headless = fileURLToPath(new URL('../../../runtime/site/session/headless.ts', import.meta.url));
const why = 'a program of a page cannot start another one';
let folder = '';

before(() => {
  folder = makeSite([], {}, {}, { nodes: [{ entry: 'lib/chatter_py/starts', executable: 'starts' }], packages: ownPackage('chatter_py') });
});

after(() => rmSync(folder, { recursive: true }));

for (const link of played('shared', 'port')) {
  test(`${link}: no program is started, and each try is answered`, watchdog, async () => {
    const child = spawn(process.execPath, [headless, folder, '--link', link], { stdio: ['ignore', 'pipe', 'pipe'], cwd: join(folder, 'python') });
    let [out, err] = ['', ''];
    child.stdout.on('data', (bytes: Buffer) => {
      out += bytes.toString();
    });
    child.stderr.on('data', (bytes: Buffer) => {
      err += bytes.toString();
    });
    await new Promise((resolve) => child.on('close', resolve));
    const none = 'emscripten does not support processes.';
    assert.deepEqual(out.split('\n').filter((line) => line !== ''), [
      `os.system('echo run >&2'): ${why}: nothing was run`,
      'system 32512 32512 0 0',
      `popen ${none}`,
      `fork os.fork: ${why}`,
      `execv os.execv: ${why}`,
      `execlp os.execv: ${why}`,
      `spawnl os.fork: ${why}`,
      `run ${none}`,
      `Popen ${none}`,
      `Process os.fork: ${why}`,
      'posix -1',
    ].map((line) => `[starts-1] ${line}`));
    // The output of a command that a shell ran would be here.
    assert.doesNotMatch(err, /^run$/m);
  });
}
