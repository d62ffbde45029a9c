// A plain static host on loopback, for tests and measurements: every file below /some/path/, with no header of its own
// but the type, unless told otherwise.

import { createReadStream, statSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';

const prefix = '/some/path/';
const types: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
};
const isolating = { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' };

export interface StaticServer {
  readonly url: string;
  /** Paths asked for, in order. */
  readonly requests: readonly string[];
  /** Drops all connections and answers nothing more. */
  close(): Promise<void>;
}

export interface HostRules {
  /** The page is cross-origin isolated by the host's headers. */
  readonly isolated?: boolean;
  /** Seconds for which browsers need not ask again, as many hosts have it. */
  readonly maxAge?: number;
  /** Paths that the host fails to give. */
  readonly broken?: RegExp;
}

export async function serveFolder(
  folder: string,
  { isolated = false, maxAge, broken }: HostRules = {},
): Promise<StaticServer> {
  const requests: string[] = [];
  const headers = {
    ...(isolated ? isolating : {}),
    ...(maxAge === undefined ? {} : { 'cache-control': `max-age=${maxAge}` }),
  };
  const server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname));
    requests.push(path);
    if (broken?.test(path)) {
      response.writeHead(503).end();
      return;
    }
    const file = join(folder, path.slice(prefix.length - 1), path.endsWith('/') ? 'index.html' : '');
    if (!path.startsWith(prefix) || statSync(file, { throwIfNoEntry: false })?.isFile() !== true) {
      response.writeHead(404).end();
      return;
    }
    const type = types[extname(file)] ?? 'application/octet-stream';
    response.writeHead(200, { 'content-type': type, ...headers });
    // A test may take its folder away while a page still asks.
    createReadStream(file).on('error', () => response.destroy()).pipe(response);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}${prefix}`,
    requests,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
