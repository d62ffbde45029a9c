// `ros2wasm serve` from outside: headers, what it gives and what it refuses, how it ends.
import assert from 'node:assert/strict';
import { mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { type IncomingHttpHeaders, request } from 'node:http';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { Scratch, ServedSite, makeSite, runCli } from '../support/served_site.ts';

const WATCHDOG = { timeout: 240_000 };
const BYTES = new Uint8Array(100_000).map((_, i) => (i * 7919) % 251);

interface Answer {
  readonly status: number;
  readonly headers: IncomingHttpHeaders;
  readonly body: Buffer;
}

/** Sends the path as it stands, which `fetch` would tidy up. */
function ask(
  server: ServedSite,
  path: string,
  headers: Record<string, string> = {},
  method = 'GET',
): Promise<Answer> {
  return new Promise((resolve, reject) => {
    const { hostname, port } = new URL(server.url);
    const sent = request({ hostname, port, path, method, headers, agent: false }, (response) => {
      const pieces: Buffer[] = [];
      response.on('data', (piece: Buffer) => pieces.push(piece));
      response.on('end', () =>
        resolve({
          status: response.statusCode ?? 0,
          headers: response.headers,
          body: Buffer.concat(pieces),
        }));
    });
    sent.on('error', reject);
    sent.end();
  });
}

function siteWithFiles(scratch: Scratch): string {
  const site = makeSite(scratch);
  scratch.file('site/programs/demo/talker.wasm', BYTES);
  scratch.file('site/main.js', 'export {};');
  scratch.file('site/empty.css', '');
  scratch.file('site/icon.svg', '<svg xmlns="http://www.w3.org/2000/svg"/>');
  scratch.file('site/docs/index.html', 'docs');
  scratch.file('secret.txt', 'secret');
  symlinkSync('../secret.txt', join(site, 'leak.txt'));
  symlinkSync('..', join(site, 'up'));
  symlinkSync('main.js', join(site, 'inside.js'));
  return site;
}

describe('headers', WATCHDOG, () => {
  test('the page is isolated, never stale and of the right kind', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([siteWithFiles(scratch), '--port', '0']);
    assert.match(server.url, /^http:\/\/127\.0\.0\.1:\d+\/$/);
    const page = await ask(server, '/');
    assert.equal(page.status, 200);
    assert.equal(page.headers['content-type'], 'text/html; charset=utf-8');
    assert.equal(page.headers['cross-origin-opener-policy'], 'same-origin');
    assert.equal(page.headers['cross-origin-embedder-policy'], 'require-corp');
    assert.equal(page.headers['cross-origin-resource-policy'], 'same-origin');
    assert.equal(page.headers['cache-control'], 'no-cache');
    assert.equal(page.headers['x-content-type-options'], 'nosniff');
    assert.match(String(page.headers['content-security-policy']), /^default-src 'none'; script-src 'self' 'wasm-unsafe-eval';.*form-action 'none'$/);
    const kinds: Record<string, string> = {
      '/main.js': 'text/javascript; charset=utf-8',
      '/inside.js': 'text/javascript; charset=utf-8',
      '/empty.css': 'text/css; charset=utf-8',
      '/icon.svg': 'image/svg+xml',
      '/site.json': 'application/json',
      '/programs/demo/talker.wasm': 'application/wasm',
      '/docs/': 'text/html; charset=utf-8',
    };
    for (const [path, kind] of Object.entries(kinds)) {
      const answer = await ask(server, path);
      assert.equal(answer.status, 200, path);
      assert.equal(answer.headers['content-type'], kind, path);
      assert.equal(answer.headers['cross-origin-resource-policy'], 'same-origin', path);
    }
  });
  // Guarantee, hostile input: documents of a lab have no part in the origin when `serve` gives them, also at a first visit
  test('documents that a lab brings along are in a sandbox, the page is not', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([siteWithFiles(scratch), '--port', '0']);
    const policy = async (path: string): Promise<string> => String((await ask(server, path)).headers['content-security-policy']);
    const usual = await policy('/');
    for (const path of ['/index.html', '/main.js', '/index.html?a']) assert.equal(await policy(path), usual, path);
    for (const path of ['/docs/', '/docs/index.html', '/icon.svg', '/%69con.svg?a']) assert.equal(await policy(path), `sandbox; ${usual}`, path);
    const { etag } = (await ask(server, '/icon.svg')).headers;
    const again = await ask(server, '/icon.svg', { 'If-None-Match': etag! });
    assert.equal(again.status, 304);
    assert.equal(again.headers['content-security-policy'], `sandbox; ${usual}`);
  });

  test('--no-isolation leaves the isolation headers out', async () => {
    using scratch = new Scratch();
    const args = [makeSite(scratch), '--port', '0', '--no-isolation'];
    await using server = await ServedSite.start(args);
    const page = await ask(server, '/');
    assert.equal(page.headers['cross-origin-opener-policy'], undefined);
    assert.equal(page.headers['cross-origin-embedder-policy'], undefined);
    assert.equal(page.headers['cross-origin-resource-policy'], undefined);
    assert.equal(page.headers['cache-control'], 'no-cache');
  });

  test('what did not change is not sent again', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([makeSite(scratch), '--port', '0']);
    const first = await ask(server, '/site.json');
    const etag = first.headers.etag ?? '';
    assert.match(etag, /^"[^"]+"$/);
    const again = await ask(server, '/site.json', { 'if-none-match': `"other", ${etag}` });
    assert.equal(again.status, 304);
    assert.equal(again.body.length, 0);
    assert.equal(again.headers.etag, etag);
    assert.equal(again.headers['cross-origin-embedder-policy'], 'require-corp');
    scratch.file('site/site.json', '{"schema":2}'); // as long as before
    const changed = await ask(server, '/site.json', { 'if-none-match': etag });
    assert.equal(changed.status, 200);
    assert.equal(changed.body.toString(), '{"schema":2}');
  });
});

describe('files', WATCHDOG, () => {
  test('whole, in parts, and only their headers', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([siteWithFiles(scratch), '--port', '0']);
    const path = '/programs/demo/talker.wasm';
    const whole = await ask(server, path);
    assert.deepEqual(whole.body, Buffer.from(BYTES));
    assert.equal(whole.headers['accept-ranges'], 'bytes');
    const head = await ask(server, path, {}, 'HEAD');
    assert.equal(head.status, 200);
    assert.equal(head.headers['content-length'], '100000');
    assert.equal(head.body.length, 0);
    const ranges: [string, number, number][] = [
      ['bytes=0-9', 0, 10],
      ['bytes=99990-', 99_990, 100_000],
      ['bytes=-10', 99_990, 100_000],
      ['bytes=99000-9999999', 99_000, 100_000],
    ];
    for (const [range, first, end] of ranges) {
      const part = await ask(server, path, { range });
      assert.equal(part.status, 206, range);
      assert.equal(part.headers['content-range'], `bytes ${first}-${end - 1}/100000`);
      assert.deepEqual(part.body, Buffer.from(BYTES.subarray(first, end)), range);
    }
    const beyond = await ask(server, path, { range: 'bytes=100000-' });
    assert.equal(beyond.status, 416);
    assert.equal(beyond.headers['content-range'], 'bytes */100000');
    const stale = await ask(server, path, { range: 'bytes=0-9', 'if-range': '"old"' });
    assert.equal(stale.status, 200);
    assert.equal(stale.body.length, 100_000);
    assert.equal((await ask(server, '/empty.css')).body.length, 0);
  });

  test('a folder without its slash is sent on, and is never listed', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([siteWithFiles(scratch), '--port', '0']);
    const docs = await ask(server, '/docs?x=1');
    assert.equal(docs.status, 308);
    assert.equal(docs.headers.location, './docs/');
    for (const path of ['/programs', '/programs/', '/programs/demo/']) {
      assert.equal((await ask(server, path)).status, 404, path);
    }
  });

  test('nothing outside of the site', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([siteWithFiles(scratch), '--port', '0']);
    for (
      const path of [
        '/../secret.txt',
        '/%2e%2e/secret.txt',
        '/%2E%2E%2Fsecret.txt',
        '/docs/../../secret.txt',
        '/docs/..%2f..%2fsecret.txt',
        '/..%5csecret.txt',
        '/leak.txt',
        '/up/secret.txt',
        '/up/site/index.html/../../../secret.txt',
        '//etc/passwd',
        '/%2fetc/passwd',
        '/index.html%00.txt',
        '/missing.txt',
      ]
    ) {
      const answer = await ask(server, path);
      assert.equal(answer.status, 404, path);
      assert.doesNotMatch(answer.body.toString(), /secret|root:/);
    }
  });

  // Guarantee, hostile input: whatever folder a site.json names as its store, `serve` answers with files of the site and with objects of a store
  // that `pack` made, and with no other file of the machine
  test('a site that names another folder as its store widens nothing', async () => {
    using scratch = new Scratch();
    scratch.file('secret.txt', 'secret');
    scratch.file('evil/index.html', 'evil');
    scratch.file('sibling/index.html', 'secret');
    for (const objects of [`${'../'.repeat(8)}x/`, `${'../'.repeat(8)}etc/`, '../sibling/', '../../', '../../tmp/']) {
      const store = { objects, scripts: 'a'.repeat(64) };
      scratch.file('evil/site.json', JSON.stringify({ generator: 'ros2wasm 1.0.0', store, files: [] }));
      await using server = await ServedSite.start([join(scratch.path, 'evil'), '--port', '0']);
      assert.equal((await ask(server, '/')).body.toString(), 'evil', objects);
      for (const path of ['/etc/passwd', join(scratch.path, 'secret.txt'), '/secret.txt', '/sibling/', '/sibling/index.html']) {
        const answer = await ask(server, path);
        assert.equal(answer.status, 404, `${objects} ${path}`);
        assert.doesNotMatch(answer.body.toString(), /secret|root:/);
      }
      if (objects !== '../../') assert.match(server.errors, /warning\[R2W0613\]: files of `\S+evil` are not served/, objects);
    }
  });

  test('of a store elsewhere only names that a store has are answered', async () => {
    using scratch = new Scratch();
    const object = 'c'.repeat(64);
    const scripts = 'a'.repeat(64);
    scratch.file('deep/sites/one/index.html', 'one');
    scratch.file('deep/sites/one/site.json',
      JSON.stringify({ generator: 'ros2wasm 1.0.0', store: { objects: '../../../STORE/objects/', scripts }, files: [] }));
    scratch.file('STORE/objects/store.json', '{"generator":"ros2wasm","store":1}\n');
    scratch.file(`STORE/objects/${object}.wasm`, 'object');
    scratch.file(`STORE/objects/${scripts}/start.js`, 'script');
    for (const path of ['STORE/objects/notes.txt', 'STORE/secret.txt', 'deep/secret.txt', 'deep/sites/two/index.html']) scratch.file(path, 'secret');
    symlinkSync('../secret.txt', join(scratch.path, `STORE/objects/${'d'.repeat(64)}`));
    await using server = await ServedSite.start([join(scratch.path, 'deep/sites/one'), '--port', '0']);
    assert.match(server.url, /:\d+\/deep\/sites\/one\/$/);
    assert.equal((await ask(server, '/deep/sites/one/')).body.toString(), 'one');
    assert.equal((await ask(server, `/STORE/objects/${object}.wasm`)).body.toString(), 'object');
    assert.equal((await ask(server, `/STORE/objects/${scripts}/start.js`)).body.toString(), 'script');
    assert.equal((await ask(server, '/')).headers.location, '/deep/sites/one/');
    assert.equal((await ask(server, '/deep/sites/one')).headers.location, './one/');
    for (
      const path of ['/STORE/objects/notes.txt', '/STORE/objects/', '/STORE/secret.txt', '/deep/secret.txt', '/deep/sites/two/',
        `/STORE/objects/${'d'.repeat(64)}`, `/STORE/objects/${scripts}/../notes.txt`]
    ) {
      const answer = await ask(server, path);
      assert.equal(answer.status, 404, path);
      assert.doesNotMatch(answer.body.toString(), /secret/);
    }
  });

  test('GET and HEAD only, and only for names of this machine', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([makeSite(scratch), '--port', '0']);
    for (const method of ['POST', 'PUT', 'DELETE', 'OPTIONS', 'PATCH']) {
      const refused = await ask(server, '/', {}, method);
      assert.equal(refused.status, 405, method);
      assert.equal(refused.headers.allow, 'GET, HEAD');
    }
    assert.equal((await ask(server, '/', { host: 'localhost:1' })).status, 200);
    const rebound = await ask(server, '/', { host: 'evil.example' });
    assert.equal(rebound.status, 403);
    assert.doesNotMatch(rebound.body.toString(), /<html>/);
  });

  test('a site that is replaced while it is served', async () => {
    using scratch = new Scratch();
    const site = makeSite(scratch);
    await using server = await ServedSite.start([site, '--port', '0']);
    assert.equal((await ask(server, '/')).status, 200);
    rmSync(site, { recursive: true });
    assert.equal((await ask(server, '/')).status, 404);
    mkdirSync(site);
    scratch.file('site/index.html', 'new');
    assert.equal((await ask(server, '/')).body.toString(), 'new');
  });

  test('many pages at once', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([siteWithFiles(scratch), '--port', '0']);
    const asked = Array.from({ length: 200 }, () => ask(server, '/programs/demo/talker.wasm'));
    for (const answer of await Promise.all(asked)) assert.equal(answer.body.length, 100_000);
  });

  test('no reload script and no events without --watch', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([makeSite(scratch), '--port', '0']);
    assert.equal((await ask(server, '/.ros2wasm/reload.js')).status, 404);
    assert.equal((await ask(server, '/.ros2wasm/events')).status, 404);
    assert.doesNotMatch((await ask(server, '/')).body.toString(), /reload/);
  });
});

describe('beginning and end', WATCHDOG, () => {
  test('one line with the link on stdout, the rest on stderr', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([makeSite(scratch), '--port', '0']);
    const ended = await server.signal('SIGTERM');
    assert.equal(ended.output, `${server.url}\n`);
    assert.match(ended.errors, /Ctrl-C/);
    assert.equal(ended.code, 0);
  });

  test('Ctrl-C ends it with 130', async () => {
    using scratch = new Scratch();
    await using server = await ServedSite.start([makeSite(scratch), '--port', '0']);
    assert.equal((await server.signal('SIGINT')).code, 130);
  });

  test('a port in use is an error with a way out', async () => {
    using scratch = new Scratch();
    const site = makeSite(scratch);
    await using first = await ServedSite.start([site, '--port', '0']);
    const second = await runCli(['serve', site, '--port', new URL(first.url).port]);
    assert.equal(second.code, 3);
    assert.match(second.errors, /error\[R2W0610\]: port \d+ is in use/);
    assert.match(second.errors, /--port 0/);
    assert.equal(second.output, '');
  });

  test('an address that is not ours', async () => {
    using scratch = new Scratch();
    const ended = await runCli(['serve', makeSite(scratch), '--host', 'nowhere.invalid']);
    assert.equal(ended.code, 3);
    assert.match(ended.errors, /error\[R2W0611\]: cannot listen on nowhere\.invalid/);
  });
});
