// A site made of the loader's small test programs and the real runtime files, served as a plain host does it.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildProgram } from '../unit/wasm_js/programs.ts';
import { splitNames } from '../unit/wasm_js/site_fixture.ts';

const root = fileURLToPath(new URL('../..', import.meta.url));
const types: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
};

export interface TestNode {
  /** File in tests/unit/wasm_js/programs. */
  readonly program: string;
  readonly threads?: boolean;
  readonly respawn?: boolean;
}

/** A temporary folder with a whole site. `more`: further files; `ui`: as in the manifest. */
export function makeSite(
  nodes: readonly TestNode[], more: Readonly<Record<string, string>> = {}, ui: Readonly<Record<string, unknown>> = {},
): string {
  const folder = mkdtempSync(join(tmpdir(), 'ros2wasm-site-'));
  const assets = join(folder, 'assets');
  execFileSync(process.execPath, [join(root, 'runtime/build.mjs'), '--out', assets]);
  for (const file of readdirSync(assets)) {
    if (file !== 'headless.js' && file !== 'runtime_assets.json') copyFileSync(join(assets, file), join(folder, file));
  }
  rmSync(assets, { recursive: true });
  mkdirSync(join(folder, 'programs'));
  const described = nodes.map(({ program, threads = false, respawn = false }, i) => {
    const name = program.replace(/\..*/, '');
    const split = splitNames(readFileSync(buildProgram(program, { threads })));
    writeFileSync(join(folder, 'programs', `${name}.wasm`), split.program);
    writeFileSync(join(folder, 'programs', `${name}.names`), split.names);
    return {
      id: `${name}-${i + 1}`, package: 'test', executable: name, label: `/${name}`, kind: 'cpp', threads, respawn,
      program: `programs/${name}.wasm`, names: `programs/${name}.names`, arguments: ['--ros-args'], environment: { COLOUR: 'red' }, output: 'screen',
      source: { file: 'workspace.yaml', line: 3 + i, column: 5 },
    };
  });
  for (const [file, text] of Object.entries(more)) writeFileSync(join(folder, file), text);
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1))
    .sort()
    .map((path) => {
      const bytes = readFileSync(join(folder, path));
      return { path, size: bytes.length, sha256: createHash('sha256').update(bytes).digest('hex'), reason: 'test' };
    });
  writeFileSync(join(folder, 'site.json'), JSON.stringify({
    schema: 1, protocol: 1, generator: 'test', name: 'test', title: 'A test', version: '1', distro: 'jazzy',
    license: 'Apache-2.0', authors: [], nodes: described, ui, files,
  }));
  return folder;
}

export interface Host {
  readonly url: string;
  /** Paths asked for, in order. */
  readonly requests: string[];
  /** Drops all connections and answers nothing more. */
  close(): Promise<void>;
}

export interface HostRules {
  /** Seconds for which browsers need not ask again, as many hosts have it. */
  readonly maxAge?: number;
  /** Paths that the host fails to give. */
  readonly broken?: RegExp;
}

/** Serves a folder under /some/path/, with or without the headers for isolation. */
export async function serveSite(folder: string, isolated: boolean, { maxAge, broken }: HostRules = {}): Promise<Host> {
  const prefix = '/some/path/';
  const requests: string[] = [];
  const headers = {
    ...(isolated ? { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' } : {}),
    ...(maxAge === undefined ? {} : { 'cache-control': `max-age=${maxAge}` }),
  };
  const server: Server = createServer((request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname));
    requests.push(path);
    if (broken?.test(path)) {
      response.writeHead(503).end();
      return;
    }
    const file = join(folder, path.slice(prefix.length - 1), path.endsWith('/') ? 'index.html' : '');
    try {
      if (!path.startsWith(prefix)) throw new Error('outside');
      const bytes = readFileSync(file);
      const type = types[extname(file)] ?? 'application/octet-stream';
      response.writeHead(200, { 'content-type': type, ...headers }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: `http://127.0.0.1:${port}${prefix}`,
    requests,
    close: () => new Promise((resolve) => {
      server.close(() => resolve());
      server.closeAllConnections();
    }),
  };
}
