// Nodes that cannot start: no place on the bus, a worker whose script breaks or that sends what is not a report, an engine
// that cannot suspend; and one that is slow to start.

// Compatibility, cannot: nodes, of Python too, in a browser that suspends no programs (no JSPI), on a page without shared memory -> each
// says so (R2W0705); on a page with shared memory it runs there

import assert from 'node:assert/strict';
import { rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { type Broker, PortBroker, SharedBroker } from '../../../runtime/site/bus/broker.ts';
import { nodePlatform } from '../../../runtime/site/session/node_platform.ts';
import type { NodeState } from '../../../runtime/site/contract/session.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { SiteSession } from '../../../runtime/site/session/site_session.ts';
import { makeFolder, reaches } from './site_fixture.ts';

const watchdog = { timeout: 240_000 };
const headless = new URL('../../../runtime/site/session/headless.ts', import.meta.url);

/** How the only node of a site ends; `script` is what its worker begins with. */
async function endOf(broker: Broker, script = ''): Promise<NodeState> {
  const folder = makeFolder([{ program: 'talker.c' }]);
  const entry = join(folder, 'entry.mjs');
  writeFileSync(entry, `${script}\nawait import(${JSON.stringify(headless.href)});\n`);
  const platform = nodePlatform(folder, pathToFileURL(entry));
  const session = new SiteSession({ site: readSite(await platform.json('site.json')), platform, broker });
  try {
    session.startAll();
    return (await reaches(session, 'talker-1', 'crashed')).state;
  } finally {
    session.close();
    platform.close();
    rmSync(folder, { recursive: true });
  }
}

test('R2W0707: a site with more nodes than the bus has places', watchdog, async () => {
  const broker = new SharedBroker({ ceiling: 64 << 20 });
  let places = 0;
  while (broker.admit() !== undefined) places += 1;
  assert.ok(places >= 100, `${places} places`);
  assert.deepEqual(await endOf(broker), {
    kind: 'crashed',
    code: 'R2W0707',
    message: 'the site has more nodes than the bus has places',
  });
});

test('R2W0708: a worker whose script breaks', watchdog, async () => {
  assert.deepEqual(await endOf(new SharedBroker({ ceiling: 64 << 20 }), "throw new Error('the script broke');"), {
    kind: 'crashed',
    code: 'R2W0708',
    message: 'the script broke',
  });
});

for (
  const [name, sent] of [
    ['nothing', 'null'],
    ['lines without lines', "{ t: 'lines' }"],
    ['an end without an end', "{ t: 'end' }"],
    ['what another kind of worker reports', "{ t: 'launch', answer: 1 }"],
    ['a thread of a program that a link without threads runs',
      "{ t: 'memory', memory: { memory: new WebAssembly.Memory({ initial: 1, maximum: 1, shared: true }), waits: 0 } }"],
  ] as const
) {
  // Guarantee, hostile input: what a program sends to the page in its worker's place ends that node (R2W0727), and no other one
  test(`R2W0727: a worker that sends ${name}`, watchdog, async () => {
    const forge = "import { parentPort } from 'node:worker_threads';\nconst send = parentPort.postMessage.bind(parentPort);\n"
      + `parentPort.postMessage = (report) => { send(report); if (report.t === 'running') send(${sent}); };`;
    assert.deepEqual(await endOf(new PortBroker(), forge), {
      kind: 'crashed',
      code: 'R2W0727',
      message: 'the program sends the page what is not a report of a node',
    });
  });
}

test('R2W0705: neither shared memory nor an engine that suspends', watchdog, async () => {
  assert.deepEqual(await endOf(new PortBroker(), 'delete WebAssembly.Suspending;'), {
    kind: 'crashed',
    code: 'R2W0705',
    message: 'this browser can neither share memory with this page nor suspend a program',
  });
});

test('a node that is restarted while it starts runs', watchdog, async () => {
  const folder = makeFolder([{ program: 'talker.c' }]);
  const real = nodePlatform(folder, headless);
  const asked: (() => void)[] = [];
  const platform = {
    ...real,
    compile: async (path: string): Promise<WebAssembly.Module> => {
      await new Promise<void>((resolve) => asked.push(resolve));
      return real.compile(path);
    },
  };
  const session = new SiteSession({
    site: readSite(await real.json('site.json')),
    platform,
    broker: new SharedBroker({ ceiling: 64 << 20 }),
  });
  try {
    session.startAll();
    session.restart('talker-1');
    assert.equal(asked.length, 2, 'two starts wait for the program');
    for (const go of asked) go();
    await reaches(session, 'talker-1', 'running');
  } finally {
    session.close();
    real.close();
    rmSync(folder, { recursive: true });
  }
});

test('R2W0710: a program for which there is no memory', watchdog, async () => {
  // The error that Chromium and Node.js throw when a process has as many memories as it may have.
  const full = `const { Instance } = WebAssembly;
  WebAssembly.Instance = function (module, imports) {
    if (imports?.ros2wasm === undefined) return new Instance(module, imports);
    throw new RangeError('WebAssembly.Instance(): Out of memory: Cannot allocate Wasm memory for new instance');
  };`;
  assert.deepEqual(await endOf(new SharedBroker({ ceiling: 64 << 20 }), full), {
    kind: 'crashed',
    code: 'R2W0710',
    message: 'there is no memory for one more program',
  });
});
