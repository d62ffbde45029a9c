// Programs of C++ and of Python with each other, each side as its tutorial has it, packed as one site: topics, services and
// actions, in both directions.

// Compatibility, works: C++ and Python nodes of a workspace with each other: messages of upstream's and of own types, services, and
// actions with feedback, results, refused and cancelled goals, each in both directions

import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';

import { openHeadless } from '../../../runtime/site/session/headless_session.ts';
import { played } from '../../support/nightly.ts';
import { serveFolder } from '../../support/static_server.ts';
import { chromiumOptions } from '../support/chromium.ts';
import { PackWorkspace } from '../support/pack_workspace.ts';

const watchdog = { timeout: 240_000 };

/** In the order of the manifest. Each pair has a namespace of its own, but one: its client counts its arguments. */
const nodes: readonly {
  readonly package: string;
  readonly executable: string;
  readonly namespace?: string;
  readonly arguments?: string;
  readonly says?: readonly RegExp[];
}[] = [
  { package: 'learn_topics_cpp', executable: 'publisher', namespace: '/heard_in_python' },
  { package: 'learn_topics_py', executable: 'subscriber', namespace: '/heard_in_python', says: [/I heard: "Hello, world! \d+"/, /five are enough/] },
  { package: 'learn_topics_py', executable: 'publisher', namespace: '/heard_in_cpp' },
  { package: 'learn_own_types_py', executable: 'talker', namespace: '/heard_in_cpp' },
  {
    package: 'learn_topics_cpp',
    executable: 'subscriber',
    namespace: '/heard_in_cpp',
    says: [/I heard as bytes: 'Hello World: \d+'/, /heard in all 8 forms/, /I heard the number \d+/],
  },
  { package: 'learn_own_types_py', executable: 'adder', says: [/Incoming request a: 10 b: 20 c: 12/] },
  { package: 'learn_services_cpp', executable: 'add_three_ints_client', arguments: "['10', '20', '12']", says: [/Sum: 42/, /Again: 42/] },
  { package: 'demo_nodes_cpp', executable: 'add_two_ints_server', namespace: '/served_in_cpp', says: [/Incoming request/, /a: 40 b: 2/] },
  {
    package: 'learn_services_py',
    executable: 'client',
    namespace: '/served_in_cpp',
    arguments: "['40', '2']",
    says: [/Result of add_two_ints: for 40 \+ 2 = 42/, /while a thread spins: 5/, /in a callback: 42/],
  },
  {
    package: 'learn_actions_py',
    executable: 'server',
    namespace: '/acted_in_python',
    says: [/Received goal request/, /Executing goal/, /Received cancel request/, /Goal canceled/],
  },
  {
    package: 'learn_actions_cpp',
    executable: 'fibonacci_client',
    namespace: '/acted_in_python',
    says: [/Goal accepted by server/, /Next number in sequence received: 1$/, /Result received: 0 1 1 2 3 5 8 13 21 $/, /Goal was canceled/],
  },
  {
    package: 'learn_actions_cpp',
    executable: 'fibonacci_server',
    namespace: '/acted_in_cpp',
    says: [/Received goal request with order -1/, /Goal succeeded/, /Received request to cancel goal/, /Goal canceled/],
  },
  {
    package: 'learn_actions_py',
    executable: 'client',
    namespace: '/acted_in_cpp',
    says: [
      /Goal rejected :\(/,
      /Goal accepted :\)/,
      /Received feedback: \[0, 1, 1\]/,
      /Goal succeeded! Result: \[0, 1, 1, 2, 3, 5\]/,
      /Goal successfully canceled/,
      /Goal ended as canceled/,
    ],
  },
];
/** The server of C++ has a thread for each goal. */
const wantsThreads = (namespace?: string): boolean => namespace === '/acted_in_cpp';

let workspace: PackWorkspace;
let folder = '';
before(async () => {
  workspace = new PackWorkspace('shared');
  for (const name of new Set(['learn_interfaces', ...nodes.map((node) => node.package)])) {
    if (name.startsWith('learn_')) workspace.copyPackages(name);
  }
  workspace.write('workspace.yaml', `schema: 1
name: both
title: Both languages
version: 1.0.0
license: Apache-2.0
distro: jazzy
packages:
  - src/*
launch:
${
    nodes.map((node) =>
      `  - {package: ${node.package}, executable: ${node.executable}${node.namespace === undefined ? '' : `, namespace: ${node.namespace}`}${
        node.arguments === undefined ? '' : `, arguments: ${node.arguments}`
      }}\n`
    ).join('')
  }`);
  folder = await workspace.packed();
}, { timeout: 600_000 });
after(() => workspace.close());

/** The expected lines that nodes have not printed yet; nodes that cannot run on the link are skipped. */
function unsaid(link: 'shared' | 'port', texts: (index: number) => readonly string[]): string[] {
  return nodes.flatMap(({ executable, namespace, says = [] }, i) => {
    if (link === 'port' && wantsThreads(namespace)) return [];
    const said = texts(i);
    return says.filter((line) => !said.some((text) => line.test(text))).map((line) => `${namespace}/${executable}: ${line}`);
  });
}

for (const link of played('port', 'shared')) {
  test(`${link}, Node.js: C++ and Python talk, serve and act for each other`, watchdog, async () => {
    const { session, close } = await openHeadless(folder, link, new URL('../../../runtime/site/session/headless.ts', import.meta.url));
    try {
      const ids = session.nodes().map(({ id }) => id);
      const missing = (): readonly string[] => unsaid(link, (i) => session.console(ids[i] ?? '').lines().map(({ text }) => text));
      const all = new Promise<void>((resolve, reject) => {
        // Before the watchdog, which would not say what is missing.
        const late = setTimeout(() => reject(new Error(missing().join('\n'))), watchdog.timeout - 20_000);
        for (const id of ids) {
          session.console(id).onLines(() => {
            if (missing().length > 0) return;
            clearTimeout(late);
            resolve();
          });
        }
      });
      session.startAll();
      await all;
    } finally {
      session.close();
      close();
    }
  });
}

test('shared, Chromium: C++ and Python talk, serve and act for each other', watchdog, async () => {
  const host = await serveFolder(folder, { isolated: true });
  const browser = await chromium.launch(chromiumOptions());
  try {
    const page = await browser.newPage();
    await page.goto(host.url);
    // The last words of those that come to an end, and of who has heard all.
    for (
      const words of ['five are enough', 'Again: 42', 'in a callback: 42', 'Goal was canceled', 'Goal ended as canceled', 'heard in all 8 forms',
        'I heard the number']
    ) {
      await page.waitForFunction((wanted) => document.body.textContent.includes(wanted), words, { timeout: 200_000 });
    }
  } finally {
    await browser.close();
    await host.close();
  }
});
