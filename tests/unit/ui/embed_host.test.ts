// The limits of a page that shows this one in a frame: a request that failed does not count against them.

import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { progressText } from '../../../runtime/site/ui/model/progress.ts';
import { hostEmbedding } from '../../../runtime/site/ui/parts/embed_host.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { eventually } from '../../support/eventually.ts';
import { FakeSession, FakeTasks } from './fake_session.ts';
import type { FakeOptions } from './fake_session.ts';

const watchdog = { timeout: 30_000 };
const listed = 'https://course.example';

interface Answer {
  readonly id?: number;
  readonly ok?: boolean;
  readonly event?: string;
  readonly error?: { readonly code: string; };
  readonly result?: { readonly subscription: number; readonly tasks?: unknown; };
  readonly state?: { readonly tasks: readonly { readonly done: boolean; }[]; };
}

/** The page around: what it was told. */
const told: Answer[] = [];
const parent = { postMessage: (what: Answer) => void told.push(what) };
let listener: (event: unknown) => void = () => undefined;
Object.assign(globalThis, {
  window: { parent },
  location: new URL('https://site.example/'),
  addEventListener: (kind: string, given: (event: unknown) => void) => {
    if (kind === 'message') listener = given;
  },
  removeEventListener: () => undefined,
});
after(() => {
  Reflect.deleteProperty(globalThis, 'window');
});

let ids = 0;

async function ask(order: Readonly<Record<string, unknown>>, origin = listed): Promise<Answer> {
  const id = ids += 1;
  listener({ source: parent, origin, data: { ros2wasm: 1, id, ...order } });
  let found: Answer | undefined;
  await eventually('an answer', async () => {
    found = told.find((one) => one.id === id);
    return found !== undefined;
  });
  return found ?? assert.fail();
}

function newSession(tasks: FakeOptions['tasks'] = []): FakeSession {
  const session = new FakeSession({ tasks, nodes: [], interfaces: new Map([['std_msgs/msg/String', 'string data\n']]) });
  Object.assign(session.site, { embed: [listed] });
  return session;
}

test('a subscription that fails for want of the definitions leaves its place free', watchdog, async (context) => {
  const session = newSession();
  const close = hostEmbedding(session, null);
  const interfaces = context.mock.method(session, 'interfaces', () => Promise.reject(new SiteError('R2W0706', 'not there')));
  for (let i = 0; i < 20; i += 1) {
    const { ok, error } = await ask({ do: 'subscribe', topic: '/chatter' });
    assert.deepEqual([ok, error?.code], [false, 'R2W0706']);
  }
  interfaces.mock.restore();
  const { ok, result } = await ask({ do: 'subscribe', topic: '/chatter' });
  assert.equal(ok, true);
  assert.equal((await ask({ do: 'unsubscribe', subscription: result?.subscription })).ok, true);
  close();
  session.close();
});

test('publishers that cannot be made take no place', watchdog, async () => {
  const session = newSession();
  const close = hostEmbedding(session, null);
  const { open } = session.node() as unknown as { readonly open: ReadonlySet<unknown>; };
  for (let i = 0; i < 20; i += 1) {
    const { ok, error } = await ask({ do: 'publish', topic: `bad name ${i}`, type: 'std_msgs/msg/String', message: { data: 'x' } });
    assert.deepEqual([ok, error?.code], [false, 'R2W0715']);
  }
  assert.equal(open.size, 0);
  assert.equal((await ask({ do: 'publish', topic: '/good', type: 'std_msgs/msg/String', message: { data: 'x' } })).ok, true);
  close();
  session.close();
});

test('the progress in tasks: of this visit for any page, of earlier ones for those that the manifest lists', watchdog, async () => {
  const title = 'Drive';
  const session = newSession([{ title, text: '', hint: 'h', solution: '', checks: [{ title: '', aim: { kind: 'rate', topic: '/x' } }] }]);
  const view = (done: boolean) => ({ title, done, checks: [{ title: 'a rate', state: done ? 'passed' as const : 'open' as const, seen: '10 Hz' }] });
  const tasks = new FakeTasks([view(false)]);
  session.tasks = tasks;
  const kept = new Map([['ros2wasm.progress /', progressText([{ title, doneAt: '2026-11-28T10:00:00Z', hintAt: '2026-11-28T09:00:00Z', seen: [] }])]]);
  Object.assign(globalThis, { document: { baseURI: 'https://site.example/' } });
  const close = hostEmbedding(session, { getItem: (name) => kept.get(name) ?? null, setItem: () => undefined });
  const now = { title, done: false, checks: [{ title: 'a rate', state: 'open' }] };
  const stranger = 'https://other.example';
  assert.deepEqual((await ask({ do: 'state' }, stranger)).result?.tasks, [now]);
  assert.equal((await ask({ do: 'tasks' }, stranger)).error?.code, 'R2W0751');
  assert.deepEqual((await ask({ do: 'tasks' })).result, [{
    title,
    done: true,
    done_at: '2026-11-28T10:00:00Z',
    hint_at: '2026-11-28T09:00:00Z',
    checks: [{ title: 'a rate', state: 'open', seen: '10 Hz' }],
  }]);
  await ask({ do: 'watch' });
  tasks.set([view(true)]);
  await eventually('an event', async () => told.some(({ event, state }) => event === 'state' && state?.tasks[0]?.done === true));
  close();
  session.close();
});
