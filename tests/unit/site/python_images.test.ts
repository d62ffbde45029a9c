// How the image that Python nodes begin with is made, which nodes get it, and how an image that cannot be opened is handled.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import type { KeptBytes } from '../../../runtime/site/program/cached_bytes.ts';
import type { WorkerReport } from '../../../runtime/site/workers/worker_messages.ts';
import type { Platform } from '../../../runtime/site/workers/platform.ts';
import { filledRuns, imageVersion, readImage } from '../../../runtime/site/python/python_image.ts';
import { fillMemory, pageBytes } from '../../../runtime/site/python/pyodide_loader.ts';
import { PythonFiles } from '../../../runtime/site/python/python_files.ts';
import { BlobParts } from '../../../runtime/site/program/blob_parts.ts';
import { PythonImages } from '../../../runtime/site/workers/python_images.ts';
import { PythonWorkers } from '../../../runtime/site/workers/python_workers.ts';
import type { SiteDescription, SiteNode } from '../../../runtime/site/contract/session.ts';

const watchdog = { timeout: 20_000 };

function node(id: string, archives: readonly string[] | undefined): SiteNode {
  const python = archives === undefined ? {} : { python: { archives, entry: 'a:b' } };
  return { id, program: archives === undefined ? 'a.wasm' : 'pyodide/pyodide.asm.wasm', ...python } as unknown as SiteNode;
}

const both = [node('a', ['channels.zip', 'workspace.zip']), node('b', ['channels.zip', 'workspace.zip', 'numpy.zip'])];
/** More than boot by themselves, when they start at once. */
const three = [...both, node('c', ['channels.zip', 'workspace.zip'])];

const paths = ['channels.zip', 'workspace.zip', 'numpy.zip', 'pyodide/pyodide.asm.wasm', 'pyodide/python_stdlib.zip', 'python_worker.js', 'other'];

function site(nodes: readonly SiteNode[], listed: readonly string[] = paths): SiteDescription {
  return { nodes, programs: [], files: listed.map((path) => ({ path, size: 1, sha256: '1', reason: '' })) } as unknown as SiteDescription;
}

function imagesOf(described: SiteDescription, platform: Platform, share: string): PythonImages {
  return new PythonImages(described, platform, new PythonWorkers(platform, new PythonFiles(described, platform)), share);
}

/** A place whose workers answer with `makes`; they are counted. */
function place(makes: 'image' | 'nothing' | 'failure' | 'silence', kept?: KeptBytes): { platform: Platform; begun: string[][]; ended: () => number; } {
  const begun: string[][] = [];
  let ended = 0;
  const platform = {
    place: '/site',
    kept,
    compile: async () => ({}) as WebAssembly.Module,
    bytes: async () => new ArrayBuffer(1),
    startWorker: (_name: string, events: { report: (report: WorkerReport) => void; failed: (why: string) => void; }) => ({
      post: (order: { t: string; start: { archives: string[]; }; }) => {
        if (order.t === 'python') return;
        begun.push(order.start.archives);
        queueMicrotask(() => {
          if (makes === 'failure') events.failed('gone');
          else if (makes !== 'silence') events.report({ t: 'image', image: makes === 'image' ? new Blob([`image ${begun.length}`]) : undefined });
        });
      },
      terminate: async () => {
        ended += 1;
      },
    }),
  } as unknown as Platform;
  return { platform, begun, ended: () => ended };
}

async function holds(condition: () => boolean): Promise<void> {
  while (!condition()) await new Promise((resolve) => setTimeout(resolve, 10));
}

function memory(): KeptBytes & { readonly found: Map<string, Blob>; } {
  const found = new Map<string, Blob>();
  return {
    found,
    get: async (key) => found.get(key),
    put: async (key, bytes) => void found.set(key, bytes),
    drop: async (key) => void found.delete(key),
  };
}

test('one worker makes it for all, of what all have', watchdog, async () => {
  const { platform, begun, ended } = place('image');
  const images = imagesOf(site(three), platform, '/opt/ros/jazzy');
  const [one, two] = await Promise.all(three.map((each) => images.take(each, {})));
  assert.ok(one !== undefined && one.bytes === two?.bytes);
  assert.deepEqual([begun, one.archives, ended()], [[['channels.zip', 'workspace.zip']], 2, 1]);
});

test('who has settings of the interpreter, and who is not a Python program, begins by itself', watchdog, async () => {
  const { platform, begun } = place('image');
  const compiled = node('c', undefined);
  const images = imagesOf(site([...three, compiled]), platform, '');
  assert.equal(await images.take(both[0] as SiteNode, { PYTHONHASHSEED: '1' }), undefined);
  assert.equal(await images.take(both[0] as SiteNode, { ROS_PYTHON_CHECK_FIELDS: '1' }), undefined);
  assert.equal(await images.take(compiled, {}), undefined);
  assert.deepEqual(begun, []);
  const [other] = await Promise.all(three.map((each) => images.take(each, { ROS_PYTHON_VERSION: '3' })));
  assert.notEqual(other, undefined);
});

test('one that starts alone boots by itself; then one is made for the next visit, or for who starts later', watchdog, async () => {
  const single = [node('a', ['channels.zip'])];
  const kept = memory();
  const first = place('image', kept);
  const images = imagesOf(site(single), first.platform, '');
  assert.equal(await images.take(single[0] as SiteNode, {}), undefined);
  assert.deepEqual(first.begun, []);
  images.settled(single[0] as SiteNode);
  await holds(() => kept.found.size === 1);
  assert.notEqual(await images.take(single[0] as SiteNode, {}), undefined);
  assert.equal(first.begun.length, 1);
  const later = place('image', kept);
  assert.notEqual(await imagesOf(site(single), later.platform, '').take(single[0] as SiteNode, {}), undefined);
  assert.equal(later.begun.length, 0);

  const two = place('image');
  const shared = imagesOf(site(three), two.platform, '');
  assert.equal(await shared.take(both[0] as SiteNode, {}), undefined);
  assert.equal(await shared.take(both[1] as SiteNode, {}), undefined);
  assert.notEqual(await shared.take(three[2] as SiteNode, {}), undefined);
});

test('two boot by themselves at once; when both wait one is made for the next visit, and for who starts later', watchdog, async () => {
  const kept = memory();
  const first = place('image', kept);
  const images = imagesOf(site(both), first.platform, '');
  assert.deepEqual(await Promise.all(both.map((each) => images.take(each, {}))), [undefined, undefined]);
  images.settled(both[0] as SiteNode);
  await new Promise((resolve) => setTimeout(resolve, 50));
  assert.deepEqual(first.begun, []);
  images.settled(both[1] as SiteNode);
  await holds(() => kept.found.size === 1);
  assert.notEqual(await images.take(node('later', ['channels.zip', 'workspace.zip']), {}), undefined);
  const next = place('image', kept);
  const [one, two] = await Promise.all(both.map((each) => imagesOf(site(both), next.platform, '').take(each, {})));
  assert.ok(one !== undefined && two !== undefined);
  assert.equal(next.begun.length, 0);
});

test('there is none that nobody keeps for a single node, none of files without hashes is kept, and nodes without archives in common have none', watchdog,
  async () => {
    const single = [node('a', ['channels.zip'])];
    const nobody = place('image');
    const images = imagesOf(site(single), nobody.platform, '');
    for (let i = 0; i < 2; i += 1) {
      assert.equal(await images.take(single[0] as SiteNode, {}), undefined);
      images.settled(single[0] as SiteNode);
    }
    assert.deepEqual(nobody.begun, []);
    const kept = memory();
    const unlisted = imagesOf(site(three, paths.slice(1)), place('image', kept).platform, '');
    for (const one of await Promise.all(three.map((each) => unlisted.take(each, {})))) assert.notEqual(one, undefined);
    await new Promise(setImmediate);
    assert.equal(kept.found.size, 0);
    const apart = [node('a', ['x.zip']), node('b', ['y.zip'])];
    const none = imagesOf(site(apart), place('image').platform, '');
    for (const each of apart) assert.equal(await none.take(each, {}), undefined);
  });

test('where none can be made, nodes begin by themselves', watchdog, async () => {
  for (const makes of ['nothing', 'failure'] as const) {
    const { platform, begun } = place(makes);
    const images = imagesOf(site(three), platform, '');
    assert.deepEqual(await Promise.all(three.map((each) => images.take(each, {}))), [undefined, undefined, undefined]);
    assert.equal(begun.length, 1);
  }
  const { platform, ended } = place('silence');
  const images = imagesOf(site(three), platform, '');
  const taken = three.map((each) => images.take(each, {}));
  await new Promise(setImmediate);
  images.close();
  assert.deepEqual(await Promise.all(taken), [undefined, undefined, undefined]);
  assert.equal(ended(), 1);
});

test('it is kept; a broken one is dropped and made anew once', watchdog, async () => {
  const kept = memory();
  const first = place('image', kept);
  const makers = imagesOf(site(three), first.platform, '');
  await Promise.all(three.map((each) => makers.take(each, {})));
  await new Promise(setImmediate);
  assert.equal(kept.found.size, 1);
  const later = place('image', kept);
  const images = imagesOf(site(three), later.platform, '');
  const [old] = await Promise.all(three.map((each) => images.take(each, {})));
  assert.equal(await old?.bytes.text(), 'image 1');
  assert.equal(later.begun.length, 0);
  images.broken(old);
  images.broken(old);
  await new Promise(setImmediate);
  const made = await images.take(both[0] as SiteNode, {});
  assert.equal(later.begun.length, 1);
  images.broken(old);
  await new Promise(setImmediate);
  assert.equal(await images.take(both[1] as SiteNode, {}).then((one) => one?.bytes), made?.bytes);
  images.broken(made);
  await new Promise(setImmediate);
  assert.equal(await images.take(both[0] as SiteNode, {}), undefined);
});

test('what is not an image is not read', async () => {
  await assert.rejects(readImage(new Blob([new Uint8Array(4)])), RangeError);
  await assert.rejects(readImage(new Blob([new Uint8Array(64)])), /no image/);
  const head = new TextEncoder().encode(JSON.stringify({ description: 16, runs: [[0, 1 << 20]], size: 1 << 20, files: [], loaded: [] }));
  const bytes = new Uint8Array(1024);
  new Uint32Array(bytes.buffer).set([0x494d3252, imageVersion, head.length]);
  bytes.set(head, 12);
  await assert.rejects(readImage(new Blob([bytes])), /not complete/);
});

test('a memory becomes that of the image, of which only the filled pages are kept', async () => {
  const image = new Uint8Array(8 * pageBytes);
  for (const at of [5, pageBytes - 1, 3 * pageBytes, 4 * pageBytes + 7]) image[at] = at % 251 + 1;
  const runs = filledRuns(image);
  assert.deepEqual(runs, [[0, pageBytes], [3 * pageBytes, 2 * pageBytes]]);
  const kept = new Blob(runs.map(([begin, length]) => image.slice(begin, begin + length)));
  const parts = new BlobParts(kept);
  // As data of the program lies there when it has begun.
  const heap = new Uint8Array(8 * pageBytes);
  for (const at of [1, pageBytes + 1, 3 * pageBytes + 9, 7 * pageBytes, 8 * pageBytes - 1]) heap[at] = 1;
  await fillMemory(heap, { runs, read: (target) => parts.read(target) });
  assert.deepEqual(heap, image);
  await assert.rejects(parts.read(new Uint8Array(1)));
});

test('parts of a blob come in order, in browsers that read into a given buffer and in others', async () => {
  const bytes = new Uint8Array(1_000_000).map((_, i) => i % 253);
  const plain = new Blob([bytes]);
  const other = new Blob([bytes]);
  Object.defineProperty(other, 'stream', {
    value: () => {
      throw new TypeError('no such reader');
    },
  });
  for (const blob of [plain, other]) {
    const parts = new BlobParts(blob);
    const found = new Uint8Array(bytes.length);
    let at = 0;
    for (const size of [3, 0, 300_000, 699_997]) {
      await parts.read(found.subarray(at, at + size));
      at += size;
    }
    assert.deepEqual(found, bytes);
    await assert.rejects(parts.read(new Uint8Array(1)));
  }
});
