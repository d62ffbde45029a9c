// The progress that a browser stores: read as hostile, merged from two tabs, and written by the desk of a session.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { merged, progressText, readProgress } from '../../../runtime/site/ui/model/progress.ts';
import { TaskDesk } from '../../../runtime/site/ui/parts/task_desk.ts';
import type { TaskView } from '../../../runtime/site/contract/site_tasks.ts';
import { FakeSession, FakeTasks } from './fake_session.ts';

const AT = '2026-11-28T09:00:00.000Z';
const LATER = '2026-11-28T10:00:00.000Z';

function view(title: string, done: boolean): TaskView {
  return { title, done, checks: [{ title: 'x above 9', state: done ? 'passed' : 'open', seen: done ? '9.1' : 'no message' }] };
}

function memory(): { getItem: (key: string) => string | null; setItem: (key: string, value: string) => void; all: Map<string, string>; } {
  const all = new Map<string, string>();
  return { all, getItem: (key) => all.get(key) ?? null, setItem: (key, value) => void all.set(key, value) };
}

test('what was written is read again, and nothing else', () => {
  const progress = [{ title: 'Drive', doneAt: AT, hintAt: AT, seen: [{ title: 'x above 9', seen: '9.1' }] }];
  assert.deepEqual(readProgress(progressText(progress)), progress);
  for (const text of [null, '', '{', '[]', '7', 'null', '{"schema":2,"tasks":[]}', '{"schema":1,"tasks":{}}', ' '.repeat(300_000)]) {
    assert.deepEqual(readProgress(text), []);
  }
  assert.deepEqual(
    readProgress('{"schema":1,"tasks":[null,7,{"title":""},{"title":3},{"title":"a","doneAt":"yesterday","hintAt":"2026-99-99T00:00:00Z","seen":[1]}]}'),
    [{ title: 'a', seen: [{ title: '', seen: '' }] }],
  );
  assert.equal(readProgress(`{"schema":1,"tasks":[${'{"title":"a"},'.repeat(2000)}{"title":"b"}]}`).length, 1);
  assert.equal(readProgress('{"schema":1,"tasks":[{"__proto__":{"title":"a"}}]}').length, 0);
});

test('of two tabs the earlier time counts', () => {
  const one = [{ title: 'a', doneAt: LATER, seen: [{ title: 'c', seen: 'late' }] }];
  const other = [{ title: 'a', doneAt: AT, solutionAt: AT, seen: [{ title: 'c', seen: 'early' }] }, { title: 'b', seen: [] }];
  const both = [{ title: 'a', doneAt: AT, solutionAt: AT, seen: [{ title: 'c', seen: 'early' }] }, { title: 'b', seen: [] }];
  assert.deepEqual(merged(one, other), both);
  assert.deepEqual(merged(other, one), both);
});

test('the desk keeps what is done over visits, says it once, and forgets', () => {
  const store = memory();
  const make = (tasks: FakeTasks): TaskDesk => {
    const session = new FakeSession({
      nodes: [],
      tasks: ['Drive', 'Stop'].map((title) => ({ title, text: '', hint: 'h', solution: 's', checks: [{ title: '', aim: { kind: 'rate', topic: '/x' } }] })),
    });
    session.tasks = tasks;
    return new TaskDesk(session, store, '/course/lab1/', () => new Date(AT));
  };
  const tasks = new FakeTasks([view('Drive', false), view('Stop', false)]);
  const desk = make(tasks);
  const news: string[] = [];
  desk.onNews((words) => news.push(words));
  desk.reveal('Drive', 'hintAt');
  tasks.set([view('Drive', true), view('Stop', false)]);
  tasks.set([view('Drive', true), view('Stop', false)]);
  assert.deepEqual(news, ['Task done: Drive']);
  assert.deepEqual([...store.all.keys()], ['ros2wasm.progress /course/lab1/']);
  desk.close();
  // Another visit, another version of the lab.
  const next = make(new FakeTasks([view('Drive', false), view('Stop', false)]));
  assert.deepEqual(next.progress(), [
    { title: 'Drive', doneAt: AT, hintAt: AT, seen: [{ title: 'x above 9', seen: '9.1' }] },
    { title: 'Stop', seen: [] },
  ]);
  next.forget();
  assert.deepEqual(next.progress(), [{ title: 'Drive', seen: [] }, { title: 'Stop', seen: [] }]);
  next.close();
  // Without storage it holds until the page is closed.
  store.setItem = () => {
    throw new Error('full');
  };
  const full = make(new FakeTasks([view('Drive', true), view('Stop', false)]));
  assert.equal(full.progress()[0]?.doneAt, AT);
  full.close();
});
