// The sources of a site on the page: read from the archive as they were packed, changed, kept within bounds.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import type { KeptTexts } from '../../../runtime/site/contract/stored_texts.ts';
import { SiteError } from '../../../runtime/site/contract/site_error.ts';
import { readSite } from '../../../runtime/site/contract/site_reader.ts';
import { mostOfFile, mostOfSite, SourceFiles } from '../../../runtime/site/python/source_files.ts';
import { zipMember } from '../../../runtime/site/contract/zip_member.ts';

const hashOf = (bytes: string | Uint8Array): string => createHash('sha256').update(bytes).digest('hex');

function archiveOf(files: Readonly<Record<string, string | Uint8Array>>): Uint8Array<ArrayBuffer> {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-zip-'));
  try {
    mkdirSync(join(folder, 'in'));
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, 'in', name), bytes);
    const tool = fileURLToPath(new URL('../../support/make_archive.py', import.meta.url));
    execFileSync('python3', [tool, join(folder, 'out.zip'), `${join(folder, 'in')}=lib`]);
    return new Uint8Array(readFileSync(join(folder, 'out.zip')));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** A browser's storage. `full`: it takes nothing. */
function storage(kept = new Map<string, string>(), full = false): KeptTexts & { other(): void; listening(): number; } {
  const own = new Map<string, string | undefined>();
  const listeners = new Set<() => void>();
  return {
    get: (key) => (own.has(key) ? own.get(key) : kept.get(key)),
    set: (key, text) => {
      if (full) own.set(key, text);
      else if (text === undefined) kept.delete(key);
      else kept.set(key, text);
      return !full;
    },
    onChange: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    other: () => listeners.forEach((listener) => listener()),
    listening: () => listeners.size,
  };
}

const files: Record<string, string | Uint8Array> = {
  'a.py': 'print("ä")\n',
  'b.py': '\ufeffb\r\n',
  'latin.py': Uint8Array.of(0x23, 0xe4, 0x0a),
  'other.py': 'as it was',
};
const archive = archiveOf({ ...files, 'other.py': 'as it is' });
const described = {
  archive: 'python/workspace.zip',
  files: [...Object.entries(files), ['gone.py', ''] as const].map(([name, bytes]) => ({ path: `lib/${name}`, file: `src/${name}`, sha256: hashOf(bytes) })),
};
const sourcesWith = (texts: KeptTexts): SourceFiles => new SourceFiles(described, texts, async () => new Blob([archive]));

test('the packed text is that of site.json, byte for byte', async () => {
  const sources = sourcesWith(storage());
  assert.equal(await sources.packed('lib/a.py'), files['a.py']);
  assert.equal(await sources.packed('lib/b.py'), files['b.py']);
  const code = (path: string, wanted: string) => assert.rejects(sources.packed(path), (error) => error instanceof SiteError && error.code === wanted);
  await code('lib/latin.py', 'R2W0726');
  await code('lib/other.py', 'R2W0724');
  await code('lib/gone.py', 'R2W0724');
  await assert.rejects(sources.packed('lib/none.py'), RangeError);
});

test('a change is for nodes that start, is kept, and goes with a reset', () => {
  const kept = new Map<string, string>();
  const sources = sourcesWith(storage(kept));
  let told = 0;
  const stop = sources.onChange(() => {
    told += 1;
  });
  assert.equal(sources.change('lib/a.py', 'mine'), 'kept');
  const again = sourcesWith(storage(kept));
  assert.deepEqual([...again.forStart().changed], [['lib/a.py', 'mine']]);
  assert.deepEqual(again.forStart().watched, described.files.map(({ path }) => path));
  assert.deepEqual(again.list()[0], { ...described.files[0], state: 'changed', changedSha256: hashOf('mine') });
  assert.equal(again.list()[1]?.state, 'packed');
  assert.equal(sources.change('lib/a.py', undefined), 'kept');
  assert.equal(kept.size, 0);
  assert.equal(told, 2);
  stop();
});

test('a change of another version of the file is for no node', () => {
  const kept = new Map([['lib/a.py', JSON.stringify({ of: hashOf('older'), text: 'mine' })]]);
  const sources = sourcesWith(storage(kept));
  assert.equal(sources.forStart().changed.size, 0);
  assert.equal(sources.list()[0]?.state, 'outdated');
  sources.change('lib/a.py', sources.changed('lib/a.py'));
  assert.deepEqual([...sources.forStart().changed], [['lib/a.py', 'mine']]);
});

test('what cannot be kept lasts for the visit; what is too long is not taken', () => {
  const kept = new Map<string, string>();
  assert.equal(sourcesWith(storage(kept, true)).change('lib/a.py', 'mine'), 'visit');
  assert.equal(kept.size, 0);
  const full = storage(kept, true);
  sourcesWith(full).change('lib/a.py', 'mine');
  assert.equal(sourcesWith(full).changed('lib/a.py'), 'mine');
  const long = 'x'.repeat(mostOfFile);
  const many = { ...described, files: Array.from({ length: 7 }, (_, i) => ({ path: `${i}.py`, file: `${i}.py`, sha256: '' })) };
  const sources = new SourceFiles(many, storage(kept), async () => new Blob());
  assert.equal(sources.change('0.py', `${long}x`), 'too_long');
  for (let i = 0; i < mostOfSite / mostOfFile; i += 1) assert.equal(sources.change(`${i}.py`, long), 'kept');
  assert.equal(sources.change('6.py', 'x'), 'too_long');
  assert.equal(sources.change('0.py', `${long.slice(1)}y`), 'kept');
});

// Guarantee, hostile input: what is in the browser's storage for changed sources, and broken archives of sources
test('what others left in the storage is not a change', () => {
  const hash = hashOf(files['a.py'] ?? '');
  for (
    const raw of ['', 'x', 'null', '[]', '{"of":1,"text":"x"}', `{"of":"${hash}","text":1}`, `{"of":"${hash}"}`,
      JSON.stringify({ of: hash, text: 'x'.repeat(mostOfFile + 1) })]
  ) {
    const sources = sourcesWith(storage(new Map([['lib/a.py', raw]])));
    assert.equal(sources.list()[0]?.state, 'packed', raw.slice(0, 40));
    assert.equal(sources.forStart().changed.size, 0);
  }
});

test('changes of another tab are heard while somebody listens', () => {
  const texts = storage();
  const sources = sourcesWith(texts);
  let told = 0;
  const stop = sources.onChange(() => {
    told += 1;
  });
  texts.other();
  assert.equal(told, 1);
  stop();
  assert.equal(texts.listening(), 0);
});

test('broken archives have no members', () => {
  assert.deepEqual(zipMember(archive, 'lib/a.py'), new Uint8Array(Buffer.from(String(files['a.py']))));
  assert.equal(zipMember(archive, 'lib/a'), undefined);
  for (let length = 0; length < archive.length; length += 1) assert.equal(zipMember(archive.slice(0, length), 'lib/a.py'), undefined);
  // Nothing of it is read out of its bounds, whatever is changed.
  for (let at = 0; at < archive.length; at += 1) {
    for (const value of [0, 0xff]) {
      const changed = archive.slice();
      changed[at] = value;
      for (const name of ['lib/a.py', 'lib/other.py']) assert.ok((zipMember(changed, name)?.length ?? 0) <= archive.length);
    }
  }
});

test('site.json names sources by paths inside the installation', () => {
  const site = (sources: unknown): unknown => ({ schema: 1, protocol: 1, nodes: [], sources });
  assert.deepEqual(readSite(site(described)).sources, described);
  assert.equal(readSite({ schema: 1, protocol: 1, nodes: [] }).sources, undefined);
  for (const path of ['../x.py', '/etc/x.py', '', 'a//b.py', 'c:/x.py']) {
    assert.throws(() => readSite(site({ ...described, files: [{ path, file: 'x', sha256: '' }] })), SiteError, path);
  }
  assert.throws(() => readSite(site({ ...described, archive: '../x.zip' })), SiteError);
  assert.throws(() => readSite(site([])), SiteError);
});
