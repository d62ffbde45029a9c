// The file that a student hands in: what is in it, and that its signature fits what `ros2wasm grade` checks.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileName, fileText, recordText, signedBytes, studentName } from '../../../runtime/site/ui/model/progress_file.ts';
import { browserKey } from '../../../runtime/site/ui/parts/browser_key.ts';

const AT = '2026-11-28T09:00:00.000Z';

test('the record has each task, and what was seen of those that are done', () => {
  const record = recordText({
    student: 'Ada',
    exportedAt: AT,
    course: 'Robots\u0007',
    labs: [{
      title: 'Drive',
      sha256: 'a'.repeat(64),
      tasks: [
        { title: 'One', doneAt: AT, hintAt: AT, seen: [{ title: 'x', seen: '9.1' }] },
        { title: 'Two', solutionAt: AT, seen: [] },
      ],
    }],
  });
  assert.deepEqual(JSON.parse(record), {
    student: 'Ada',
    exported_at: AT,
    course: 'Robots ',
    labs: [{
      title: 'Drive',
      sha256: 'a'.repeat(64),
      tasks: [
        { title: 'One', done_at: AT, hint_at: AT, seen: [{ title: 'x', seen: '9.1' }] },
        { title: 'Two', solution_at: AT },
      ],
    }],
  });
});

test('a name is one line, and a part of a file name', () => {
  assert.equal(studentName('  Ada\nLovelace\u009b '), 'Ada Lovelace');
  assert.equal(studentName(' \t'), null);
  assert.equal(studentName('\ud800a'), '\ufffda');
  assert.equal(studentName('x'.repeat(500))?.length, 200);
  assert.equal(fileName('../Ada L\u00f6w "x"'), 'progress-_Ada_L\u00f6w_x_.json');
});

test('the signature is over the record and what it is for; a browser that keeps nothing has a key for the visit', async () => {
  const key = await browserKey();
  assert.ok(typeof key === 'object');
  assert.equal(key.kept, false);
  const record = '{"student":"Ada"}';
  const signature = await key.sign(signedBytes(record));
  const file = JSON.parse(fileText(record, key.publicKey, signature)) as Readonly<Record<string, string>>;
  assert.deepEqual(Object.keys(file), ['format', 'schema', 'record', 'key', 'signature']);
  const bytes = (name: string): Uint8Array<ArrayBuffer> => new Uint8Array(Buffer.from(file[name] ?? '', 'base64'));
  const imported = await crypto.subtle.importKey('raw', bytes('key'), 'Ed25519', false, ['verify']);
  const fits = (text: string): Promise<boolean> => crypto.subtle.verify('Ed25519', imported, bytes('signature'), new TextEncoder().encode(text));
  assert.equal(await fits(`ros2wasm progress 1\n${file['record'] ?? ''}`), true);
  assert.equal(await fits(record), false);
});
